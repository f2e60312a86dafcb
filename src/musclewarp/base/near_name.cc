// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/near_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace musclewarp {
namespace {

std::string InSmallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return text;
}

}  // namespace

int EditDistance(const std::string& a, const std::string& b) {
  std::vector<int> before_last, last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), 0);
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (size_t k = 1; k <= b.size(); ++k) {
      const int change = a[i - 1] == b[k - 1] ? 0 : 1;
      row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + change});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1]) {
        row[k] = std::min(row[k], before_last[k - 2] + 1);
      }
    }
    before_last = last;
    last = row;
  }
  return last.back();
}

std::string NearName(const std::string& name,
                     const std::vector<std::string>& known) {
  const std::string small = InSmallLetters(name);
  int least = std::max(1, static_cast<int>(name.size()) / 3) + 1;
  std::string nearest;
  for (const std::string& other : known) {
    // A name of one letter is no misspelt other one.
    if (other.empty() || (name.size() < 2 && other != small)) continue;
    const int distance = EditDistance(small, InSmallLetters(other));
    if (distance >= least) continue;
    least = distance;
    nearest = other;
  }
  return nearest;
}

std::string DidYouMean(const std::string& name,
                       const std::vector<std::string>& known,
                       const std::string& before) {
  const std::string near = NearName(name, known);
  return near.empty() ? "" : "did you mean " + before + near + "? ";
}

}  // namespace musclewarp

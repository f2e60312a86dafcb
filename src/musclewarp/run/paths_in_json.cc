// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/paths_in_json.h"

#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "musclewarp/base/portable_path.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/mesh_files/mesh_path.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

enum class Content { kOther, kPath, kText };

// What strings under a key hold; `outer` is what those around it do.
Content ContentOf(const std::string& key, Content outer) {
  static const std::set<std::string> kPaths = {"mesh", "model", "file", "run"};
  static const std::set<std::string> kTexts = {"command",
                                               "options",
                                               "notes",
                                               "warnings",
                                               "shortcomings",
                                               "stop_reason",
                                               "stopped",
                                               "reasons"};
  if (outer == Content::kText) return outer;
  if (kPaths.count(key) > 0) return Content::kPath;
  return kTexts.count(key) > 0 ? Content::kText : outer;
}

using Change = std::function<std::string(Content, const std::string&)>;

void ChangeTexts(const Change& change, Content content, OrderedJson* json) {
  if (json->is_string()) {
    if (content == Content::kOther) return;
    auto& text = json->get_ref<std::string&>();
    text = change(content, text);
  } else if (json->is_object()) {
    for (auto& item : json->items()) {
      ChangeTexts(change, ContentOf(item.key(), content), &item.value());
    }
  } else if (json->is_array()) {
    for (OrderedJson& item : *json) ChangeTexts(change, content, &item);
  }
}

}  // namespace

void AdaptTexts(const std::string& folder, OrderedJson* json) {
  const auto change = [&](Content content, const std::string& text) {
    return content == Content::kPath ? MeshPathFrom(folder, text)
                                     : WithFlags(WithPathsFrom(folder, text));
  };
  ChangeTexts(change, Content::kOther, json);
}

void RemoveFolders(OrderedJson* json) {
  ChangeTexts(
      [](Content, const std::string& text) { return WithoutFolders(text); },
      Content::kOther,
      json);
}

}  // namespace musclewarp

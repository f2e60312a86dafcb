// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page.h"

#include <glog/logging.h>

#include <string_view>

namespace musclewarp {
namespace {

constexpr std::string_view kDataPlace = "<!--musclewarp:data-->";

// Returns the JSON as the content of a <script>, which no text in it can end.
std::string ScriptSafe(const nlohmann::ordered_json& json) {
  const auto on_error = nlohmann::ordered_json::error_handler_t::replace;
  std::string safe;
  for (const char c : json.dump(-1, ' ', false, on_error)) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string PageHtml(const std::vector<RecordedRun>& runs,
                     const PageOptions& options) {
  const std::string_view bundle(kPageBundle, kPageBundleSize);
  const std::size_t place = bundle.find(kDataPlace);
  CHECK(place != std::string_view::npos);
  const PageContents contents = PageContentsOf(runs, options);
  std::string html(bundle.substr(0, place));
  html += "<script type=\"application/json\" id=\"runs\">" +
          ScriptSafe(contents.json) +
          "</script>\n<script type=\"text/plain\" id=\"numbers\">" +
          contents.numbers + "</script>\n";
  html += bundle.substr(place + kDataPlace.size());
  return html;
}

}  // namespace musclewarp

// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/page_parts.h"

#include <glog/logging.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "musclewarp/geometry/decimation.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view kDataPlace = "<!--musclewarp:data-->";

}  // namespace

std::string PageText(std::string_view bundle,
                     const std::string& data_id,
                     const OrderedJson& json,
                     const std::string& numbers) {
  const std::size_t place = bundle.find(kDataPlace);
  CHECK(place != std::string_view::npos);
  std::string html(bundle.substr(0, place));
  // Base64 cannot end a script, whatever names the JSON has.
  const std::string text =
      json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
  html += "<script type=\"text/plain\" id=\"" + data_id + "\">" +
          DeflatedBase64(text) +
          "</script>\n<script type=\"text/plain\" id=\"numbers\">" + numbers +
          "</script>\n";
  html += bundle.substr(place + kDataPlace.size());
  return html;
}

double RoundingStep(const std::vector<const Points*>& points) {
  Eigen::RowVector3d lower = Eigen::RowVector3d::Constant(INFINITY);
  Eigen::RowVector3d upper = -lower;
  for (const Points* some : points) {
    if (some->rows() == 0) continue;
    lower = lower.cwiseMin(some->colwise().minCoeff());
    upper = upper.cwiseMax(some->colwise().maxCoeff());
  }
  return (upper - lower).norm() / (1 << 17);
}

OrderedJson BoneShapeJson(const std::string& name,
                          const TriangleSoup& soup,
                          double step,
                          int max_triangles,
                          PackedNumbers* packed) {
  const Decimation view = Decimated(soup, {max_triangles});
  std::vector<int> positions;
  AppendRounded(view.soup.points, step, &positions);
  return {{"name", name},
          {"vertices", view.soup.points.rows()},
          {"triangles", packed->Add(view.soup.triangles)},
          {"points", packed->Add(positions, 3)},
          {"triangles_in_files", soup.triangles.rows()},
          {"view_error_mm", view.max_error}};
}

OrderedJson ViewJson(const View& view) {
  const auto vector = [](const Eigen::Vector3d& v) {
    return OrderedJson{v[0], v[1], v[2]};
  };
  return {{"toward_viewer", vector(view.toward_viewer)},
          {"up", vector(view.up)}};
}

}  // namespace musclewarp

// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// Prints the lists of figures (src/musclewarp/figures) as JSON. Pages, types
// and stubs are made of it (scripts/generated.py); it is not installed.

#include <iostream>

#include "musclewarp/base/described_json.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/figures/run_figures.h"
#include "musclewarp/figures/surface_reconstruction.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

#define MUSCLEWARP_NAMED(Struct) \
  constexpr const char* NameOfStruct(Described<Struct>) { return #Struct; }
MUSCLEWARP_NAMED(PairFigures)
MUSCLEWARP_NAMED(MeshGap)
MUSCLEWARP_NAMED(SceneIntersections)
MUSCLEWARP_NAMED(StretchMeasures)
MUSCLEWARP_NAMED(ShapeMeasures)
MUSCLEWARP_NAMED(AttachmentDrift)
MUSCLEWARP_NAMED(MuscleFigures)
MUSCLEWARP_NAMED(BoneOverlap)
MUSCLEWARP_NAMED(DeliveredCrossing)
MUSCLEWARP_NAMED(StageTime)
MUSCLEWARP_NAMED(FrameFigures)
MUSCLEWARP_NAMED(RunFigures)
MUSCLEWARP_NAMED(SurfaceReconstruction)
#undef MUSCLEWARP_NAMED

// "number", "whole", "bool", "text", "place" or the name of a struct; an array
// for a list and an object for a map of it; {"or_null": ...}.
template <class T>
OrderedJson TypeOf() {
  if constexpr (kIsDescribed<T>) {
    return NameOfStruct(Described<T>());
  } else if constexpr (kIsVector<T>) {
    return OrderedJson::array({TypeOf<typename T::value_type>()});
  } else if constexpr (kIsMap<T>) {
    return {{"map", TypeOf<typename T::mapped_type>()}};
  } else if constexpr (kIsOptional<T>) {
    return {{"or_null", TypeOf<typename T::value_type>()}};
  } else if constexpr (std::is_same_v<T, Eigen::RowVector3d>) {
    return "place";
  } else if constexpr (std::is_same_v<T, bool>) {
    return "bool";
  } else if constexpr (std::is_floating_point_v<T>) {
    return "number";
  } else if constexpr (std::is_integral_v<T>) {
    return "whole";
  } else {
    return "text";
  }
}

template <class Struct>
void Add(OrderedJson* all) {
  OrderedJson fields = OrderedJson::array();
  VisitFields(Struct(), [&](const auto& field, const auto& value) {
    OrderedJson type = TypeOf<std::decay_t<decltype(value)>>();
    if (field.presence == Presence::kNullIfEmpty) type = {{"or_null", type}};
    fields.push_back({{"key", field.key},
                      {"name", NameOf(field)},
                      {"unit", field.unit},
                      {"text", WithFlags(field.text)},
                      {"type", type},
                      {"may_be_missing",
                       field.presence == Presence::kUnlessEmpty ||
                           field.presence == Presence::kLater}});
  });
  (*all)[NameOfStruct(Described<Struct>())] = fields;
}

OrderedJson AllFigures() {
  OrderedJson all;
  Add<RunFigures>(&all);
  Add<FrameFigures>(&all);
  Add<MuscleFigures>(&all);
  Add<ShapeMeasures>(&all);
  Add<StretchMeasures>(&all);
  Add<AttachmentDrift>(&all);
  Add<SceneIntersections>(&all);
  Add<PairFigures>(&all);
  Add<MeshGap>(&all);
  Add<DeliveredCrossing>(&all);
  Add<BoneOverlap>(&all);
  Add<StageTime>(&all);
  Add<SurfaceReconstruction>(&all);
  return all;
}

}  // namespace
}  // namespace musclewarp

int main() {
  std::cout << musclewarp::AllFigures().dump(1) << "\n";
  return 0;
}

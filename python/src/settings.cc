// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/settings.h"

#include "musclewarp/settings/articulation_settings.h"
#include "musclewarp/settings/deformer_settings.h"
#include "musclewarp/settings/label_settings.h"
#include "musclewarp/settings/separation_settings.h"
#include "python/src/bindings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

template <class Settings>
void Bind(const char* name, py::dict* defaults, py::dict* texts) {
  (*defaults)[name] = DefaultsOf<Settings>();
  (*texts)[name] = ArgumentTexts<Settings>();
}

}  // namespace

std::string TextFrom(const py::object& value) {
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    std::string text;
    for (const py::handle& part : value) {
      text += (text.empty() ? "" : ",") + part.cast<std::string>();
    }
    return text;
  }
  if (py::hasattr(value, "__fspath__")) {
    return value.attr("__fspath__")().cast<std::string>();
  }
  return value.cast<std::string>();
}

void BindSettings(py::module_* module) {
  py::dict defaults, texts;
  Bind<ArticulationSettings>("ArticulationSettings", &defaults, &texts);
  Bind<DeformerSettings>("DeformerSettings", &defaults, &texts);
  Bind<LabelSettings>("LabelSettings", &defaults, &texts);
  Bind<SeparationSettings>("SeparationSettings", &defaults, &texts);
  module->attr("default_settings") = defaults;
  module->attr("settings_texts") = texts;
}

}  // namespace musclewarp::python

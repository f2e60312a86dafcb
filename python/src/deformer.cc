// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/deformer.h"

#include <pybind11/stl.h>

#include "musclewarp/base/input_error.h"
#include "python/src/bindings.h"
#include "python/src/choices.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;
using Self = std::shared_ptr<SharedDeformer>;

// Where the muscles of a deformer are.
struct StateOfDeformer {
  SceneState state;
  std::shared_ptr<const SceneParts> parts;  // tells deformers apart
};
using SharedState = std::shared_ptr<StateOfDeformer>;

// Returns what calls a function of Python, and stops what was abandoned.
ProgressCallback CallbackOf(const py::object& progress) {
  if (progress.is_none()) {
    return [](const Progress& /*progress*/) { ThrowIfAbandoned(); };
  }
  // The last owner may be a thread without the interpreter.
  const std::shared_ptr<py::object> function(
      new py::object(progress), [](py::object* object) {
        const py::gil_scoped_acquire hold;
        delete object;
      });
  return [function](const Progress& now) {
    ThrowIfAbandoned();
    const py::gil_scoped_acquire hold;
    (*function)(now.stage, now.done, now.total);
  };
}

Self MakeFromKeywords(const SharedScene& scene,
                      const py::dict& keywords,
                      const py::object& progress) {
  const Self self = MakeDeformer(*scene, OptionsFrom(keywords), progress);
  for (const auto& [name, value] : keywords) {
    self->keywords[name.cast<std::string>()] =
        py::str(value).cast<std::string>();
  }
  return self;
}

SharedState StateOf(const Self& self) {
  return SharedDeformer::Compute(self, [self](Deformer* deformer) {
    return std::make_shared<StateOfDeformer>(
        StateOfDeformer{deformer->state(), self->parts});
  });
}

void SetState(const Self& self, const SharedState& state) {
  if (state->parts != self->parts) {
    throw InputError("state",
                     "is one of another deformer",
                     "give a state that this deformer had");
  }
  SharedDeformer::Compute(self, [state](Deformer* deformer) {
    deformer->set_state(state->state);
    return true;
  });
}

int ExpectedSteps(const Self& self,
                  const SharedPose& pose,
                  const std::optional<SharedPose>& start) {
  return SharedDeformer::Compute(self, [=](Deformer* deformer) {
    return deformer->ExpectedSteps(start ? start->get() : nullptr, *pose);
  });
}

}  // namespace

std::shared_ptr<SharedDeformer> MakeDeformer(Scene scene,
                                             DeformerOptions options,
                                             const py::object& progress) {
  options.on_progress = CallbackOf(progress);
  return ComputeFree([scene = std::move(scene), options = std::move(options)] {
    const auto self = std::make_shared<SharedDeformer>();
    self->solver = options.solver.name;
    self->deformer.emplace(scene, options);
    self->parts = PartsOf(self->deformer->scene());
    return self;
  });
}

void BindDeformer(py::module_* module) {
  module->def("default_choices", &DefaultChoices);
  py::class_<StateOfDeformer, SharedState>(*module, "State");
  py::class_<SharedDeformer, Self>(*module, "Deformer")
      .def(py::init(&MakeFromKeywords),
           py::arg("scene"),
           py::arg("keywords"),
           py::arg("progress"))
      .def(
          "move_to",
          [](const Self& self, const SharedPose& pose) {
            return SharedDeformer::ComputeFrame(
                self, [pose](Deformer* d) { return d->MoveTo(*pose); });
          },
          py::arg("pose"))
      .def(
          "solve_alone",
          [](const Self& self, const SharedPose& pose) {
            return SharedDeformer::ComputeFrame(
                self, [pose](Deformer* d) { return d->SolveAlone(*pose); });
          },
          py::arg("pose"))
      .def("reset",
           [](const Self& self) {
             SharedDeformer::Compute(self, [](Deformer* deformer) {
               deformer->Reset();
               return true;
             });
           })
      .def_property_readonly("rest_frame",
                             [](const Self& self) {
                               return SharedDeformer::ComputeFrame(
                                   self,
                                   [](Deformer* d) { return d->RestFrame(); });
                             })
      .def_property("state", &StateOf, &SetState)
      .def("expected_steps",
           &ExpectedSteps,
           py::arg("pose"),
           py::arg("start") = py::none())
      // What follows does not change once the deformer is made.
      .def_property_readonly(
          "warnings",
          [](const Self& self) { return self->deformer->scene().warnings; })
      .def_property_readonly(
          "notes",
          [](const Self& self) { return self->deformer->scene().scene.notes; })
      .def_property_readonly("contact", [](const Self& self) {
        return self->deformer->contact().name;
      });
}

}  // namespace musclewarp::python

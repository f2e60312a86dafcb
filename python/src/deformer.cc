// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/deformer.h"

#include <pybind11/stl.h>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/settings/deformer_settings.h"
#include "python/src/bindings.h"
#include "python/src/settings.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// What help() says.
constexpr char kStateDoc[] =
    R"(Where the muscles of a deformer are, to be put back later.)";

constexpr char kMoveToDoc[] =
    R"(Moves the muscles from where they are to a pose.

The frames of a motion follow each other like this, without jumps. If the call
is interrupted, the muscles stay where they were.

Args:
    pose: a Pose.
Returns:
    A Frame. Whether it may be used, it says itself (Frame.usable).
Raises:
    InputError: the pose contradicts the scene.)";

constexpr char kSolveAloneDoc[] =
    R"(Returns the frame of a pose that is on its own.

It does not depend on where the muscles are now, and they stay there. Args,
returns and raises as move_to().)";

constexpr char kSolveDoc[] =
    R"(Returns the frame of a pose of the scene, from where it starts.

In a motion that is where the muscles are now, so that poses are asked for in
their order. Poses of a design start from the pose of their tree, and may be
asked for in any order. Others start from rest.

Args:
    number: of the pose in Scene.poses, from 0.
Returns:
    A Frame, with its `index` and, of a design, where it was `reached_from`.
Raises:
    InputError: the scene has no such pose.)";

constexpr char kExpectedStepsDoc[] =
    R"(Returns in how many steps a pose can be reached, if they are short.

Args:
    pose: a Pose.
    start: the Pose before; None if the pose is computed on its own.)";
using Self = std::shared_ptr<SharedDeformer>;

// Where the muscles of a deformer are.
struct StateOfDeformer {
  SceneState state;
  std::shared_ptr<const SceneParts> parts;  // tells deformers apart
};
using SharedState = std::shared_ptr<StateOfDeformer>;

Self MakeFromKeywords(const SharedScene& scene,
                      const py::dict& keywords,
                      const py::object& progress) {
  std::map<std::string, std::string> given;
  for (const auto& [name, value] : keywords) {
    given[name.cast<std::string>()] = py::str(value).cast<std::string>();
  }
  DeformerOptions options = OptionsOf(SettingsFrom<DeformerSettings>(keywords));
  options.on_progress = CallbackOf(progress);
  return ComputeFree(
      [scene = *scene, options = std::move(options), given = std::move(given)] {
        const auto self = std::make_shared<SharedDeformer>();
        self->solver = options.solver.name;
        self->keywords = given;
        self->deformer.emplace(scene, options);
        self->walk.emplace(&*self->deformer);
        self->parts = PartsOf(self->deformer->scene(), given);
        return self;
      });
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

std::shared_ptr<FrameOfScene> Solve(const Self& self, int number) {
  const auto count =
      static_cast<int>(self->deformer->scene().scene.poses.size());
  if (number < 0 || number >= count) {
    throw InputError(
        "number",
        "is " + std::to_string(number),
        "the scene has " + std::to_string(count) + " poses, numbered from 0");
  }
  return SharedDeformer::ComputeFrame(self,
                                      [self, number](Deformer* /*deformer*/) {
                                        return self->walk->Solve(number);
                                      });
}

int ExpectedSteps(const Self& self,
                  const SharedPose& pose,
                  const std::optional<SharedPose>& start) {
  return SharedDeformer::Compute(self, [=](Deformer* deformer) {
    return deformer->ExpectedSteps(start ? start->get() : nullptr, *pose);
  });
}

// What does not change once a deformer is made.
void BindWhatIsKnown(py::class_<SharedDeformer, Self>* type) {
  type->def_property_readonly(
          "warnings",
          [](const Self& self) {
            return WithFieldNames(self->deformer->scene().warnings);
          },
          "What is likely wrong with the scene, a sentence each.")
      .def_property_readonly(
          "notes",
          [](const Self& self) {
            return WithFieldNames(self->deformer->scene().scene.notes);
          },
          "What was found while the scene was read, a sentence each.")
      .def_property_readonly(
          "contact",
          [](const Self& self) { return self->deformer->contact().name; },
          "The kind of contact: certified, paper/coarse, paper/fine or none.");
}

}  // namespace

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

void BindDeformer(py::module_* module) {
  py::class_<StateOfDeformer, SharedState>(*module, "State", kStateDoc);
  py::class_<SharedDeformer, Self> type(*module, "Deformer");
  type.def(py::init(&MakeFromKeywords),
           py::arg("scene"),
           py::arg("keywords"),
           py::arg("progress"))
      .def(
          "move_to",
          [](const Self& self, const SharedPose& pose) {
            return SharedDeformer::ComputeFrame(
                self, [pose](Deformer* d) { return d->MoveTo(*pose); });
          },
          py::arg("pose"),
          kMoveToDoc)
      .def(
          "solve_alone",
          [](const Self& self, const SharedPose& pose) {
            return SharedDeformer::ComputeFrame(
                self, [pose](Deformer* d) { return d->SolveAlone(*pose); });
          },
          py::arg("pose"),
          kSolveAloneDoc)
      .def("solve", &Solve, py::arg("number"), kSolveDoc)
      .def(
          "reset",
          [](const Self& self) {
            SharedDeformer::Compute(self, [](Deformer* deformer) {
              deformer->Reset();
              return true;
            });
          },
          "Moves the muscles back to where a motion starts.")
      .def_property_readonly(
          "rest_frame",
          [](const Self& self) {
            return SharedDeformer::ComputeFrame(
                self, [](Deformer* d) { return d->RestFrame(); });
          },
          "The scene as it was delivered and repaired, before any contact.")
      .def_property("state",
                    &StateOf,
                    &SetState,
                    "Where the muscles are. One that is put back must have "
                    "been of this deformer.")
      .def("expected_steps",
           &ExpectedSteps,
           py::arg("pose"),
           py::arg("start") = py::none(),
           kExpectedStepsDoc);
  BindWhatIsKnown(&type);
}

}  // namespace musclewarp::python

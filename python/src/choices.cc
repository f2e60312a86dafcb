// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/choices.h"

#include <iomanip>
#include <limits>
#include <sstream>
#include <string>

#include "musclewarp/deformer/length_options.h"
#include "python/src/bindings.h"
#include "tools/deform_command.h"
#include "tools/deformer_settings.h"
#include "tools/option_flags.h"

namespace musclewarp::python {
namespace {

namespace py = pybind11;

// Calls visit(name, reference to the field) for every choice.
template <typename Choices, typename Visitor>
void VisitChoices(Choices* choices, const Visitor& visit) {
  visit("solver", choices->solver);
  visit("contact", choices->contact);
  visit("contact_level", choices->contact_level);
  visit("attachments", choices->attachments);
  visit("remake", choices->remake);
  visit("max_loss", choices->max_loss);
  visit("max_lost_area", choices->max_lost_area);
  visit("max_lost_extent", choices->max_lost_extent);
  visit("max_torn_patch", choices->max_torn_patch);
  visit("max_iterations", choices->max_iterations);
  visit("seed", choices->seed);
  visit("max_hole", choices->max_hole);
  visit("coarse_vertices", choices->coarse_vertices);
  visit("bone_coarse_vertices", choices->bone_coarse_vertices);
  visit("laplacian", choices->laplacian);
  visit("laplacian_length", choices->laplacian_length);
  visit("lines", choices->lines);
  visit("sample_spacing", choices->sample_spacing);
  visit("skeleton_weight", choices->skeleton_weight);
  visit("attachment_weight", choices->attachment_weight);
  visit("bending_weight", choices->bending_weight);
  visit("auto_lines", choices->auto_lines);
  visit("fibres", choices->fibres);
  visit("gap", choices->gap);
  visit("max_rounds", choices->max_rounds);
  visit("frame_timeout_s", choices->frame_timeout_s);
  visit("max_step_turn", choices->max_step_turn);
  visit("max_step_move", choices->max_step_move);
  visit("body_twist", choices->body_twist);
  visit("cache", choices->cache);
}

const char* WhatIsAllowed(const std::string& /*field*/) { return "a text"; }
const char* WhatIsAllowed(double /*field*/) { return "a number"; }
const char* WhatIsAllowed(int /*field*/) { return "a whole number"; }
const char* WhatIsAllowed(unsigned /*field*/) {
  return "a whole number that is not negative";
}
const char* WhatIsAllowed(bool /*field*/) { return "True or False"; }

// A text that differs between any two sets of choices by which a scene is
// prepared differently.
std::string KeyOf(const DeformerSettings& choices) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  VisitChoices(&choices, [&](const std::string& name, const auto& field) {
    if (name != "cache") text << name << "=" << field << "\n";
  });
  for (const std::string& name : choices.lengths_in_mm) text << name << "\n";
  return text.str();
}

}  // namespace

void CallWithKeywords(const std::function<void()>& function) {
  try {
    function();
  } catch (const InputError& error) {
    const std::string& where = error.where();
    if (where.rfind("--", 0) != 0) throw;
    throw InputError(where.substr(2), error.problem(), error.advice());
  }
}

DeformerOptions OptionsFrom(const py::dict& keywords) {
  DeformerSettings choices;
  VisitChoices(&choices, [&](const char* name, auto& field) {
    if (!keywords.contains(name)) return;
    const auto otherwise = field;
    const py::object value = keywords[name];
    try {
      field = value.cast<std::decay_t<decltype(field)>>();
    } catch (const py::cast_error&) {
      throw InputError(name,
                       "is " + py::repr(value).cast<std::string>(),
                       std::string("allowed: ") + WhatIsAllowed(field));
    }
    // All keywords come with values; one that is not the default was given.
    if (field != otherwise && LengthsThatCanBeAskedFor().count(name) > 0) {
      choices.lengths_in_mm.insert(name);
    }
  });
  DeformOptions run;
  CallWithKeywords([&] {
    run.deformer = OptionsOf(choices);
    run.deformer.cache.options_key = KeyOf(choices);
    CheckValid(run);
  });
  return run.deformer;
}

py::dict DefaultChoices() {
  const DeformerSettings choices;
  py::dict keywords;
  VisitChoices(&choices, [&](const char* name, const auto& field) {
    keywords[name] = field;
  });
  return keywords;
}

}  // namespace musclewarp::python

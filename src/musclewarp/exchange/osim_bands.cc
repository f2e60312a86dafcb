// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/osim_bands.h"

#include <glog/logging.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"
#include "musclewarp/base/xml_text.h"
#include "musclewarp/exchange/osim_text.h"
#include "musclewarp/opensim/dynamics.h"
#include "musclewarp/opensim/osim_xml.h"

namespace musclewarp {
namespace {

constexpr int kDigits = 17;

// The edit that gives a property of a muscle another value.
TextEdit EditOfProperty(const std::string& text,
                        pugi::xml_node muscle,
                        const std::string& property,
                        double value) {
  const pugi::xml_node old = muscle.child(property.c_str());
  CHECK(old) << property;  // BandMusclesOf
  return {BeginOf(old),
          EndOf(text, old),
          "<" + property + ">" + NumberText(value, kDigits) + "</" + property +
              ">"};
}

// The text of a muscle as that of a band.
std::string CopyOf(const std::string& text,
                   pugi::xml_node muscle,
                   const BandMuscle& band) {
  const size_t begin = BeginOf(muscle);
  const size_t start_end = EndOfStartTag(text, muscle);
  static const std::regex name(R"re((\sname\s*=\s*)("[^"]*"|'[^']*'))re");
  std::string start_tag = text.substr(begin, start_end - begin);
  std::smatch match;
  CHECK(std::regex_search(start_tag, match, name));
  start_tag = match.prefix().str() + match[1].str() + "\"" +
              XmlEscaped(band.name) + "\"" + match.suffix().str();
  std::vector<TextEdit> edits = {
      {begin, start_end, start_tag},
      EditOfProperty(text, muscle, "max_isometric_force", band.force),
      EditOfProperty(text,
                     muscle,
                     "tendon_slack_length",
                     band.tendon / kMillimetresPerMetre)};
  for (TextEdit& edit : edits) {
    edit.begin -= begin;
    edit.end -= begin;
  }
  return WithEdits(text.substr(begin, EndOf(text, muscle) - begin),
                   std::move(edits));
}

// Throws InputError if a muscle that stays has the name of a band.
void CheckNames(const pugi::xml_document& document,
                const std::string& where,
                const std::vector<BandMuscle>& bands,
                const std::set<std::string>& replaced) {
  std::set<std::string> names;
  for (const BandMuscle& band : bands) {
    if (replaced.count(band.name) == 0) names.insert(band.name);
  }
  document.find_node([&](pugi::xml_node node) {
    if (std::string(node.name()) != kGeometryPath) return false;
    const pugi::xml_node muscle = OwnerOfPath(node);
    const std::string name = muscle.attribute("name").value();
    if (names.count(name) > 0) {
      throw InputError(where,
                       "has a <" + std::string(muscle.name()) + "> named \"" +
                           name + "\", as a band of fibres is",
                       "rename it, or the muscle of the scene");
    }
    return false;
  });
}

// The edits that put bands into groups in place of the muscles that go.
void EditGroups(const std::string& text,
                const pugi::xml_document& document,
                const std::map<std::string, std::string>& names,
                std::vector<TextEdit>* edits) {
  document.find_node([&](pugi::xml_node node) {
    if (std::string(node.name()) != "members") return false;
    std::istringstream members(node.text().get());
    std::string member, changed;
    bool is_changed = false;
    while (members >> member) {
      const auto bands = names.find(member);
      is_changed = is_changed || bands != names.end();
      const std::string& words = bands == names.end() ? member : bands->second;
      if (!words.empty()) changed += (changed.empty() ? "" : " ") + words;
    }
    if (is_changed) {
      edits->push_back({BeginOf(node),
                        EndOf(text, node),
                        "<members>" + XmlEscaped(changed) + "</members>"});
    }
    return false;
  });
}

}  // namespace

std::vector<BandMuscle> BandMusclesOf(const RunPaths& paths) {
  const ModelDynamics dynamics = DynamicsOf(paths.model);
  std::vector<BandMuscle> bands;
  for (const MeasuredPath& path : paths.paths) {
    if (path.fibres.empty() || path.replaces.empty()) continue;
    for (const std::string& name : path.replaces) {
      const auto muscle = dynamics.muscles.find(name);
      if (muscle != dynamics.muscles.end() && muscle->second.force > 0 &&
          muscle->second.tendon > 0) {
        continue;
      }
      throw InputError(paths.model.path + ": muscle \"" + name + "\"",
                       "has no max_isometric_force or tendon_slack_length, "
                       "which bands of its fibres share",
                       "give it both, or export without {paths_per_muscle}");
    }
    BandMuscle band;
    band.name = path.name;
    band.like = path.nearest;
    band.replaces = path.replaces;
    band.force = ForceOf(path, dynamics);
    band.tendon = std::max(dynamics.muscles.at(band.like).tendon + path.longer,
                           kShortestTendon);
    bands.push_back(std::move(band));
  }
  return bands;
}

std::string WithBandMuscles(const std::string& bytes,
                            const std::string& where,
                            const std::vector<BandMuscle>& bands) {
  const std::string text = DecodeXml(bytes).utf8;
  pugi::xml_document document;
  ParseOsim(text, where, &document);

  // Bands stand where the first of the muscles stood that they replace.
  std::map<std::string, std::vector<const BandMuscle*>> in_place_of;
  std::set<std::string> replaced;
  for (const BandMuscle& band : bands) {
    replaced.insert(band.replaces.begin(), band.replaces.end());
    in_place_of[band.replaces.at(0)].push_back(&band);
  }
  CheckNames(document, where, bands, replaced);
  std::vector<TextEdit> edits;
  std::map<std::string, std::string> names;  // of bands, for each that goes
  for (const std::string& name : replaced) {
    const pugi::xml_node muscle =
        OwnerOfPath(PathOfMuscle(document, where, name));
    TextEdit edit = {BeginOf(muscle), EndOf(text, muscle), ""};
    const std::string indent = IndentAt(text, edit.begin);
    std::string& of_bands = names[name];
    for (const BandMuscle* band : in_place_of[name]) {
      const pugi::xml_node like =
          OwnerOfPath(PathOfMuscle(document, where, band->like));
      edit.text +=
          (edit.text.empty() ? "" : "\n" + indent) + CopyOf(text, like, *band);
      of_bands += (of_bands.empty() ? "" : " ") + band->name;
    }
    edits.push_back(std::move(edit));
  }
  EditGroups(text, document, names, &edits);
  return WithUtf8Declaration(WithEdits(text, std::move(edits)));
}

}  // namespace musclewarp

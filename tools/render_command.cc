// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/render_command.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <ostream>
#include <set>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"
#include "musclewarp/base/palette.h"
#include "musclewarp/base/text.h"
#include "musclewarp/mesh_files/mesh_io.h"
#include "musclewarp/mesh_files/mesh_path.h"
#include "musclewarp/render/picture.h"
#include "musclewarp/render/picture_texts.h"
#include "musclewarp/render/stretch_colors.h"
#include "musclewarp/run/run_files.h"
#include "musclewarp/settings/checked_settings.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// Parses all of a text as a number. Returns false if it is none.
template <typename Number>
bool Parse(const std::string& text, Number* number) {
  std::istringstream in(text);
  in >> *number;
  return in && in.peek() == EOF;
}

RunFiles FilesAsRun(const std::vector<std::string>& files) {
  RunFiles run;
  run.frames.resize(1);
  for (const std::string& file : files) {
    if (!run.frames[0].meshes.emplace(MeshNameOf(file), file).second) {
      throw InputError(
          file, "another file has the same name", "name every part once");
    }
  }
  return run;
}

std::set<std::string> NamesIn(const RunFiles& run) {
  std::set<std::string> names;
  for (const FrameFiles& frame : run.frames) {
    for (const auto& [name, file] : frame.meshes) names.insert(name);
  }
  return names;
}

// Returns the names in the words of a flag. Throws InputError for a name that
// is not among the known meshes.
std::set<std::string> ParseNames(const std::string& flag,
                                 const std::vector<std::string>& words,
                                 const std::set<std::string>& known) {
  for (const std::string& word : words) {
    if (known.count(word) > 0) continue;
    std::string all;
    for (const std::string& name : known) all += " " + name;
    throw InputError(flag,
                     "there is no mesh '" + word + "'",
                     DidYouMean(word, {known.begin(), known.end()}) +
                         "the meshes are:" + all);
  }
  return {words.begin(), words.end()};
}

std::map<std::string, double> ParseFade(const std::string& text,
                                        const std::set<std::string>& known) {
  std::map<std::string, double> opacities;
  for (const std::string& word : Split(text, ',')) {
    const std::size_t colon = word.rfind(':');
    double opacity = -1;
    if (colon == std::string::npos ||
        !Parse(word.substr(colon + 1), &opacity) ||
        !(opacity >= 0 && opacity <= 1)) {
      throw InputError("--fade",
                       "'" + word + "' is not name:opacity",
                       "use for example femur_r:0.3, opacity from 0 to 1");
    }
    const std::string name = word.substr(0, colon);
    ParseNames("--fade", {name}, known);
    opacities[name] = opacity;
  }
  return opacities;
}

void ParseSize(const std::string& text, PictureOptions* options) {
  const std::size_t cross = text.find('x');
  const auto is_fine = [](int pixels) {
    return pixels >= 64 && pixels <= 4096;
  };
  if (cross == std::string::npos ||
      !Parse(text.substr(0, cross), &options->width) ||
      !Parse(text.substr(cross + 1), &options->height) ||
      !is_fine(options->width) || !is_fine(options->height)) {
    throw InputError("--size",
                     "'" + text + "' is not a size",
                     "use WIDTHxHEIGHT, each from 64 to 4096 pixels");
  }
}

// Returns the muscles in the order of their colours: that of the report or,
// without one, the alphabetical order.
std::vector<std::string> ShownMuscles(const RunFiles& run,
                                      const std::set<std::string>& names,
                                      const std::set<std::string>& bones) {
  std::vector<std::string> muscles;
  if (run.has_report) {
    for (const std::string& name : run.muscles) {
      if (names.count(name) > 0) muscles.push_back(name);
    }
  } else {
    std::set_difference(names.begin(),
                        names.end(),
                        bones.begin(),
                        bones.end(),
                        std::back_inserter(muscles));
  }
  return muscles;
}

std::string WithSpaces(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

// Returns the look of each mesh by its name; the surfaces are still empty.
std::map<std::string, PictureMesh> Looks(const RenderRequest& request,
                                         const RunFiles& run,
                                         PictureOptions* options) {
  const std::set<std::string> names = NamesIn(run);
  const auto parse = [&](const char* flag, const std::string& text) {
    return ParseNames(flag, Split(text, ','), names);
  };
  const std::set<std::string> fit = parse("--fit", request.fit);
  const std::set<std::string> hide = parse("--hide", request.hide);
  std::map<std::string, PictureMesh> looks;
  for (const std::string& name : names) {
    looks[name].color = BoneColor();
    looks[name].fit = fit.empty() || fit.count(name) > 0;
  }
  const std::vector<std::string> muscles =
      ShownMuscles(run, names, parse("--bones", request.bones));
  for (std::size_t i = 0; i < muscles.size(); ++i) {
    const Color color = MuscleColor(static_cast<int>(i));
    looks[muscles[i]].color = color;
    if (request.legend && request.color == "muscle" &&
        hide.count(muscles[i]) == 0) {
      options->legend.push_back({WithSpaces(muscles[i]), color});
    }
  }
  if (request.legend && request.color == "stretch") {
    options->legend = StretchLegend();
  }
  for (const auto& [name, opacity] : ParseFade(request.fade, names)) {
    looks[name].opacity = opacity;
  }
  for (const std::string& name : hide) looks.erase(name);
  return looks;
}

std::vector<std::string> Captions(const RenderRequest& request,
                                  const RunFiles& run) {
  std::vector<std::string> captions(run.frames.size());
  if (request.captions == "auto") {
    if (run.frames.size() == 1) return captions;
    for (std::size_t i = 0; i < captions.size(); ++i) {
      captions[i] = WithSpaces(run.frames[i].name);
    }
  } else if (!request.captions.empty()) {
    captions = Split(request.captions, ',');
    if (captions.size() != run.frames.size()) {
      throw InputError("--captions",
                       "gives " + std::to_string(captions.size()) +
                           " texts for " + std::to_string(run.frames.size()) +
                           " frames",
                       "give one text for every frame, with commas");
    }
  }
  return captions;
}

// Sets the colours of a muscle of a run by its stretch.
void ColorByStretch(const MeshFiles& rest_files,
                    const std::string& name,
                    PictureMesh* mesh) {
  const auto file = rest_files.find(name);
  if (file == rest_files.end()) {
    throw InputError("--color",
                     "the run has no mesh of " + name + " at rest",
                     "use a folder that musclewarp-deform has written");
  }
  const TriangleSoup rest = ReadTriangleSoup(file->second);
  if (rest.points.rows() != mesh->surface.points.rows() ||
      rest.triangles.rows() != mesh->surface.triangles.rows()) {
    throw InputError(file->second,
                     "has other triangles than the mesh of the frame",
                     "use the files of one run");
  }
  mesh->triangle_colors =
      StretchColors(rest.points, mesh->surface.points, mesh->surface.triangles);
}

// Reads the meshes of the panels. Precondition: the flags have been checked.
std::vector<PicturePanel> ReadPanels(
    const RenderRequest& request,
    const RunFiles& run,
    const std::vector<std::string>& captions,
    const std::map<std::string, PictureMesh>& looks,
    std::vector<std::string>* notes) {
  std::vector<PicturePanel> panels(run.frames.size());
  bool has_fit = false;
  const std::set<std::string> muscles(run.muscles.begin(), run.muscles.end());
  MeshFiles rest;
  if (request.color == "stretch") {
    rest = MeshFilesIn((fs::path(request.in) / "rest").string());
  }
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panels[i].caption = captions[i];
    for (const auto& item : run.frames[i].meshes) {
      const std::string& name = item.first;
      const auto look = looks.find(name);
      if (look == looks.end()) continue;
      panels[i].meshes.push_back(look->second);
      panels[i].meshes.back().surface =
          ReadMeshOfFrame(run.frames[i], name, notes);
      if (request.color == "stretch" && muscles.count(name) > 0) {
        ColorByStretch(rest, name, &panels[i].meshes.back());
      }
      has_fit = has_fit || look->second.fit;
    }
  }
  if (!has_fit) {
    throw InputError("--hide",
                     "leaves nothing to draw",
                     "hide fewer meshes, or name a shown one in --fit");
  }
  return panels;
}

void CheckColor(const RenderRequest& request) {
  CheckSettings(request);
  if (request.color == "stretch" && request.in.empty()) {
    throw InputError("--color",
                     "mesh files alone do not tell how far they are stretched",
                     "use --in=RUN_DIR");
  }
}

void CheckRoom(const std::vector<PicturePanel>& panels,
               const RenderRequest& request,
               const PictureOptions& options) {
  const TextLayout layout = LayOutTexts(panels, options);
  const int height =
      options.height - layout.caption_height - layout.legend_height;
  const int width = options.width / static_cast<int>(panels.size());
  if (std::min(width, height) < kLeastPanelSize) {
    throw InputError("--size",
                     request.size +
                         " leaves no room for the scenes beside "
                         "each other and above the texts",
                     "make the picture larger, or use --nolegend");
  }
}

}  // namespace

void Render(const RenderRequest& request, std::ostream& log) {
  if (fs::path(request.out).extension() != ".png") {
    throw InputError("--out",
                     "'" + request.out + "' is not a .png file",
                     "use --out=picture.png");
  }
  if (request.in.empty() == request.files.empty()) {
    throw InputError("--in",
                     "is to be given, or mesh files, and not both",
                     "use --in=RUN_DIR or FILE...");
  }
  CheckColor(request);
  PictureOptions options;
  options.outlines = request.outlines;
  ParseSize(request.size, &options);
  const RunFiles run = request.in.empty()
                           ? FilesAsRun(request.files)
                           : FindRunFiles(request.in, request.frames);
  const View view = ParseView(request.view,
                              request.axes.empty() ? run.axes : request.axes,
                              request.side.empty() ? run.side : request.side);
  const std::map<std::string, PictureMesh> looks =
      Looks(request, run, &options);
  std::vector<std::string> notes;
  const std::vector<PicturePanel> panels =
      ReadPanels(request, run, Captions(request, run), looks, &notes);
  for (const std::string& note : notes) log << note << "\n";
  CheckRoom(panels, request, options);
  WritePng(request.out, DrawPicture(panels, view, options));
  log << "wrote " << request.out << "\n";
}

}  // namespace musclewarp

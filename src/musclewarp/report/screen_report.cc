// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/report/screen_report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>
#include <vector>

#include "musclewarp/base/memory.h"
#include "musclewarp/base/setting_names.h"
#include "musclewarp/base/text.h"
#include "musclewarp/report/remedies.h"
#include "musclewarp/run/pose_name.h"
#include "musclewarp/run/shape_warnings.h"

namespace musclewarp {

namespace {

// Returns the text of the last column of the table. "converged" concerns the
// solver only: without certified contact, a converged frame may have crossings,
// which the text then mentions.
std::string OutcomeOf(const FrameFigures& frame) {
  if (!frame.shortcomings.empty()) return "NOT usable";
  return frame.stop_reason() + (frame.IsClean() ? "" : ", crossing");
}

// Prints a list under a title, unless it is empty.
void PrintList(const std::string& title,
               const std::vector<std::string>& lines,
               std::ostream& out) {
  constexpr size_t kMaxLines = 12;  // the rest is in report.json
  if (lines.empty()) return;
  out << "\n" << title << ":\n";
  for (size_t i = 0; i < std::min(kMaxLines, lines.size()); ++i) {
    out << "  " << lines[i] << "\n";
  }
  if (lines.size() > kMaxLines) {
    out << "  ... and " << lines.size() - kMaxLines << " more in report.json\n";
  }
}

// Returns the frames with the names that they have on the screen.
std::vector<FrameFigures> FramesForReaders(const RunRecord& run) {
  std::vector<FrameFigures> frames = run.frames;
  if (!run.scene) return frames;
  const auto moving = MovingCoordinatesOf(run.scene->scene);
  for (FrameFigures& frame : frames) {
    frame.name = PoseName(frame.name, frame.coordinates, moving);
  }
  return frames;
}

std::vector<std::string> Shortcomings(const std::vector<FrameFigures>& frames) {
  std::vector<std::string> lines;
  for (const FrameFigures& frame : frames) {
    for (const std::string& shortcoming : frame.shortcomings) {
      lines.push_back("frame " + std::to_string(frame.index) + ", " +
                      frame.name + ": " + shortcoming);
    }
  }
  return lines;
}

std::string Counted(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// Returns the changes to a mesh, for the end of its line.
std::string Treatment(const MeshPreparation& mesh) {
  std::string text = mesh.repairs.AnythingDone() ? ", repaired" : "";
  if (mesh.repairs.pieces > 1) {
    text += ", " + Counted(mesh.repairs.pieces, "piece");
  }
  const std::vector<DroppedPiece>& dropped = mesh.repairs.dropped_pieces;
  const auto others =
      std::count_if(dropped.begin(), dropped.end(), [](const auto& piece) {
        return piece.reason != DropReason::kCrumb &&
               piece.reason != DropReason::kShell;
      });
  if (others > 0) {
    text += ", " + Counted(static_cast<int>(others), "piece") + " left out";
  }
  text += FilledCavities(mesh.repairs);
  const int faces = mesh.repairs.fillings.missing_faces;
  if (faces > 0) text += ", " + Counted(faces, "missing face") + " filled";
  const SelfCrossingRemoval& crossings = mesh.self_crossings;
  const int removed = crossings.pairs_before - crossings.pairs_after;
  if (removed > 0) {
    text += ", " + std::to_string(removed) + " self-crossings removed";
  }
  if (crossings.pairs_after > 0) {
    text += ", " + std::to_string(crossings.pairs_after) +
            " self-crossings could not be removed";
  }
  if (mesh.reconstruction.is_done) text += ", made anew";
  return text;
}

// Returns the meaning of the crossings in the table for the verdict: only
// certified contact makes frames with crossings unusable.
std::string CrossingsIn(const RunFigures& totals, ContactKind contact) {
  if (contact == ContactKind::kNone) {
    return "not tested for crossings (contact none)";
  }
  const std::string count =
      std::to_string(totals.frames_clean) + " without intersection";
  const bool is_tolerated =
      contact == ContactKind::kPaper && totals.frames_clean < totals.frames;
  return count + (is_tolerated ? " (contact paper does not refuse them)" : "");
}

// Returns "15 frames", or "4 of 15 frames" for a run that was stopped.
std::string FramesOf(const RunRecord& run) {
  const std::string all = Counted(run.frames_planned, "frame");
  return run.finished ? all : std::to_string(run.frames.size()) + " of " + all;
}

std::string VerdictOf(const RunRecord& run, const RunFigures& totals) {
  if (!totals.usable) return "NOT usable";
  return run.finished ? "usable" : "usable so far";
}

void PrintTotals(const RunRecord& run, std::ostream& out) {
  const RunFigures totals = TotalsOf(run);
  out << "\n"
      << FramesOf(run) << ", " << CrossingsIn(totals, run.contact.kind)
      << ", worst volume error " << std::scientific << totals.worst_volume_error
      << ", median " << std::fixed << totals.wall_ms_per_frame_median
      << " ms a frame: " << VerdictOf(run, totals) << "\n";
}

}  // namespace

std::string FilledCavities(const RepairReport& repairs) {
  const double volume = TotalsOf(repairs.dropped_pieces).cavity;
  if (volume == 0) return "";
  return ", cavities of " + MeasureText(volume / 1000) + " cm3 filled";
}

void PrintPreparation(const PreparedScene& scene,
                      const ContactReport& contact,
                      std::ostream& out) {
  out << "scene " << scene.scene.name << ": " << scene.muscles.size()
      << " muscles, " << scene.bones.size() << " bones, "
      << scene.scene.poses.size() << " poses; "
      << (scene.is_cached ? "preparation read in " : "prepared in ")
      << std::fixed << std::setprecision(0) << scene.wall_ms << " ms";
  if (contact.rest) {
    out << ", " << ToString(contact.kind) << " contact in "
        << contact.prepare_ms << " ms";
  }
  out << "; about " << MemoryText(scene.memory_needed) << "\n";
  for (const std::string& note : scene.scene.notes) {
    out << "  " << WithFlags(note) << "\n";
  }
  for (const PreparedMuscle& muscle : scene.muscles) {
    out << "  " << muscle.model.name << ": " << muscle.model.fine_rest.rows()
        << " vertices, " << FixedText(muscle.model.rest_volume / 1000, 1)
        << " cm3, hull of " << muscle.model.coarse_rest.rows() << " vertices"
        << (muscle.hull_encloses ? "" : " that does NOT enclose it")
        << Treatment(muscle.mesh) << "\n";
  }
  for (const PreparedBone& bone : scene.bones) {
    out << "  " << bone.mesh.name << ": " << bone.rest.points.rows()
        << " vertices, bone" << Treatment(bone.mesh) << "\n";
  }
  PrintBoneCrossings(scene, out);
}

void PrintBoneCrossings(const PreparedScene& scene, std::ostream& out) {
  for (const BoneCrossing& crossing : scene.bone_crossings) {
    out << "  " << crossing.a << " and " << crossing.b
        << " cross each other as delivered, in " << crossing.triangle_pairs
        << " pairs of triangles; bones are not moved\n";
  }
}

void PrintFrames(const RunRecord& run, std::ostream& out) {
  const std::vector<FrameFigures> frames = FramesForReaders(run);
  size_t name_width = 4;
  for (const FrameFigures& frame : frames) {
    name_width = std::max(name_width, frame.name.size());
  }
  out << "\nframe  " << std::left << std::setw(name_width) << "pose"
      << std::right << "  iterations       ms  volume error  folded"
      << "  crossing pairs  inside  depth mm  stop\n";
  const auto print_counts = [&](const SceneIntersections& counts) {
    out << std::setw(16) << counts.triangle_pairs << std::setw(8)
        << counts.vertices_inside << std::setw(10) << std::fixed
        << FixedText(counts.max_depth_mm, 2);
  };
  out << " rest  " << std::setw(name_width) << "" << std::setw(12 + 9 + 14 + 8)
      << "";
  print_counts(run.rest);
  out << "\n";
  for (const FrameFigures& frame : frames) {
    out << std::setw(5) << frame.index << "  " << std::left
        << std::setw(name_width) << frame.name << std::right << std::setw(12)
        << frame.iterations() << std::setw(9) << std::fixed
        << std::setprecision(1) << frame.wall_ms << std::scientific
        << std::setw(14) << frame.WorstVolumeError() << std::setw(8)
        << SumOf(frame.muscles, &MuscleFigures::folded_triangles);
    print_counts(frame.intersections);
    out << "  " << OutcomeOf(frame) << "\n";
  }
  PrintList("not usable", Shortcomings(frames), out);
  const double body_size = run.scene ? run.scene->scene.body_size : 1;
  PrintList("warnings", ShapeWarnings(frames, body_size), out);
  PrintTotals(run, out);
  std::vector<std::string> remedies = RemediesFor(run);
  for (std::string& remedy : remedies) remedy = WithFlags(remedy);
  PrintList("what helps", remedies, out);
}

}  // namespace musclewarp

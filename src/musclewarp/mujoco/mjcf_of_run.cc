// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/mjcf_of_run.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/parallel_for.h"
#include "musclewarp/exchange/fibre_bands.h"
#include "musclewarp/exchange/path_coordinates.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/mujoco/mjcf_slides.h"
#include "musclewarp/mujoco/skin_slides.h"
#include "musclewarp/run/attachments_file.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::MatrixXd;

// How the meshes of a run lie on its model, mm.
struct MeshesOnModel {
  Matrix4d scene_from_ground;
  std::map<int, Matrix4d> body_from_rest;  // of the bodies of the scene
};

MeshesOnModel ReadPlaces(const JsonField& motion, const Model& model) {
  if (!motion.Has("rest")) {
    motion.Fail("does not say how the meshes lie on the model",
                "run musclewarp-deform again: runs of this version say so");
  }
  const JsonField rest = motion.At("rest");
  MeshesOnModel places;
  places.scene_from_ground = rest.At("scene_from_ground").AsRigidTransform();
  const JsonField bodies = rest.At("body_from_rest");
  for (const std::string& name : bodies.Keys()) {
    const int body = model.FindBody(name);
    if (body < 0) {
      bodies.Fail(
          "names the body \"" + name + "\", which is not in " + model.path,
          "check {model}");
    }
    places.body_from_rest[body] = bodies.At(name).AsRigidTransform();
  }
  return places;
}

// At most `most` of the numbers 0 to count - 1, evenly spread.
std::vector<size_t> Spread(size_t count, int most) {
  const auto limit = static_cast<size_t>(most);
  std::vector<size_t> chosen;
  for (size_t i = 0; i < std::min(count, limit); ++i) {
    chosen.push_back(count <= limit ? i : i * count / limit);
  }
  return chosen;
}

// The making of a model, step by step.
class MjcfMaker {
 public:
  MjcfMaker(const std::string& dir,
            const RunPaths& paths,
            const FittedPaths& fitted,
            double max_skin_distance,
            const std::function<void(const std::string&)>& on_progress)
      : paths_(paths),
        fitted_(fitted),
        max_skin_distance_(max_skin_distance),
        model_(paths.model),
        on_progress_(on_progress) {
    const JsonField report = ReadReport(dir);
    places_ = ReadPlaces(report.At("motion"), model_);
    run_ = OutlineOf(dir, report);
    DropMissingFrames(&run_);
    rest_ = ReadRestPose(run_.rest, run_.names);
    for (RecordedFrame& frame : run_.frames) {
      if (!WhyNoSample(frame.figures).empty()) continue;
      if (!WhyDoubtful(frame.figures).empty()) continue;
      values_.push_back(ModelValuesOf(model_, frame.figures, dir));
      frames_.push_back(&frame);
    }
    if (frames_.empty()) {
      throw InputError(dir,
                       "has no usable frame with meshes",
                       "run musclewarp-deform again");
    }
  }

  MjcfModel Make() {
    mjcf_.name = model_.name.empty() ? "musclewarp" : model_.name;
    dynamics_ = DynamicsOf(model_);
    mjcf_.masses = dynamics_.bodies;
    Say("joints");
    mjcf_.tree = MakeMjcfTree(model_, ValuesOver(0), ValuesOver(1));
    AddBones();
    AddMuscles();
    AddSkins();
    return std::move(mjcf_);
  }

 private:
  void Say(const std::string& what) const {
    if (on_progress_) on_progress_(what);
  }

  // The smallest or the largest value of each coordinate in the frames.
  CoordinateValues ValuesOver(int side) const {
    CoordinateValues values = values_[0];
    for (const CoordinateValues& more : values_) {
      for (size_t c = 0; c < values.size(); ++c) {
        values[c] = side == 0 ? std::min(values[c], more[c])
                              : std::max(values[c], more[c]);
      }
    }
    return values;
  }

  void AddBones() {
    const auto attachments = ReadAttachments(
        (std::filesystem::path(run_.dir) / kAttachmentsFile).string());
    for (size_t i = 0; i < run_.names.bones.size(); ++i) {
      const std::string& name = run_.names.bones[i];
      const auto body_name = attachments.bones.find(name);
      const int body = body_name == attachments.bones.end()
                           ? -1
                           : model_.FindBody(body_name->second);
      const auto place = places_.body_from_rest.find(body);
      if (place == places_.body_from_rest.end()) {
        mjcf_.tree.notes.push_back("the bone " + name +
                                   " is on no body of the model, and left out");
        continue;
      }
      mjcf_.bones.push_back({name,
                             body,
                             {Transformed(rest_.bones[i].points, place->second),
                              rest_.bones[i].triangles}});
    }
  }

  // Bodies of the scene that move with those of a path, or between them.
  std::vector<int> BodiesAlong(const std::vector<int>& bodies) const {
    std::vector<int> all(model_.coordinates.size());
    for (size_t c = 0; c < all.size(); ++c) all[c] = static_cast<int>(c);
    const auto crossed = CrossedCoordinates(model_, all, bodies);
    std::vector<int> along;
    for (const auto& item : places_.body_from_rest) {
      std::vector<int> more = bodies;
      more.push_back(item.first);
      if (CrossedCoordinates(model_, all, more) == crossed) {
        along.push_back(item.first);
      }
    }
    return along;
  }

  std::vector<int> BodiesOf(const MeasuredPath& path) const {
    return BodiesOfPath(model_, frames_[0]->figures, path.muscle, path.name);
  }

  // Where a path is in a frame: the line, or the mean of the band of fibres. No
  // points if the frame does not have it.
  static Points PlaceIn(const std::vector<MuscleLines>& lines,
                        const MeasuredPath& path) {
    for (const MuscleLines& muscle : lines) {
      if (muscle.name != path.muscle) continue;
      for (const NamedLine& line : muscle.lines) {
        if (line.name == path.name) return line.points;
      }
      if (!path.fibres.empty()) return MeanFibre(muscle.fibres, path.fibres);
    }
    return Points(0, 3);
  }

  void AddMuscles() {
    const Matrix4d ground_from_scene = RigidInverse(places_.scene_from_ground);
    const std::vector<size_t> chosen = Spread(frames_.size(), kMostPathFrames);
    std::vector<std::vector<MuscleLines>> lines;
    for (const size_t f : chosen) {
      lines.push_back(ReadLinesFile(
          (std::filesystem::path(frames_[f]->folder) / kLinesFile).string()));
    }
    std::vector<MjcfMuscle> muscles(fitted_.paths.size());
    Say("paths of muscles");
    ParallelFor(fitted_.paths.size(), [&](size_t p) {
      const FittedPath& one = fitted_.paths[p];
      const PathFunction& function = one.fit.path;
      std::vector<int> coordinates;
      for (const int k : function.coordinates) {
        coordinates.push_back(model_.FindCoordinate(paths_.coordinates[k]));
      }
      std::vector<SitePosture> postures;
      for (size_t i = 0; i < chosen.size(); ++i) {
        const Points place = PlaceIn(lines[i], *one.path);
        if (place.rows() == 0) continue;
        SitePosture posture;
        posture.values = values_[chosen[i]];
        posture.line = WithPartsBeyond(Transformed(place, ground_from_scene),
                                       one.path->beyond,
                                       model_,
                                       one.path->nearest,
                                       posture.values);
        Eigen::VectorXd at(static_cast<Eigen::Index>(coordinates.size()));
        for (size_t k = 0; k < coordinates.size(); ++k) {
          at[static_cast<Eigen::Index>(k)] = posture.values[coordinates[k]];
        }
        const PathValue value = Evaluate(function, at);
        posture.length = value.length;
        posture.arms = value.arms;
        postures.push_back(std::move(posture));
      }
      muscles[p] = MuscleOf(one, coordinates, postures);
    });
    for (MjcfMuscle& muscle : muscles) {
      if (muscle.path.sites.empty()) {
        mjcf_.tree.notes.push_back("the path " + muscle.name +
                                   " has no line or bodies, and no tendon");
      } else {
        mjcf_.muscles.push_back(std::move(muscle));
      }
    }
  }

  MjcfMuscle MuscleOf(const FittedPath& one,
                      const std::vector<int>& coordinates,
                      const std::vector<SitePosture>& postures) const {
    MjcfMuscle muscle;
    muscle.name = one.path->name;
    muscle.force = ForceOf(*one.path, dynamics_);
    if (postures.empty()) return muscle;
    std::vector<int> bodies = BodiesAlong(BodiesOf(*one.path));
    if (bodies.empty()) return muscle;
    muscle.path = FitSites(model_, bodies, coordinates, postures);
    muscle.length_range = {postures[0].length, postures[0].length};
    for (const SitePosture& posture : postures) {
      muscle.length_range[0] = std::min(muscle.length_range[0], posture.length);
      muscle.length_range[1] = std::max(muscle.length_range[1], posture.length);
    }
    return muscle;
  }

  void AddSkins() {
    const std::vector<size_t> chosen = Spread(frames_.size(), kMostSkinFrames);
    std::vector<std::vector<Points>> points(run_.names.muscles.size());
    for (const size_t f : chosen) {
      RecordedPose pose = ReadPose(frames_[f]->folder, run_.names, rest_);
      for (size_t m = 0; m < points.size(); ++m) {
        points[m].push_back(std::move(pose.muscles[m].points));
      }
    }
    std::vector<std::vector<Matrix4d>> ground_from_body;
    for (const size_t f : chosen) {
      ground_from_body.push_back(BodyFrames(model_, values_[f]));
    }
    const std::vector<int> drivers = Drivers();
    const MatrixXd values = ValuesIn(chosen, drivers);
    for (size_t m = 0; m < points.size(); ++m) {
      const std::string& name = run_.names.muscles[m];
      Say("skin of " + name);
      MjcfSkin skin;
      skin.name = name;
      const std::vector<int> bodies = BodiesOfSkin(name);
      if (bodies.empty()) {
        mjcf_.tree.notes.push_back(
            "the muscle " + name +
            " is on no body of the model, and has no skin");
        continue;
      }
      std::vector<std::vector<Matrix4d>> motions;
      for (const auto& frames : ground_from_body) {
        std::vector<Matrix4d>& of_bones = motions.emplace_back();
        for (const int body : bodies) {
          of_bones.push_back(places_.scene_from_ground * frames[body] *
                             places_.body_from_rest.at(body));
        }
      }
      for (const int body : bodies) {
        skin.bones.push_back({model_.bodies[body].name,
                              RigidInverse(places_.body_from_rest.at(body))});
      }
      skin.skin = FitSkin(rest_.muscles[m].points, points[m], motions);
      skin.triangles = rest_.muscles[m].triangles;
      const SkinSlides slides =
          FitSlides(skin.skin, points[m], motions, values, max_skin_distance_);
      if (slides.bone >= 0) {
        const int body = bodies[slides.bone];
        AddSlides(slides,
                  CoordinatesOf(drivers),
                  body,
                  places_.body_from_rest.at(body),
                  &mjcf_.tree,
                  &skin);
      }
      mjcf_.skins.push_back(std::move(skin));
    }
  }

  // The coordinates that joints of the model have and moment arms are about:
  // they follow no other.
  std::vector<int> Drivers() const {
    std::vector<int> drivers;
    for (const std::string& name : paths_.coordinates) {
      const int coordinate = model_.FindCoordinate(name);
      if (coordinate >= 0) drivers.push_back(coordinate);
    }
    return drivers;
  }

  std::vector<Coordinate> CoordinatesOf(const std::vector<int>& indices) const {
    std::vector<Coordinate> coordinates;
    for (const int c : indices) coordinates.push_back(model_.coordinates[c]);
    return coordinates;
  }

  // The values of coordinates in frames, a row each.
  MatrixXd ValuesIn(const std::vector<size_t>& frames,
                    const std::vector<int>& coordinates) const {
    MatrixXd values(frames.size(), coordinates.size());
    for (size_t i = 0; i < frames.size(); ++i) {
      for (size_t c = 0; c < coordinates.size(); ++c) {
        values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(c)) =
            values_[frames[i]][coordinates[c]];
      }
    }
    return values;
  }

  // Those to which the muscle is attached, or to which its lines go on beyond
  // it.
  std::vector<int> BodiesOfSkin(const std::string& muscle) const {
    std::vector<int> ends =
        BodiesOfPath(model_, frames_[0]->figures, muscle, "");
    for (const MeasuredPath& path : paths_.paths) {
      if (path.muscle != muscle || path.beyond.length == 0) continue;
      const std::vector<int> more = BodiesOf(path);
      ends.insert(ends.end(), more.begin(), more.end());
    }
    std::vector<int> bodies = BodiesAlong(ends);
    if (bodies.size() > kMostSkinBones) bodies.resize(kMostSkinBones);
    return bodies;
  }

  const RunPaths& paths_;
  const FittedPaths& fitted_;
  const double max_skin_distance_;
  const Model& model_;
  const std::function<void(const std::string&)>& on_progress_;
  ModelDynamics dynamics_;
  MeshesOnModel places_;
  RunOutline run_;
  RecordedPose rest_;
  std::vector<const RecordedFrame*> frames_;  // that count
  std::vector<CoordinateValues> values_;      // of the model, in them
  MjcfModel mjcf_;
};

}  // namespace

MjcfModel MjcfOfRun(
    const std::string& dir,
    const RunPaths& paths,
    const FittedPaths& fitted,
    double max_skin_distance,
    const std::function<void(const std::string&)>& on_progress) {
  return MjcfMaker(dir, paths, fitted, max_skin_distance, on_progress).Make();
}

}  // namespace musclewarp

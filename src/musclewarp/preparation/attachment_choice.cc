// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/attachment_choice.h"

#include <algorithm>
#include <sstream>

#include "musclewarp/base/text.h"
#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/continued_lines.h"
#include "musclewarp/scene/leaving_lines.h"
#include "musclewarp/skeleton/covered_part.h"

namespace musclewarp {
namespace {

// A line continues beyond the tip of its muscle if the part beyond it is longer
// than this share of the part that the muscle covers.
constexpr double kBeyondShare = 0.1;

// Returns true if a line goes on along a tendon without a mesh at the end of
// the muscle at which an area lies, wherever that area was found: a muscle does
// not end beside its tendon.
bool GoesOnBare(const ActionLine& line, const Points& area) {
  const CoveredPart part = PartAlong(line.rest, area);
  const bool is_at_begin =
      part.begin + part.end < line.bare_begin + part.length - line.bare_end;
  return (is_at_begin ? line.bare_begin : line.bare_end) > 0;
}

// Returns true if a line continues beyond the tip of a muscle (#P x 3), to the
// structure on which the muscle pulls.
bool GoesOnBeyond(const ActionLine& line,
                  const Points& tip,
                  const Points& muscle) {
  const CoveredPart part = PartAlong(line.rest, muscle);
  const CoveredPart at_tip = PartAlong(line.rest, tip);
  const double beyond = kBeyondShare * (part.end - part.begin);
  if (at_tip.begin + at_tip.end < part.begin + part.end) {
    return part.begin > beyond;
  }
  return part.length - part.end > beyond;
}

// Returns the detected attachments to bodies. A tip without a bone is omitted
// if it lies on another soft part, or if a line of the muscle continues beyond
// it, and any area where a tendon has no mesh.
std::vector<Attachment> HeldAreas(
    const std::vector<FoundAttachment>& found,
    const std::vector<ActionLine>& lines,
    const Points& muscle,
    const std::vector<const TriangleBvh*>& soft_parts) {
  std::vector<Attachment> held;
  for (const FoundAttachment& area : found) {
    const Points& tip = area.attachment.points;
    const bool is_at_tendon =
        std::any_of(lines.begin(), lines.end(), [&](const ActionLine& line) {
          return GoesOnBare(line, tip);
        });
    const bool is_soft =
        !area.is_on_bones &&
        (LiesOnSoftPart(tip, soft_parts) ||
         std::any_of(lines.begin(), lines.end(), [&](const ActionLine& line) {
           return GoesOnBeyond(line, tip, muscle);
         }));
    if (!is_soft && !is_at_tendon) held.push_back(area.attachment);
  }
  return held;
}

}  // namespace

std::vector<Attachment> ChooseAttachments(
    AttachmentKind kind,
    const SceneMuscle& muscle,
    const std::vector<ScenePose>& poses,
    const TriangleSoup& fine,
    const std::vector<FoundAttachment>& found,
    const std::vector<BodySurface>& bodies,
    const std::vector<const TriangleBvh*>& soft_parts,
    double body_size,
    std::vector<std::string>* warnings) {
  warnings->clear();
  const bool finds =
      kind == AttachmentKind::kAuto && muscle.attachments.empty();
  std::vector<Attachment> attachments =
      finds ? HeldAreas(found, muscle.lines, fine.points, soft_parts)
            : muscle.attachments;
  for (Attachment& attachment : attachments) {
    if (!attachment.is_outline) continue;
    attachment = FilledOutline(attachment, fine, bodies);
  }
  const auto is_dropped = [&](const Attachment& attachment) {
    const auto leaving = FindLeavingLine(muscle.lines, attachment, poses);
    if (!leaving) return false;
    std::ostringstream text;
    text << "line " << leaving->line << " of muscle " << muscle.name
         << " leaves " << attachment.body << ", to which the muscle is attached"
         << " where the line ends, by "
         << LengthText(leaving->distance, body_size) << " in pose "
         << leaving->pose
         << (finds ? "; the muscle follows the line there" : "");
    warnings->push_back(text.str());
    return finds;
  };
  attachments.erase(
      std::remove_if(attachments.begin(), attachments.end(), is_dropped),
      attachments.end());
  return attachments;
}

}  // namespace musclewarp

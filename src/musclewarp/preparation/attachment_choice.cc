// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/attachment_choice.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/found_attachments.h"
#include "musclewarp/scene/leaving_lines.h"

namespace musclewarp {

std::vector<Attachment> ChooseAttachments(
    AttachmentKind kind,
    const SceneMuscle& muscle,
    const std::vector<ScenePose>& poses,
    const TriangleSoup& fine,
    const std::vector<BodySurface>& bodies,
    const std::vector<const TriangleBvh*>& soft_parts,
    std::vector<std::string>* warnings) {
  warnings->clear();
  const bool finds =
      kind == AttachmentKind::kAuto && muscle.attachments.empty();
  std::vector<Attachment> attachments =
      finds ? FindAttachments(fine, bodies, soft_parts, muscle.lines)
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
         << " where the line ends, by " << std::round(leaving->distance)
         << " mm in pose " << leaving->pose
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

// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/render/picture.h"

class vtkRenderer;

namespace musclewarp {

// Where the texts below the scenes are, in pixels of the finished picture: a
// row for the captions, and below it the legend in columns of equal width.
struct TextLayout {
  int font_size = 0;
  // The height of the row of captions; 0 if no panel has one.
  int caption_height = 0;
  // The height of the legend; 0 if there is none.
  int legend_height = 0;
  int legend_columns = 0;
  int legend_column_width = 0;
};

// Chooses the layout, by the size of the picture and the longest text of the
// legend. What it leaves of the height is for the panels.
TextLayout LayOutTexts(const std::vector<PicturePanel>& panels,
                       const PictureOptions& options);

// Adds the texts and the colour patches of the legend to a renderer that covers
// the whole picture, which is `options.oversampling` times as large as in the
// end.
void AddTexts(const std::vector<PicturePanel>& panels,
              const PictureOptions& options,
              vtkRenderer* renderer);

}  // namespace musclewarp

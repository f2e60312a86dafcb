// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/render/picture.h"

class vtkRenderer;

namespace musclewarp {

// Where the texts below the scenes go, pixels of the finished picture: a row
// for the captions, and below it the legend in columns of equal width.
struct TextLayout {
  int font_size = 0;
  int caption_height = 0;  // 0 without captions
  int legend_height = 0;   // 0 without legend
  int legend_columns = 0;
  int legend_column_width = 0;
};

TextLayout LayOutTexts(const std::vector<PicturePanel>& panels,
                       const PictureOptions& options);

// Puts the texts and the patches of the legend into a renderer that covers the
// whole picture, `options.oversampling` times as large.
void AddTexts(const std::vector<PicturePanel>& panels,
              const PictureOptions& options,
              vtkRenderer* renderer);

}  // namespace musclewarp

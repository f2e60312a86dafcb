// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/picture_texts.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>

namespace musclewarp {
namespace {

constexpr double kGray = 0.2;

// Adds a text whose baseline starts at (x, baseline), or has its middle there.
void AddText(const std::string& text,
             double x,
             double baseline,
             int font_size,
             bool centered,
             vtkRenderer* renderer) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  vtkTextProperty* property = actor->GetTextProperty();
  property->SetFontSize(font_size);
  property->SetColor(kGray, kGray, kGray);
  if (centered) property->SetJustificationToCentered();
  actor->SetPosition(x, baseline);
  renderer->AddActor2D(actor);
}

void AddPatch(const Color& color,
              double x,
              double y,
              double size,
              vtkRenderer* renderer) {
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, y, 0);
  points->InsertNextPoint(x + size, y, 0);
  points->InsertNextPoint(x + size, y + size, 0);
  points->InsertNextPoint(x, y + size, 0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  vtkNew<vtkPolyData> square;
  square->SetPoints(points);
  square->SetPolys(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(square);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(
      color.r / 255.0, color.g / 255.0, color.b / 255.0);
  renderer->AddActor2D(actor);
}

}  // namespace

TextLayout LayOutTexts(const std::vector<PicturePanel>& panels,
                       const PictureOptions& options) {
  TextLayout layout;
  const int font =
      std::max(9, std::min(options.width / 54, options.height / 40));
  layout.font_size = font;
  for (const PicturePanel& panel : panels) {
    if (!panel.caption.empty()) layout.caption_height = 2 * font;
  }
  if (options.legend.empty()) return layout;
  std::size_t letters = 0;
  for (const LegendEntry& entry : options.legend) {
    letters = std::max(letters, entry.text.size());
  }
  // Letters are about 0.6 times as wide as high; the patch and the gaps take as
  // much room as four letters.
  const int count = static_cast<int>(options.legend.size());
  layout.legend_column_width = static_cast<int>(0.6 * font * (letters + 4));
  layout.legend_columns =
      std::clamp(options.width / layout.legend_column_width, 1, count);
  const int rows = (count + layout.legend_columns - 1) / layout.legend_columns;
  layout.legend_height = (3 * rows + 1) * font / 2;
  return layout;
}

void AddTexts(const std::vector<PicturePanel>& panels,
              const PictureOptions& options,
              vtkRenderer* renderer) {
  const TextLayout layout = LayOutTexts(panels, options);
  const double scale = options.oversampling;
  const double font = scale * layout.font_size;
  const double width = scale * options.width;
  const double legend_height = scale * layout.legend_height;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    if (panels[i].caption.empty()) continue;
    AddText(panels[i].caption,
            (i + 0.5) * width / panels.size(),
            legend_height + 0.6 * font,
            static_cast<int>(font),
            true,
            renderer);
  }
  const double column_width = scale * layout.legend_column_width;
  const double left = (width - layout.legend_columns * column_width) / 2;
  for (std::size_t i = 0; i < options.legend.size(); ++i) {
    const std::size_t row = i / layout.legend_columns;
    const std::size_t column = i % layout.legend_columns;
    const double x = left + column * column_width + 0.5 * font;
    const double y = legend_height - (1.5 * row + 1.25) * font;
    AddPatch(
        options.legend[i].color, x, y - 0.05 * font, 0.85 * font, renderer);
    AddText(options.legend[i].text,
            x + 1.25 * font,
            y,
            static_cast<int>(0.85 * font),
            false,
            renderer);
  }
}

}  // namespace musclewarp

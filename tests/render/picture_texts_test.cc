// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/picture_texts.h"

#include <gtest/gtest.h>

#include <string>

namespace musclewarp {
namespace {

PictureOptions WithLegend(int entries, const std::string& text) {
  PictureOptions options;
  options.legend.assign(entries, {text, {255, 0, 0}});
  return options;
}

TEST(LayOutTexts, WithoutTextsThePanelsHaveAllOfTheHeight) {
  const TextLayout layout = LayOutTexts({{"", {}}, {"", {}}}, {});
  EXPECT_EQ(layout.caption_height, 0);
  EXPECT_EQ(layout.legend_height, 0);
}

TEST(LayOutTexts, OneCaptionMakesRoomForAll) {
  const TextLayout layout = LayOutTexts({{"", {}}, {"flexion", {}}}, {});
  EXPECT_GT(layout.caption_height, layout.font_size);
}

TEST(LayOutTexts, AllEntriesOfTheLegendHaveAPlace) {
  for (const int entries : {1, 2, 7, 40}) {
    const PictureOptions options = WithLegend(entries, "gluteus medius");
    const TextLayout layout = LayOutTexts({{"", {}}}, options);
    ASSERT_GE(layout.legend_columns, 1);
    EXPECT_LE(layout.legend_columns, entries);
    EXPECT_LE(layout.legend_columns * layout.legend_column_width,
              options.width);
    const int rows =
        (entries + layout.legend_columns - 1) / layout.legend_columns;
    EXPECT_GE(layout.legend_height, rows * layout.font_size);
  }
}

TEST(LayOutTexts, LongTextsHaveFewerColumns) {
  const TextLayout narrow = LayOutTexts({{"", {}}}, WithLegend(8, "psoas"));
  const TextLayout wide = LayOutTexts(
      {{"", {}}}, WithLegend(8, "gluteus medius, posterior compartment"));
  EXPECT_GT(narrow.legend_columns, wide.legend_columns);
  EXPECT_GT(wide.legend_height, narrow.legend_height);
}

TEST(LayOutTexts, TextsGrowWithThePicture) {
  PictureOptions large;
  large.width *= 2;
  large.height *= 2;
  EXPECT_EQ(LayOutTexts({}, large).font_size,
            2 * LayOutTexts({}, {}).font_size);
}

}  // namespace
}  // namespace musclewarp

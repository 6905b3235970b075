// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_pictures.h"

#include <gtest/gtest.h>

namespace afx {
namespace {

Picture picture_of(uint32_t width, uint32_t height, uint32_t components,
                   std::vector<uint8_t> samples) {
  Picture picture(width, height, components);
  picture.samples = std::move(samples);
  return picture;
}

using Samples = std::vector<uint8_t>;

TEST(MeshPictures, AreTintedInLinearLight) {
  // sRGB 188 is 0.5029 in linear light; a half of that is 0.2514, which is sRGB 137.3 / 255. A
  // quarter of white is 136.96 / 255.
  const Picture grey = tinted(picture_of(2, 1, 1, {188, 255}), {0.5F, 0.25F, 1}, true);
  EXPECT_EQ(grey.components, 3U);
  EXPECT_EQ(grey.samples, (Samples{137, 99, 188, 188, 137, 255}));
}

TEST(MeshPictures, KeepAlphaWhereItIsAskedFor) {
  const Picture rgba = picture_of(1, 1, 4, {10, 20, 30, 40});
  EXPECT_EQ(tinted(rgba, {1, 1, 1}, true).samples, (Samples{10, 20, 30, 40}));
  EXPECT_EQ(tinted(rgba, {1, 1, 1}, false).samples, (Samples{10, 20, 30}));
  EXPECT_EQ(tinted(picture_of(1, 1, 2, {10, 40}), {1, 0, 1}, true).samples,
            (Samples{10, 0, 10, 40}));
}

TEST(MeshPictures, HaveTheirMirrorImageAtTheRightAndAbove) {
  const Picture picture = picture_of(3, 2, 1, {1, 2, 3, 4, 5, 6});
  const Picture u = with_mirror_image(picture, true, false);
  EXPECT_EQ(u.width, 6U);
  EXPECT_EQ(u.samples, (Samples{1, 2, 3, 3, 2, 1, 4, 5, 6, 6, 5, 4}));
  const Picture v = with_mirror_image(picture, false, true);
  EXPECT_EQ(v.height, 4U);
  EXPECT_EQ(v.samples, (Samples{4, 5, 6, 1, 2, 3, 1, 2, 3, 4, 5, 6}));
  const Picture both = with_mirror_image(picture_of(1, 1, 3, {7, 8, 9}), true, true);
  EXPECT_EQ(both.samples, (Samples{7, 8, 9, 7, 8, 9, 7, 8, 9, 7, 8, 9}));
}

}  // namespace
}  // namespace afx

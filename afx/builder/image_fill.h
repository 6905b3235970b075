// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <vector>

#include "afx/picture.h"

namespace afx {

/// Which coder a picture is meant for.
enum class ImageCoder : uint8_t {
  jpeg,  ///< by cosine transform of blocks of 8 x 8 pixels
  png    ///< by differences of neighbouring pixels
};

/// Gives the pixels that nothing uses colours that cost an image coder least, without foreign ones:
/// coarser levels of an octree may look there.
///
/// For JPEG what a block's free pixels show is made from its used ones alone. They are such that
/// the block has few coefficients: the small ones of its cosine transform are taken away, the used
/// pixels put back, again and again. Blocks without used pixels have one colour: the mean of the
/// blocks around that have some, and where there are none that of the block before.
/// Source: projection onto convex sets, after Papoulis and Gerchberg.
///
/// For PNG a free pixel repeats the one before it in its row, at the beginning of a row the first
/// used one; rows without used pixels repeat the row above, at the top the first with used ones.
///
/// picture   any number of components; blocks begin at the left and the top
/// used      one for each pixel, row by row; those stay as they are. All false: the picture becomes
///           mid grey
void fill_unused(Picture& picture, const std::vector<bool>& used, ImageCoder coder);

}  // namespace afx

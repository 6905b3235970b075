// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <vector>

#include "afx/picture.h"

namespace afx {

/// Gives the pixels that nothing uses colours that cost an image coder least; JPEG is thought of,
/// and its blocks of 8 x 8 pixels. No foreign colour bleeds into used pixels: what a block's free
/// pixels show is made from its used ones alone.
///
/// Free pixels of a block that has used ones are such that the block has few coefficients: the
/// small ones of its cosine transform are taken away, the used pixels put back, again and again.
/// Blocks without used pixels have one colour: the mean of the blocks around that have some, which
/// is what coarser levels of an octree may see of them, and where there are none that of the block
/// before, so that differences of blocks or neighbours, which coders code, are zero.
/// Source: projection onto convex sets, after Papoulis and Gerchberg.
///
/// picture   any number of components; its blocks begin at the left and the top
/// used      one for each pixel, row by row; those stay as they are. All false: the picture becomes
///           mid grey
void fill_unused(Picture& picture, const std::vector<bool>& used);

}  // namespace afx

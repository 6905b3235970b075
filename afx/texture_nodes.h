// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The pictures that texture nodes hold or name.
#pragma once

#include "afx/picture.h"
#include "afx/scene_files.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/field_value.h"
#include "nodes/node_view.h"

namespace afx {

/// The picture of a PixelTexture or ImageTexture, 8 bits a sample.
///
/// texture   may be a view of nothing
/// Errors    bad_argument: there is no texture node; unsupported: another type of node, e.g.
///           MovieTexture; those of open_url and decode_picture. limit_exceeded is worth being
///           passed on, the others may be warnings where the picture can be done without
Result<Picture> load_texture(const nodes::NodeView& texture, const UrlBase& base,
                             const Limits& limits);

/// The same with its samples as they are stored, 1 to 16 bits: for depths.
/// Errors  as load_texture; unsupported also: a picture in floating point
Result<DeepPicture> load_deep_texture(const nodes::NodeView& texture, const UrlBase& base,
                                      const Limits& limits);

/// The picture of a PixelTexture; SFImage has the bottom row first, Picture the top row.
Picture picture_of(const nodes::Image& image);

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "afx/picture.h"

namespace afx {

/// What the alpha of a texture is good for.
enum class AlphaRule : uint8_t {
  ignore,   ///< the material says that it is opaque
  as_is,    ///< the material says that alpha counts
  if_mixed  ///< the file does not say: if it looks as made to cut holes (has_mixed_alpha())
};

/// Whether some of the alpha is below one half and some is not. Alpha that is all the same, or
/// grows from the middle up, is there for something else, or for nothing.
bool has_mixed_alpha(const Picture& picture);

/// The picture with its alpha where that counts and says something, otherwise without.
Picture with_alpha_by_rule(Picture picture, AlphaRule rule);

/// The colours of one picture with the alpha that another shows: its own where that is mixed, or
/// else the mean of its colours. Of the size of the colours, or of the opacity where there are none
/// (an empty picture): then white.
Picture with_opacity(const Picture& colours, const Picture& opacity);

}  // namespace afx

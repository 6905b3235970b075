// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What OwnDecoder answers, by the kind of the stream.
#pragma once

#include "conformance/decoder.h"
#include "tools/input.h"

namespace afx::tools {

/// An answer that rejects the stream or, where the code is about us and not about it, has failed.
conformance::Answer answer_of_error(const Error& error);

/// Of an OctreeImage stream: octree, stream.
conformance::Answer answer_octree(const conformance::Question& question, const Input& input,
                                  const Limits& limits, Diagnostics& diagnostics);
/// Of a scene of any kind: commands, tracks, stream.
conformance::Answer answer_scene(const conformance::Question& question, const Input& input,
                                 const Limits& limits, Diagnostics& diagnostics);
/// Of a scene of any kind: image.
conformance::Answer answer_image(const conformance::Question& question, Input input,
                                 const Limits& limits, Diagnostics& diagnostics);

}  // namespace afx::tools

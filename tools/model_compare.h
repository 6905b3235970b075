// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// How far apart two models are, whatever they are made of.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "tools/input.h"
#include "tools/session.h"

namespace afx::tools {

/// What is measured.
struct ModelCompareOptions {
  unsigned views = 8;      ///< of the ring of pictures; 0: none
  uint32_t size = 512;     ///< width and height of these
  size_t points = 500000;  ///< that a mesh is sampled at
  std::string shade = "auto";
};

/// The distances of two models. Lengths in parts of the longest side of A.
struct ModelDistance {
  nlohmann::ordered_json json;
  std::vector<std::string> lines;  ///< for people
};

/// Compares model B with A, the reference: points of both (D1, D2, colours of matching points) and
/// pictures of both from a ring of views.
/// query     for a raw octree and for a stream of several frames
/// Errors    those of reading and drawing, with the file
/// Warnings  those of reading
Result<ModelDistance> compare_models(const Input& a, const Input& b,
                                     const ModelCompareOptions& options, OctreeQuery& query,
                                     const Session& session, Diagnostics (&diagnostics)[2]);

}  // namespace afx::tools

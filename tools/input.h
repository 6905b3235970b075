// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the commands read: files told by their content, and the OctreeImages in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "afx/file.h"
#include "afx/octree_image.h"
#include "afx/octree_model.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::tools {

enum class Kind {
  scene_text,     ///< .wrl .bt
  octree_stream,  ///< .afx
  raw_octree,     ///< .oct
  picture,        ///< .png .jpg ...
  model,          ///< meshes and point clouds, by their ending
  not_yet,        ///< .mp4 .bifs .xmt .json: promised, but not in this version
  unknown
};

/// The name of a kind as --format and --input-format have it: "wrl", "afx", "oct", ...; unknown:
/// unknown.
Kind kind_of_format(const std::string& format);
/// By the ending of a file name.
Kind kind_of_ending(const std::string& path);
const char* describe(Kind kind);

/// The error for a file of a kind that this version cannot read or write yet; its exit code is
/// kFailed.
Error not_in_this_version(const std::string& path);

/// An opened input.
struct Input {
  std::string path;  ///< as given; "-" = standard input
  Kind kind = Kind::unknown;
  MappedFile file;

  [[nodiscard]] std::string folder() const;  ///< what urls in it are relative to
};

/// Opens a file and tells its kind: --input-format if given, .oct by the ending, else the content,
/// else the ending. Where content and ending disagree, content wins (warning wrong_ending). Errors
/// as MappedFile::open; malformed: nothing tells what it is
Result<Input> open_input(const std::string& path, const std::string& input_format,
                         const Limits& limits, Diagnostics& diagnostics);

/// Reads the scene text of an input. Errors as read_scene_text.
Result<nodes::Scene> read_scene(const Input& input, const Limits& limits, Diagnostics& diagnostics);

/// What an input of octrees is asked for.
struct OctreeQuery {
  std::string node;                    ///< DEF name of the OctreeImage; empty: the only one
  std::optional<uint32_t> resolution;  ///< of a raw octree
  std::optional<uint32_t> frame;       ///< of a stream
  bool missing_is_usage = false;  ///< set where `node`, `resolution` or `frame` is what is wrong
};

/// Picks the OctreeImage that `query` asks for.
/// Errors  malformed: none or several (the text lists them); bad_argument: no node of that name
Result<nodes::NodeView> pick_octree_image(const nodes::Scene& scene, OctreeQuery& query);

/// Reads the coded fields of one OctreeImage from a scene, raw octree or stream (several frames:
/// query.frame).
Result<OctreeNode> read_octree(const Input& input, OctreeQuery& query, const Limits& limits,
                               Diagnostics& diagnostics);

}  // namespace afx::tools

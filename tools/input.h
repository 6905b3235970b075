// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the commands read: files told by their content, and the OctreeImages in them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "afx/file.h"
#include "afx/octree_image.h"
#include "afx/octree_model.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "tools/formats.h"

namespace afx::tools {

/// An opened input.
struct Input {
  std::string path;  ///< as given; "-" = standard input
  Kind kind = Kind::unknown;
  MappedFile file;

  [[nodiscard]] std::string folder() const;  ///< what urls in it are relative to
};

/// The error with the file that it is about, if it names none.
Error in_file(Error error, const std::string& file);

/// An opened file with its kind: by its content, else by its ending; it may be unknown. Warnings
/// wrong_ending: they disagree
Input input_of(const std::string& path, MappedFile file, Diagnostics& diagnostics);

/// Opens a file and tells its kind: --input-format if given, .oct by the ending, else the content,
/// else the ending. Where content and ending disagree, content wins (warning wrong_ending). Errors
/// as MappedFile::open; malformed: nothing tells what it is
Result<Input> open_input(const std::string& path, const std::string& input_format,
                         const Limits& limits, Diagnostics& diagnostics);

/// The same where meshes and points are read too: what nothing tells the kind of is taken for one,
/// because their readers know more endings. Not so for standard input.
Result<Input> open_model_input(const std::string& path, const std::string& input_format,
                               const Limits& limits, Diagnostics& diagnostics);

/// What an input of octrees is asked for.
struct OctreeQuery {
  std::string node;                    ///< DEF name of the OctreeImage; empty: the only one
  std::optional<uint32_t> resolution;  ///< of a raw octree
  std::optional<uint32_t> frame;       ///< of a stream
  bool missing_is_usage = false;  ///< set where `node`, `resolution` or `frame` is what is wrong
};

/// A sentence about an option of `query` that none of these inputs can use; empty: there is none.
std::string useless_option(const OctreeQuery& query, std::span<const Kind> inputs);

/// What the first bytes of a file tell of its kind; else unknown.
Kind kind_of_content(std::span<const uint8_t> bytes);

/// Picks the OctreeImage that `query` asks for.
/// Errors  malformed: none or several (the text lists them); bad_argument: no node of that name
Result<nodes::NodeView> pick_octree_image(const nodes::Scene& scene, OctreeQuery& query);

/// Reads the coded fields of one OctreeImage from a scene of any kind, raw octree or stream
/// (several frames: query.frame).
Result<OctreeNode> read_octree(const Input& input, OctreeQuery& query, const Limits& limits,
                               Diagnostics& diagnostics);

}  // namespace afx::tools

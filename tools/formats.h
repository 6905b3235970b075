// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The kinds of files, and how names, --format and --input-format tell them.
#pragma once

#include <span>
#include <string>

#include "codec/error.h"

namespace afx::tools {

class Session;

enum class Kind {
  scene_text,     ///< .wrl .bt
  scene_xml,      ///< .xmt
  mp4,            ///< .mp4
  raw_bifs,       ///< .bifs
  json,           ///< .json: decoded BIFS
  octree_stream,  ///< .afx
  raw_octree,     ///< .oct
  picture,        ///< .png .jpg ...
  model,          ///< meshes and point clouds, by their ending
  unknown
};

/// The kind that a format's name stands for, in any case: "wrl", "afx", "oct", ...; else unknown.
Kind kind_of_format(const std::string& format);
/// The ending of a file name in small letters, without its dot; empty where there is none.
std::string ending_of(const std::string& path);
/// By the ending of a file name.
Kind kind_of_ending(const std::string& path);
const char* describe(Kind kind);

/// Whether it is a scene as text: scene_text, scene_xml.
bool is_text_scene(Kind kind);
/// Whether it is a scene as a stream: mp4, raw_bifs.
bool is_coded_scene(Kind kind);
/// Either.
bool is_scene(Kind kind);

/// Tells what an output is to be: its name's ending, or --format (`option`) where the name is "-"
/// or has no ending that is known. Anything else, and a --format that the ending denies, is
/// reported.
///
/// names    the formats that the command writes, e.g. "wrl", "bt"
/// format   receives the one of `names` that it is
/// Returns  an exit code: kDone or kUsage
int output_format(const Session& session, const std::string& path, const std::string& option,
                  std::span<const char* const> names, std::string& format);

/// Checks the value of --input-format ("" = not given): it must be of the kind of one of `names`.
/// Returns  as output_format
int check_input_format(const Session& session, const std::string& option,
                       std::span<const char* const> names);

}  // namespace afx::tools

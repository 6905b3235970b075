// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/scene.h"

namespace afx::nodes {

struct SceneReadOptions {
  /// Gives the bytes of a file that the text names ("file:name" in BitWrapper.buffer). Empty: such
  /// a text is an error (unsupported).
  std::function<Result<std::string>(std::string_view name)> load_file;
  /// Read strings as GPAC does: two backslashes stay two. (VRML97: they are one.)
  bool like_gpac = false;
  /// Hears, about once in a megabyte, that everything before an offset of the text has been read
  /// over: it may be dropped from memory (MappedFile::let_go). It must still be there for reading
  /// again, though that may be slow: lists are counted before they are read, and an error looks
  /// back. So the offset may also go back.
  std::function<void(size_t offset)> passed;
};

/// Reads a scene from text in VRML97 node syntax, as .wrl files and MPEG-4 BT files have it.
///
/// `text` is UTF-8 with or without a header line. Commas are white space, `#` starts a comment.
/// Numbers are decimal, integers and pixels also hexadecimal, floats also inf and nan. TRUE and
/// FALSE may have small letters. A list of one needs no brackets. PROTO interfaces may carry BT's
/// coding parameters, ROUTEs may have DEF names.
///
/// Errors carry line, column and an excerpt with a caret:
///   truncated       the text ends inside something
///   malformed       not as the definitions want it; the nearest known name is offered
///   unsupported     object descriptors and timed commands of BT; `file:` without a load_file;
///                   VRML 1.0; X3D
///   limit_exceeded  limits.scene_depth, scene_values, memory, picture_pixels
///
/// Stricter than VRML97: no node stands inside itself, a Script neither (BIFS cannot code it), and
/// no PROTO has the name of a node, or hides one that its scope has used before.
///
/// Warnings:
///   invalid_utf8    the bytes are kept
///   def_twice       the second node gets a name of its own; USE means the nearest before it, as
///                   VRML97 says
///   is_kind         IS between kinds of fields that do not go together
///
/// Reading is linear in the text. Lists of numbers are counted before they are read, so memory is
/// that of the values and the text. #define, #if and #include of the peer's BT are comments here.
/// Source: ISO/IEC 14772-1:1997 (VRML97); the BT dialect as the peer reads it.
Result<Scene> read_scene_text(std::string_view text, const Limits& limits, Diagnostics& diagnostics,
                              const SceneReadOptions& options = {});

}  // namespace afx::nodes

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The files and streams that a scene names by url.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "afx/file.h"
#include "bifs/media.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/field_value.h"

namespace afx {

/// "%20" as a space and so on; a % that is not followed by two hexadecimal digits stays.
std::string percent_decoded(const std::string& text);

/// The name of a file as an url gives it: "file:" in front is left out.
std::string file_name_of_url(const std::string& text);

/// The streams of a presentation, by the IDs of their object descriptors.
using ObjectStreams = std::map<uint16_t, bifs::Media>;

/// What the urls of a scene lead to. A folder alone will do: a scene without streams.
struct UrlBase {
  std::string folder;                      ///< of the scene's file; empty: the working folder
  const ObjectStreams* streams = nullptr;  ///< what "od:10" names; nullptr: nothing

  UrlBase(std::string folder_name, const ObjectStreams* object_streams = nullptr)
      : folder(std::move(folder_name)), streams(object_streams) {}  // NOLINT: implicit on purpose
};

/// What was opened by url.
struct UrlFile {
  std::string path;  ///< for messages; of a stream "od:10"
  MappedFile file;   ///< of a stream its first sample
  std::string name;  ///< as it was found, relative to the folder; of a stream empty
  const bifs::Media* stream = nullptr;  ///< where it is one: that, in the streams of the UrlBase
};

/// Opens the first of the urls (VRML97: in order of preference) that is there, as a regular file or
/// as a stream. A name is taken relative to the folder as it is written, then with %-codes decoded;
/// "file:" in front is left out.
/// Errors  io: why the last could not be opened; unsupported: an object descriptor without a
/// stream,
///         or another scheme ("http://"); bad_argument: there is no url; malformed: the stream has
///         no samples; those of reading the sample
Result<UrlFile> open_url(std::span<const nodes::Url> urls, const UrlBase& base,
                         const Limits& limits);

}  // namespace afx

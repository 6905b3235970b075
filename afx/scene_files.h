// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The files that a scene names by url.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "afx/file.h"
#include "codec/error.h"
#include "codec/limits.h"
#include "nodes/field_value.h"

namespace afx {

/// "%20" as a space and so on; a % that is not followed by two hexadecimal digits stays.
std::string percent_decoded(const std::string& text);

/// A file that was opened by url.
struct UrlFile {
  std::string path;
  MappedFile file;
};

/// Opens the first of the urls (VRML97: in order of preference) that is there as a regular file.
/// A name is taken relative to `folder` (empty: the working folder) as it is written, then with
/// %-codes decoded; "file:" in front is left out.
/// Errors  io: why the last could not be opened; unsupported: an object descriptor, or another
/// scheme
///         ("http://"); bad_argument: there is no url
Result<UrlFile> open_url(std::span<const nodes::Url> urls, const std::string& folder,
                         const Limits& limits);

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A conformance suite in memory: streams, and what must hold of each. Its form as a file:
// conformance/suites/suite.schema.json, explained in the README beside it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "codec/error.h"

namespace afx::conformance {

/// What a decoder can be asked for.
enum class Form {
  octree,    ///< the fields of an OctreeImage stream
  commands,  ///< the configuration and access units of a scene stream
  tracks,    ///< what an MP4 file carries
  picture,   ///< size and samples
  stream,    ///< the input, decoded and encoded again
  image      ///< the scene, drawn
};
const char* to_string(Form form);
/// Nothing where no form has that name.
std::optional<Form> form_of(std::string_view name);
/// What a stream of a kind (Case::kind) is first of all: octree, picture, else commands.
Form first_form_of(std::string_view kind);

/// An error or warning: its code, and its place as far as one is named.
struct Finding {
  std::string code;
  Place place;
  bool operator==(const Finding&) const = default;
};
/// "malformed at bit 12", "malformed at 3:7", "malformed".
std::string to_string(const Finding& finding);

/// A file of a suite; `path` is relative to the suite's folder and does not leave it.
struct SuiteFile {
  std::string path;
  std::string sha256;
};

/// Numbers that need not be exact: those at or below a JSON pointer in which * stands for any part.
struct Tolerance {
  std::string path;
  double abs = 0;
  std::string reason;
};

struct DecodeCheck {
  Form form = Form::octree;
  SuiteFile expected;
  std::optional<unsigned> levels;                ///< only so many levels of the octree
  bool partial = false;                          ///< of a truncated stream what is whole
  std::optional<std::vector<Finding>> warnings;  ///< exactly these; nothing: they are not judged
  std::vector<Tolerance> tolerances;
};

struct ReencodeCheck {
  std::optional<Form> equal;  ///< compare what it decodes to; nothing: the bytes
};

struct RenderCheck {
  SuiteFile expected;
  unsigned width = 0;
  unsigned height = 0;
  double max_mean = 0;  ///< mean absolute difference, in steps of 1/255
  std::string reason;
};

struct RejectCheck {
  Finding error;
  std::string reason;
};

using Check = std::variant<DecodeCheck, ReencodeCheck, RenderCheck, RejectCheck>;

/// "decode as octree", "decode as octree, 3 levels", "reencode", "render", "reject".
std::string describe(const Check& check);

struct Case {
  std::string name;
  std::string about;
  std::string kind;  ///< "octree", "mp4", "bifs", "bt", "wrl", "xmt", "picture"
  SuiteFile stream;
  std::vector<SuiteFile> beside;
  std::string origin;
  std::vector<std::string> covers;
  std::vector<Check> expect;  ///< at least one
};

struct Origin {
  std::string text;
  std::string licence;
};

struct Suite {
  std::string folder;
  std::string name;
  std::string title;
  std::vector<std::string> rules;  ///< files, relative to the folder
  std::map<std::string, Origin> origins;
  std::vector<Case> cases;
};

/// Reads FOLDER/suite.json. The files that it names are not looked at.
/// Errors  io: it cannot be read; malformed: it is no JSON (with line and column), or not of the
///         form (the text names the JSON pointer and what was expected), a name is there twice, a
///         path leaves the folder, an origin is not in the list
Result<Suite> read_suite(const std::string& folder);
/// The same of the bytes of a suite.json that stands in `folder`.
Result<Suite> parse_suite(std::span<const uint8_t> bytes, const std::string& folder);

}  // namespace afx::conformance

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The cases of a suite of OctreeImage streams in memory, and what holds of a coder: for tests that
// judge a coder many times.
#pragma once

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "codec/plain/octree_plain_stream.h"
#include "conformance/suite.h"
#include "conformance/suite_files.h"

namespace afx::conformance {

using codec::plain::Stream;

struct OctreeCase {
  std::string suite;
  Case info;
  std::vector<uint8_t> data;
  std::vector<Stream> values;  ///< for each check; only those of decode checks have any
};

/// Who is judged.
struct OctreeCoder {
  std::function<Stream(const std::vector<uint8_t>&, unsigned levels)> decode;
  std::function<std::vector<uint8_t>(const Stream&)> encode;
};

inline constexpr unsigned kAllOctreeLevels = 32;

template <class T>
T value_or_throw(Result<T> result) {
  if (!result.ok()) throw std::runtime_error(to_string(result.error()));
  return std::move(result).value();
}

inline Stream values_of(const nlohmann::json& json) {
  Stream values;
  values.resolution = json.at("octreeResolution");
  values.textures = json.at("numOfTextures");
  for (const auto& frame : json.at("frames")) {
    values.frames.push_back({frame.at("octree").get<std::vector<uint8_t>>(),
                             frame.at("voxelImageIndex").get<std::vector<uint8_t>>()});
  }
  return values;
}

/// All cases of conformance/suites/NAME; throws where something is wrong with it.
inline std::vector<OctreeCase> read_octree_cases(const std::string& name) {
  const Suite suite = value_or_throw(read_suite(AFX_SOURCE_DIR "/conformance/suites/" + name));
  std::vector<OctreeCase> cases;
  for (const Case& info : suite.cases) {
    OctreeCase one{name, info, value_or_throw(read_suite_file(suite, info.stream)), {}};
    for (const Check& check : info.expect) {
      const auto* decode = std::get_if<DecodeCheck>(&check);
      one.values.push_back(
          decode == nullptr ? Stream{}
                            : values_of(value_or_throw(read_suite_json(suite, decode->expected))));
    }
    cases.push_back(std::move(one));
  }
  return cases;
}

inline bool is_as_expected(const codec::plain::Finding& found, const Finding& expected) {
  const bool judged = expected.place.kind == Place::Kind::bit;
  return found.code == expected.code && (!judged || found.bit == expected.place.bit);
}

inline bool decodes_to(const Stream& found, const Stream& values, const DecodeCheck& check) {
  if (found.error.has_value() != check.partial) return false;
  if (found.resolution != values.resolution || found.textures != values.textures ||
      found.frames != values.frames)
    return false;
  return !check.warnings ||
         std::equal(found.warnings.begin(), found.warnings.end(), check.warnings->begin(),
                    check.warnings->end(), is_as_expected);
}

/// The first check of a case that does not hold, from 0; nothing: all do.
inline std::optional<size_t> first_failure(const OctreeCase& one, const OctreeCoder& coder) {
  const Stream whole = coder.decode(one.data, kAllOctreeLevels);
  for (size_t i = 0; i < one.info.expect.size(); ++i) {
    const Check& check = one.info.expect[i];
    bool holds = false;
    if (const auto* decode = std::get_if<DecodeCheck>(&check)) {
      holds = decodes_to(decode->levels ? coder.decode(one.data, *decode->levels) : whole,
                         one.values[i], *decode);
    } else if (std::holds_alternative<ReencodeCheck>(check)) {
      holds = !whole.error && coder.encode(whole) == one.data;
    } else if (const auto* reject = std::get_if<RejectCheck>(&check)) {
      holds = whole.error && is_as_expected(*whole.error, reject->error);
    }
    if (!holds) return i;
  }
  return {};
}

}  // namespace afx::conformance

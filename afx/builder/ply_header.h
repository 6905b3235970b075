// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The header of a PLY file. Source: Greg Turk, "The PLY Polygon File Format" (1994), and what
// programs write since: type names with widths (uint8), unknown keywords ignored.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "codec/error.h"

namespace afx {

enum class PlyFormat : uint8_t { ascii, little_endian, big_endian };

enum class PlyType : uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value in binary files.
size_t ply_size(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value, or of each entry of the list
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of the number of entries before a list
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Bytes of one element in binary files, or 0 where lists make them differ.
  [[nodiscard]] size_t stride() const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;  ///< in the order of the file
  size_t size = 0;                   ///< bytes of the header; the data follow
  uint32_t lines = 0;                ///< of the header

  [[nodiscard]] const PlyElement* find(const std::string& name) const;
};

/// Whether the bytes begin like a PLY file.
bool is_ply(std::span<const uint8_t> bytes);

/// Errors  malformed: with the line; truncated: no end_header
Result<PlyHeader> read_ply_header(std::span<const uint8_t> bytes);

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Boxes in memory: the inside of 'moov' and 'moof'. Part of mp4_reader, not for others.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bifs/mp4_movie.h"
#include "bifs/mp4_source.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// The payload of a box.
struct Mp4Part {
  FourCc type = 0;
  std::span<const uint8_t> bytes;
  uint64_t offset = 0;    ///< of the payload in the file
  uint64_t begin = 0;     ///< of the box in the file
  std::string path = {};  ///< "moov/trak[1]/mdia"
};

/// What all parts of the reader share.
struct Mp4Context {
  const Mp4Source& source;
  const Limits& limits;
  Diagnostics& diagnostics;
  const codec::Trace* trace;
  uint64_t memory_left;
  bool fragmented = false;

  /// Takes memory off the limit before it is asked for.
  Status charge(uint64_t amount, const Mp4Part& part);
  void warn(const char* code, const Mp4Part& part, const std::string& text);
};

/// The error of a part: "path: text".
Error mp4_error(Errc code, const Mp4Part& part, uint64_t offset, const std::string& text);

/// Reads the fields of a part one after the other. The first failure sticks, reads after it give 0.
class Mp4Fields {
 public:
  Mp4Fields(const Mp4Part& part, const Mp4Context& context);
  // It keeps a reference: the part must live as long.
  Mp4Fields(Mp4Part&&, const Mp4Context&) = delete;

  uint64_t u(unsigned bytes, const char* name);  ///< big-endian, 1..8 bytes
  uint8_t u8(const char* name) { return static_cast<uint8_t>(u(1, name)); }
  uint16_t u16(const char* name) { return static_cast<uint16_t>(u(2, name)); }
  uint32_t u32(const char* name) { return static_cast<uint32_t>(u(4, name)); }
  int16_t i16(const char* name) { return static_cast<int16_t>(u16(name)); }
  int32_t i32(const char* name) { return static_cast<int32_t>(u32(name)); }

  /// Version and flags of a full box; fails with unsupported where the version is more than `most`.
  struct Version {
    unsigned version;
    uint32_t flags;
  };
  Version version(unsigned most);

  /// A number of elements of which each takes `element_bits`; fails with truncated where the bytes
  /// left cannot hold them. 4 bytes, big-endian.
  uint32_t count(unsigned element_bits, const char* name);

  /// The next bytes, or as many as there are; fails where there are fewer.
  std::span<const uint8_t> bytes(uint64_t count, const char* name);
  void skip(uint64_t count, const char* name) { bytes(count, name); }

  /// The next box inside, nothing at the end or after a failure.
  std::optional<Mp4Part> box();

  void fail(Errc code, const std::string& text);
  [[nodiscard]] bool ok() const { return !error_.has_value(); }
  [[nodiscard]] Status status() const { return error_ ? Status(*error_) : Status(); }
  [[nodiscard]] uint64_t left() const { return part_.bytes.size() - at_; }
  [[nodiscard]] uint64_t offset() const { return part_.offset + at_; }  ///< in the file

 private:
  bool need(uint64_t count, const char* name);

  const Mp4Part& part_;
  const codec::Trace* trace_;
  size_t at_ = 0;
  size_t element_ = 0;  // where the field read last begins
  std::map<FourCc, unsigned> seen_;
  std::optional<Error> error_;
};

/// Keeps a box as it is.
Result<Mp4Box> keep_box(const Mp4Part& part, Mp4Context& context);

/// Inside a box that holds boxes: those looked for, each at most once.
class Mp4Children {
 public:
  /// Sorts the boxes of `part`: those of the types wanted, and the others in order.
  static Result<Mp4Children> read(const Mp4Part& part, std::span<const FourCc> wanted,
                                  Mp4Context& context);

  [[nodiscard]] const Mp4Part* find(FourCc type) const;  ///< null where it is not there
  [[nodiscard]] Result<const Mp4Part*> need(FourCc type) const;
  [[nodiscard]] const std::vector<Mp4Part>& others() const { return others_; }

 private:
  Mp4Part part_;
  std::map<FourCc, Mp4Part> found_;
  std::vector<Mp4Part> others_;
};

}  // namespace afx::bifs

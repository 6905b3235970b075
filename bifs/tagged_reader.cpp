// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/tagged_reader.h"

namespace afx::bifs {

namespace {

constexpr unsigned kMaxLengthBytes = 4;

}  // namespace

TaggedHeader read_tagged_header(codec::BitReader& in, const char* (*name_of)(uint8_t tag),
                                const std::string& prefix, std::string_view container) {
  TaggedHeader header;
  header.tag = static_cast<uint8_t>(in.u(8, "tag"));
  header.name = prefix + name_of(header.tag);
  if (in.ok() && (header.tag == 0 || header.tag == 0xFF))
    in.fail(Errc::malformed,
            header.name + ": the tag is " + std::to_string(header.tag) + ", which is forbidden");
  unsigned count = 0;
  for (bool more = true; more && in.ok(); ++count) {
    more = in.u(1, "nextByte") != 0;
    header.length = header.length << 7 | in.u(7, "sizeOfInstance");
    if (more && count + 1 == kMaxLengthBytes)
      in.fail(Errc::malformed, header.name + ": the length has more than 4 bytes");
  }
  if (in.ok() && header.length > in.bits_left() / 8)
    in.fail(Errc::truncated, header.name + ": ends behind the " + std::string(container) +
                                 " (expected " + std::to_string(header.length) + " bytes, " +
                                 std::to_string(in.bits_left() / 8) + " are left)");
  if (!in.ok()) return header;
  const bool shortest = count == 1 || header.length >> (7 * (count - 1)) != 0;
  header.length_bytes = static_cast<uint8_t>(shortest ? 0 : count);
  return header;
}

}  // namespace afx::bifs

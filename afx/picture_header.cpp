// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/picture_header.h"

#include <algorithm>
#include <string>

#include "bifs/descriptor.h"
#include "bifs/mp4_movie.h"

namespace afx {
namespace {

using bifs::fourcc;
namespace object_type = bifs::object_type;
using Bytes = std::span<const uint8_t>;

constexpr uint8_t kPngSignature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr uint8_t kJpegSignature[] = {0xFF, 0xD8, 0xFF};
constexpr uint8_t kJp2Signature[] = {0, 0, 0, 12, 'j', 'P', ' ', ' ', '\r', '\n', 0x87, '\n'};

bool begins_with(Bytes bytes, Bytes signature) {
  return bytes.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), bytes.begin());
}

/// `count` bytes, most significant first; they are there.
uint64_t number_at(Bytes bytes, uint64_t at, unsigned count) {
  uint64_t value = 0;
  for (unsigned i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
  return value;
}

uint32_t u16_at(Bytes bytes, uint64_t at) { return static_cast<uint32_t>(number_at(bytes, at, 2)); }
uint32_t u32_at(Bytes bytes, uint64_t at) { return static_cast<uint32_t>(number_at(bytes, at, 4)); }

Error error_at(uint64_t byte, Errc code, std::string text) {
  return {code, Place::at_byte(byte), std::move(text)};
}

Error ends_early(Bytes bytes, const char* kind) {
  return error_at(bytes.size(), Errc::truncated,
                  std::string("the ") + kind + " ends before it says its size");
}

Result<PictureHeader> checked(const PictureHeader& header, uint64_t byte) {
  if (header.width == 0 || header.height == 0) {
    return error_at(byte, Errc::malformed,
                    "the picture has the size " + std::to_string(header.width) + " x " +
                        std::to_string(header.height) + " (expected 1 or more)");
  }
  return header;
}

Result<PictureHeader> read_png(Bytes bytes) {
  constexpr size_t kChunk = sizeof kPngSignature;
  if (bytes.size() < kChunk + 16) return ends_early(bytes, "PNG");
  if (u32_at(bytes, kChunk + 4) != fourcc("IHDR"))
    return error_at(kChunk, Errc::malformed, "the first chunk of the PNG is not IHDR");
  return checked({object_type::kPng, u32_at(bytes, kChunk + 8), u32_at(bytes, kChunk + 12)},
                 kChunk + 8);
}

/// SOF0 to SOF15: what lies between them has other meanings.
bool is_frame_header(uint8_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

Result<PictureHeader> read_frame_header(Bytes bytes, uint64_t at) {
  if (bytes.size() < at + 7) return ends_early(bytes, "JPEG");
  const uint32_t height = u16_at(bytes, at + 3);
  if (height == 0)
    return error_at(at + 3, Errc::unsupported,
                    "the JPEG says its height only after its first scan");
  return checked({object_type::kJpeg, u16_at(bytes, at + 5), height}, at + 3);
}

/// Segment after segment up to the frame header.
Result<PictureHeader> read_jpeg(Bytes bytes) {
  uint64_t at = 2;
  while (at + 4 <= bytes.size()) {
    if (bytes[at] != 0xFF) return error_at(at, Errc::malformed, "no marker in the JPEG here");
    const uint8_t marker = bytes[at + 1];
    if (marker == 0xFF || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {
      at += marker == 0xFF ? 1 : 2;  // filling; a marker without a segment
      continue;
    }
    if (marker == 0xD9 || marker == 0xDA)
      return error_at(at, Errc::malformed, "the JPEG has no frame header before its first scan");
    if (is_frame_header(marker)) return read_frame_header(bytes, at + 2);
    const uint32_t length = u16_at(bytes, at + 2);
    if (length < 2) return error_at(at + 2, Errc::malformed, "a segment of the JPEG is too short");
    at += 2 + length;
  }
  return ends_early(bytes, "JPEG");
}

/// Box after box, into 'jp2h', up to 'ihdr'.
Result<PictureHeader> read_jp2(Bytes bytes) {
  uint64_t at = sizeof kJp2Signature;
  while (bytes.size() - at >= 16) {
    const uint32_t type = u32_at(bytes, at + 4);
    uint64_t length = u32_at(bytes, at);
    const unsigned head = length == 1 ? 16 : 8;
    if (length == 1) length = number_at(bytes, at + 8, 8);
    if (length == 0) length = bytes.size() - at;
    if (length < head) return error_at(at, Errc::malformed, "a box of the JP2 is too short");
    if (type == fourcc("ihdr")) {
      if (bytes.size() - at < head + 8) break;
      return checked(
          {object_type::kJpeg2000, u32_at(bytes, at + head + 4), u32_at(bytes, at + head)},
          at + head);
    }
    const uint64_t step = type == fourcc("jp2h") ? head : length;
    if (step > bytes.size() - at) break;
    at += step;
  }
  return ends_early(bytes, "JP2");
}

}  // namespace

uint8_t still_picture_type(std::span<const uint8_t> bytes) {
  if (begins_with(bytes, kPngSignature)) return object_type::kPng;
  if (begins_with(bytes, kJpegSignature)) return object_type::kJpeg;
  if (begins_with(bytes, kJp2Signature)) return object_type::kJpeg2000;
  return 0;
}

Result<PictureHeader> read_picture_header(std::span<const uint8_t> bytes) {
  switch (still_picture_type(bytes)) {
    case object_type::kPng:
      return read_png(bytes);
    case object_type::kJpeg:
      return read_jpeg(bytes);
    case object_type::kJpeg2000:
      return read_jp2(bytes);
    default:
      return error_at(0, Errc::unsupported,
                      "is not a picture of a kind that is known here (expected PNG, JPEG or JP2)");
  }
}

}  // namespace afx

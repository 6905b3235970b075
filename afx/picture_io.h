// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Pictures from and to files. OpenImageIO does the work, in a module (afx_pictures.so) that is
// loaded when the first picture is read or written; a process that needs no picture pays nothing.
//
// The module is looked for in the folder that AFX_MODULE_DIR names, then in ../lib/afx beside the
// folder of the program, in afx beside this library, and where it was installed. All functions here
// fail with not_available, naming these places, where it is not found. They may be called from
// several threads at once.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "afx/picture.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// Reads a picture; the content tells its format: PNG, JPEG, TIFF, BMP, GIF, WebP, PSD, DDS, PNM,
/// OpenEXR, Radiance HDR, JPEG 2000; TGA, which has no mark of its own, by its ending. Samples are
/// as stored: no colour conversion, nothing premultiplied; 16 bits are rounded to 8, and pictures
/// in floating point, which hold linear light, are converted to sRGB (and those of OpenEXR, which
/// are premultiplied, divided by their alpha). Channels after the fourth are left out. Errors  io:
/// the file cannot be read; unsupported: no picture format known here;
///         malformed or truncated: as the format's reader says; limit_exceeded: more than
///         limits.picture_pixels, or limits.memory bytes; not_available
Result<Picture> read_picture(const std::string& path, const Limits& limits = {});

/// The same from memory. name   only for messages and for the ending of TGA
Result<Picture> decode_picture(std::span<const uint8_t> bytes, const std::string& name = {},
                               const Limits& limits = {});

/// Reads a picture with its samples exactly as stored: 1 to 8 bits a sample or 16,
/// DeepPicture::bits says which. (Grey PNG of 1, 2 or 4 bits too; of palettes the colours.) Errors
/// as read_picture; unsupported also: floating point
Result<DeepPicture> read_deep_picture(const std::string& path, const Limits& limits = {});
Result<DeepPicture> decode_deep_picture(std::span<const uint8_t> bytes,
                                        const std::string& name = {}, const Limits& limits = {});

/// Reads a picture of floating point with its samples as stored (OpenEXR, TIFF, Radiance HDR).
/// Errors as read_picture; unsupported also: integers
Result<FloatPicture> decode_float_picture(std::span<const uint8_t> bytes,
                                          const std::string& name = {}, const Limits& limits = {});

/// How a picture is written.
struct PictureOptions {
  int jpeg_quality = 90;    ///< 1..100. Chroma is never subsampled (4:4:4)
  int png_compression = 6;  ///< 0 (none) .. 9
  bool colour = true;       ///< marks PNG as sRGB; false for depths and other data
  /// OpenEXR only: a distance for each pixel, which goes into the channel Z as it is; empty: no Z.
  std::span<const float> depth{};
};

/// A picture as the bytes of a file. The same picture and options give the same bytes; no date, no
/// program name. OpenEXR has linear light, premultiplied, of 16 bits in floating point (which hold
/// all that 8 bits of sRGB tell), and Z of 32, compressed without loss.
/// format   "png", "jpeg" ("jpg"), "bmp", "tga" or "exr"
/// Errors  bad_argument: empty picture, sizes that do not fit, quality out of range, a format that
///         cannot hold the picture (JPEG with alpha) or its depth; unsupported: unknown format;
///         not_available; no_memory
Result<std::vector<uint8_t>> encode_picture(const Picture& picture, std::string_view format,
                                            const PictureOptions& options = {});
/// 16 bits a sample where the picture has more than 8 (not JPEG, not OpenEXR), otherwise 8. Samples
/// as they are.
Result<std::vector<uint8_t>> encode_picture(const DeepPicture& picture, std::string_view format,
                                            const PictureOptions& options = {});

/// The format that a file name's ending stands for, e.g. "x.JPG" -> "jpeg"; empty where it is none
/// of ours.
std::string picture_format_of(std::string_view path);

/// The format that the first bytes tell, e.g. "png"; empty where none of ours.
std::string picture_format_of_content(std::span<const uint8_t> bytes);

/// Encodes by the ending of `path` and writes atomically (see file.h).
/// Errors  as encode_picture and write_file_atomically
Status write_picture(const std::string& path, const Picture& picture,
                     const PictureOptions& options = {}, bool overwrite = false);

}  // namespace afx

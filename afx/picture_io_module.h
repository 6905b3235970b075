// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The boundary between picture_io.cpp and the module afx_pictures.so: plain C data and functions,
// no exception crosses it, nobody frees what the other side allocated.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// Size and kind of a picture's samples: interleaved, rows from the top, without gaps.
struct afx_picture_shape {
  uint32_t width;
  uint32_t height;
  uint32_t components;    ///< 1..4
  uint32_t sample_bytes;  ///< 1 or 2, integers; 4, float; native byte order
};

/// Why something failed. code   0 = nothing, else one of kAfxPicture...
struct afx_picture_error {
  int code;
  char text[512];
};

enum {
  kAfxPictureMalformed = 1,
  kAfxPictureUnsupported = 2,
  kAfxPictureLimit = 3,
  kAfxPictureNoMemory = 4
};

/// Which samples are asked for.
enum {
  kAfxSamplesShown = 0,   ///< 8 bits, linear light becomes sRGB
  kAfxSamplesStored = 1,  ///< as stored, 8 or 16 bits
  kAfxSamplesFloat = 2    ///< as stored, floating point
};

/// Gives memory for `shape`, which the caller of the module owns; null: none to be had.
typedef void* (*afx_picture_allocate)(void* user, const struct afx_picture_shape* shape);
/// Takes the bytes of an encoded picture; called once. Non-zero: could not.
typedef int (*afx_picture_sink)(void* user, const void* bytes, size_t size);

struct afx_picture_read_request {
  const char* format;  ///< e.g. "png"
  const void* bytes;
  size_t size;
  int samples;  ///< one of kAfxSamples...
  uint64_t max_pixels;
  uint64_t max_bytes;
};

struct afx_picture_write_request {
  const char* format;
  struct afx_picture_shape shape;
  const void* samples;
  int jpeg_quality;
  int png_compression;
  int colour;          ///< 1: sRGB
  const float* depth;  ///< OpenEXR: width * height distances, a channel Z of floats; null: none
};

/// What the module offers. Functions return 0, or fill `error` and return its code.
struct afx_picture_module {
  uint32_t version;  ///< kAfxPictureModuleVersion; others are refused
  int (*read)(const struct afx_picture_read_request* request, afx_picture_allocate allocate,
              void* user, struct afx_picture_error* error);
  int (*write)(const struct afx_picture_write_request* request, afx_picture_sink sink, void* user,
               struct afx_picture_error* error);
};

enum { kAfxPictureModuleVersion = 3 };

/// The one symbol of the module, by the name "afx_picture_module_get".
typedef const struct afx_picture_module* (*afx_picture_module_get_function)(void);
}

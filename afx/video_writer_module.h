// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The boundary between video_writer.cpp and the module afx_video.so: plain C data and functions, no
// exception crosses it, nobody frees what the other side allocated.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

/// Why something failed. code   0 = nothing, else one of kAfxVideo...
struct afx_video_error {
  int code;
  char text[512];
};

enum { kAfxVideoRefused = 1, kAfxVideoLimit = 2, kAfxVideoNoMemory = 3 };

struct afx_video_request {
  const char* format;  ///< e.g. "mp4"
  uint32_t width;
  uint32_t height;
  double fps;
  int quality;         ///< CRF of H.264
  uint64_t max_bytes;  ///< of the file
};

/// A video in the making.
struct afx_video;

/// Takes the bytes of the file; called once. Non-zero: could not.
typedef int (*afx_video_sink)(void* user, const void* bytes, size_t size);

/// What the module offers. Functions return 0 (begin: not null), or fill `error` and return its
/// code.
struct afx_video_module {
  uint32_t version;  ///< kAfxVideoModuleVersion; others are refused
  struct afx_video* (*begin)(const struct afx_video_request* request,
                             struct afx_video_error* error);
  const char* (*encoder)(const struct afx_video* video);
  /// rgba   width * height * 4 bytes, the top row first
  int (*add)(struct afx_video* video, const uint8_t* rgba, struct afx_video_error* error);
  int (*finish)(struct afx_video* video, afx_video_sink sink, void* user,
                struct afx_video_error* error);
  void (*close)(struct afx_video* video);
};

enum { kAfxVideoModuleVersion = 1 };

/// The one symbol of the module, by the name "afx_video_module_get".
typedef const struct afx_video_module* (*afx_video_module_get_function)(void);
}

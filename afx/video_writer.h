// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Videos from pictures. libavformat and libavcodec do the work, in a module (afx_video.so) that is
// loaded when the first video is begun; it is looked for where that of pictures is (picture_io.h).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "afx/picture.h"
#include "codec/error.h"
#include "codec/limits.h"

struct afx_video;
struct afx_video_module;

namespace afx {

/// How a video is made.
struct VideoOptions {
  std::string format = "mp4";  ///< "mp4", "mkv", "webm" or "avi"
  uint32_t width = 0;          ///< even, 2..16384
  uint32_t height = 0;         ///< even, 2..16384
  double fps = 30;             ///< pictures a second, 0.1..1000
  /// The constant rate factor of H.264 (0 = best, 51 = least); other codecs get one of like effect.
  int quality = 18;
};

/// Whether the format is one of VideoOptions::format.
[[nodiscard]] bool is_video_format(std::string_view format);

/// A video in the making, in memory, because most formats come back to their beginning at the end.
/// H.264 (in .webm: VP9) or, where there is no encoder for it, another that the format takes. YUV
/// 4:2:0 by the matrix of BT.709 in the narrow range, marked so, with the transfer of sRGB. The
/// same pictures and options give the same bytes with the same libraries. For one thread at a time.
class VideoWriter {
 public:
  /// Errors  bad_argument: an option out of range; unsupported: no format of ours; not_available:
  ///         this build has no video, the module is not there, or no encoder for the format that
  ///         takes the size; no_memory
  static Result<VideoWriter> begin(const VideoOptions& options, const Limits& limits = {});

  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  ~VideoWriter();

  /// The encoder's name, "libx264".
  [[nodiscard]] std::string encoder() const;
  /// Adds a picture: of the video's size, RGBA, whose alpha is not looked at.
  /// Errors  bad_argument: another size; limit_exceeded: the video is longer than limits.memory;
  ///         no_memory; not_available: what the encoder says
  Status add(const Picture& picture);
  /// The bytes of the file; nothing can be added afterwards. Errors  as add()
  Result<std::vector<uint8_t>> finish();

 private:
  struct Close {
    void operator()(afx_video* video) const;
  };
  VideoWriter(const VideoOptions& options, afx_video* video);

  VideoOptions options_;
  std::unique_ptr<afx_video, Close> video_;
};

}  // namespace afx

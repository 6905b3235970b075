// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/video_writer.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "afx/module_loader.h"
#include "afx/video_writer_module.h"

namespace afx {
namespace {

// The module, once it was found; otherwise why not.
struct Module {
  const afx_video_module* functions = nullptr;
  std::string problem;
};

Module load_module() {
#ifdef AFX_HAS_VIDEO
  const ModuleSymbol found =
      find_in_module("afx_video", "afx_video_module_get", "the module for videos");
  if (found.symbol == nullptr) return {nullptr, found.problem};
  const auto* functions = reinterpret_cast<afx_video_module_get_function>(found.symbol)();
  if (functions->version == kAfxVideoModuleVersion) return {functions, {}};
  return {nullptr, "the module for videos is of another version"};
#else
  return {nullptr, "this build has no video"};
#endif
}

const Module& module() {
  static const Module loaded = load_module();
  return loaded;
}

Error error_of(const afx_video_error& error) {
  const Errc code = error.code == kAfxVideoLimit      ? Errc::limit_exceeded
                    : error.code == kAfxVideoNoMemory ? Errc::no_memory
                                                      : Errc::unsupported;
  return {code, Place::none(), error.text};
}

Error refused(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

Status check(const VideoOptions& options) {
  if (!is_video_format(options.format))
    return Error{
        Errc::unsupported, Place::none(),
        "videos cannot be written as " + options.format + " (expected mp4, mkv, webm or avi)"};
  for (const uint32_t side : {options.width, options.height})
    if (side % 2 != 0 || side < 2 || side > 16384)
      return refused("a side of the video is " + std::to_string(side) +
                     " pixels (expected an even number, 2 to 16384)");
  if (!(options.fps >= 0.1) || !(options.fps <= 1000))
    return refused("the video has " + std::to_string(options.fps) +
                   " pictures a second (expected 0.1 to 1000)");
  if (options.quality < 0 || options.quality > 51)
    return refused("the video's quality is " + std::to_string(options.quality) +
                   " (expected 0 to 51)");
  return {};
}

int take_bytes(void* user, const void* bytes, size_t size) {
  try {
    const auto* from = static_cast<const uint8_t*>(bytes);
    static_cast<std::vector<uint8_t>*>(user)->assign(from, from + size);
    return 0;
  } catch (const std::bad_alloc&) {
    return 1;
  }
}

}  // namespace

bool is_video_format(std::string_view format) {
  constexpr std::array<std::string_view, 4> kFormats{"mp4", "mkv", "webm", "avi"};
  return std::find(kFormats.begin(), kFormats.end(), format) != kFormats.end();
}

void VideoWriter::Close::operator()(afx_video* video) const { module().functions->close(video); }

VideoWriter::VideoWriter(const VideoOptions& options, afx_video* video)
    : options_(options), video_(video) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::begin(const VideoOptions& options, const Limits& limits) {
  if (Status right = check(options); !right.ok()) return right.error();
  if (module().functions == nullptr)
    return Error{Errc::not_available, Place::none(), module().problem};
  const afx_video_request request{options.format.c_str(), options.width,
                                  options.height,         options.fps,
                                  options.quality,        limits.memory};
  afx_video_error error{};
  afx_video* video = module().functions->begin(&request, &error);
  if (video == nullptr) return error_of(error);
  return VideoWriter(options, video);
}

std::string VideoWriter::encoder() const { return module().functions->encoder(video_.get()); }

Status VideoWriter::add(const Picture& picture) {
  if (picture.width != options_.width || picture.height != options_.height ||
      picture.components != 4 ||
      picture.samples.size() != size_t{picture.width} * picture.height * 4)
    return refused("the picture is not RGBA of the video's size");
  afx_video_error error{};
  if (module().functions->add(video_.get(), picture.samples.data(), &error) != 0)
    return error_of(error);
  return {};
}

Result<std::vector<uint8_t>> VideoWriter::finish() {
  std::vector<uint8_t> bytes;
  afx_video_error error{};
  if (module().functions->finish(video_.get(), take_bytes, &bytes, &error) != 0)
    return error_of(error);
  return bytes;
}

}  // namespace afx

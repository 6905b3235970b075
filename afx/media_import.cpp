// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/media_import.h"

#include <charconv>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "afx/octree_stream.h"
#include "afx/picture_header.h"
#include "bifs/mp4_builder.h"
#include "bifs/mp4_reader.h"

namespace afx {
namespace {

using bifs::Media;
using bifs::Mp4Track;
using SharedFile = std::shared_ptr<const MappedFile>;
using Bytes = std::vector<uint8_t>;

Error error_of(Errc code, std::string text) { return {code, Place::none(), std::move(text)}; }

Error no_sample(size_t sample) {
  return error_of(Errc::bad_argument, "there is no sample " + std::to_string(sample));
}

Result<Bytes> copy_of(std::span<const uint8_t> bytes, const Limits& limits) {
  if (bytes.size() > limits.memory) {
    return error_of(Errc::limit_exceeded,
                    "a sample of " + std::to_string(bytes.size()) + " bytes is beyond the limit");
  }
  return Bytes(bytes.begin(), bytes.end());
}

Status add_sample(Mp4Track& track, uint64_t size, uint32_t duration) {
  if (size > 0xFFFFFFFF) return error_of(Errc::limit_exceeded, "a sample has 4 GB or more");
  bifs::Mp4Sample sample;
  sample.size = static_cast<uint32_t>(size);
  sample.time = track.media_duration;
  sample.duration = duration;
  track.samples.push_back(sample);
  track.media_duration += duration;
  return {};
}

Result<Media> import_picture(MappedFile file, const Limits& limits) {
  const auto header = read_picture_header(file.bytes());
  if (!header.ok()) return header.error();
  const auto [type, width, height] = header.value();
  if (width > 0xFFFF || height > 0xFFFF) {
    return error_of(Errc::limit_exceeded, "the picture has the size " + std::to_string(width) +
                                              " x " + std::to_string(height) +
                                              " (an MP4 file holds at most 65535 a side)");
  }
  Mp4Track track =
      bifs::make_image_track(0, type, static_cast<uint16_t>(width), static_cast<uint16_t>(height));
  return one_sample_media(std::move(track), std::move(file), limits);
}

/// A frame with its start code, in the bytes of its stream.
struct Frame {
  uint64_t byte = 0;
  uint64_t size = 0;
};

constexpr uint64_t kStartCodeBytes = 4;

/// Where a frame ends is known only by decoding it; of what is decoded nothing is kept.
Result<std::vector<Frame>> find_frames(std::span<const uint8_t> stream, const Limits& limits,
                                       Diagnostics& diagnostics) {
  OctreeDecodeOptions options;
  options.levels = 0;
  options.limits = limits;
  const DecodedOctreeStream decoded = decode_octree_stream(stream, options, diagnostics);
  if (!decoded.status.ok()) return decoded.status.error();
  std::vector<Frame> frames;
  for (const OctreeFrameInfo& info : decoded.infos)
    frames.push_back({info.byte - kStartCodeBytes, kStartCodeBytes + (info.bits + 7) / 8});
  return frames;
}

Result<Media> import_octree(MappedFile mapped, const Limits& limits, Diagnostics& diagnostics) {
  const auto file = std::make_shared<const MappedFile>(std::move(mapped));
  auto found = find_frames(file->bytes(), limits, diagnostics);
  if (!found.ok()) return std::move(found).error();
  const std::vector<Frame> frames = std::move(found).value();
  const size_t header = frames.front().byte;
  Media media;
  media.track = bifs::make_afx_track(0, {kOctreeImageCode});
  for (const Frame& frame : frames) {
    const Status added =
        add_sample(media.track, header + frame.size, frames.size() > 1 ? kFrameMilliseconds : 0);
    if (!added.ok()) return added.error();
  }
  media.bytes = [file, frames, header, limits](size_t sample) -> Result<Bytes> {
    if (sample >= frames.size()) return no_sample(sample);
    auto bytes = copy_of(file->bytes().first(header), limits);
    auto frame = copy_of(file->bytes().subspan(frames[sample].byte, frames[sample].size), limits);
    if (!frame.ok()) return frame;
    bytes.value().insert(bytes.value().end(), frame.value().begin(), frame.value().end());
    return bytes;
  };
  return media;
}

Result<Media> import_track(MappedFile mapped, uint32_t id, const Limits& limits,
                           Diagnostics& diagnostics) {
  const auto file = std::make_shared<const MappedFile>(std::move(mapped));
  const auto movie = bifs::read_mp4(bifs::mp4_source(file->bytes()), limits, diagnostics);
  if (!movie.ok()) return movie.error();
  const Mp4Track* found = bifs::find_track(movie.value(), id);
  if (found == nullptr)
    return error_of(Errc::bad_argument, "has no track with the ID " + std::to_string(id));
  const auto track = std::make_shared<const Mp4Track>(*found);
  Media media;
  media.track = *track;
  media.track.id = 0;
  media.track.references.clear();
  for (bifs::Mp4Edit& edit : media.track.edits)
    edit.duration = bifs::rescale(edit.duration, movie.value().timescale, track->timescale);
  media.bytes = [file, track, limits](size_t sample) {
    return bifs::read_sample(bifs::mp4_source(file->bytes()), *track, sample, limits);
  };
  return media;
}

Result<Media> import_file(MappedFile file, const bifs::MediaSource& source, const Limits& limits,
                          Diagnostics& diagnostics) {
  if (source.format == "SC3DMC" || source.file.ends_with(".s3d"))
    return one_sample_media(bifs::make_afx_track(0, {kSc3dmcCode}), std::move(file), limits);
  if (still_picture_type(file.bytes()) != 0) return import_picture(std::move(file), limits);
  if (looks_like_octree_stream(file.bytes()))
    return import_octree(std::move(file), limits, diagnostics);
  return error_of(
      Errc::unsupported,
      "is no media of a kind that is known here (expected PNG, JPEG, JP2, an OctreeImage "
      "stream, or \"NAME.mp4#ID\" for a track of an MP4 file)");
}

/// "scene.mp4#20" in parts.
struct TrackName {
  std::string file;
  uint32_t id = 0;
};

std::optional<TrackName> track_name(const std::string& name) {
  const size_t mark = name.rfind('#');
  if (mark == std::string::npos) return std::nullopt;
  TrackName parts{name.substr(0, mark), 0};
  const char* end = name.data() + name.size();
  const auto [stop, failure] = std::from_chars(name.data() + mark + 1, end, parts.id);
  if (failure != std::errc{} || stop != end) return std::nullopt;
  return parts;
}

std::string path_in(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

/// Lets errors and warnings about a file name it.
template <class Import>
Result<Media> about_file(const std::string& path, const Limits& limits, Diagnostics& diagnostics,
                         Import import) {
  auto file = MappedFile::open_regular(path, limits);
  Diagnostics of_file;
  Result<Media> media =
      file.ok() ? import(std::move(file).value(), of_file) : Result<Media>(std::move(file).error());
  diagnostics.append(of_file, path);
  if (!media.ok()) media.error().file = path;
  return media;
}

const bifs::DecoderConfig* config_of(const Media& media) {
  return media.track.entries.empty() ? nullptr : decoder_config_of(media.track.entries.front());
}

}  // namespace

Result<Media> import_media(const bifs::MediaSource& source, const std::string& folder,
                           const Limits& limits, Diagnostics& diagnostics) {
  const std::string path = path_in(folder, source.file);
  const auto track = track_name(source.file);
  std::error_code ignored;
  if (track && !std::filesystem::exists(path, ignored)) {
    return about_file(path_in(folder, track->file), limits, diagnostics,
                      [&](MappedFile file, Diagnostics& of_file) {
                        return import_track(std::move(file), track->id, limits, of_file);
                      });
  }
  return about_file(path, limits, diagnostics, [&](MappedFile file, Diagnostics& of_file) {
    return import_file(std::move(file), source, limits, of_file);
  });
}

Result<Media> one_sample_media(Mp4Track track, MappedFile mapped, const Limits& limits) {
  const auto file = std::make_shared<const MappedFile>(std::move(mapped));
  Media media;
  media.track = std::move(track);
  const Status added = add_sample(media.track, file->bytes().size(), 0);
  if (!added.ok()) return added.error();
  media.bytes = [file, limits](size_t sample) {
    return sample == 0 ? copy_of(file->bytes(), limits) : Result<Bytes>(no_sample(sample));
  };
  return media;
}

std::optional<uint8_t> afx_object_code(const Media& media) {
  const bifs::DecoderConfig* config = config_of(media);
  if (config == nullptr || config->stream_type != bifs::stream_type::kScene ||
      config->object_type != bifs::object_type::kAfx)
    return std::nullopt;
  const auto* info = bifs::find_part<bifs::DecoderSpecificInfo>(config->parts);
  if (info == nullptr || info->bytes.empty()) return std::nullopt;
  return info->bytes.front();
}

std::optional<uint8_t> still_picture_type(const Media& media) {
  using namespace bifs::object_type;
  const bifs::DecoderConfig* config = config_of(media);
  if (config == nullptr || config->stream_type != bifs::stream_type::kVisual) return std::nullopt;
  const uint8_t type = config->object_type;
  const bool still = type == kPng || type == kJpeg || type == kJpeg2000;
  return still ? std::optional(type) : std::nullopt;
}

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/octree_stream.h"

#include <algorithm>
#include <bit>
#include <map>
#include <string>

#include "codec/bit_writer.h"
#include "codec/octree_encoder.h"
#include "codec/parallel.h"

namespace afx {
namespace {

using codec::BitReader;
using codec::OctreeFrame;
using codec::OctreeFrameOptions;

constexpr uint32_t kStartCode = 0x000001C8;
constexpr const char* kStartCodeName = "octree_frame_start_code";

/// The width field and the number of the header: the least width that holds the number.
void write_number(codec::BitWriter& out, uint32_t value, unsigned width_bits) {
  const auto width = static_cast<unsigned>(std::bit_width(value));
  out.u(width, width_bits);
  out.u(value, width);
}

uint32_t read_number(BitReader& in, unsigned width_bits, std::string_view width_name,
                     std::string_view name, Diagnostics& diagnostics) {
  const uint64_t at = in.bit();
  const uint32_t width = in.u(width_bits, width_name);
  const uint32_t value = in.u(width, name);
  const auto least = static_cast<uint32_t>(std::bit_width(value));
  if (in.ok() && width != least) {
    diagnostics.warn("non_minimal_width", Place::at_bit(at),
                     std::string(width_name) + " is " + std::to_string(width) + " where " +
                         std::to_string(least) + " hold the value " + std::to_string(value));
  }
  return value;
}

void read_header(BitReader& in, OctreeStream& stream, Diagnostics& diagnostics) {
  stream.resolution = read_number(in, 5, "resolution_bits", "octreeResolution", diagnostics);
  if (in.ok() && stream.resolution == 0) {
    in.fail(Errc::malformed, "octreeResolution is 0 (expected at least 1)");
  }
  stream.textures = read_number(in, 3, "texture_bits", "numOfTextures", diagnostics);
}

/// Reads the start code of a frame, from a byte boundary.
void read_start_code(BitReader& in) {
  const uint32_t code = in.u(32, kStartCodeName);
  if (in.ok() && code != kStartCode) {
    in.fail(Errc::malformed, "no octree_frame_start_code (expected the bytes 00 00 01 C8)");
  }
}

bool start_code_at(std::span<const uint8_t> data, uint64_t byte) {
  constexpr uint8_t bytes[4] = {0x00, 0x00, 0x01, 0xC8};
  return byte + 4 <= data.size() &&
         std::equal(bytes, bytes + 4, data.begin() + static_cast<ptrdiff_t>(byte));
}

struct FrameJob {
  OctreeFrame frame;
  Diagnostics diagnostics;
};

class StreamDecoder {
 public:
  StreamDecoder(std::span<const uint8_t> data, const OctreeDecodeOptions& options,
                Diagnostics& diagnostics)
      : data_(data),
        options_(options),
        diagnostics_(diagnostics),
        in_(data, options.trace),
        guessing_(thread_count(options.threads) > 1 && !options.frame) {}

  DecodedOctreeStream run() {
    const BitReader::Scope scope(in_, "octree_stream");
    read_header(in_, result_.stream, diagnostics_);
    result_.has_header = in_.ok();
    levels_ = octree_levels(std::max(1U, result_.stream.resolution));
    in_.align(diagnostics_);
    read_start_code(in_);
    for (uint32_t number = 0; in_.ok() && result_.status.ok(); ++number) {
      if (!take_frame(number) || !more_frames(number)) break;
    }
    if (!in_.ok()) result_.status = in_.error();
    return std::move(result_);
  }

 private:
  bool take_frame(uint32_t number);
  bool more_frames(uint32_t number);
  FrameJob frame_at(uint64_t byte, uint32_t number);
  void decode_ahead(uint64_t byte);
  FrameJob decode(uint64_t byte, uint64_t share, unsigned stop_level) const;
  void keep(uint64_t byte, uint32_t number, OctreeFrame frame);
  void trace_levels(uint32_t number, uint64_t byte, const OctreeFrame& frame) const;

  [[nodiscard]] bool wanted(uint32_t number) const {
    return !options_.frame || *options_.frame == number;
  }

  std::span<const uint8_t> data_;
  const OctreeDecodeOptions& options_;
  Diagnostics& diagnostics_;
  BitReader in_;
  DecodedOctreeStream result_;
  unsigned levels_ = 0;
  bool guessing_;
  uint64_t bytes_held_ = 0;  // in the fields of result_
  std::map<uint64_t, FrameJob>
      ahead_;  // frames decoded on the guess that they begin at these bytes
};

/// Returns whether the stream is to be read on.
bool StreamDecoder::take_frame(uint32_t number) {
  const uint64_t byte = in_.bit() / 8;
  FrameJob job = frame_at(byte, number);
  diagnostics_.append(job.diagnostics);
  result_.status = job.frame.status;
  if (options_.trace != nullptr) trace_levels(number, byte, job.frame);
  in_.seek(byte * 8 + job.frame.bits);
  if (wanted(number) && job.frame.usable) keep(byte, number, std::move(job.frame));
  return result_.status.ok() && options_.frame != number;
}

/// After a whole frame: whether another follows. What is left otherwise is a warning.
bool StreamDecoder::more_frames(uint32_t number) {
  in_.align(diagnostics_);
  const uint64_t byte = in_.bit() / 8;
  if (start_code_at(data_, byte)) {
    read_start_code(in_);
    return true;
  }
  if (options_.frame) {
    result_.status =
        Error{Errc::bad_argument, Place::none(),
              "frame " + std::to_string(*options_.frame) + " is not there (the stream has " +
                  std::to_string(number + 1) + ", counted from 0)"};
  }
  if (byte < data_.size()) {
    diagnostics_.warn(
        "trailing_bytes", Place::at_byte(byte),
        std::to_string(data_.size() - byte) + " bytes after the last frame belong to none");
  }
  return false;
}

FrameJob StreamDecoder::frame_at(uint64_t byte, uint32_t number) {
  if (guessing_ && ahead_.count(byte) == 0) decode_ahead(byte);
  if (auto found = ahead_.find(byte); found != ahead_.end()) {
    FrameJob job = std::move(found->second);
    ahead_.erase(found);
    if (job.frame.status.ok() || job.frame.status.error().code != Errc::limit_exceeded) return job;
  }
  // A chosen frame is the last one read, so its end need not be found.
  return decode(byte, 1, options_.frame == number ? options_.levels : 32);
}

/// Where frames begin is known only when the one before has been decoded. So with several threads
/// the places that look like start codes are decoded at once, and a result counts only when the
/// chain of frames arrives at its place: the outcome is that of decoding one after the other. After
/// the first wrong guess there are no more: a hostile stream could have very many of them, each to
/// be decoded to the end of the data.
void StreamDecoder::decode_ahead(uint64_t byte) {
  guessing_ = ahead_.empty();
  if (!guessing_) return;
  std::vector<uint64_t> places{byte};
  const unsigned threads = thread_count(options_.threads);
  for (uint64_t at = byte; places.size() < threads && at + 4 <= data_.size(); ++at) {
    if (start_code_at(data_, at)) places.push_back(at + 4);
  }
  std::vector<FrameJob> jobs(places.size());
  parallel_for(places.size(), threads,
               [&](size_t i) { jobs[i] = decode(places[i], places.size(), 32); });
  for (size_t i = 0; i < places.size(); ++i) ahead_.emplace(places[i], std::move(jobs[i]));
}

/// Decodes the frame at a byte within 1/share of the limits.
FrameJob StreamDecoder::decode(uint64_t byte, uint64_t share, unsigned stop_level) const {
  OctreeFrameOptions frame_options{.levels = levels_,
                                   .textures = result_.stream.textures,
                                   .stop_level = stop_level,
                                   .base_byte = byte};
  frame_options.limits = options_.limits;
  frame_options.limits.memory -= std::min(frame_options.limits.memory, bytes_held_);
  frame_options.limits.memory /= share;
  frame_options.limits.octree_nodes /= share;
  FrameJob job;
  job.frame = codec::decode_octree_frame(data_.subspan(byte), frame_options, job.diagnostics);
  return job;
}

void StreamDecoder::keep(uint64_t byte, uint32_t number, OctreeFrame frame) {
  OctreeFrameInfo info;
  info.number = number;
  info.byte = byte;
  info.bits = frame.bits;
  info.whole = frame.status.ok() && frame.stats.size() >= levels_;
  const unsigned levels = std::min(frame.levels, options_.levels);
  codec::coarsen_octree(frame.fields, frame.levels, levels);
  info.resolution = levels == levels_ ? result_.stream.resolution : 1U << levels;
  info.node_symbols = frame.node_symbols;
  info.texture_symbols = frame.texture_symbols;
  info.stats = std::move(frame.stats);
  bytes_held_ += frame.fields.octree.size() + frame.fields.voxel_image_index.size();
  result_.infos.push_back(std::move(info));
  result_.stream.frames.push_back(std::move(frame.fields));
}

void StreamDecoder::trace_levels(uint32_t number, uint64_t byte, const OctreeFrame& frame) const {
  uint64_t from = 0;
  for (size_t level = 0; level < frame.stats.size(); ++level) {
    const codec::OctreeLevelStats& stats = frame.stats[level];
    const std::string path = "octree_stream/octree_frame[" + std::to_string(number) + "]/level[" +
                             std::to_string(level) + "].symbols";
    const uint64_t nodes = level == levels_ ? 0 : stats.nodes;
    (*options_.trace)({byte * 8 + from, static_cast<unsigned>(stats.end_bit - from), path,
                       nodes + stats.texture_symbols});
    from = stats.end_bit;
  }
}

Status check_header(const OctreeStream& stream) {
  const auto bad = [](std::string text) {
    return Error{Errc::bad_argument, Place::none(), std::move(text)};
  };
  if (stream.resolution == 0) return bad("octreeResolution is 0 (expected at least 1)");
  if (stream.resolution >> 31 != 0) {
    return bad("octreeResolution is " + std::to_string(stream.resolution) +
               " (the stream holds at most 2147483647)");
  }
  if (stream.textures > kMaxStreamTextures) {
    return bad("the OctreeImage has " + std::to_string(stream.textures) +
               " images, but numOfTextures of the stream holds at most " +
               std::to_string(kMaxStreamTextures));
  }
  if (stream.frames.empty()) return bad("there are no frames to encode (expected at least 1)");
  return {};
}

}  // namespace

Result<std::vector<uint8_t>> encode_octree_stream(const OctreeStream& stream, unsigned threads) {
  if (Status header = check_header(stream); !header.ok()) return header.error();
  const unsigned levels = octree_levels(stream.resolution);
  std::vector<std::vector<uint8_t>> frames(stream.frames.size());
  std::vector<Status> status(stream.frames.size());
  parallel_for(frames.size(), threads, [&](size_t i) {
    auto bits = codec::encode_octree_frame(stream.frames[i], levels, stream.textures, frames[i]);
    if (!bits.ok()) status[i] = std::move(bits).error();
  });
  std::vector<uint8_t> out;
  codec::BitWriter writer(out);
  write_number(writer, stream.resolution, 5);
  write_number(writer, stream.textures, 3);
  for (size_t i = 0; i < frames.size(); ++i) {
    if (!status[i].ok()) {
      Error error = status[i].error();
      if (frames.size() > 1) error.text = "frame " + std::to_string(i) + ": " + error.text;
      return error;
    }
    writer.align();
    writer.u(kStartCode, 32);
    out.insert(out.end(), frames[i].begin(), frames[i].end());
  }
  return out;
}

DecodedOctreeStream decode_octree_stream(std::span<const uint8_t> data,
                                         const OctreeDecodeOptions& options,
                                         Diagnostics& diagnostics) {
  return StreamDecoder(data, options, diagnostics).run();
}

bool looks_like_octree_stream(std::span<const uint8_t> data) {
  BitReader in(data);
  Diagnostics ignored;
  OctreeStream stream;
  read_header(in, stream, ignored);
  in.align(ignored);
  read_start_code(in);
  return in.ok();
}

}  // namespace afx

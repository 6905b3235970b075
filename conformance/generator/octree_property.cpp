// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/octree_property.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "codec/bit_writer.h"
#include "codec/plain/octree_plain.h"
#include "conformance/generator/random_octree.h"

namespace afx::conformance {

namespace {

using nlohmann::json;
using Bytes = std::vector<uint8_t>;

json json_of(const OctreeStream& stream, uint32_t resolution) {
  json frames = json::array();
  for (const OctreeFields& fields : stream.frames)
    frames.push_back({{"octree", fields.octree}, {"voxelImageIndex", fields.voxel_image_index}});
  return {{"octreeResolution", resolution},
          {"numOfTextures", stream.textures},
          {"frames", std::move(frames)}};
}

/// The stream by the plain coder, and the byte at which each frame begins.
struct PlainStream {
  Bytes bytes;
  std::vector<size_t> frames;
};

PlainStream plain_stream(const OctreeStream& stream) {
  PlainStream out;
  codec::BitWriter writer(out.bytes);
  const auto number = [&](uint32_t value, unsigned width_bits) {
    const auto width = static_cast<unsigned>(std::bit_width(value));
    writer.u(width, width_bits);
    writer.u(value, width);
  };
  number(stream.resolution, 5);
  number(stream.textures, 3);
  writer.align();
  for (const OctreeFields& fields : stream.frames) {
    out.bytes.insert(out.bytes.end(), {0x00, 0x00, 0x01, 0xC8});  // octree_frame_start_code
    out.frames.push_back(out.bytes.size());
    const Bytes frame =
        codec::plain::encode_frame(fields, octree_levels(stream.resolution), stream.textures);
    out.bytes.insert(out.bytes.end(), frame.begin(), frame.end());
  }
  return out;
}

/// Checks one case. Each check gives what fails.
class OctreeCheck {
 public:
  OctreeCheck(const OctreeCoder& coder, const OctreeStream& stream)
      : coder_(coder),
        stream_(stream),
        levels_(octree_levels(stream.resolution)),
        plain_(plain_stream(stream)) {}

  std::optional<Failure> run(Choices& choices) {
    for (const unsigned threads : {1U, 3U})
      if (auto failure = check_whole(threads)) return failure;
    if (auto failure = check_plain_decoder()) return failure;
    for (unsigned levels = 0; levels < levels_; ++levels)
      if (auto failure = check_levels(levels)) return failure;
    return check_cut(choices.below(static_cast<uint32_t>(plain_.bytes.size())));
  }

 private:
  DecodedOctreeStream decode(std::span<const uint8_t> data, unsigned levels, unsigned threads) {
    OctreeDecodeOptions options{.levels = levels};
    options.threads = threads;
    Diagnostics ignored;
    return coder_.decode(data, options, ignored);
  }

  [[nodiscard]] Failure failure(const std::string& text, json check, json expected = {}) const {
    return {text, {"octree", plain_.bytes, {{std::move(check), std::move(expected)}}}};
  }
  [[nodiscard]] Failure wrong_decode(const std::string& text) const {
    return failure(text, {{"check", "decode"}, {"as", "octree"}},
                   json_of(stream_, stream_.resolution));
  }

  std::optional<Failure> check_whole(unsigned threads) {
    const std::string where = " on " + std::to_string(threads) + " threads";
    const json reencode = {{"check", "reencode"}};
    const auto bytes = coder_.encode(stream_, threads);
    if (!bytes.ok()) return failure("encode" + where + ": " + to_string(bytes.error()), reencode);
    if (bytes.value() != plain_.bytes)
      return failure("encode" + where + ": other bytes than the plain coder's", reencode);
    const DecodedOctreeStream decoded = decode(plain_.bytes, 32, threads);
    if (!decoded.status.ok())
      return wrong_decode("decode" + where + ": " + to_string(decoded.status.error()));
    if (!is_equal(decoded.stream, stream_.frames, stream_.resolution))
      return wrong_decode("decode" + where + ": other fields than were encoded");
    const auto again = coder_.encode(decoded.stream, threads);
    if (!again.ok() || again.value() != plain_.bytes)
      return failure("encode again" + where + ": other bytes", reencode);
    return std::nullopt;
  }

  bool is_equal(const OctreeStream& found, const std::vector<OctreeFields>& frames,
                uint32_t resolution) const {
    return found.resolution == resolution && found.textures == stream_.textures &&
           found.frames == frames;
  }

  std::optional<Failure> check_plain_decoder() {
    for (size_t i = 0; i < stream_.frames.size(); ++i) {
      const auto data = std::span(plain_.bytes).subspan(plain_.frames[i]);
      const auto frame = codec::plain::decode_frame(data, levels_, stream_.textures, UINT64_MAX);
      if (frame.truncated || frame.fields != stream_.frames[i])
        return wrong_decode("plain decode: other fields than were encoded");
    }
    return std::nullopt;
  }

  std::optional<Failure> check_levels(unsigned levels) {
    const DecodedOctreeStream decoded = decode(plain_.bytes, levels, 1);
    OctreeStream expected = stream_;
    for (OctreeFields& fields : expected.frames) codec::coarsen_octree(fields, levels_, levels);
    const bool holds =
        decoded.status.ok() && is_equal(decoded.stream, expected.frames, stream_.resolution) &&
        std::all_of(decoded.infos.begin(), decoded.infos.end(),
                    [&](const auto& i) { return i.resolution == uint32_t{1} << levels; });
    if (holds) return std::nullopt;
    return failure("decode " + std::to_string(levels) + " levels: not the coarser model",
                   {{"check", "decode"}, {"as", "octree"}, {"levels", levels}},
                   json_of(expected, uint32_t{1} << levels));
  }

  /// What is left of a cut frame may by chance be a whole one, of other symbols: the plain coder
  /// says whether it is.
  std::optional<Failure> check_cut(size_t size) {
    const auto data = std::span(plain_.bytes).first(size);
    std::vector<OctreeFields> left = stream_.frames;
    left.resize(whole_frames(size));
    bool truncated = left.empty();
    if (left.size() < plain_.frames.size() && plain_.frames[left.size()] <= size) {
      auto cut = codec::plain::decode_frame(data.subspan(plain_.frames[left.size()]), levels_,
                                            stream_.textures, UINT64_MAX);
      truncated = cut.truncated;
      if (!truncated) left.push_back(std::move(cut.fields));
    }
    const DecodedOctreeStream decoded = decode(data, 32, 1);
    const std::string found =
        decoded.status.ok() ? "is accepted" : to_string(decoded.status.error());
    if (!truncated) {
      if (decoded.status.ok() && decoded.stream.frames == left) return std::nullopt;
      OctreeStream expected = stream_;
      expected.frames = std::move(left);
      return cut_failure(size, found + ", not as by the plain coder",
                         {{"check", "decode"}, {"as", "octree"}},
                         json_of(expected, stream_.resolution));
    }
    if (!decoded.status.ok() && decoded.status.error().code == Errc::truncated &&
        holds_prefix(decoded))
      return std::nullopt;
    return cut_failure(size, found + " (expected truncated, and what is whole before)",
                       {{"check", "reject"}, {"code", "truncated"}, {"bit", uint64_t{8} * size}});
  }

  [[nodiscard]] Failure cut_failure(size_t size, const std::string& text, json check,
                                    json expected = {}) const {
    Failure found = failure("cut to " + std::to_string(size) + " bytes: " + text, std::move(check),
                            std::move(expected));
    found.kept.stream.resize(size);
    return found;
  }

  /// Frames whose bytes are all there. Behind one, a part of the next start code is no error.
  [[nodiscard]] size_t whole_frames(size_t size) const {
    size_t whole = 0;
    while (whole + 1 < plain_.frames.size() && plain_.frames[whole + 1] - 4 <= size) ++whole;
    return whole;  // the last one is not, for the cut is before its end
  }

  bool holds_prefix(const DecodedOctreeStream& decoded) const {
    for (size_t i = 0; i < decoded.stream.frames.size(); ++i) {
      OctreeFields whole = stream_.frames[i];
      OctreeFields found = decoded.stream.frames[i];
      if (decoded.infos[i].whole) {
        if (found != whole) return false;
        continue;
      }
      const unsigned levels = decoded.infos[i].resolution == stream_.resolution
                                  ? levels_
                                  : octree_levels(decoded.infos[i].resolution);
      codec::coarsen_octree(whole, levels_, levels);
      if (levels == levels_) cut_voxels(whole, found);
      if (found != whole) return false;
    }
    return true;
  }

  /// Of the voxels' own images the last are missing, which is 0.
  static void cut_voxels(OctreeFields& whole, const OctreeFields& found) {
    auto& images = whole.voxel_image_index;
    for (size_t i = std::min(images.size(), found.voxel_image_index.size()); i > 0; --i) {
      if (found.voxel_image_index[i - 1] != 0) return;
      images[i - 1] = 0;
    }
  }

  const OctreeCoder& coder_;
  const OctreeStream& stream_;
  unsigned levels_;
  PlainStream plain_;
};

}  // namespace

const OctreeCoder& own_octree_coder() {
  static const OctreeCoder coder{encode_octree_stream, decode_octree_stream};
  return coder;
}

Property octree_property(const OctreeCoder& coder) {
  return [coder](Choices& choices) {
    const OctreeStream stream = random_octree(choices);
    return OctreeCheck(coder, stream).run(choices);
  };
}

}  // namespace afx::conformance

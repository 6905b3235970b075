// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/plain/octree_plain_stream.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "codec/plain/octree_plain.h"
#include "codec/plain/octree_plain_bits.h"

namespace afx::codec::plain {
namespace {

using Bits = std::vector<bool>;

unsigned levels_of(uint32_t resolution, LevelsOf rule) {
  const auto floor = static_cast<unsigned>(std::bit_width(resolution) - 1);
  if (rule == LevelsOf::floor_log2) return floor;
  if (rule == LevelsOf::bit_width) return floor + 1;
  return static_cast<unsigned>(std::bit_width(resolution - 1));
}

/// Cuts what was decoded of a frame down to the model of a level.
OctreeFields fields_of_level(const Frame& frame, size_t level, const LevelRules& rules) {
  const Mark& mark = frame.levels[std::min(level + rules.more_levels, frame.levels.size() - 1)];
  OctreeFields fields = frame.fields;
  fields.octree.resize(mark.octree);
  fields.voxel_image_index.resize(rules.textures ? mark.index : 0);
  const uint64_t zeros =
      (rules.undefined_zeros ? mark.undefined : 0) + (rules.childless_stay ? mark.childless : 0);
  fields.voxel_image_index.resize(fields.voxel_image_index.size() + zeros, 0);
  return fields;
}

/// The deepest complete level of a truncated frame; 0: none.
size_t deepest_level(const Frame& frame, const LevelRules& rules) {
  size_t deepest = 0;
  for (size_t level = 1; level < frame.levels.size(); ++level) {
    const size_t textures = frame.levels[rules.nodes_suffice ? level - 1 : level].index;
    if (frame.levels[level].octree + textures <= frame.whole) deepest = level;
  }
  return deepest;
}

class StreamDecoder {
 public:
  StreamDecoder(std::span<const uint8_t> data, unsigned levels, uint64_t most_nodes,
                const Rules& rules)
      : bits_(bits_of_bytes(data, rules.bits)),
        wanted_(levels == 0 && rules.levels.none_is_all ? 32 : levels),
        most_nodes_(most_nodes),
        rules_(rules) {}

  Stream run() {
    read_header();
    if (!ok() || at_empty_end()) return std::move(stream_);
    read_first_start_code();
    if (!ok()) return std::move(stream_);
    Model model(stream_.textures, rules_);
    do {
      take_frame(model);
      model.restart();
    } while (ok() && more_frames());
    if (ok() && at_ < bits_.size()) warn("trailing_bytes", at_);
    return std::move(stream_);
  }

 private:
  [[nodiscard]] bool ok() const { return !stream_.error; }
  [[nodiscard]] uint64_t place(uint64_t bit) const {
    return rules_.stream.places_in_bytes ? bit / 8 : bit;
  }
  void fail(std::string_view code, uint64_t bit) {
    if (ok()) stream_.error = Finding{code, place(bit)};
  }
  void warn(std::string_view code, uint64_t bit) {
    if (code == rules_.stream.refused) fail("malformed", bit);
    if (code != rules_.stream.unreported) stream_.warnings.push_back({code, place(bit)});
  }

  uint32_t u(unsigned width) {
    if (!ok()) return 0;
    if (at_ + width > bits_.size() && !rules_.stream.missing_bits) fail("truncated", at_);
    if (!ok()) return 0;
    uint64_t value = 0;
    for (unsigned i = 0; i < width; ++i, ++at_)
      value = 2 * value + (at_ < bits_.size() && bits_[at_] ? 1 : 0);
    const bool negative = rules_.bits.is_signed && width > 0 && (value >> (width - 1) & 1) != 0;
    return static_cast<uint32_t>(negative ? value - (uint64_t{1} << width) : value);
  }

  uint32_t read_number(const NumberRules& rules) {
    const uint64_t at = at_;
    const unsigned width = u(rules.width_bits);
    number_at_ = at_;
    const uint32_t value = u(width);
    if (ok() && width != static_cast<unsigned>(std::bit_width(value)))
      warn("non_minimal_width", at);
    return value + rules.offset;
  }

  void read_header() {
    stream_.resolution = read_number(rules_.stream.resolution);
    if (stream_.resolution == 0) {
      if (!rules_.stream.zero_resolution) fail("malformed", number_at_);
      stream_.resolution = 1;
    }
    if (rules_.stream.powers_of_two_only && !std::has_single_bit(stream_.resolution))
      fail("malformed", number_at_);
    stream_.textures = read_number(rules_.stream.textures);
    if (stream_.textures > rules_.stream.most_textures) fail("malformed", number_at_);
    levels_ = std::min(32U, levels_of(stream_.resolution, rules_.stream.levels));
    if (rules_.stream.aligned_frames) align();
  }

  void align() {
    const uint64_t from = at_;
    bool zeros = true;
    while (at_ % rules_.bits.align != 0 && at_ < bits_.size()) zeros = !bits_[at_++] && zeros;
    if (!zeros) warn("align_bits", from);
  }

  /// Whether the stream ends where a frame should begin, and may.
  [[nodiscard]] bool at_empty_end() const {
    return rules_.stream.least_frames == 0 && stream_.frames.empty() && at_ + 32 > bits_.size();
  }

  [[nodiscard]] bool start_code_at(uint64_t bit) const {
    if (bit + 32 > bits_.size()) return false;
    uint32_t code = 0;
    for (uint64_t i = 0; i < 32; ++i) code = 2 * code + (bits_[bit + i] ? 1 : 0);
    return rules_.stream.any_start_code || code == rules_.stream.start_code;
  }

  /// The next start code at a byte boundary from here on, or the end.
  [[nodiscard]] uint64_t next_start_code() const {
    uint64_t bit = at_;
    while (bit < bits_.size() && !start_code_at(bit)) bit += 8;
    return std::min(bit, uint64_t{bits_.size()});
  }

  void read_first_start_code() {
    if (at_ + 32 > bits_.size())
      fail(rules_.stream.short_start_code ? "malformed" : "truncated", at_);
    if (rules_.stream.codes_are_searched && ok()) at_ = next_start_code();
    if (!start_code_at(at_)) fail("malformed", at_);
    at_ += 32;
  }

  void take_frame(Model& model) {
    const uint64_t end = rules_.stream.codes_end_frames ? next_start_code() : bits_.size();
    const auto begin = bits_.begin();
    const Bits data(begin + static_cast<ptrdiff_t>(at_), begin + static_cast<ptrdiff_t>(end));
    const Frame frame = decode_frame(data, levels_, stream_.textures, most_nodes_, rules_, model);
    if (frame.too_many) {
      stream_.error = Finding{"limit_exceeded", {}};
    } else if (frame.truncated) {
      fail("truncated", rules_.coder.truncated_at_end ? end : at_);
      keep_whole_levels(frame);
    } else {
      keep(frame);
      at_ += frame.bits;
    }
  }

  void keep(const Frame& frame) {
    if (frame.childless > 0) warn("octree_childless_node", at_);
    if (!frame.ends_well) warn("octree_bad_ending", at_ + frame.bits);
    if (frame.undefined_voxel && !rules_.walk.undefined_voxels) fail("malformed", at_);
    const unsigned whole = levels_ + (rules_.levels.all_is_whole ? 0 : 1);
    if (wanted_ < whole) {
      stream_.frames.push_back(fields_of_level(frame, wanted_, rules_.levels));
      set_level(wanted_);
    } else {
      stream_.frames.push_back(frame.fields);
    }
  }

  void keep_whole_levels(const Frame& frame) {
    const LevelRules& rules = rules_.levels;
    const size_t level = deepest_level(frame, rules);
    if (!rules.of_truncated || (level == 0 && !rules.root_at_least)) return;
    OctreeFields fields = fields_of_level(frame, level, rules);
    if (level == levels_ && rules.whole_voxels) {
      const uint64_t symbols = std::max(frame.whole, uint64_t{fields.octree.size()});
      const uint64_t kept = std::min(symbols - fields.octree.size(),
                                     uint64_t{std::min(fields.voxel_image_index.size(),
                                                       frame.fields.voxel_image_index.size())});
      std::copy_n(frame.fields.voxel_image_index.begin(), kept, fields.voxel_image_index.begin());
    }
    stream_.frames.push_back(std::move(fields));
    if (level < levels_) set_level(level);
  }

  void set_level(size_t level) {
    if (rules_.levels.own_resolution) stream_.resolution = uint32_t{1} << level;
  }

  /// After a frame: whether another follows; then it is read on behind the start code.
  bool more_frames() {
    if (rules_.stream.aligned_frames) align();
    if (rules_.stream.codes_are_searched) at_ = next_start_code();
    if (rules_.stream.code_at_end && at_ >= bits_.size()) fail("truncated", at_);
    if (!ok() || stream_.frames.size() >= rules_.stream.most_frames) return false;
    if (!start_code_at(at_)) return false;
    at_ += 32;
    return true;
  }

  const Bits bits_;
  const unsigned wanted_;
  const uint64_t most_nodes_;
  const Rules& rules_;
  Stream stream_;
  uint64_t at_ = 0;
  uint64_t number_at_ = 0;  // of the header's number that was read last
  unsigned levels_ = 0;
};

void put(Bits& bits, uint32_t value, unsigned width) {
  for (unsigned i = width; i-- > 0;) bits.push_back(i < 32 && (value >> i & 1) != 0);
}

void put_number(Bits& bits, uint32_t value, const NumberRules& rules) {
  const uint32_t coded = value - rules.offset;
  const auto least = static_cast<unsigned>(std::bit_width(coded));
  const unsigned width = coded == 0 ? rules.width_of_zero : least + rules.spare_bits;
  put(bits, width, rules.width_bits);
  put(bits, coded, width);
}

}  // namespace

Stream decode_stream(std::span<const uint8_t> data, unsigned levels, uint64_t most_nodes,
                     const Rules& rules) {
  return StreamDecoder(data, levels, most_nodes, rules).run();
}

std::vector<uint8_t> encode_stream(const Stream& stream, const Rules& rules) {
  Bits bits;
  const auto align = [&] {
    while (bits.size() % rules.bits.align != 0) bits.push_back(rules.bits.align_with != 0);
  };
  put_number(bits, stream.resolution, rules.stream.resolution);
  put_number(bits, stream.textures, rules.stream.textures);
  const unsigned levels = std::min(32U, levels_of(stream.resolution, rules.stream.levels));
  Model model(stream.textures, rules);
  for (const OctreeFields& fields : stream.frames) {
    if (rules.stream.aligned_frames) align();
    put(bits, rules.stream.start_code, 32);
    const Bits frame = encode_frame(fields, levels, stream.textures, rules, model);
    bits.insert(bits.end(), frame.begin(), frame.end());
    model.restart();
  }
  align();
  return bytes_of_bits(bits, rules.bits);
}

}  // namespace afx::codec::plain

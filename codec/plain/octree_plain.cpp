// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/plain/octree_plain.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "codec/octree_symmetry.h"

namespace afx::codec::plain {
namespace {

constexpr uint32_t kQ1 = 16384;
constexpr uint32_t kQ2 = 32768;
constexpr uint32_t kQ3 = 49152;

struct Table {
  std::vector<uint16_t> frequency;
  uint32_t total;
  uint16_t step;
  uint32_t limit;

  Table(size_t symbols, uint16_t step_in, uint32_t limit_in)
      : frequency(symbols, 1),
        total(static_cast<uint32_t>(symbols)),
        step(step_in),
        limit(limit_in) {}

  void count(size_t symbol) {
    frequency[symbol] = static_cast<uint16_t>(frequency[symbol] + step);
    total += step;
    if (total <= limit) return;
    for (uint16_t& f : frequency) f = static_cast<uint16_t>((f + 1) / 2);
    total = std::accumulate(frequency.begin(), frequency.end(), uint32_t{0});
  }
};

struct Model {
  uint64_t coded = 0;
  std::vector<Table> tables{Table(256, 2, 8192)};
  Table texture;

  explicit Model(unsigned textures) : texture(textures + 1, 32, 512) {}

  void copy_tables(size_t copies, uint16_t step) {
    std::vector<Table> next;
    for (const Table& table : tables) {
      for (size_t i = 0; i < copies; ++i) {
        next.push_back(table);
        next.back().step = step;
      }
    }
    tables = std::move(next);
  }

  /// The table for the next node symbol, and the symmetry to apply to it.
  Table& node(uint8_t parent, unsigned position, unsigned& symmetry) {
    if (coded == 512) copy_tables(22, 3);
    if (coded == 512 + 2048) copy_tables(8, 4);
    const unsigned t = kSymbolClasses.symmetry[parent];
    const size_t number = kSymbolClasses.number[parent];
    symmetry = coded < 512 ? SymbolMaps::kIdentity : t;
    ++coded;
    if (coded <= 512) return tables[0];
    if (coded <= 512 + 2048) return tables[number];
    return tables[number * 8 + kSymmetryNumbering[t][position]];
  }
};

struct Interval {
  uint32_t low = 0;
  uint32_t high = 65535;
  void narrow(uint32_t cum, uint32_t cum_next, uint32_t total) {
    const uint32_t length = high - low + 1;
    high = low - 1 + length * cum / total;
    low = low + length * cum_next / total;
  }
};

class Encoder {
 public:
  void encode(Table& table, size_t symbol) {
    uint32_t cum = table.total;
    for (size_t s = 0; s < symbol; ++s) cum -= table.frequency[s];
    at_.narrow(cum, cum - table.frequency[symbol], table.total);
    for (;; at_.low = 2 * at_.low, at_.high = 2 * at_.high + 1) {
      if (at_.high < kQ2) {
        put(0);
      } else if (at_.low >= kQ2) {
        put(1);
        at_.low -= kQ2;
        at_.high -= kQ2;
      } else if (at_.low >= kQ1 && at_.high < kQ3) {
        ++pending_;
        at_.low -= kQ1;
        at_.high -= kQ1;
      } else {
        break;
      }
    }
    table.count(symbol);
  }

  std::vector<uint8_t> finish() {
    ++pending_;
    put(at_.low < kQ1 ? 0 : 1);
    return std::move(bytes_);
  }

 private:
  void put(unsigned bit) {
    append(bit);
    for (; pending_ > 0; --pending_) append(1 - bit);
  }
  void append(unsigned bit) {
    if (bits_ % 8 == 0) bytes_.push_back(0);
    bytes_.back() = static_cast<uint8_t>(bytes_.back() | bit << (7 - bits_ % 8));
    ++bits_;
  }

  Interval at_;
  uint64_t pending_ = 0;
  uint64_t bits_ = 0;
  std::vector<uint8_t> bytes_;
};

class Decoder {
 public:
  explicit Decoder(std::span<const uint8_t> data) : data_(data) {
    for (int i = 0; i < 16; ++i) code_ = 2 * code_ + bit();
  }

  size_t decode(Table& table) {
    whole_ += 16 + shifts_ <= uint64_t{data_.size()} * 8 ? 1 : 0;
    const uint32_t length = at_.high - at_.low + 1;
    const uint32_t target = ((code_ - at_.low + 1) * table.total - 1) / length;
    size_t symbol = 0;
    uint32_t cum = table.total;
    while (cum - table.frequency[symbol] > target) cum -= table.frequency[symbol++];
    at_.narrow(cum, cum - table.frequency[symbol], table.total);
    renormalise();
    table.count(symbol);
    return symbol;
  }

  [[nodiscard]] uint64_t frame_bits() const { return shifts_ + 2; }
  /// Symbols decoded from 16 bits of code that were all there.
  [[nodiscard]] uint64_t whole() const { return whole_; }

 private:
  void renormalise() {
    for (;; ++shifts_) {
      uint32_t take = 0;
      if (at_.high >= kQ2) {
        if (at_.low >= kQ2) {
          take = kQ2;
        } else if (at_.low >= kQ1 && at_.high < kQ3) {
          take = kQ1;
        } else {
          return;
        }
      }
      at_.low = 2 * (at_.low - take);
      at_.high = 2 * (at_.high - take) + 1;
      code_ = 2 * (code_ - take) + bit();
    }
  }
  uint32_t bit() {
    const uint64_t at = next_++;
    return at / 8 < data_.size() ? data_[at / 8] >> (7 - at % 8) & 1U : 0U;
  }

  std::span<const uint8_t> data_;
  Interval at_;
  uint32_t code_ = 0;
  uint64_t next_ = 0;
  uint64_t shifts_ = 0;
  uint64_t whole_ = 0;
};

struct Node {
  uint8_t parent;
  uint8_t position;
  bool undefined;
};

/// The walk of both directions: code_node(parent, position) and code_texture() return the symbol
/// that was coded; going(n) says whether to go on, with n more nodes ahead.
template <class CodeNode, class CodeTexture, class Going>
void walk(unsigned levels, bool textured, CodeNode code_node, CodeTexture code_texture,
          Going going) {
  std::vector<Node> level{{0, 0, textured}};
  for (unsigned l = 0; l < levels && going(level.size()); ++l) {
    std::vector<Node> below;
    for (const Node& node : level) {
      const uint8_t symbol = code_node(node.parent, node.position);
      if (!going(0)) return;
      const bool undefined = node.undefined && code_texture() == 0;
      if (!going(0)) return;
      for (uint8_t child = 0; child < 8; ++child) {
        if ((symbol >> child & 1) != 0) below.push_back({symbol, child, undefined});
      }
    }
    level = std::move(below);
  }
  for (const Node& voxel : level) {
    if (voxel.undefined && going(0)) code_texture();
  }
}

}  // namespace

std::vector<uint8_t> encode_frame(const OctreeFields& fields, unsigned levels, unsigned textures) {
  Model model(textures);
  Encoder encoder;
  auto node = fields.octree.begin();
  auto texture = fields.voxel_image_index.begin();
  walk(
      levels, textures > 0,
      [&](uint8_t parent, unsigned position) {
        unsigned t = 0;
        Table& table = model.node(parent, position, t);
        encoder.encode(table, kSymbolMaps.forward[t][*node]);
        return *node++;
      },
      [&] {
        encoder.encode(model.texture, *texture);
        return *texture++;
      },
      [](size_t) { return true; });
  return encoder.finish();
}

Frame decode_frame(std::span<const uint8_t> data, unsigned levels, unsigned textures,
                   uint64_t most_nodes) {
  Model model(textures);
  Decoder decoder(data);
  Frame frame;
  const uint64_t bits_present = uint64_t{data.size()} * 8;
  walk(
      levels, textures > 0,
      [&](uint8_t parent, unsigned position) {
        unsigned t = 0;
        Table& table = model.node(parent, position, t);
        const uint8_t symbol = kSymbolMaps.inverse[t][decoder.decode(table)];
        frame.fields.octree.push_back(symbol);
        return symbol;
      },
      [&] {
        const auto symbol = static_cast<uint8_t>(decoder.decode(model.texture));
        frame.fields.voxel_image_index.push_back(symbol);
        return symbol;
      },
      [&](size_t more) {
        if (frame.fields.octree.size() + more > most_nodes) return false;
        return decoder.frame_bits() == 2 || decoder.frame_bits() <= bits_present;
      });
  frame.bits = decoder.frame_bits();
  frame.truncated = frame.bits > bits_present;
  frame.whole = decoder.whole();
  return frame;
}

}  // namespace afx::codec::plain

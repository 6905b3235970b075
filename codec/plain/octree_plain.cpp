// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/plain/octree_plain.h"

#include <algorithm>
#include <utility>

#include "codec/plain/octree_plain_bits.h"
#include "codec/plain/octree_plain_coder.h"

namespace afx::codec::plain {
namespace {

struct Node {
  uint8_t context;  // the byte of its parent
  uint8_t position;
  bool undefined;   // the texture of its parent
  uint8_t texture;  // the one inherited
};

/// The walk of both directions. A Coding has node(Node) and texture(Node, of_voxel), which return
/// the symbol that was coded, context(symbol), inherit(texture), and begin_level(undefined nodes)
/// and stop() to end it early.
template <class Coding>
class Walk {
 public:
  Walk(Coding& coding, unsigned levels, unsigned textures, const WalkRules& rules)
      : coding_(coding),
        rules_(rules),
        node_levels_(static_cast<unsigned>(std::max(0, int(levels) + rules.more_node_levels))),
        textured_(textures > 0 || rules.textures_always) {
    if (levels == 0 && !rules.single_voxel_texture) textured_ = false;
  }

  void run() {
    const Node root{0, 0, textured_, rules_.undefined};
    std::vector<Node> level{root};
    if (rules_.order == LevelOrder::depth_first) {
      if (begin(level)) depth_first(root, 0);
      return;
    }
    for (unsigned l = 0; l < node_levels_; ++l) {
      if (!begin(level)) return;
      std::vector<Node> below;
      for (const Node& node : level)
        if (coding_.stop(0) || !add_children(node, l, below)) return;
      if (rules_.order == LevelOrder::parents_backwards) std::reverse(below.begin(), below.end());
      level = std::move(below);
    }
    if (!begin(level)) return;
    for (const Node& node : level) {
      if (coding_.stop(0)) return;
      voxel(node);
    }
  }

 private:
  bool begin(const std::vector<Node>& level) {
    coding_.begin_level(static_cast<uint64_t>(std::count_if(
        level.begin(), level.end(), [](const Node& node) { return node.undefined; })));
    return !coding_.stop(level.size());
  }

  void depth_first(const Node& node, unsigned level) {
    if (level == node_levels_) return voxel(node);
    std::vector<Node> children;
    add_children(node, level, children);
    for (const Node& child : children) {
      if (coding_.stop(children.size())) return;
      depth_first(child, level + 1);
    }
  }

  /// Codes a node; returns whether it got all its symbols.
  bool add_children(const Node& node, unsigned level, std::vector<Node>& below) {
    const bool has_texture = node.undefined && (level > 0 || rules_.root_texture);
    uint8_t texture = node.texture;
    if (has_texture && rules_.texture_first) texture = coding_.texture(false);
    const uint8_t symbol = coding_.node(node.context, node.position, node.undefined);
    if (coding_.stop(0) && has_texture) return false;
    if (has_texture && !rules_.texture_first) texture = coding_.texture(false);
    if (!node.undefined && textured_ && rules_.inherited_index) coding_.inherit(texture);
    const bool undefined =
        node.undefined && (texture == rules_.undefined || !rules_.texture_inherited);
    for (uint8_t i = 0; i < 8; ++i) {
      const auto child = static_cast<uint8_t>(rules_.siblings_backwards ? 7 - i : i);
      const unsigned bit = rules_.bits_backwards ? 7U - child : child;
      if ((symbol >> bit & 1) != 0)
        below.push_back({coding_.context(symbol), child, undefined, texture});
    }
    return true;
  }

  void voxel(const Node& node) {
    if (node.undefined && rules_.voxel_textures) {
      coding_.texture(true);
    } else if (textured_ && rules_.inherited_index) {
      coding_.inherit(node.texture);
    }
  }

  Coding& coding_;
  const WalkRules& rules_;
  unsigned node_levels_;
  bool textured_;
};

/// What both directions do alike with a node symbol's table.
class Coding {
 public:
  Coding(const Rules& rules, Model& model) : rules_(rules), model_(model) {}
  /// The context that the children of the node coded last have.
  [[nodiscard]] uint8_t context(uint8_t symbol) const {
    return rules_.walk.transformed_byte ? coded_ : symbol;
  }

 protected:
  [[nodiscard]] const std::array<uint8_t, 256>& forward(unsigned t) const {
    const Symmetries& symmetries = *rules_.model.symmetries;
    return rules_.model.base_to_parent ? symmetries.inverse[t] : symmetries.forward[t];
  }
  [[nodiscard]] const std::array<uint8_t, 256>& inverse(unsigned t) const {
    const Symmetries& symmetries = *rules_.model.symmetries;
    return rules_.model.base_to_parent == rules_.model.decoder_inverts ? symmetries.forward[t]
                                                                       : symmetries.inverse[t];
  }
  void count(Table& table, uint8_t symbol) {
    table.count(rules_.model.own_symbol_counts ? symbol : coded_);
  }

  const Rules& rules_;
  Model& model_;
  uint8_t coded_ = 0;  // the node symbol coded last, as it was coded
};

class Encoding : public Coding {
 public:
  Encoding(const OctreeFields& fields, const Rules& rules, Model& model)
      : Coding(rules, model), fields_(fields), encoder_(rules.coder) {}

  // Fields fit the text's rules; by broken ones they may run out, which is as good as an end.
  uint8_t node(uint8_t context, uint8_t position, bool /*undefined*/) {
    const uint8_t symbol = node_ < fields_.octree.size() ? fields_.octree[node_++] : uint8_t{0};
    const NodeTable at = model_.node(context, position);
    coded_ = forward(at.symmetry)[symbol];
    encoder_.encode(at.table, coded_);
    count(at.table, symbol);
    return symbol;
  }
  uint8_t texture(bool of_voxel) {
    Table& table = model_.texture(of_voxel);
    const std::vector<uint8_t>& index = fields_.voxel_image_index;
    const uint8_t symbol = texture_ < index.size() ? index[texture_++] : uint8_t{0};
    const auto most = static_cast<uint8_t>(table.frequency.size() - 1);
    encoder_.encode(table, std::min(symbol, most));
    table.count(std::min(symbol, most));
    return symbol;
  }
  void inherit(uint8_t /*texture*/) {}
  void begin_level(uint64_t /*undefined*/) {}
  static bool stop(uint64_t /*nodes*/) { return false; }
  std::vector<bool> finish() { return encoder_.finish(); }

 private:
  const OctreeFields& fields_;
  Encoder encoder_;
  size_t node_ = 0;
  size_t texture_ = 0;
};

class Decoding : public Coding {
 public:
  Decoding(const std::vector<bool>& data, uint64_t most_nodes, const Rules& rules, Model& model)
      : Coding(rules, model), most_nodes_(most_nodes), decoder_(data, rules.coder) {}

  uint8_t node(uint8_t context, uint8_t position, bool undefined) {
    const NodeTable at = model_.node(context, position);
    coded_ = static_cast<uint8_t>(decoder_.decode(at.table));
    const uint8_t symbol = inverse(at.symmetry)[coded_];
    count(at.table, symbol);
    const bool childless = symbol == 0 && frame_.fields.octree.size() >= rules_.walk.childless_from;
    frame_.childless += childless ? 1 : 0;
    undefined_childless_ += symbol == 0 && undefined ? 1 : 0;
    frame_.fields.octree.push_back(rules_.walk.coded_octree ? coded_ : symbol);
    return symbol;
  }
  uint8_t texture(bool of_voxel) {
    Table& table = model_.texture(of_voxel);
    const size_t symbol = decoder_.decode(table);
    table.count(symbol);
    frame_.undefined_voxel = frame_.undefined_voxel || (of_voxel && symbol == 0);
    frame_.fields.voxel_image_index.push_back(static_cast<uint8_t>(symbol));
    return static_cast<uint8_t>(symbol);
  }
  void inherit(uint8_t texture) { frame_.fields.voxel_image_index.push_back(texture); }
  void begin_level(uint64_t undefined) {
    const OctreeFields& fields = frame_.fields;
    frame_.levels.push_back(
        {fields.octree.size(), fields.voxel_image_index.size(), undefined, undefined_childless_});
  }
  [[nodiscard]] bool stop(uint64_t nodes) {
    frame_.too_many = frame_.too_many || frame_.fields.octree.size() + nodes > most_nodes_;
    const bool begun = !frame_.fields.octree.empty() || !frame_.fields.voxel_image_index.empty();
    return frame_.too_many || (begun && rules_.coder.truncation_at_once && truncated());
  }
  Frame finish() {
    frame_.bits = decoder_.bits();
    frame_.truncated = truncated();
    frame_.whole = decoder_.whole();
    frame_.ends_well = decoder_.ends_well();
    return std::move(frame_);
  }

 private:
  [[nodiscard]] bool truncated() const { return rules_.coder.truncation && decoder_.truncated(); }

  uint64_t most_nodes_;
  Decoder decoder_;
  Frame frame_;
  uint64_t undefined_childless_ = 0;
};

}  // namespace

std::vector<bool> encode_frame(const OctreeFields& fields, unsigned levels, unsigned textures,
                               const Rules& rules, Model& model) {
  Encoding encoding(fields, rules, model);
  Walk(encoding, levels, textures, rules.walk).run();
  return encoding.finish();
}

Frame decode_frame(const std::vector<bool>& data, unsigned levels, unsigned textures,
                   uint64_t most_nodes, const Rules& rules, Model& model) {
  Decoding decoding(data, most_nodes, rules, model);
  Walk(decoding, levels, textures, rules.walk).run();
  return decoding.finish();
}

std::vector<uint8_t> encode_frame(const OctreeFields& fields, unsigned levels, unsigned textures) {
  Model model(textures, text_rules());
  return bytes_of_bits(encode_frame(fields, levels, textures, text_rules(), model), BitRules{});
}

Frame decode_frame(std::span<const uint8_t> data, unsigned levels, unsigned textures,
                   uint64_t most_nodes) {
  Model model(textures, text_rules());
  return decode_frame(bits_of_bytes(data, BitRules{}), levels, textures, most_nodes, text_rules(),
                      model);
}

}  // namespace afx::codec::plain

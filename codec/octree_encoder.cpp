// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/octree_encoder.h"

#include <algorithm>
#include <string>

#include "codec/arithmetic_encoder.h"
#include "codec/octree_contexts.h"
#include "codec/octree_voxels.h"
#include "codec/octree_walk.h"

namespace afx::codec {
namespace {

constexpr Limits kUnlimited{.octree_nodes = UINT64_MAX, .memory = UINT64_MAX};

Error bad_field(std::string text) { return {Errc::bad_argument, Place::none(), std::move(text)}; }

class FrameEncoder {
 public:
  FrameEncoder(const OctreeFields& fields, unsigned textures, std::vector<uint8_t>& out)
      : fields_(fields), contexts_(textures), walk_(fields, textures > 0), encoder_(out) {}

  /// Encodes the frame and returns its bits. Whether voxelImageIndex had as many symbols as it
  /// takes, fits() tells afterwards; if not, the bits are of no use.
  uint64_t run(const std::vector<uint64_t>& level_counts) {
    for (size_t level = 0; level + 1 < level_counts.size(); ++level) {
      while (walk_.remaining() > 0) encode_batch(walk_.next_contexts());
      if (textures_ > fields_.voxel_image_index.size())
        return 0;  // nothing to walk the next level by
      walk_.descend(level_counts[level + 1], textures_);
    }
    encode_voxels();
    return encoder_.finish();
  }

  [[nodiscard]] bool fits() const { return textures_ == fields_.voxel_image_index.size(); }

 private:
  void encode_batch(const OctreeWalk::Batch& batch) {
    for (size_t done = 0; done < batch.count;) {
      const uint64_t in_stage = contexts_.enter_stage(nodes_);
      const auto now = static_cast<size_t>(std::min(uint64_t{batch.count - done}, in_stage));
      encode_nodes(batch.contexts + done, now);
      done += now;
    }
  }

  void encode_nodes(const NodeContext* contexts, size_t count) {
    const uint8_t* symbols = fields_.octree.data() + nodes_;
    ArithmeticEncoder encoder = encoder_;  // a copy of our own stays in registers
    for (size_t i = 0; i < count; ++i) {
      const NodeContext context = contexts[i];
      const uint8_t mapped = kSymbolMaps.forward[contexts_.symmetry(context)][symbols[i]];
      encoder.encode(contexts_.node_table(context), mapped);
      if ((context & kTextured) != 0) encode_texture(encoder);
    }
    encoder_ = encoder;
    nodes_ += count;
  }

  void encode_voxels() {
    if (fields_.voxel_image_index.empty()) return;
    while (walk_.remaining() > 0) {
      const OctreeWalk::Run run = walk_.next_run();
      for (uint64_t n = 0; run.textured && n < run.nodes; ++n) encode_texture(encoder_);
    }
  }

  /// Where the symbols have run out it only counts what is missing.
  void encode_texture(ArithmeticEncoder& encoder) {
    const std::vector<uint8_t>& index = fields_.voxel_image_index;
    if (textures_ < index.size()) encoder.encode(contexts_.texture_table(), index[textures_]);
    ++textures_;
  }

  const OctreeFields& fields_;
  OctreeContexts contexts_;
  OctreeWalk walk_;
  ArithmeticEncoder encoder_;
  size_t nodes_ = 0;     // symbols encoded
  size_t textures_ = 0;  // symbols asked for
};

Status check_indices(const std::vector<uint8_t>& index, unsigned textures) {
  if (textures == 0) {
    if (index.empty()) return {};
    return bad_field("field voxelImageIndex has " + std::to_string(index.size()) +
                     " symbols, but there are no images (expected none)");
  }
  if (index.empty()) {
    return bad_field(
        "field voxelImageIndex is empty (expected at least 1 symbol, as there are images)");
  }
  if (*std::max_element(index.begin(), index.end()) <= textures) return {};
  const auto wrong =
      std::find_if(index.begin(), index.end(), [&](uint8_t k) { return k > textures; });
  return bad_field("field voxelImageIndex has " + std::to_string(*wrong) + " at position " +
                   std::to_string(wrong - index.begin()) + " (expected 0.." +
                   std::to_string(textures) + ", the number of images)");
}

}  // namespace

Status check_octree_fields(const OctreeFields& fields, unsigned levels, unsigned textures) {
  if (Status indices = check_indices(fields.voxel_image_index, textures); !indices.ok())
    return indices;
  const auto images = octree_voxel_images(fields, levels, 0, kUnlimited);
  return images.ok() ? Status{} : images.error();
}

Result<uint64_t> encode_octree_frame(const OctreeFields& fields, unsigned levels, unsigned textures,
                                     std::vector<uint8_t>& out) {
  const auto counts = octree_level_counts(fields.octree, levels, kUnlimited);
  if (!counts.ok()) return counts.error();
  if (Status indices = check_indices(fields.voxel_image_index, textures); !indices.ok())
    return indices.error();
  const size_t before = out.size();
  FrameEncoder encoder(fields, textures, out);
  const uint64_t bits = encoder.run(counts.value());
  if (encoder.fits()) return bits;
  out.resize(before);
  return check_octree_fields(fields, levels, textures).error();
}

}  // namespace afx::codec

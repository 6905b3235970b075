// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/octree_compare.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "codec/octree_voxels.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

/// The first place where two byte fields differ, in words; empty where they are the same.
std::string difference_of(const char* field, const std::vector<uint8_t>& a,
                          const std::vector<uint8_t>& b) {
  const auto at = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (at.first == a.end() && at.second == b.end()) return {};
  const auto value = [](auto found, auto end) {
    return found == end ? std::string("nothing") : std::to_string(*found);
  };
  return std::string("field ") + field + " differs at position " +
         std::to_string(at.first - a.begin()) + ": " + value(at.first, a.end()) + " and " +
         value(at.second, b.end()) + " (lengths " + std::to_string(a.size()) + " and " +
         std::to_string(b.size()) + ")";
}

/// How far apart the voxels of two octrees are, frame by frame.
struct VoxelDistance {
  uint64_t only_a = 0;
  uint64_t only_b = 0;
  uint64_t both = 0;
  uint64_t other_image = 0;  ///< of those in both, coloured by another image
};

/// A frame as voxels and the images they have; two parallel lists.
struct FrameVoxels {
  std::vector<uint64_t> codes;
  std::vector<uint8_t> images;
};

Result<FrameVoxels> voxels_of(const OctreeFields& fields, unsigned levels, const Limits& limits) {
  auto codes = codec::octree_morton(fields.octree, levels, levels, limits);
  if (!codes.ok()) return std::move(codes).error();
  auto images = codec::octree_voxel_images(fields, levels, levels, limits);
  if (!images.ok()) return std::move(images).error();
  return FrameVoxels{std::move(codes).value(), std::move(images).value()};
}

void add_distance(const FrameVoxels& a, const FrameVoxels& b, VoxelDistance& distance) {
  size_t i = 0;
  size_t j = 0;
  while (i < a.codes.size() && j < b.codes.size()) {
    if (a.codes[i] == b.codes[j]) {
      ++distance.both;
      if (a.images[i] != b.images[j]) ++distance.other_image;
      ++i;
      ++j;
    } else if (a.codes[i] < b.codes[j]) {
      ++distance.only_a;
      ++i;
    } else {
      ++distance.only_b;
      ++j;
    }
  }
  distance.only_a += a.codes.size() - i;
  distance.only_b += b.codes.size() - j;
}

/// Adds how far apart two streams are to what is said, if their voxels can be laid side by side.
void measure(const OctreeStream& a, const OctreeStream& b, const Limits& limits, Verdict& verdict) {
  const unsigned levels = octree_levels(a.resolution);
  if (levels != octree_levels(b.resolution) || levels > codec::kMortonLevels) return;
  if (a.frames.size() != b.frames.size()) return;
  Limits half = limits;  // for each of the two, eleven bytes a voxel while it works
  half.octree_nodes = std::min(limits.octree_nodes, limits.memory / 2 / 11);
  VoxelDistance d;
  for (size_t i = 0; i < a.frames.size(); ++i) {
    const auto x = voxels_of(a.frames[i], levels, half);
    const auto y = voxels_of(b.frames[i], levels, half);
    if (!x.ok() || !y.ok()) return;
    add_distance(x.value(), y.value(), d);
  }
  const double share =
      d.both == 0 ? 0 : static_cast<double>(d.other_image) / static_cast<double>(d.both);
  verdict.json["voxelsOnlyA"] = d.only_a;
  verdict.json["voxelsOnlyB"] = d.only_b;
  verdict.json["voxelsBoth"] = d.both;
  verdict.json["otherImageShare"] = share;
  verdict.text += "\nvoxels: " + grouped(d.only_a) + " in A only, " + grouped(d.only_b) +
                  " in B only, " + grouped(d.both) + " in both; " + fixed(share * 100, 2) +
                  " % of those have another image";
}

Verdict compare_fields(const OctreeStream& a, const OctreeStream& b) {
  const auto number = [](const char* what, uint64_t x, uint64_t y) {
    return differ(std::string(what) + " is " + std::to_string(x) + " and " + std::to_string(y));
  };
  if (a.resolution != b.resolution) return number("octreeResolution", a.resolution, b.resolution);
  if (a.textures != b.textures) return number("the number of images", a.textures, b.textures);
  if (a.frames.size() != b.frames.size())
    return number("the number of frames", a.frames.size(), b.frames.size());
  for (size_t i = 0; i < a.frames.size(); ++i) {
    const OctreeFields& x = a.frames[i];
    const OctreeFields& y = b.frames[i];
    std::string text = difference_of("octree", x.octree, y.octree);
    if (text.empty())
      text = difference_of("voxelImageIndex", x.voxel_image_index, y.voxel_image_index);
    if (!text.empty())
      return differ((a.frames.size() > 1 ? "frame " + std::to_string(i) + ": " : "") + text);
  }
  return same("the OctreeImage fields are the same", {{"frames", a.frames.size()}});
}

}  // namespace

Result<OctreeStream> octrees_of(const Input& input, OctreeQuery& query, const Session& session,
                                Diagnostics& diagnostics) {
  if (input.kind == Kind::octree_stream) {
    OctreeDecodeOptions how{.threads = session.options.threads};
    how.limits = session.limits;
    DecodedOctreeStream decoded = decode_octree_stream(input.file.bytes(), how, diagnostics);
    if (!decoded.status.ok()) return std::move(decoded.status).error();
    return std::move(decoded.stream);
  }
  auto octree = read_octree(input, query, session.limits, diagnostics);
  if (!octree.ok()) return std::move(octree).error();
  OctreeNode& node = octree.value();
  const uint32_t textures = node.fields.voxel_image_index.empty() ? 0 : node.images;
  OctreeStream stream{node.resolution, textures, {}};
  stream.frames.push_back(std::move(node.fields));
  return stream;
}

Verdict compare_octrees(const OctreeStream& a, const OctreeStream& b, const Limits& limits) {
  Verdict verdict = compare_fields(a, b);
  if (verdict.different) measure(a, b, limits, verdict);
  return verdict;
}

}  // namespace afx::tools

#include <afx/octree_stream.h>
#include <codec/octree_voxels.h>

#include <cstdio>

int main() {
  const uint8_t stream[] = {0x14, 0x00, 0x00, 0x00, 0x01, 0xC8, 0xFE, 0x40};
  afx::Diagnostics warnings;
  const auto decoded = afx::decode_octree_stream(stream, {}, warnings);
  if (!decoded.status.ok()) return std::puts(to_string(decoded.status.error()).c_str()), 1;
  const unsigned levels = afx::octree_levels(decoded.stream.resolution);
  const auto voxels = afx::codec::octree_voxels(decoded.stream.frames[0].octree, levels, levels);
  for (const afx::Voxel v : voxels.value()) std::printf("voxel %u %u %u\n", v.x, v.y, v.z);
}

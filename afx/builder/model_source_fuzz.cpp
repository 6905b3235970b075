// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What models are built from, as far as its readers are ours: PLY points, lists of cameras, lists
// of RGB-D pictures. Each gives what fits together, or an error that says something; points that
// are written are read again.
#include <cstdint>
#include <span>

#include "afx/builder/camera_list.h"
#include "afx/builder/model_reader.h"
#include "afx/builder/ply_writer.h"
#include "afx/builder/rgbd_description.h"
#include "codec/fuzz_test_support.h"

namespace {

using namespace afx;

Limits small_limits() {
  Limits limits;
  limits.memory = 1 << 24;
  limits.scene_values = 1 << 16;
  return limits;
}

void check_points(std::span<const uint8_t> bytes) {
  Diagnostics diagnostics;
  const auto cloud = read_ply_points(bytes, small_limits(), diagnostics);
  if (!cloud.ok()) return require(!cloud.error().text.empty());
  const auto written = write_ply_points(cloud.value());
  const auto again = read_ply_points(written, {}, diagnostics);
  require(again.ok() && again.value().positions.size() == cloud.value().positions.size());
}

void check_cameras(std::span<const uint8_t> bytes) {
  const auto shots = read_camera_list(bytes, small_limits());
  if (!shots.ok()) return require(!shots.error().text.empty());
  require(!shots.value().empty());
  for (const Shot& shot : shots.value()) require(check_depth_camera(shot.camera).ok());
}

void check_rgbd(std::span<const uint8_t> bytes) {
  Diagnostics diagnostics;
  const auto frames = read_rgbd_description(bytes, small_limits(), diagnostics);
  if (!frames.ok()) require(!frames.error().text.empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::span<const uint8_t> bytes(data, size);
  check_points(bytes);
  check_cameras(bytes);
  check_rgbd(bytes);
  return 0;
}

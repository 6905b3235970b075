// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The ways of `afx decode`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/input.h"
#include "tools/session.h"

namespace afx {
class OutputFiles;
}

namespace afx::tools {

struct DecodeOptions {
  std::string input;
  std::string output;
  std::string format;
  std::string input_format;
  std::optional<uint32_t> frame;
  std::optional<unsigned> levels;
  bool partial = false;
};

/// An OctreeImage stream into scene text or raw octrees, a file for each frame. Returns an exit
/// code.
int decode_octrees(const DecodeOptions& options, const std::string& format, const Input& input,
                   OutputFiles& outputs, const Session& session, Diagnostics& diagnostics);

/// An MP4 file or a raw BIFS stream into BT, XMT-A or JSON, or, format "wrl", into the scene as it
/// is at the end, with its pictures beside it. Returns an exit code.
int decode_presentation(const DecodeOptions& options, const std::string& format, const Input& input,
                        OutputFiles& outputs, const Session& session, Diagnostics& diagnostics);

/// The DIBR objects of a scene of any kind, or RGB-D pictures, as a point cloud (PLY): pixels at
/// their depth, voxel centres. Returns an exit code.
int decode_points(const DecodeOptions& options, const Input& input, OutputFiles& outputs,
                  const Session& session, Diagnostics& diagnostics);

}  // namespace afx::tools

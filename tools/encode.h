// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The two ways of `afx encode`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/session.h"

namespace afx {
class OutputFiles;
}

namespace afx::tools {

struct EncodeOptions {
  std::vector<std::string> inputs;
  std::string output;
  std::string format;
  std::string input_format;
  // an octree stream
  std::string node;
  std::optional<uint32_t> resolution;
  // a scene
  std::string afx;       ///< stream, buffer, none; empty: stream for a plain scene, else none
  std::string pictures;  ///< stream, none; likewise
  std::string choices = "own";
  std::string names = "auto";
  bool predictive = false;
  bool quantize = false;
  std::vector<std::string> quantize_bits;  ///< "color=8"
};

/// Octree fields of the inputs, each a frame, into an OctreeImage stream. Returns an exit code.
int encode_octrees(const EncodeOptions& options, OutputFiles& outputs, const Session& session);

/// A scene with its commands, object descriptors, octrees and pictures into an MP4 file or, format
/// "bifs", a raw stream. Returns an exit code.
int encode_presentation(const EncodeOptions& options, const std::string& format,
                        OutputFiles& outputs, const Session& session);

}  // namespace afx::tools

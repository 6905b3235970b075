// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "bifs/command.h"
#include "bifs/config.h"
#include "codec/error.h"

namespace afx::bifs {

/// What an encoder may choose. The defaults are GPAC's choices, so that the same commands give the
/// same bits; they are good choices too.
struct EncodeOptions {
  /// Form of lists and of node descriptions.
  enum class Form : uint8_t {
    shorter,  ///< as GPAC counts them: for lists, the list form up to 6 elements, then the vector
    list,
    compact  ///< the vector of lists, the mask of nodes
  };
  Form lists = Form::shorter;
  Form nodes = Form::shorter;
  /// Write images that were not given (as 0x0) and lists of script texts too: GPAC never takes
  /// these for equal to their default.
  bool always_write_images = false;
  /// Where the configuration has use_predictive_field: code quantized numeric MFFields predictively
  /// if that is shorter. GPAC never does and cannot read it; the coding is not verified against any
  /// other program (bifs/predictive_model.h).
  bool predictive = false;
  /// Write integers that have a range (OctreeImage.octree: 8 bits instead of 32) under coding
  /// quantizers (bifs/coding_quantizer.h) where that makes the stream shorter: before children that
  /// no command can address, where no quantizer is active. Not with usePredictiveMFField.
  bool short_integers = false;
};

/// Encodes commands into access units; the mirror of BifsDecoder.
///
/// A frame is made by add() for each command and then finish(). Each command must be given with the
/// scene as it stands before the command is applied, for the coding depends on it; whoever encodes
/// applies the command after adding it (bifs/apply.h). A node is written whole at its first place
/// since the last scene replacement and by its ID at the others, so nodes with several places and
/// targets of commands need an ID (nodes::Node::id), as do ROUTEs that are changed and PROTOs.
///
/// Fields that equal their default are left out. Not for use by several threads at once.
class BifsEncoder {
 public:
  explicit BifsEncoder(const BifsConfig& config, const EncodeOptions& options = {});
  BifsEncoder(BifsEncoder&&) noexcept;
  BifsEncoder& operator=(BifsEncoder&&) noexcept;
  ~BifsEncoder();

  /// Adds a command to the frame at work.
  ///
  /// Errors: bad_argument (an ID is missing or does not fit the configuration; a field that the
  /// command cannot address; a value that the quantizer cannot hold; a node where its type may not
  /// stand), unsupported (a script that is not inline or not understood; a command buffer that is
  /// only text). After an error the frame is lost: go on with a scene replacement.
  Status add(const Command& command, const nodes::Scene& scene);

  /// Ends the frame: its bytes, the last one filled with zero bits.
  /// Errors: that of an add() that failed; bad_argument (no command was added).
  Result<std::vector<uint8_t>> finish();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Encodes a frame of commands and applies each to the scene.
Result<std::vector<uint8_t>> encode_frame(BifsEncoder& encoder, nodes::Scene& scene,
                                          const std::vector<Command>& commands);

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "bifs/command.h"
#include "bifs/config.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/limits.h"
#include "nodes/scene.h"

namespace afx::bifs {

struct DecoderState;

struct DecodeOptions {
  /// Keep coding quantizers (bifs/coding_quantizer.h), which are no part of the scene: for who
  /// wants to see the stream as it is. The scene then has nodes that nobody put there.
  bool keep_coding_quantizers = false;
  /// Hears, in long lists of numbers, that everything before a byte of the access unit has been
  /// read: it may be dropped from memory if it can be read again (a mapped file).
  std::function<void(size_t byte)> passed = {};
};

/// What one access unit held.
struct CommandFrame {
  std::vector<Command> commands;
  uint64_t bits_used = 0;  ///< up to the padding of the last byte
};

/// Decodes the access units of one scene stream, in order, into one scene.
///
/// Each command is applied to the scene as soon as it is decoded, because later ones may depend on
/// it: the number of points is the width of an index, a child of a list is the layout of a value.
/// So a command in the returned frame shows its nodes as they stand at the end of the frame. Who
/// wants to see a command before the next one changes its nodes (to print or to encode it) passes a
/// CommandSink.
///
/// Not for use by several threads at once.
class BifsDecoder {
 public:
  /// Hears of each command of a frame when it is decoded and before it is applied; where a command
  /// buffer speaks of nodes that come later in the frame, when that has been decoded. The
  /// references are good during the call.
  using CommandSink = std::function<void(const Command& command, const nodes::Scene& scene)>;

  explicit BifsDecoder(const BifsConfig& config, const Limits& limits = {},
                       const DecodeOptions& options = {});
  BifsDecoder(BifsDecoder&&) noexcept;
  BifsDecoder& operator=(BifsDecoder&&) noexcept;
  ~BifsDecoder();

  /// Decodes one access unit. After an error the scene holds the commands before the one that
  /// failed; decoding can go on with an access unit that begins with a scene replacement.
  ///
  /// Errors (place: bit in `data`; text begins with the path of the structure, e.g.
  /// "commandFrame/SceneReplacement/Group/children"):
  ///   truncated       the data end inside the frame
  ///   malformed       unknown node code, ID, PROTO; a node in a place where it may not stand;
  ///                   a quantized integer of a category that has none; and so on
  ///   unsupported     3D mesh coding; field types of private numbers
  ///   limit_exceeded  limits.scene_depth, scene_values, memory (of one call), picture_pixels
  /// Warnings: trailing_bytes, align_bits, id_twice, name_twice, name_changed (of a PROTO or a
  /// field: no identifier, or a node's), reserved_bits, residual_ending (a predictive MFField may
  /// be damaged), not_applied (the command is well coded but says what cannot be, e.g. an index
  /// behind the end).
  Result<CommandFrame> decode(std::span<const uint8_t> data, Diagnostics& diagnostics,
                              const CommandSink& sink = {}, const codec::Trace* trace = nullptr);

  [[nodiscard]] const BifsConfig& config() const;
  /// The scene as it stands after the last access unit. Nodes that have been replaced or deleted
  /// stay in it unconnected, so node numbers stay good.
  [[nodiscard]] const nodes::Scene& scene() const;
  /// Hands the scene over; the decoder is done with it.
  [[nodiscard]] nodes::Scene take_scene();

 private:
  std::unique_ptr<DecoderState> state_;
};

}  // namespace afx::bifs

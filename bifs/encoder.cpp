// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, BIFS command frames (clauses not checked); spec/bifs.md 3.
#include "bifs/encoder.h"

#include <utility>

#include "bifs/apply.h"
#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"

namespace afx::bifs {

class BifsEncoder::State : public FrameEncoder {
 public:
  using FrameEncoder::FrameEncoder;
};

BifsEncoder::BifsEncoder(const BifsConfig& config, const EncodeOptions& options)
    : state_(std::make_unique<State>(config, options)) {}
BifsEncoder::BifsEncoder(BifsEncoder&&) noexcept = default;
BifsEncoder& BifsEncoder::operator=(BifsEncoder&&) noexcept = default;
BifsEncoder::~BifsEncoder() = default;

Status BifsEncoder::add(const Command& command, const nodes::Scene& scene) {
  return state_->add(command, scene);
}
Result<std::vector<uint8_t>> BifsEncoder::finish() { return state_->finish(); }

Result<std::vector<uint8_t>> encode_frame(BifsEncoder& encoder, nodes::Scene& scene,
                                          const std::vector<Command>& commands) {
  for (const Command& command : commands) {
    const Status added = encoder.add(command, scene);
    if (!added.ok()) break;  // finish() tells, and clears the frame
    const Status applied = apply_command(scene, command);
    if (applied.ok()) continue;
    (void)encoder.finish();
    return applied.error();
  }
  return encoder.finish();
}

FrameEncoder::Part::Part(FrameEncoder& encoder, std::string_view name)
    : encoder_(encoder), before_(encoder.path_.size()) {
  encoder.path_.append(encoder.path_.empty() ? "" : "/").append(name);
}

void FrameEncoder::fail(Errc code, const std::string& text) {
  if (ok()) error_ = Error{code, {}, path_.empty() ? text : path_ + ": " + text};
}

void FrameEncoder::put(uint64_t value, unsigned bits) {
  if (!ok()) return;
  if (bits < 64 && value >> bits != 0)
    return fail(Errc::bad_argument,
                std::to_string(value) + " does not fit " + std::to_string(bits) + " bits");
  if (bits > 32) out_->writer.u(static_cast<uint32_t>(value >> 32), bits - 32);
  out_->writer.u(static_cast<uint32_t>(value), bits > 32 ? 32 : bits);
}

/// The number of bits of a number, then the number.
void FrameEncoder::put_sized(uint64_t value, unsigned size_bits) {
  put(bits_for(value), size_bits);
  put(value, bits_for(value));
}

void FrameEncoder::put_bytes(std::span<const uint8_t> bytes) {
  if (ok()) out_->writer.bytes(bytes);
}

void FrameEncoder::put_name(std::string_view name) {
  put_bytes({reinterpret_cast<const uint8_t*>(name.data()), name.size()});
  put(0, 8);
}

Status FrameEncoder::add(const Command& added, const nodes::Scene& scene) {
  scene_ = &scene;
  savings_ = {};
  if (out_->commands == 0) quantizer_ = global_quantizer_ ? &*global_quantizer_ : nullptr;
  command(added);
  if (!ok()) return *error_;
  return {};
}

Result<std::vector<uint8_t>> FrameEncoder::finish() {
  if (frame_.commands == 0) fail(Errc::bad_argument, "a frame without commands");
  put_flag(false);  // moreCommands
  std::vector<uint8_t> bytes = std::exchange(frame_.bytes, {});
  frame_.writer.align();
  frame_.commands = 0;
  path_.clear();
  const std::optional<Error> error = std::exchange(error_, std::nullopt);
  if (error) return *error;
  return bytes;
}

}  // namespace afx::bifs

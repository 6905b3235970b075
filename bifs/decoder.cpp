// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, BIFS command frames (clauses not checked); spec/bifs.md 3.
#include "bifs/decoder.h"

#include <utility>

#include "bifs/apply.h"
#include "bifs/decoder_frame.h"

namespace afx::bifs {

BifsDecoder::BifsDecoder(const BifsConfig& config, const Limits& limits,
                         const DecodeOptions& options)
    : state_(std::make_unique<DecoderState>()) {
  state_->config = config;
  state_->limits = limits;
  state_->options = options;
}
BifsDecoder::BifsDecoder(BifsDecoder&&) noexcept = default;
BifsDecoder& BifsDecoder::operator=(BifsDecoder&&) noexcept = default;
BifsDecoder::~BifsDecoder() = default;

const BifsConfig& BifsDecoder::config() const { return state_->config; }
const nodes::Scene& BifsDecoder::scene() const { return state_->scene; }
nodes::Scene BifsDecoder::take_scene() { return std::move(state_->scene); }

Result<CommandFrame> BifsDecoder::decode(std::span<const uint8_t> data, Diagnostics& diagnostics,
                                         const CommandSink& sink, const codec::Trace* trace) {
  return FrameDecoder(*state_, data, diagnostics, trace).read(sink);
}

FrameDecoder::Part::Part(FrameDecoder& decoder, std::string_view name)
    : decoder_(decoder), before_(decoder.path_.size()), scope_(*decoder.in_, name) {
  decoder.path_.append(decoder.path_.empty() ? "" : "/").append(name);
}

FrameDecoder::Depth::Depth(FrameDecoder& decoder) : decoder_(decoder) {
  if (++decoder.depth_ > decoder.state_.limits.scene_depth)
    decoder.fail(Errc::limit_exceeded, "nested deeper than the limit scene_depth, " +
                                           std::to_string(decoder.state_.limits.scene_depth));
}

FrameDecoder::FrameDecoder(DecoderState& state, std::span<const uint8_t> data,
                           Diagnostics& diagnostics, const codec::Trace* trace)
    : state_(state), diagnostics_(&diagnostics), frame_(data, trace), in_(&frame_), data_(data) {}

void FrameDecoder::fail(Errc code, const std::string& text) {
  if (ok()) in_->fail(code, path_ + ": " + text);
}

void FrameDecoder::warn(std::string_view code, const std::string& text) {
  diagnostics_->warn(std::string(code), Place::at_bit(in_->bit()), path_ + ": " + text);
}

/// Counts what is about to be kept against the limits of the call.
bool FrameDecoder::take(uint64_t count, size_t bytes) {
  if (!ok()) return false;
  values_taken_ += count;
  if (values_taken_ > state_.limits.scene_values) {
    fail(Errc::limit_exceeded,
         "more values than the limit scene_values, " + std::to_string(state_.limits.scene_values));
    return false;
  }
  // No overflow: count is below 2^32, and what has been taken below the limit.
  bytes_taken_ += count * bytes;
  if (bytes_taken_ > state_.limits.memory)
    fail(Errc::limit_exceeded,
         "more memory than the limit memory, " + std::to_string(state_.limits.memory) + " bytes");
  return ok();
}

/// Bytes up to a zero byte.
std::string FrameDecoder::read_name(std::string_view what) {
  std::string name;
  while (ok()) {
    const auto c = static_cast<char>(u(8, what));
    if (!ok() || c == '\0' || !take(0, 1) || !take(1, 1)) break;
    name.push_back(c);
  }
  return name;
}

Result<CommandFrame> FrameDecoder::read(const BifsDecoder::CommandSink& sink) {
  CommandFrame frame;
  {
    const Part part(*this, "commandFrame");
    if (state_.global_quantizer) {
      frame_quantizer_ = state_.global_quantizer;
      quantizer_ = &*frame_quantizer_;
    }
    read_frame(sink, frame);
  }
  if (!frame_.ok()) return frame_.error();
  return frame;
}

void FrameDecoder::read_frame(const BifsDecoder::CommandSink& sink, CommandFrame& frame) {
  bool more = true;
  size_t told = 0;  // commands that the sink has heard of
  while (ok() && more) {
    std::optional<Command> command = read_command();
    if (!ok() || !command || !take(1, sizeof(Command))) return;
    frame.commands.push_back(std::move(*command));
    more = u(1, "moreCommands") != 0;
    read_buffers(!more);
    if (!ok()) return;
    if (buffers_.empty()) forget_bodies();
    // Who hears of a command hears of what its buffers hold.
    for (; buffers_.empty() && told < frame.commands.size(); ++told)
      if (sink) sink(frame.commands[told], state_.scene);
    keep_first_lists(frame.commands.back());
    const Status applied = apply_command(state_.scene, frame.commands.back());
    if (!applied.ok()) warn("not_applied", applied.error().text);
  }
  frame.bits_used = in_->bit();
  in_->align(*diagnostics_);
  if (in_->bits_left() > 0)
    warn("trailing_bytes", std::to_string(in_->bits_left() / 8) + " bytes behind the frame");
}

/// The IDs of nodes in PROTO bodies mean nothing outside, but for the command buffers there.
void FrameDecoder::forget_bodies() {
  for (const nodes::ScopeId body : ended_bodies_) state_.ids.erase(body);
  ended_bodies_.clear();
}

/// Decodes the command buffers of the commands so far. They may speak of nodes that come later in
/// the frame: until its end (`last`) one that is not understood waits.
void FrameDecoder::read_buffers(bool last) {
  for (size_t i = 0; ok() && i < buffers_.size();) {
    const Buffer buffer = buffers_[i];
    Diagnostics warnings;
    const std::optional<Error> error = try_buffer(buffer, warnings);
    if (error && !last && error->code != Errc::limit_exceeded) {
      ++i;
      continue;
    }
    diagnostics_->append(warnings);
    if (!error) {
      buffers_.erase(buffers_.begin() + static_cast<ptrdiff_t>(i));
      continue;
    }
    frame_.seek(buffer.bit + error->place.bit);
    (void)frame_.u(0, "buffer");  // the place of the error
    frame_.fail(error->code, error->text);
  }
}

/// Reads a buffer; what cannot be read leaves nothing behind.
std::optional<Error> FrameDecoder::try_buffer(const Buffer& buffer, Diagnostics& warnings) {
  Before before{state_.scene.mark(), ended_bodies_.size(), buffers_.size(), {}};
  Diagnostics* const diagnostics = std::exchange(diagnostics_, &warnings);
  before_ = &before;
  buffer_scope_ = buffer.scope;
  std::optional<Error> error = read_buffer(buffer);
  before_ = nullptr;
  diagnostics_ = diagnostics;
  if (error) {
    buffer.commands->commands.clear();
    take_back(before, buffer.scope);
  }
  return error;
}

void FrameDecoder::take_back(const Before& before, nodes::ScopeId scope) {
  buffers_.resize(before.buffers);
  ended_bodies_.resize(before.ended_bodies);
  state_.ids.erase(state_.ids.lower_bound(nodes::ScopeId{before.scene.scopes}), state_.ids.end());
  const auto restore = [](auto& known, const auto& meanings) {
    for (const auto& [number, id] : meanings) {
      if (id.valid())
        known[number] = id;
      else
        known.erase(number);
    }
  };
  ScopeIds& ids = state_.ids[scope];
  restore(ids.nodes, before.ids.nodes);
  restore(ids.protos, before.ids.protos);
  state_.scene.revert(before.scene);
}

/// A buffer is a command frame of its own, without effect on the state until it is carried out.
std::optional<Error> FrameDecoder::read_buffer(const Buffer& buffer) {
  codec::BitReader inner(*buffer.bytes);
  const std::string path = std::exchange(path_, buffer.path);
  const auto scope = std::exchange(scope_, buffer.scope);
  const auto proto = std::exchange(proto_, buffer.proto);
  const Quantizer* const quantizer = std::exchange(quantizer_, nullptr);
  const std::optional<Quantizer> frame_quantizer = frame_quantizer_;
  const bool use_names = state_.use_names;
  const auto data = std::exchange(data_, std::span<const uint8_t>(*buffer.bytes));
  in_ = &inner;
  buffer_depth_ = buffer.depth;
  {
    const Part part(*this, "commandFrame");
    bool more = true;
    while (ok() && more) {
      std::optional<Command> command = read_command();
      if (!ok() || !command || !take(1, sizeof(Command))) break;
      buffer.commands->commands.push_back(std::move(*command));
      more = u(1, "moreCommands") != 0;
    }
  }
  in_ = &frame_;
  data_ = data;
  buffer_depth_ = 0;
  state_.use_names = use_names;
  frame_quantizer_ = frame_quantizer;  // in place: quantizer_ may point to it
  quantizer_ = quantizer;
  proto_ = proto;
  scope_ = scope;
  path_ = path;
  if (inner.ok()) return std::nullopt;
  return inner.error();
}

}  // namespace afx::bifs

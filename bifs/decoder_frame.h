// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of decoder.h: a function for each syntax structure of a command frame.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bifs/decoder.h"
#include "bifs/quantizer.h"
#include "nodes/definitions.h"

namespace afx::bifs {

/// What is known by its BIFS ID in a name scope.
struct ScopeIds {
  std::map<uint32_t, nodes::NodeId> nodes;
  std::map<uint32_t, nodes::ProtoId> protos;
};

/// What lasts from one access unit to the next.
struct DecoderState {
  BifsConfig config;
  Limits limits;
  DecodeOptions options;
  nodes::Scene scene;
  std::map<nodes::ScopeId, ScopeIds> ids;
  bool use_names = false;
  std::optional<Quantizer> global_quantizer;
  /// Lists of nodes that commands have changed, as they were first.
  std::map<std::pair<nodes::NodeId, nodes::FieldIndex>, std::vector<nodes::NodeId>> first_lists;
};

/// Decodes one access unit.
class FrameDecoder {
 public:
  FrameDecoder(DecoderState& state, std::span<const uint8_t> data, Diagnostics& diagnostics,
               const codec::Trace* trace);
  Result<CommandFrame> read(const BifsDecoder::CommandSink& sink);

 private:
  /// Names the structure being read, for error texts.
  class Part {
   public:
    Part(FrameDecoder& decoder, std::string_view name);
    ~Part() { decoder_.path_.resize(before_); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    FrameDecoder& decoder_;
    size_t before_;
    codec::BitReader::Scope scope_;
  };

  /// Counts nesting; fails beyond limits.scene_depth.
  class Depth {
   public:
    explicit Depth(FrameDecoder& decoder);
    ~Depth() { --decoder_.depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

   private:
    FrameDecoder& decoder_;
  };

  /// Where the fields of a node description go: into a node, or into a list (a command).
  struct FieldTarget {
    nodes::NodeId node;
    std::vector<nodes::FieldEntry>* entries = nullptr;
  };

  /// A command buffer, decoded when the frame is.
  struct Buffer {
    std::shared_ptr<BufferedCommands> commands;
    std::shared_ptr<const std::vector<uint8_t>> bytes;
    uint64_t bit;  ///< where it begins in the caller's data
    std::string path;
    nodes::ScopeId scope;
    nodes::ProtoId proto;
    uint32_t depth;
  };

  /// What was known before a buffer was begun.
  struct Before {
    nodes::Scene::Mark scene;
    size_t ended_bodies;
    size_t buffers;
    ScopeIds ids;  ///< in its scope, where it gives them anew; not valid: unknown
  };

  // decoder.cpp: the frame, and what all parts use
  void read_frame(const BifsDecoder::CommandSink& sink, CommandFrame& frame);
  void forget_bodies();
  void read_buffers(bool last);
  std::optional<Error> try_buffer(const Buffer& buffer, Diagnostics& warnings);
  void take_back(const Before& before, nodes::ScopeId scope);
  std::optional<Error> read_buffer(const Buffer& buffer);
  uint32_t u(unsigned bits, std::string_view name) { return in_->u(bits, name); }
  [[nodiscard]] bool ok() const { return in_->ok(); }
  void fail(Errc code, const std::string& text);
  void warn(std::string_view code, const std::string& text);
  bool take(uint64_t count, size_t bytes);
  std::string read_name(std::string_view what);
  void take_name(std::string_view what, std::string& name, bool of_type);
  ScopeIds& ids() { return state_.ids[scope_]; }
  /// Gives `number` its meaning in the scope.
  template <class Id>
  void know(std::map<uint32_t, Id> ScopeIds::*kind, uint32_t number, Id id) {
    Id& known = (ids().*kind)[number];
    if (before_ != nullptr && scope_ == buffer_scope_) (before_->ids.*kind).emplace(number, known);
    known = id;
  }

  // decoder_commands.cpp
  std::optional<Command> read_command();
  Command read_insertion();
  Command read_deletion();
  Command read_replacement();
  Command read_scene_replacement();
  void forget_scene();
  Command read_extended_update();
  Command read_proto_deletion();
  Command read_multiple_indexed();
  Command read_multiple_fields();
  Command read_global_quantizer();
  Command read_xreplace();
  void read_xreplace_place(XReplace& command, const nodes::FieldDefinition& field);
  bool read_child_field(XReplace& command, const std::vector<nodes::NodeId>* list);
  void keep_first_lists(const Command& command);
  nodes::NodeId read_node_id();
  uint32_t read_route_id();
  nodes::FieldIndex read_field_ref(nodes::NodeId node, nodes::IndexMode mode);
  FieldRef read_target(nodes::IndexMode mode);
  FieldRef read_list_target();
  Position read_position(unsigned bits);
  nodes::FieldValue read_target_value(const FieldRef& target, bool element);
  std::vector<nodes::Route> read_routes();
  nodes::Route read_route();
  void read_route_ends(nodes::Route& route);

  // decoder_node.cpp
  nodes::NodeId read_node(nodes::NodeDataType type);
  nodes::NodeId read_reused(nodes::NodeDataType type);
  nodes::NodeId read_node_type(nodes::NodeDataType type);
  nodes::NodeId read_instance();
  void register_node(nodes::NodeId node, uint32_t id);
  void read_fields(const nodes::NodeDefinition& layout, const FieldTarget& target, bool in_body);
  void read_mask(const nodes::NodeDefinition& layout, const FieldTarget& target, bool in_body);
  void read_list(const nodes::NodeDefinition& layout, const FieldTarget& target, bool in_body);
  void read_link(const nodes::NodeDefinition& layout, nodes::FieldIndex field,
                 const FieldTarget& target);
  void read_field(const nodes::NodeDefinition& layout, nodes::FieldIndex field,
                  const FieldTarget& target);

  // decoder_values.cpp
  ElementCoding coding_of(const nodes::FieldDefinition& field, const nodes::NodeDefinition& layout,
                          std::span<const nodes::FieldEntry> values);
  nodes::FieldValue read_value(const nodes::FieldDefinition& field, const ElementCoding& coding,
                               nodes::NodeId script = {}, bool may_predict = true);
  nodes::FieldValue read_element(const nodes::FieldDefinition& field, const ElementCoding& coding);
  template <class ReadElement, class ReadAll>
  void read_multiple(size_t element_bytes, ReadElement read_one, ReadAll read_all);
  template <class ReadElement>
  void read_multiple(size_t element_bytes, ReadElement read_one);
  bool read_prediction_flag(const ElementCoding& coding);
  template <class T>
  bool read_run(std::vector<T>& out, uint32_t count, const ElementCoding& coding);
  void read_one(bool& value, const ElementCoding& coding);
  void read_one(uint8_t& value, const ElementCoding& coding);
  void read_one(int32_t& value, const ElementCoding& coding);
  void read_one(float& value, const ElementCoding& coding);
  void read_one(double& value, const ElementCoding& coding);
  void read_one(std::string& value, const ElementCoding& coding);
  void read_one(nodes::Url& value, const ElementCoding& coding);
  void read_one(glm::vec2& value, const ElementCoding& coding);
  void read_one(glm::vec3& value, const ElementCoding& coding);
  void read_one(glm::vec4& value, const ElementCoding& coding);
  void read_one(nodes::Rotation& value, const ElementCoding& coding);
  void read_one(nodes::Image& value, const ElementCoding& coding);
  void read_one(nodes::CommandBuffer& value, const ElementCoding& coding);
  void read_one(nodes::NodeId& value, const ElementCoding& coding);  // never called
  float read_float(const ElementCoding& coding, size_t component);
  float read_efficient_float();
  QuantizedDirection read_direction(bool has_sign, size_t components, unsigned bits);
  template <class Bytes>
  void read_bytes(Bytes& out, uint64_t count, std::string_view name);
  void read_node_list(std::vector<nodes::NodeId>& out, const nodes::FieldDefinition& field,
                      nodes::NodeId holder);

  // predictive_decoder.cpp
  nodes::FieldValue read_predictive(const nodes::FieldDefinition& field,
                                    const ElementCoding& coding);

  // decoder_proto.cpp
  std::vector<nodes::ProtoId> read_protos();
  nodes::ProtoId read_proto();
  nodes::ProtoId declare_proto(uint32_t id);
  void read_interface(nodes::ProtoId proto);
  nodes::FieldDefinition read_interface_field(size_t number);
  void read_proto_body(nodes::ProtoId proto);
  void read_interface_coding(nodes::ProtoId proto);
  void read_quantization(nodes::FieldDefinition& field);
  double read_bound(nodes::FieldType type);

  // decoder_script.cpp
  std::string read_script(nodes::NodeId script);
  void read_script_fields(nodes::NodeId script, std::vector<std::string>& identifiers);
  bool read_script_field(nodes::NodeId script, std::vector<std::string>& identifiers);

  friend class ScriptDecoder;
  friend class PredictiveDecoder;

  DecoderState& state_;
  Diagnostics* diagnostics_;
  codec::BitReader frame_;         ///< over the whole access unit
  codec::BitReader* in_;           ///< that, or over a command buffer
  std::span<const uint8_t> data_;  ///< what in_ reads
  std::string path_;
  uint32_t depth_ = 0;
  uint64_t values_taken_ = 0;
  uint64_t bytes_taken_ = 0;
  nodes::ScopeId scope_ = nodes::Scene::kMain;
  nodes::ProtoId proto_;  ///< the PROTO whose body is being read
  const Quantizer* quantizer_ = nullptr;
  std::optional<Quantizer> frame_quantizer_;
  std::deque<Buffer> buffers_;                ///< not read yet
  std::vector<nodes::ScopeId> ended_bodies_;  ///< whose IDs the buffers may need
  uint32_t buffer_depth_ = 0;                 ///< 0: not in a buffer
  nodes::ScopeId buffer_scope_;               ///< of the buffer that is being read
  Before* before_ = nullptr;                  ///< nullptr: not in a buffer
};

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of encoder.h: a function for each syntax structure, the mirror of decoder_frame.h.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bifs/coding_quantizer.h"
#include "bifs/encoder.h"
#include "bifs/node_walk.h"
#include "bifs/quantizer.h"
#include "codec/bit_writer.h"
#include "nodes/definitions.h"

namespace afx::bifs {

class FrameEncoder {
 public:
  FrameEncoder(const BifsConfig& config, const EncodeOptions& options)
      : config_(config), options_(options) {}

  Status add(const Command& command, const nodes::Scene& scene);
  Result<std::vector<uint8_t>> finish();

 private:
  /// Bits as they come, and how many.
  struct Output {
    std::vector<uint8_t> bytes;
    codec::BitWriter writer{bytes};
    uint64_t commands = 0;
  };

  /// Names the structure being written, for error texts.
  class Part {
   public:
    Part(FrameEncoder& encoder, std::string_view name);
    ~Part() { encoder_.path_.resize(before_); }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    FrameEncoder& encoder_;
    size_t before_;
  };

  // encoder.cpp
  void put(uint64_t value, unsigned bits);
  void put_flag(bool value) { put(value ? 1 : 0, 1); }
  void put_sized(uint64_t value, unsigned size_bits = 5);
  void put_bytes(std::span<const uint8_t> bytes);
  void put_name(std::string_view name);
  void fail(Errc code, const std::string& text);
  [[nodiscard]] bool ok() const { return !error_.has_value(); }

  // encoder_commands.cpp
  void command(const Command& command);
  void reserve(const Command& command);
  void write(const NodeInsertion& c);
  void write(const IndexedValueInsertion& c);
  void write(const RouteInsertion& c);
  void write(const NodeDeletion& c);
  void write(const IndexedValueDeletion& c);
  void write(const RouteDeletion& c);
  void write(const NodeReplacement& c);
  void write(const FieldReplacement& c);
  void write(const IndexedValueReplacement& c);
  void write(const RouteReplacement& c);
  void write(const SceneReplacement& c);
  void write(const ProtoInsertion& c);
  void write(const ProtoDeletion& c);
  void write(const AllProtoDeletion& c);
  void write(const MultipleIndexedReplacement& c);
  void write(const MultipleFieldReplacement& c);
  void write(const GlobalQuantizer& c);
  void write(const XReplace& c);
  void put_command(uint32_t type, uint32_t subtype);
  void put_extended(uint32_t type);
  void put_node_id(nodes::NodeId node);
  void put_route_id(uint32_t id);
  void put_field_ref(const FieldRef& ref, nodes::IndexMode mode);
  void put_target(const FieldRef& ref, nodes::IndexMode mode);
  void put_position(const Position& position, unsigned bits);
  void target_value(const FieldRef& target, const nodes::FieldValue& value, bool element);
  void routes(const std::vector<nodes::Route>& list);
  void route(const nodes::Route& route);
  void route_ends(const nodes::Route& route);

  // encoder_node.cpp
  /// A field that a node description has: a value or an IS link.
  struct WrittenField {
    nodes::FieldIndex field;
    const nodes::FieldValue* value = nullptr;
    std::optional<nodes::FieldIndex> interface_field;
  };
  void node(nodes::NodeId id, nodes::NodeDataType type);
  void reused_node(nodes::NodeId id);
  void node_type(nodes::NodeId id, nodes::NodeDataType type);
  std::vector<WrittenField> written_fields(nodes::NodeId id, const nodes::NodeDefinition& layout);
  bool is_written(const nodes::FieldDefinition& field, const nodes::FieldValue* given) const;
  void fields(const nodes::NodeDefinition& layout, nodes::NodeId id,
              const std::vector<WrittenField>& list, bool in_body, bool force_mask);
  void field_content(const nodes::NodeDefinition& layout, nodes::NodeId id,
                     const WrittenField& field, std::vector<nodes::FieldEntry>& before);

  // encoder_values.cpp
  ElementCoding coding_of(const nodes::FieldDefinition& field, const nodes::NodeDefinition& layout,
                          std::span<const nodes::FieldEntry> values);
  void value(const nodes::FieldDefinition& field, const ElementCoding& coding,
             const nodes::FieldValue& value, nodes::NodeId script = {}, bool may_predict = true);
  void element(const nodes::FieldDefinition& field, const ElementCoding& coding,
               const nodes::FieldValue& value);
  template <class WriteElement, class WriteAll>
  void multiple(size_t count, WriteElement write_one, WriteAll write_all);
  template <class WriteElement>
  void multiple(size_t count, WriteElement write_one);
  template <class T>
  bool put_run(const std::vector<T>& list, const ElementCoding& coding);
  void one(bool v, const ElementCoding& coding);
  void one(uint8_t v, const ElementCoding& coding);
  void one(int32_t v, const ElementCoding& coding);
  void one(float v, const ElementCoding& coding);
  void one(double v, const ElementCoding& coding);
  void one(const std::string& v, const ElementCoding& coding);
  void one(const nodes::Url& v, const ElementCoding& coding);
  void one(const glm::vec2& v, const ElementCoding& coding);
  void one(const glm::vec3& v, const ElementCoding& coding);
  void one(const glm::vec4& v, const ElementCoding& coding);
  void one(const nodes::Rotation& v, const ElementCoding& coding);
  void one(const nodes::Image& v, const ElementCoding& coding);
  void one(const nodes::CommandBuffer& v, const ElementCoding& coding);
  void one(nodes::NodeId v, const ElementCoding& coding);  // never called
  void put_float(float v, const ElementCoding& coding, size_t component);
  void put_efficient_float(float v);
  void put_direction(const QuantizedDirection& direction, bool has_sign, size_t components,
                     unsigned bits);
  void node_list(const std::vector<nodes::NodeId>& list, const nodes::FieldDefinition& field,
                 nodes::NodeId holder);

  // encoder_coding_quantizer.cpp
  std::vector<bool> coding_quantizers(const std::vector<nodes::NodeId>& list,
                                      const nodes::FieldDefinition& field, nodes::NodeId holder);
  [[nodiscard]] int64_t list_form_cost(size_t count) const;
  int64_t coding_quantizer_cost(nodes::NodeDataType type);
  void put_coding_quantizer(nodes::NodeDataType type);

  // predictive_encoder.cpp
  bool predictive(const nodes::FieldDefinition& field, const ElementCoding& coding,
                  const nodes::FieldValue& written);

  // encoder_proto.cpp
  void protos(const std::vector<nodes::ProtoId>& list);
  void proto(nodes::ProtoId id);
  void interface_field(const nodes::FieldDefinition& field);
  void interface_coding(const nodes::NodeDefinition& interface);
  void bounds(const nodes::FieldDefinition& field);

  // encoder_script.cpp
  void script(nodes::NodeId holder, const std::string& text);
  void script_fields(nodes::NodeId holder, std::vector<std::string>& identifiers);
  void script_field(nodes::NodeId holder, nodes::FieldIndex field);

  friend class ScriptEncoder;

  BifsConfig config_;
  EncodeOptions options_;
  const nodes::Scene* scene_ = nullptr;
  Output frame_;
  Output* out_ = &frame_;
  std::optional<Error> error_;
  std::string path_;
  NodeSet known_;  ///< written, or in the command at work
  NodeSet fresh_;  ///< in the command at work and not written yet
  NodeSet open_;   ///< begun and not ended
  bool use_names_ = false;
  nodes::ProtoId proto_;  ///< the PROTO whose body is being written
  const Quantizer* quantizer_ = nullptr;
  std::optional<Quantizer> global_quantizer_;
  IntegerSavings savings_;  ///< of the command at work
};

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The inside of bt_reader.h: the grammar of BT, a function for each rule.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bifs/bt_reader.h"
#include "bifs/config.h"
#include "bifs/id_assignment.h"
#include "bifs/noted_lists.h"
#include "nodes/scene_text_reader.h"

namespace afx::bifs {

class BtTextReader final : private nodes::SceneTextReader {
 public:
  using nodes::SceneTextReader::SceneTextReader;
  Result<Presentation> read_presentation();

 private:
  using Commands = std::vector<Command>;

  /// The braces of a command buffer, read when all that they may speak of has been.
  struct Buffer {
    size_t begin;  ///< offset behind `{`
    nodes::ScopeId scope;
    uint32_t depth;  ///< how many buffers it stands in, itself included
    std::shared_ptr<BufferedCommands> commands;
  };

  // bt_reader.cpp: statements, time, the scene
  void read_top();
  void read_scene_statement(size_t begin);
  [[nodiscard]] bool is_instance(std::string_view word) const;
  void end_scene();
  void read_timed();
  uint64_t read_time();
  void read_commands(uint64_t time, bool random_access);
  AccessUnit& unit_at(uint64_t time, bool descriptors, bool random_access);
  void merge_units();
  void settle_roots(SceneReplacement& command);
  void begin_epoch();
  void end_epoch();
  void assign_body_route_ids();
  void read_buffers();
  nodes::CommandBuffer read_command_buffer(nodes::ScopeId scope) override;

  // bt_command_reader.cpp: commands of the scene
  bool read_scene_command(std::string_view word, Commands& out);
  void read_insert(Commands& out);
  void read_append(Commands& out);
  void read_delete(Commands& out);
  void read_extended_delete(Commands& out);
  void read_global_quantizer(Commands& out);
  void read_replace(Commands& out);
  void read_replace_scene(Commands& out);
  void read_insert_route(Commands& out);
  void read_replace_route(Commands& out);
  void read_multiple_replace(Commands& out);
  void read_multiple_indexed(Commands& out);
  void read_xreplace(Commands& out);
  void read_xreplace_place(XReplace& command);
  void read_child_field(XReplace& command);
  void read_insert_proto(Commands& out);
  void read_delete_proto(Commands& out);
  void forget_protos(const std::vector<nodes::ProtoId>& deleted);
  void insertion(const FieldRef& target, Position position, Commands& out);
  nodes::NodeId read_target_node();
  FieldRef read_target(nodes::IndexMode mode);
  FieldRef read_list_target();
  nodes::FieldIndex read_target_field(nodes::NodeId node, nodes::IndexMode mode);
  std::optional<Position> read_position();
  bool expect_word(std::string_view word);
  [[nodiscard]] bool is_field_path() const;
  nodes::FieldValue read_field(const FieldRef& target);
  nodes::FieldValue read_element(const FieldRef& target);
  nodes::Route read_new_route(std::string_view name);
  uint32_t read_route_id();

  // bt_descriptor_reader.cpp: object descriptors and their commands
  bool read_descriptor_command(std::string_view word, OdCommands& out);
  void read_update(OdCommands& out);
  void read_remove(OdCommands& out);
  void read_unknown_command(OdCommands& out);
  InitialObjectDescriptor read_initial_object();
  ObjectDescriptor read_object_descriptor();
  Descriptors read_es_descriptors();
  EsDescriptor read_es_descriptor();
  DecoderConfig read_decoder_config();
  DecoderSpecificInfo read_specific_info(DecoderConfig& config);
  BifsConfig read_bifs_config(uint8_t version);
  SlConfig read_sl_config();
  MediaSource read_mux_info();
  Descriptors read_other_descriptors();
  UnknownDescriptor read_unknown_descriptor();
  template <class Field>
  void read_block(std::string_view name, Field read_one);
  template <class Read>
  void read_bracketed(Read read_one);
  uint32_t read_number(std::string_view what, uint64_t most);
  std::vector<uint16_t> read_ids(uint32_t most);

  Presentation out_;
  bool has_initial_ = false;
  bool scene_open_ = true;  ///< nodes may still be of the scene that no command begins
  std::vector<size_t> root_begins_;  ///< offsets of that scene's top nodes
  nodes::ScopeId scope_ = nodes::Scene::kMain;  ///< whose names commands mean
  uint64_t last_time_ = 0;
  std::vector<AccessUnit> scene_units_, descriptor_units_;  ///< in the order of time
  size_t command_begin_ = 0;                                ///< offset of the statement at work
  nodes::NodeId epoch_;  ///< the first node since the last scene replacement
  RouteIds route_ids_;   ///< of the scene
  std::deque<Buffer> buffers_;
  uint32_t buffer_depth_ = 0;  ///< of the buffer that is being read; 0: none
  ProtoIds proto_ids_;
  size_t bodies_seen_ = 0;  ///< PROTOs whose ROUTEs have their IDs
  NotedLists lists_;        ///< what an XREPLACE of a child may mean
};

}  // namespace afx::bifs

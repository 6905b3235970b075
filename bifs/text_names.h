// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "bifs/node_walk.h"
#include "nodes/node_text_writer.h"

namespace afx::bifs {

/// The names by which a stream's nodes and ROUTEs stand in text, and which node stands whole where:
/// at its first place in the commands, as in the stream.
class TextNames final : public nodes::NodeNaming {
 public:
  /// A command is about to be written: the nodes that come with it stand whole in it. Gives what
  /// end_command wants: a command may stand in a buffer of another.
  [[nodiscard]] NodeSet begin_command(const nodes::Scene& scene, const Command& command);
  void end_command(NodeSet outer) { fresh_ = std::move(outer); }

  bool stands_here(nodes::NodeId id) override { return fresh_.erase(id.value) != 0; }
  /// The node's own name if text can hold it and no other node of the scope has it; N<k> for the ID
  /// k + 1; empty for a node with neither.
  std::string_view name(nodes::NodeId id) override;
  std::string route_name(const nodes::Route& route) override;
  bool can_write(const nodes::Route&) override { return true; }
  /// The name of the ROUTE of the scene itself with an ID.
  [[nodiscard]] std::string route_name(uint32_t id) const;

 private:
  using Names = std::set<std::string, std::less<>>;
  std::string unique(Names& taken, std::string_view own, char letter, uint32_t id);
  void forget_scene();

  const nodes::Scene* scene_ = nullptr;
  NodeSet known_;  ///< written, or in the command at work
  NodeSet fresh_;  ///< in the command at work and not written yet
  std::map<nodes::NodeId, std::string> names_;
  std::map<nodes::ScopeId, Names> taken_;
  std::map<uint32_t, std::string> routes_;  ///< of the scene itself
  std::map<nodes::ScopeId, Names> taken_routes_;
  std::map<std::string, unsigned> copies_;  ///< of names that were taken: tried so far
};

}  // namespace afx::bifs

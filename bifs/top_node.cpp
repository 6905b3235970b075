// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/top_node.h"

#include "nodes/definitions.h"

namespace afx::bifs {

nodes::NodeDataType top_node_type() {
  static const auto type = nodes::definitions().find_data_type("SFTopNode");
  return type.value_or(nodes::kWorldNode);
}

bool may_be_top_node(const nodes::Scene& scene, nodes::NodeId id) {
  return !id.valid() || nodes::contains(scene.node(id).definition->data_types, top_node_type());
}

Result<nodes::NodeId> put_in_group(nodes::Scene& scene, std::span<const nodes::NodeId> roots,
                                   size_t& refused) {
  const Result<nodes::NodeId> group = scene.add("Group");
  if (!group.ok()) return group;
  for (refused = 0; refused < roots.size(); ++refused)
    if (!scene.append(group.value(), "children", roots[refused]).ok())
      return Error{Errc::malformed, Place::none(),
                   "a " + scene.type_name(roots[refused]) +
                       " may not stand at the top [expected Group, Shape or another that may stand "
                       "under a Group]"};
  return group;
}

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/known_nodes.h"

#include <cassert>
#include <utility>

namespace afx {

nodes::NodeId add_known(nodes::Scene& scene, const char* type) {
  auto id = scene.add(type);
  assert(id.ok());
  return id.value();
}

void set_known(nodes::Scene& scene, nodes::NodeId node, const char* field,
               nodes::FieldValue value) {
  const Status status = scene.set(node, field, std::move(value));
  assert(status.ok());
  (void)status;
}

}  // namespace afx

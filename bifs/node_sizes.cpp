// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/node_sizes.h"

#include "nodes/definitions.h"

namespace afx::bifs {
namespace {

/// The type of the innermost node that a path names; "commands" without one.
std::string innermost_node(std::string_view path) {
  while (!path.empty()) {
    const size_t slash = path.rfind('/');
    const std::string_view part = slash == std::string_view::npos ? path : path.substr(slash + 1);
    if (nodes::definitions().find(part) != nullptr) return std::string(part);
    path = slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
  }
  return "commands";
}

}  // namespace

void NodeSizes::hear(const codec::TraceElement& element) {
  const size_t slash = element.path.rfind('/');
  const std::string_view part = element.path.substr(0, slash);
  if (last_ == nullptr || part != last_path_) {
    last_path_ = part;
    last_ = &sizes_[innermost_node(part)];
  }
  last_->bits += element.width;
  // The first element inside a node says whether it has an ID.
  const std::string_view name =
      slash == std::string_view::npos ? element.path : element.path.substr(slash + 1);
  if (name == "isUpdateable") ++last_->count;
}

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "codec/bit_reader.h"

namespace afx::bifs {

/// What the nodes of one type take in a stream.
struct NodeSize {
  uint64_t count = 0;
  uint64_t bits = 0;  ///< of their own elements, not of the nodes inside them
};

/// Adds up what each type of node takes, from the trace of a decoder: an element belongs to the
/// innermost node of its path.
class NodeSizes {
 public:
  void hear(const codec::TraceElement& element);
  /// By type; "commands" is what belongs to no node.
  [[nodiscard]] const std::map<std::string, NodeSize>& sizes() const { return sizes_; }

 private:
  std::map<std::string, NodeSize> sizes_;
  std::string last_path_;
  NodeSize* last_ = nullptr;  ///< where the elements of last_path_ count
};

}  // namespace afx::bifs

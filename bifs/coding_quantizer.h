// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Quantizers that say nothing of the scene. Under any quantizer the integers of categories 13 and
// 14 are written in as many bits as their range needs, an entry of OctreeImage.octree in 8 instead
// of 32, and nothing is lost. A coding quantizer is a local QuantizationParameter with everything
// switched off: the encoder may put one before a child for the sake of its integers, the decoder
// leaves it out.
// Source: spec/bifs.md 9.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "bifs/node_walk.h"
#include "bifs/quantizer.h"

namespace afx::bifs {

/// A scene of its own that holds just a coding quantizer, as it is written.
struct CodingQuantizer {
  nodes::Scene scene;
  nodes::NodeId node;
  Quantizer quantizer;
};
const CodingQuantizer& coding_quantizer();

/// Whether a node is one: isLocal TRUE, the switches that are on by default FALSE, nothing else
/// given, and no ID, name or IS.
bool is_coding_quantizer(const nodes::Scene& scene, nodes::NodeId node);

/// Whether the places in a list of nodes mean nothing, so that one more node in it changes nothing:
/// the children of a grouping node (Group, Transform, ...; not Form or OrderedGroup, whose other
/// fields count children) that no command can address, for it has no ID. holder: not valid: no.
bool is_free_list(const nodes::Scene& scene, nodes::NodeId holder,
                  const nodes::FieldDefinition& field);

/// Whether integers are in the range of their coding (kind integer).
bool all_fit(const nodes::FieldValue& value, const ElementCoding& coding);

/// How many bits the integers of a node's own fields save under any quantizer. None if one of them
/// cannot be written so, as it is out of range or an index without coordinates.
std::optional<uint64_t> integer_saving(const nodes::Scene& scene, nodes::NodeId node);

/// What the nodes of a command save under coding quantizers, each node at its first place.
class IntegerSavings {
 public:
  /// Bits that a coding quantizer before a child saves; 0 if it may not stand there: in or below
  /// the child an integer does not fit, or stands a quantizer or a Script.
  /// fresh: the nodes of the command that have not been written yet. Children are to be asked for
  /// in the order in which they will be written.
  uint64_t below(const nodes::Scene& scene, const NodeSet& fresh, nodes::NodeId holder,
                 nodes::NodeId child);

 private:
  struct Saving {
    nodes::NodeId holder;  ///< where the node has its first place
    bool possible = true;
    uint64_t bits = 0;
  };
  Saving walk(const nodes::Scene& scene, const NodeSet& fresh, nodes::NodeId holder,
              nodes::NodeId node);

  std::unordered_map<uint32_t, Saving> known_;
};

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <utility>

#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"

namespace afx::bifs {

using nodes::NodeId;

/// Before which elements of a list of nodes coding quantizers are worth their bits, a flag for each
/// element. Empty: before none. They need the list form, which counts as well.
std::vector<bool> FrameEncoder::coding_quantizers(const std::vector<NodeId>& list,
                                                  const nodes::FieldDefinition& field,
                                                  NodeId holder) {
  if (!options_.short_integers || config_.use_predictive_field || quantizer_ != nullptr ||
      !is_free_list(*scene_, holder, field))
    return {};
  std::vector<bool> marked(list.size());
  NodeSet seen;  // the second place of a node is only its ID
  int64_t gain = -list_form_cost(list.size());
  int64_t cost = 0;  // not known yet
  for (size_t i = 0; i < list.size() && !is_quantizer(*scene_, list[i]); ++i) {
    if (!seen.insert(list[i].value).second) continue;
    const auto saved = static_cast<int64_t>(savings_.below(*scene_, fresh_, holder, list[i]));
    if (saved > 0 && cost == 0) cost = coding_quantizer_cost(field.data_type);
    marked[i] = saved > cost;
    if (marked[i]) gain += saved - cost;
  }
  return gain > 0 ? marked : std::vector<bool>{};
}

/// How many bits the list form of a list takes more than the form that it would have.
int64_t FrameEncoder::list_form_cost(size_t count) const {
  const auto list = static_cast<int64_t>(count) + 1;
  const auto vector = int64_t{5} + bits_for(count);
  switch (options_.lists) {
    case EncodeOptions::Form::list:
      return 0;
    case EncodeOptions::Form::compact:
      return list - vector;
    case EncodeOptions::Form::shorter:
      break;
  }
  return std::max<int64_t>(list - vector, 0);
}

/// Bits of one more element of a list, rounded up to whole bytes.
int64_t FrameEncoder::coding_quantizer_cost(nodes::NodeDataType type) {
  Output measured;
  Output* const outer = std::exchange(out_, &measured);
  put_coding_quantizer(type);
  out_ = outer;
  return static_cast<int64_t>(measured.bytes.size()) * 8 + 1;
}

void FrameEncoder::put_coding_quantizer(nodes::NodeDataType type) {
  const CodingQuantizer& written = coding_quantizer();
  const nodes::Scene* const scene = std::exchange(scene_, &written.scene);
  NodeSet fresh = std::exchange(fresh_, NodeSet{written.node.value});
  NodeSet open = std::exchange(open_, NodeSet{});
  node(written.node, type);
  open_ = std::move(open);
  fresh_ = std::move(fresh);
  scene_ = scene;
}

}  // namespace afx::bifs

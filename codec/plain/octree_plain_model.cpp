// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/plain/octree_plain_model.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace afx::codec::plain {

Table::Table(size_t symbols, uint16_t step_in, const TableRules& rules_in)
    : frequency(symbols, rules_in.first),
      total(static_cast<uint32_t>(symbols * rules_in.first)),
      step(step_in),
      rules(rules_in) {}

void Table::count(size_t symbol) {
  frequency[symbol] = static_cast<uint16_t>(frequency[symbol] + step);
  total += step;
  if (total < rules.limit || (total == rules.limit && !rules.halved_at_limit)) return;
  for (uint16_t& f : frequency)
    f = static_cast<uint16_t>(rules.halved_upwards ? (f + 1) / 2 : std::max(f / 2, 1));
  total = std::accumulate(frequency.begin(), frequency.end(), uint32_t{0});
}

Model::Model(unsigned textures, const Rules& rules)
    : rules_(rules), symmetries_(*rules.model.symmetries), textures_(textures) {
  enter_stage(0);
  const ModelRules& model = rules.model;
  texture_.assign(2, Table(textures + model.texture_symbols, model.texture_step, model.texture));
}

void Model::restart() {
  Model fresh(textures_, rules_);
  if (!rules_.stream.tables_carry) {
    tables_ = std::move(fresh.tables_);
    coded_ = 0;
    stage_ = 0;
  }
  if (!rules_.stream.texture_table_carries) texture_ = std::move(fresh.texture_);
}

size_t Model::tables_of(Context context) const {
  switch (context) {
    case Context::none:
      return 1;
    case Context::parent_class:
      return symmetries_.classes;
    case Context::position:
      return 8;
    case Context::class_and_position:
      break;
  }
  return size_t{symmetries_.classes} * 8;
}

/// The table of the stage before that a table of this stage is a copy of.
size_t Model::table_before(size_t stage, size_t table) const {
  const size_t before = tables_of(rules_.model.stages[stage - 1].context);
  const size_t now = tables_of(rules_.model.stages[stage].context);
  return table * before / now;
}

void Model::enter_stage(size_t stage) {
  const Stage& rules = rules_.model.stages[stage];
  const bool copies = stage > 0 && rules.copies;
  std::vector<Table> next;
  for (size_t i = 0; i < tables_of(rules.context); ++i) {
    next.push_back(copies ? tables_[table_before(stage, i)]
                          : Table(rules_.model.node_symbols, rules.step, rules_.model.node));
    next.back().step = rules.step;
  }
  tables_ = std::move(next);
  stage_ = stage;
}

NodeTable Model::node(uint8_t parent, unsigned position) {
  const ModelRules& model = rules_.model;
  while (stage_ + 1 < model.stages.size() && coded_ >= model.stages[stage_ + 1].start)
    enter_stage(stage_ + 1);
  ++coded_;
  const Stage& stage = model.stages[stage_];
  const unsigned t = symmetries_.symmetry[parent];
  const unsigned symmetry = stage.transformed ? t : Symmetries::kIdentity;
  const size_t number = symmetries_.number[parent];
  const size_t place = model.transformed_position ? symmetries_.child[t][position] : position;
  switch (stage.context) {
    case Context::none:
      return {tables_[0], symmetry};
    case Context::parent_class:
      return {tables_[number], symmetry};
    case Context::position:
      return {tables_[place], symmetry};
    case Context::class_and_position:
      break;
  }
  return {tables_[number * 8 + place], symmetry};
}

Table& Model::texture(bool of_voxel) {
  if (rules_.model.textures_count) ++coded_;
  return texture_[of_voxel && rules_.model.voxels_apart ? 1 : 0];
}

}  // namespace afx::codec::plain

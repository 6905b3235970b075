// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>

#include "bifs/presentation.h"
#include "nodes/text_out.h"

namespace afx::bifs {

/// Writes a presentation as BT that read_bt (bifs/bt_reader.h) reads back: the same commands on
/// equal nodes, with the same IDs where nodes, ROUTEs and PROTOs had no names.
///
/// A node without a name is called N<k> where its ID is k + 1, a ROUTE R<k>. What text has no place
/// for: whether a first element was named by its index or as the first one.
/// Errors: those of the sink.
class BtWriter final : public PresentationSink {
 public:
  explicit BtWriter(nodes::TextSink sink);
  ~BtWriter() override;

  Status begin(const InitialObjectDescriptor& initial) override;
  Status begin_frame(uint64_t time, bool random_access) override;
  Status add(const Command& command, const nodes::Scene& before) override;
  Status end_frame() override;
  Status object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) override;
  Status end() override;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace afx::bifs

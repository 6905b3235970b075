// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bifs/decoded_json.h"
#include "bifs/presentation.h"

namespace afx::conformance {

/// Keeps what a presentation tells of its scene stream, as JSON text: the access units, each with
/// its time, whether it is a random access point, and its commands (bifs/decoded_json.h).
class ToldCommands final : public bifs::PresentationSink {
 public:
  Status begin(const bifs::InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t time, bool random_access) override;
  Status add(const bifs::Command& command, const nodes::Scene& before) override;
  Status end_frame() override;
  Status object_descriptors(uint64_t, bool, const bifs::OdCommands&) override { return {}; }
  Status end() override { return {}; }

  /// A list of access units.
  [[nodiscard]] std::string text() const { return "[" + text_ + "]"; }

 private:
  bifs::CommandJsonWriter writer_;
  std::string text_;
  bool first_ = true;  ///< command of its access unit
};

/// What is not compared.
struct Forgiven {
  bool names = false;      ///< of nodes and ROUTEs, where the ID stands for it
  bool positions = false;  ///< index 0 and `first` are the same
  bool images = false;  ///< and empty scripts, which some encoders write though they are defaults
};

/// Takes out of told commands what is forgiven.
nlohmann::json without(nlohmann::json commands, const Forgiven& forgiven);

}  // namespace afx::conformance

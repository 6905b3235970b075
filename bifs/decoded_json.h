// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>
#include <string>

#include "bifs/command.h"
#include "bifs/config.h"

namespace afx::bifs {

/// A configuration as a JSON object: version, nodeIDbits, width (null if none) and so on.
std::string config_json(const BifsConfig& config);

/// Writes commands as JSON text, one object for each, in the form of the project's BIFS vectors
/// (conformance/suites/bifs-gpac/README.md): a node is {"node", "id", "name", "fields"} at its
/// first place and
/// {"use": id} at later ones, floats are the shortest decimals that read back, infinities and NaN
/// strings. Commands are given in the order of the stream, before they are applied; one writer for
/// a stream.
class CommandJsonWriter {
 public:
  CommandJsonWriter();
  CommandJsonWriter(CommandJsonWriter&&) noexcept;
  CommandJsonWriter& operator=(CommandJsonWriter&&) noexcept;
  ~CommandJsonWriter();

  std::string write(const Command& command, const nodes::Scene& scene);

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace afx::bifs

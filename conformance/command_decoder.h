// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

#include "conformance/decoder.h"

namespace afx::conformance {

/// A decoder that is a program: each question runs a command of the shell, in which {in}, {out},
/// {as}, {levels}, {width} and {height} are replaced; conformance/suites/README.md says what it
/// must do. It reads nothing from standard input; what it prints is only looked at for messages.
class CommandDecoder final : public Decoder {
 public:
  /// seconds   how long a run may take before it is ended with all that it started
  CommandDecoder(std::string command, double seconds)
      : command_(std::move(command)), seconds_(seconds) {}

  [[nodiscard]] std::string name() const override { return command_; }
  [[nodiscard]] Answer ask(const Question& question) const override;

 private:
  [[nodiscard]] bool has(const char* word) const {
    return command_.find(word) != std::string::npos;
  }
  [[nodiscard]] std::string why_not_asked(const Question& question) const;
  [[nodiscard]] std::string line_for(const Question& question, const std::string& output) const;

  std::string command_;
  double seconds_;
};

}  // namespace afx::conformance

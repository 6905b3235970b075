// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "codec/limits.h"
#include "conformance/decoder.h"
#include "conformance/judge.h"

namespace afx::tools {

/// This program, asked in its own process. Of texts the form `commands` is what the scene stream
/// encoded of them (without names) decodes to.
class OwnDecoder final : public conformance::Decoder {
 public:
  explicit OwnDecoder(const Limits& limits = {}) : limits_(limits) {}

  [[nodiscard]] std::string name() const override;
  [[nodiscard]] conformance::Answer ask(const conformance::Question& question) const override;

 private:
  Limits limits_;
};

}  // namespace afx::tools

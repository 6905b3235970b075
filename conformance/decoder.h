// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Whoever is judged: it is asked a question about a stream, and answers.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "conformance/suite.h"

namespace afx::conformance {

inline constexpr unsigned kAllLevels = 32;

struct Question {
  std::string path;  ///< of the stream
  std::string kind;  ///< of the stream, as in Case
  Form form = Form::octree;
  unsigned levels = kAllLevels;  ///< of an octree
  unsigned width = 0;            ///< of an image
  unsigned height = 0;
};

struct Answer {
  enum class State {
    accepted,
    rejected,  ///< the input is not right: `error`
    failed,    ///< the decoder did not do its work: it crashed, took too long, answered nonsense
    not_run    ///< it was not asked, or says that it cannot do this
  };
  State state = State::accepted;
  std::string why = {};               ///< failed, not_run: in words
  std::optional<Finding> error = {};  ///< rejected; nothing where it does not say why
  std::string error_text = {};        ///< the decoder's own sentence
  nlohmann::json values = {};         ///< of the forms that are JSON; null: none
  std::vector<uint8_t> bytes = {};    ///< of the forms stream and image
  std::optional<std::vector<Finding>> warnings = {};  ///< nothing: it does not tell
};

inline Answer failed(std::string why) {
  return {.state = Answer::State::failed, .why = std::move(why)};
}
inline Answer not_run(std::string why) {
  return {.state = Answer::State::not_run, .why = std::move(why)};
}

/// The answer that a JSON document of the form in conformance/suites/README.md holds; rejected if
/// it has an error. Errors  malformed: it is not of that form
Result<Answer> answer_of_json(const nlohmann::json& document);
/// The document of an answer that is accepted or rejected.
nlohmann::json json_of_answer(const Answer& answer);

class Decoder {
 public:
  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  virtual ~Decoder() = default;

  /// For people: "afx 0.1.0", or the command.
  [[nodiscard]] virtual std::string name() const = 0;
  /// May be called by several threads at once.
  [[nodiscard]] virtual Answer ask(const Question& question) const = 0;
};

}  // namespace afx::conformance

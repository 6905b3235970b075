// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/command_decoder.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <optional>

#include "afx/builder/json_text.h"
#include "conformance/process.h"
#include "conformance/temporary_folder.h"

namespace afx::conformance {
namespace {

constexpr int kNotAccepted = 3;
constexpr size_t kMostOutput = size_t{1} << 30;
constexpr size_t kMostTalk = 4096;

void replace_all(std::string& text, const std::string& word, const std::string& by) {
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

bool is_json(Form form) { return form != Form::stream && form != Form::image; }

/// The last line that it printed to standard error, in brackets; the first `kMostTalk` bytes count.
std::string talk(const std::string& path) {
  const auto bytes = read_whole_file(path, kMostOutput);
  if (!bytes) return {};
  std::string text(bytes->begin(), bytes->begin() + static_cast<std::ptrdiff_t>(
                                                        std::min(bytes->size(), kMostTalk)));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const size_t line = text.rfind('\n');
  if (line != std::string::npos) text = text.substr(line + 1);
  return text.empty() ? text : " (" + text + ")";
}

Answer json_answer(const std::string& path, bool accepted) {
  const auto bytes = read_whole_file(path, kMostOutput);
  if (!bytes)
    return accepted ? failed("it wrote no answer") : Answer{.state = Answer::State::rejected};
  const auto document = parse_json(*bytes, {.memory = kMostOutput * 64});
  if (!document.ok()) return failed("its answer: " + to_string(document.error()));
  auto answer = answer_of_json(document.value());
  if (!answer.ok()) return failed("its answer: " + to_string(answer.error()));
  if (accepted && answer.value().error)
    return failed("its answer has an error, but it ended with exit code 0");
  if (!accepted) answer.value().state = Answer::State::rejected;
  return std::move(answer).value();
}

Answer bytes_answer(const std::string& path, bool accepted) {
  if (!accepted) return {.state = Answer::State::rejected};
  auto bytes = read_whole_file(path, kMostOutput);
  if (!bytes) return failed("it wrote no output");
  return {.bytes = std::move(*bytes)};
}

}  // namespace

std::string CommandDecoder::why_not_asked(const Question& question) const {
  if (!has("{as}") && question.form != first_form_of(question.kind))
    return std::string("the command has no {as} to ask for ") + to_string(question.form);
  if (!has("{levels}") && question.levels != kAllLevels)
    return "the command has no {levels} to ask for a coarser model";
  return {};
}

std::string CommandDecoder::line_for(const Question& question, const std::string& output) const {
  std::string line = command_;
  replace_all(line, "{as}", to_string(question.form));
  replace_all(line, "{levels}", std::to_string(question.levels));
  replace_all(line, "{width}", std::to_string(question.width));
  replace_all(line, "{height}", std::to_string(question.height));
  replace_all(line, "{out}", quoted(output));
  replace_all(line, "{in}", quoted(question.path));
  return line;
}

Answer CommandDecoder::ask(const Question& question) const {
  if (std::string why = why_not_asked(question); !why.empty()) return not_run(std::move(why));
  const auto folder = TemporaryFolder::make();
  if (!folder.ok()) return failed(to_string(folder.error()));
  const std::string output = folder.value().path() + "/answer";
  const std::string errors = folder.value().path() + "/errors";
  const auto end =
      run_process(line_for(question, output), folder.value().path() + "/talk", errors, seconds_);
  if (!end.ok()) return failed(to_string(end.error()));
  const ProcessEnd& how = end.value();
  if (how.timed_out) return failed("it did not end in time");
  if (how.signal != 0)
    return failed("it crashed: signal " + std::to_string(how.signal) + ", " +
                  strsignal(how.signal));
  if (how.exit_code > 128 && how.exit_code < 128 + NSIG)  // a shell's way to say the same
    return failed("it crashed: signal " + std::to_string(how.exit_code - 128) + ", " +
                  strsignal(how.exit_code - 128));
  if (how.exit_code != 0 && how.exit_code != kNotAccepted)
    return failed("it failed with exit code " + std::to_string(how.exit_code) + talk(errors));
  const bool accepted = how.exit_code == 0;
  return is_json(question.form) ? json_answer(output, accepted) : bytes_answer(output, accepted);
}

}  // namespace afx::conformance

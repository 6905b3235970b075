// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/judge.h"

#include <algorithm>
#include <utility>

#include "conformance/judge_picture.h"
#include "conformance/suite_files.h"
#include "conformance/temporary_folder.h"

namespace afx::conformance {
namespace {

using nlohmann::json;

Outcome fail(std::string text) { return {.verdict = Verdict::failed, .text = std::move(text)}; }

/// The outcome of an answer that there is nothing to judge in; nothing where it was accepted or
/// rejected.
std::optional<Outcome> without_answer(const Answer& answer) {
  if (answer.state == Answer::State::failed) return fail(answer.why);
  if (answer.state == Answer::State::not_run)
    return Outcome{.verdict = Verdict::not_run, .text = answer.why};
  return {};
}

std::string error_of(const Answer& answer) {
  std::string text = answer.error ? to_string(*answer.error) : "without saying why";
  return answer.error_text.empty() ? text : text + ": " + answer.error_text;
}

Outcome unexpected_error(const Answer& answer) {
  return fail("it is rejected, " + error_of(answer) + " (expected to be accepted)");
}

bool is_text(const std::string& kind) { return kind == "bt" || kind == "wrl" || kind == "xmt"; }

/// Leaves out what an encoder chooses, so that only what is said is compared.
void drop_choices(json& commands) {
  if (!commands.is_object()) return;
  commands.erase("config");
  if (!commands.contains("accessUnits")) return;
  for (json& unit : commands["accessUnits"]) {
    if (!unit.is_object()) continue;
    unit.erase("bitsUsed");
    unit.erase("bytes");
  }
}

std::string list(const std::vector<Finding>& findings) {
  if (findings.empty()) return "none";
  std::string text;
  for (const Finding& finding : findings) text += (text.empty() ? "" : ", ") + to_string(finding);
  return text;
}

bool fits(const Finding& expected, const Finding& found) {
  return expected.code == found.code &&
         (expected.place == Place::none() || expected.place == found.place);
}

Outcome judge_warnings(const std::vector<Finding>& expected, const Answer& answer) {
  if (!answer.warnings)
    return {.verdict = Verdict::not_run, .text = "its values are right; it tells no warnings"};
  if (expected.size() == answer.warnings->size() &&
      std::equal(expected.begin(), expected.end(), answer.warnings->begin(), fits))
    return {};
  return fail("its warnings are: " + list(*answer.warnings) + " (expected: " + list(expected) +
              ")");
}

class Judge {
 public:
  Judge(const Suite& suite, const Case& one, const Decoder& decoder, const LocateValue& locate)
      : suite_(suite), case_(one), decoder_(decoder), locate_(locate) {}

  Outcome operator()(const DecodeCheck& check) const {
    Question question = question_for(check.form);
    if (check.levels) question.levels = *check.levels;
    const Answer answer = decoder_.ask(question);
    if (auto nothing = without_answer(answer)) return *nothing;
    const bool rejected = answer.state == Answer::State::rejected;
    if (rejected && !check.partial) return unexpected_error(answer);
    if (!rejected && check.partial)
      return fail("it is accepted (expected an error and what is whole)");
    if (rejected && answer.values.is_null())
      return {.verdict = Verdict::not_run, .text = "it gives nothing of a truncated stream"};
    Outcome outcome = compare_with_file(check, question, answer);
    if (outcome.verdict != Verdict::passed || !check.warnings) return outcome;
    return judge_warnings(*check.warnings, answer);
  }

  Outcome operator()(const RejectCheck& check) const {
    const Answer answer = decoder_.ask(question_for(first_form_of(case_.kind)));
    if (auto nothing = without_answer(answer)) return *nothing;
    const std::string wanted = " (expected " + to_string(check.error) +
                               (check.reason.empty() ? "" : ": " + check.reason) + ")";
    if (answer.state == Answer::State::accepted) return fail("it is accepted" + wanted);
    if (!answer.error)
      return {.verdict = Verdict::not_run, .text = "it is rejected without saying why" + wanted};
    if (fits(check.error, *answer.error)) return {};
    return fail("it is rejected, " + error_of(answer) + wanted);
  }

  Outcome operator()(const ReencodeCheck& check) const {
    const Answer again = decoder_.ask(question_for(Form::stream));
    if (auto nothing = without_answer(again)) return *nothing;
    if (again.state == Answer::State::rejected) return unexpected_error(again);
    return check.equal ? compare_answers(*check.equal, again.bytes) : compare_bytes(again.bytes);
  }

  Outcome operator()(const RenderCheck& check) const {
    Question question = question_for(Form::image);
    question.width = check.width;
    question.height = check.height;
    const Answer answer = decoder_.ask(question);
    if (auto nothing = without_answer(answer)) return *nothing;
    if (answer.state == Answer::State::rejected) return unexpected_error(answer);
    const auto expected = read_suite_file(suite_, check.expected);
    if (!expected.ok()) return fail(to_string(expected.error(), check.expected.path));
    return judge_picture(check, expected.value(), answer.bytes);
  }

 private:
  Question question_for(Form form) const {
    return {.path = suite_.folder + "/" + case_.stream.path, .kind = case_.kind, .form = form};
  }

  Outcome compare_with_file(const DecodeCheck& check, const Question& question,
                            const Answer& answer) const {
    auto expected = read_suite_json(suite_, check.expected);
    if (!expected.ok()) return fail(to_string(expected.error(), check.expected.path));
    json found = answer.values;
    if (check.form == Form::commands && is_text(case_.kind)) {
      drop_choices(found);
      drop_choices(expected.value());
    }
    Outcome outcome = compare(expected.value(), found, check.tolerances);
    if (outcome.difference && locate_) outcome.bit = locate_(question, outcome.difference->path);
    if (outcome.bit) outcome.text += ", coded at bit " + std::to_string(*outcome.bit);
    return outcome;
  }

  static Outcome compare(const json& expected, const json& found,
                         const std::vector<Tolerance>& tolerances) {
    auto difference = first_difference(expected, found, tolerances);
    if (!difference) return {};
    Outcome outcome = fail(difference->path + " is " + difference->found + " (expected " +
                           difference->expected + ")");
    outcome.difference = std::move(difference);
    return outcome;
  }

  Outcome compare_bytes(const std::vector<uint8_t>& found) const {
    const auto file = read_suite_file(suite_, case_.stream);
    if (!file.ok()) return fail(to_string(file.error(), case_.stream.path));
    const std::vector<uint8_t>& expected = file.value();
    if (expected == found) return {};
    const auto at = std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
    Outcome outcome =
        fail("encoded again it differs from byte " + std::to_string(at.first - expected.begin()) +
             " on, in " + std::to_string(found.size()) + " bytes (expected the " +
             std::to_string(expected.size()) + " bytes of the stream)");
    outcome.bit = static_cast<uint64_t>(at.first - expected.begin()) * 8;
    return outcome;
  }

  Outcome compare_answers(Form form, const std::vector<uint8_t>& stream) const {
    const auto folder = TemporaryFolder::make();
    if (!folder.ok()) return fail(to_string(folder.error()));
    Question second = question_for(form);
    second.path = folder.value().path() + "/again." + case_.kind;
    if (const Status put = write_whole_file(second.path, stream); !put.ok())
      return fail(to_string(put.error()));
    Answer before = decoder_.ask(question_for(form));
    Answer after = decoder_.ask(second);
    for (const Answer* answer : {&before, &after}) {
      if (auto nothing = without_answer(*answer)) return *nothing;
      if (answer->state == Answer::State::rejected) return unexpected_error(*answer);
    }
    if (form == Form::commands) {
      drop_choices(before.values);
      drop_choices(after.values);
    }
    Outcome outcome = compare(before.values, after.values, {});
    if (outcome.verdict == Verdict::failed) outcome.text = "encoded again, " + outcome.text;
    return outcome;
  }

  const Suite& suite_;
  const Case& case_;
  const Decoder& decoder_;
  const LocateValue& locate_;
};

}  // namespace

const char* to_string(Verdict verdict) {
  if (verdict == Verdict::passed) return "passed";
  return verdict == Verdict::failed ? "failed" : "not run";
}

Outcome judge(const Suite& suite, const Case& one, const Check& check, const Decoder& decoder,
              const LocateValue& locate) {
  return std::visit(Judge(suite, one, decoder, locate), check);
}

}  // namespace afx::conformance

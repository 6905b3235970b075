// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/decoder.h"

#include "conformance/finding_reader.h"
#include "conformance/json_fields.h"

namespace afx::conformance {
namespace {

using nlohmann::json;

json json_of(const Finding& finding) {
  json out{{"code", finding.code}};
  if (finding.place.kind == Place::Kind::bit) out["bit"] = finding.place.bit;
  if (finding.place.kind == Place::Kind::text) {
    out["line"] = finding.place.line;
    out["column"] = finding.place.column;
  }
  return out;
}

}  // namespace

Result<Answer> answer_of_json(const json& document) {
  JsonFields in(document);
  Answer answer;
  if (in.has("error")) {
    JsonFields error = in.object("error");
    answer.state = Answer::State::rejected;
    answer.error = read_finding(error);
    answer.error_text = error.text_or("text");
  }
  if (in.has("warnings")) answer.warnings.emplace();
  for (JsonFields& warning : in.objects("warnings"))
    answer.warnings->push_back(read_finding(warning));
  if (!in.status().ok()) return in.status().error();
  answer.values = document;
  answer.values.erase("error");
  answer.values.erase("warnings");
  if (answer.values.empty()) answer.values = nullptr;
  return answer;
}

json json_of_answer(const Answer& answer) {
  json document = answer.values.is_null() ? json::object() : answer.values;
  if (answer.error) {
    document["error"] = json_of(*answer.error);
    document["error"]["text"] = answer.error_text;
  }
  if (answer.warnings) {
    document["warnings"] = json::array();
    for (const Finding& warning : *answer.warnings)
      document["warnings"].push_back(json_of(warning));
  }
  return document;
}

}  // namespace afx::conformance

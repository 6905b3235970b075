// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/own_decoder.h"

#include <utility>

#include "afx/picture_io.h"
#include "conformance/sha256.h"
#include "tools/own_answers.h"

namespace afx::tools {
namespace {

using conformance::Answer;
using conformance::Finding;
using conformance::Form;
using conformance::Question;

Answer answer_picture(const Input& input, const Limits& limits) {
  const auto picture = decode_picture(input.file.bytes(), input.path, limits);
  if (!picture.ok()) return answer_of_error(picture.error());
  return {.values = {{"width", picture.value().width},
                     {"height", picture.value().height},
                     {"components", picture.value().components},
                     {"samples", conformance::sha256(picture.value().samples)}}};
}

std::vector<Finding> findings_of(const Diagnostics& diagnostics) {
  std::vector<Finding> findings;
  for (const Warning& warning : diagnostics.warnings())
    findings.push_back({warning.code, warning.place});
  return findings;
}

Answer answer_input(const Question& question, Input input, const Limits& limits,
                    Diagnostics& diagnostics) {
  if (question.kind == "picture")
    return question.form == Form::picture
               ? answer_picture(input, limits)
               : conformance::not_run("pictures are answered as pictures alone");
  if (question.form == Form::image)
    return answer_image(question, std::move(input), limits, diagnostics);
  if (question.kind == "octree") return answer_octree(question, input, limits, diagnostics);
  return answer_scene(question, input, limits, diagnostics);
}

}  // namespace

std::string OwnDecoder::name() const { return "afx " AFX_VERSION; }

Answer OwnDecoder::ask(const Question& question) const {
  auto file = MappedFile::open_regular(question.path, limits_);
  if (!file.ok()) return conformance::failed(to_string(file.error(), question.path));
  Input input{question.path, kind_of_format(question.kind == "octree" ? "afx" : question.kind),
              std::move(file).value()};
  Diagnostics diagnostics;
  Answer answer = answer_input(question, std::move(input), limits_, diagnostics);
  answer.warnings = findings_of(diagnostics);
  return answer;
}

}  // namespace afx::tools

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/suite.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "afx/builder/json_text.h"
#include "afx/file.h"
#include "conformance/finding_reader.h"
#include "conformance/json_fields.h"

namespace afx::conformance {
namespace {

constexpr std::array kForms{Form::octree,  Form::commands, Form::tracks,
                            Form::picture, Form::stream,   Form::image};
constexpr std::array kKinds{"octree", "mp4", "bifs", "bt", "wrl", "xmt", "picture"};
constexpr std::array kRejectCodes{"truncated", "malformed", "unsupported", "limit_exceeded"};

template <class List>
bool is_one_of(const std::string& name, const List& list) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

template <class List>
std::string expected(const std::string& found, const List& list) {
  std::string text = "is '" + found + "' (expected ";
  for (size_t i = 0; i < list.size(); ++i)
    text += (i == 0 ? "" : i + 1 == list.size() ? " or " : ", ") + std::string(list[i]);
  return text + ")";
}

/// A path that stays in the folder.
bool is_inside(const std::string& path) {
  if (path.empty() || path.front() == '/') return false;
  for (size_t at = 0; at <= path.size();) {
    const size_t end = std::min(path.find('/', at), path.size());
    if (path.substr(at, end - at) == "..") return false;
    at = end + 1;
  }
  return true;
}

SuiteFile read_file(JsonFields& in, const std::string& name) {
  SuiteFile file{in.text(name), in.text("sha256")};
  if (!is_inside(file.path))
    in.fail(name, "is '" + file.path + "' (expected a file in the suite's folder)");
  return file;
}

Form read_form(JsonFields& in, const std::string& name, size_t forms) {
  const std::string text = in.text(name);
  const std::span<const Form> known(kForms.data(), forms);
  for (const Form form : known)
    if (text == to_string(form)) return form;
  std::vector<std::string> names;
  for (const Form form : known) names.emplace_back(to_string(form));
  in.fail(name, expected(text, names));
  return Form::octree;
}

DecodeCheck read_decode(JsonFields& in) {
  DecodeCheck check;
  check.form = read_form(in, "as", 4);
  check.expected = read_file(in, "file");
  if (in.has("levels")) check.levels = static_cast<unsigned>(in.number("levels", 31));
  if (in.has("partial")) check.partial = in.flag("partial");
  if (in.has("warnings")) check.warnings.emplace();
  for (JsonFields& warning : in.objects("warnings")) {
    check.warnings->push_back(read_finding(warning));
    warning.end();
  }
  for (JsonFields& tolerance : in.objects("tolerances")) {
    check.tolerances.push_back(
        {tolerance.text("path"), tolerance.real("abs"), tolerance.text("reason")});
    tolerance.end();
  }
  return check;
}

ReencodeCheck read_reencode(JsonFields& in) {
  ReencodeCheck check;
  if (in.has("equal")) check.equal = read_form(in, "equal", 3);
  return check;
}

RenderCheck read_render(JsonFields& in) {
  RenderCheck check;
  check.expected = read_file(in, "file");
  check.width = static_cast<unsigned>(in.number("width", 4096));
  check.height = static_cast<unsigned>(in.number("height", 4096));
  check.max_mean = in.real("maxMean");
  check.reason = in.text_or("reason");
  if (check.width == 0 || check.height == 0) in.fail("width", "or height is 0");
  return check;
}

RejectCheck read_reject(JsonFields& in) {
  RejectCheck check{read_finding(in), in.text_or("reason")};
  if (!is_one_of(check.error.code, kRejectCodes))
    in.fail("code", expected(check.error.code, kRejectCodes));
  return check;
}

Check read_check(JsonFields& in) {
  constexpr std::array kChecks{"decode", "reencode", "render", "reject"};
  const std::string name = in.text("check");
  Check check;
  if (name == "decode")
    check = read_decode(in);
  else if (name == "reencode")
    check = read_reencode(in);
  else if (name == "render")
    check = read_render(in);
  else if (name == "reject")
    check = read_reject(in);
  else
    in.fail("check", expected(name, kChecks));
  in.end();
  return check;
}

Case read_case(JsonFields& in) {
  Case one;
  one.name = in.text("name");
  one.about = in.text("about");
  one.kind = in.text("kind");
  if (!is_one_of(one.kind, kKinds)) in.fail("kind", expected(one.kind, kKinds));
  one.stream = read_file(in, "stream");
  for (JsonFields& beside : in.objects("beside")) {
    one.beside.push_back(read_file(beside, "file"));
    beside.end();
  }
  one.origin = in.text("origin");
  one.covers = in.texts("covers");
  for (JsonFields& check : in.objects("expect")) one.expect.push_back(read_check(check));
  if (one.expect.empty()) in.fail("expect", "holds no check");
  in.end();
  return one;
}

void check_names(const Suite& suite, JsonFields& in) {
  std::set<std::string> names;
  for (size_t i = 0; i < suite.cases.size(); ++i) {
    const Case& one = suite.cases[i];
    const std::string where = "cases/" + std::to_string(i);
    if (!names.insert(one.name).second) in.fail(where, "has the name of another: " + one.name);
    if (!suite.origins.contains(one.origin))
      in.fail(where, "names the origin '" + one.origin + "', which is not in /origins");
  }
  if (suite.cases.empty()) in.fail("cases", "holds no case");
}

}  // namespace

const char* to_string(Form form) {
  switch (form) {
    case Form::octree:
      return "octree";
    case Form::commands:
      return "commands";
    case Form::tracks:
      return "tracks";
    case Form::picture:
      return "picture";
    case Form::stream:
      return "stream";
    case Form::image:
      break;
  }
  return "image";
}

std::optional<Form> form_of(std::string_view name) {
  for (const Form form : kForms)
    if (name == to_string(form)) return form;
  return {};
}

Form first_form_of(std::string_view kind) {
  if (kind == "octree") return Form::octree;
  return kind == "picture" ? Form::picture : Form::commands;
}

std::string to_string(const Finding& finding) {
  if (finding.place.kind == Place::Kind::none) return finding.code;
  if (finding.place.kind == Place::Kind::bit)
    return finding.code + " at bit " + std::to_string(finding.place.bit);
  return finding.code + " at " + to_string(finding.place);
}

std::string describe(const Check& check) {
  if (const auto* decode = std::get_if<DecodeCheck>(&check)) {
    std::string text = std::string("decode as ") + to_string(decode->form);
    if (decode->levels) text += ", " + std::to_string(*decode->levels) + " levels";
    return decode->partial ? text + ", what is whole" : text;
  }
  if (const auto* reencode = std::get_if<ReencodeCheck>(&check))
    return reencode->equal ? std::string("reencode, equal ") + to_string(*reencode->equal)
                           : "reencode";
  return std::holds_alternative<RenderCheck>(check) ? "render" : "reject";
}

Result<Suite> read_suite(const std::string& folder) {
  const auto file = MappedFile::open_regular(folder + "/suite.json");
  if (!file.ok()) return file.error();
  return parse_suite(file.value().bytes(), folder);
}

Result<Suite> parse_suite(std::span<const uint8_t> bytes, const std::string& folder) {
  const auto document = parse_json(bytes, {});
  if (!document.ok()) return document.error();
  JsonFields in(document.value());
  Suite suite;
  suite.folder = folder;
  in.text_or("$schema");
  suite.name = in.text("suite");
  suite.title = in.text("title");
  suite.rules = in.texts("rules");
  JsonFields origins = in.object("origins");
  for (const std::string& name : origins.names()) {
    JsonFields origin = origins.object(name);
    suite.origins[name] = {origin.text("text"), origin.text("licence")};
    origin.end();
  }
  for (JsonFields& one : in.objects("cases")) suite.cases.push_back(read_case(one));
  in.end();
  check_names(suite, in);
  if (!in.status().ok()) return in.status().error();
  return suite;
}

}  // namespace afx::conformance

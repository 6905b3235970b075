// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/rules.h"

#include <filesystem>
#include <map>
#include <set>

#include "afx/builder/json_text.h"
#include "afx/file.h"
#include "conformance/json_fields.h"

namespace afx::conformance {
namespace {

std::string normal_path(const Suite& suite, const std::string& file) {
  return (std::filesystem::path(suite.folder) / file).lexically_normal().string();
}

Status check_covers(const Suite& suite, const std::set<std::string>& known) {
  for (const Case& one : suite.cases)
    for (const std::string& id : one.covers)
      if (!known.contains(id))
        return Error{Errc::malformed,
                     Place::none(),
                     "the case " + one.name + " covers '" + id + "', which is no rule of its suite",
                     {},
                     suite.folder + "/suite.json"};
  return {};
}

}  // namespace

Result<RuleSet> read_rules(const std::string& path) {
  const auto file = MappedFile::open_regular(path);
  if (!file.ok()) return file.error();
  const auto document = parse_json(file.value().bytes(), {});
  if (!document.ok()) return document.error();
  JsonFields in(document.value());
  in.text_or("$schema");
  RuleSet set{in.text("area"), in.text("source"), {}};
  std::set<std::string> ids;
  for (JsonFields& rule : in.objects("rules")) {
    set.rules.push_back({rule.text("id"), rule.text("section"), rule.text("text")});
    rule.end();
    if (!ids.insert(set.rules.back().id).second)
      rule.fail("id", "is there twice: " + set.rules.back().id);
  }
  in.end();
  if (!in.status().ok()) return in.status().error();
  return set;
}

Result<std::vector<RuleSet>> rules_of(const std::vector<Suite>& suites) {
  std::vector<RuleSet> sets;
  std::map<std::string, size_t> read;  // path -> place in `sets`
  for (const Suite& suite : suites) {
    std::set<std::string> known;
    for (const std::string& file : suite.rules) {
      const auto [at, fresh] = read.emplace(normal_path(suite, file), sets.size());
      if (fresh) {
        auto set = read_rules(at->first);
        if (!set.ok()) {
          set.error().file = at->first;
          return std::move(set).error();
        }
        sets.push_back(std::move(set).value());
      }
      for (const Rule& rule : sets[at->second].rules) known.insert(rule.id);
    }
    if (Status covered = check_covers(suite, known); !covered.ok()) return covered.error();
  }
  return sets;
}

}  // namespace afx::conformance

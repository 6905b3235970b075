// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/coverage.h"

#include <algorithm>
#include <map>
#include <set>

#include "conformance/html.h"

namespace afx::conformance {
namespace {

/// The cases that cover anything of these rules, in the order of the suites.
std::vector<std::string> columns_of(const std::vector<RuleCover>& rows,
                                    const std::vector<Suite>& suites) {
  std::set<std::string> covering;
  for (const RuleCover& row : rows) covering.insert(row.cases.begin(), row.cases.end());
  std::vector<std::string> columns;
  for (const Suite& suite : suites)
    for (const Case& one : suite.cases)
      if (const std::string name = suite.name + "/" + one.name; covering.contains(name))
        columns.push_back(name);
  return columns;
}

/// A strip with a mark for each case that covers the rule, at its place among the columns.
std::string strip(const RuleCover& row, const std::vector<std::string>& columns) {
  const std::set<std::string> covering(row.cases.begin(), row.cases.end());
  const double mark = std::max(1.0, static_cast<double>(columns.size()) / 120);
  std::string html = "<td><svg class=\"strip\" preserveAspectRatio=\"none\" viewBox=\"0 0 " +
                     std::to_string(columns.size()) + " 1\">";
  for (size_t i = 0; i < columns.size(); ++i)
    if (covering.contains(columns[i]))
      html += "<rect x=\"" + std::to_string(i) + "\" width=\"" + std::to_string(mark) +
              "\" height=\"1\"><title>" + html_text(columns[i]) + "</title></rect>";
  return html + "</svg></td>";
}

std::string case_list(const RuleCover& row) {
  if (row.cases.empty()) return "<td>no case</td>";
  std::string html = "<td><details><summary>" + std::to_string(row.cases.size()) + "</summary>";
  for (const std::string& name : row.cases) html += "<code>" + html_text(name) + "</code><br>";
  return html + "</details></td>";
}

std::string table(const RuleSet& set, const std::vector<Suite>& suites) {
  const std::vector<RuleCover> rows = cover_of(set, suites);
  const std::vector<std::string> columns = columns_of(rows, suites);
  const auto gaps = std::count_if(rows.begin(), rows.end(),
                                  [](const RuleCover& row) { return row.cases.empty(); });
  std::string html = "<h2>" + html_text(set.area) + "</h2>\n<p>" + html_text(set.source) +
                     "</p>\n<p><b>" + std::to_string(rows.size()) + " rules, " +
                     std::to_string(gaps) + " without a case</b>; " +
                     std::to_string(columns.size()) +
                     " cases cover them.</p>\n<table>\n"
                     "<tr><th>rule</th><th>section</th><th></th><th>cases</th><th></th></tr>\n";
  for (const RuleCover& row : rows)
    html += std::string(row.cases.empty() ? "<tr class=\"gap\">" : "<tr>") +
            "<td class=\"rule\"><code>" + html_text(row.rule->id) + "</code></td><td>" +
            html_text(row.rule->section) + "</td><td>" + html_text(row.rule->text) + "</td>" +
            case_list(row) + strip(row, columns) + "</tr>\n";
  return html + "</table>\n";
}

}  // namespace

std::vector<RuleCover> cover_of(const RuleSet& set, const std::vector<Suite>& suites) {
  std::vector<RuleCover> rows;
  std::map<std::string, size_t> row_of;
  for (const Rule& rule : set.rules) {
    row_of[rule.id] = rows.size();
    rows.push_back({.rule = &rule, .cases = {}});
  }
  for (const Suite& suite : suites)
    for (const Case& one : suite.cases)
      for (const std::string& id : one.covers)
        if (const auto row = row_of.find(id); row != row_of.end())
          rows[row->second].cases.push_back(suite.name + "/" + one.name);
  return rows;
}

std::string coverage_page(const std::vector<RuleSet>& sets, const std::vector<Suite>& suites) {
  std::string body = "<h1>What the conformance suites cover</h1>\n";
  for (const RuleSet& set : sets) body += table(set, suites);
  return html_page("Conformance coverage", body);
}

}  // namespace afx::conformance

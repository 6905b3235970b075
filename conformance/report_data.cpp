// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The reports for machines: JUnit and JSON.
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "conformance/report.h"

namespace afx::conformance {
namespace {

using Json = nlohmann::ordered_json;

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", seconds);
  return text;
}

/// Without what XML cannot hold.
std::string for_xml(const std::string& text) {
  std::string clean;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 && c != '\n' && c != '\t')
      clean += '?';
    else
      clean += c;
  }
  return clean;
}

/// "check: sentence" of the checks with that verdict, a line each.
std::string sentences(const CaseOutcome& one, Verdict verdict) {
  std::string text;
  for (size_t i = 0; i < one.checks.size(); ++i) {
    if (one.checks[i].verdict != verdict) continue;
    text += (text.empty() ? "" : "\n") + describe(one.one->expect[i]) + ": " + one.checks[i].text;
  }
  return text;
}

void add_junit_case(pugi::xml_node& node, const CaseOutcome& one) {
  pugi::xml_node test = node.append_child("testcase");
  test.append_attribute("classname") = one.suite->name.c_str();
  test.append_attribute("name") = one.one->name.c_str();
  test.append_attribute("time") = seconds_text(one.seconds).c_str();
  const Verdict verdict = one.verdict();
  if (verdict == Verdict::passed) return;
  const std::string text = for_xml(sentences(one, verdict));
  pugi::xml_node child = test.append_child(verdict == Verdict::failed ? "failure" : "skipped");
  child.append_attribute("message") = text.substr(0, text.find('\n')).c_str();
  if (verdict == Verdict::failed) child.append_child(pugi::node_pcdata).set_value(text.c_str());
}

void add_counts(pugi::xml_node& node, const Counts& counts, double seconds) {
  node.append_attribute("tests") = static_cast<unsigned long long>(counts.all());
  node.append_attribute("failures") = static_cast<unsigned long long>(counts.failed);
  node.append_attribute("errors") = 0;
  node.append_attribute("skipped") = static_cast<unsigned long long>(counts.not_run);
  node.append_attribute("time") = seconds_text(seconds).c_str();
}

Json json_of(const Counts& counts) {
  return {{"passed", counts.passed}, {"failed", counts.failed}, {"notRun", counts.not_run}};
}

Json json_of(const Check& check, const Outcome& outcome) {
  Json json{{"check", describe(check)}, {"verdict", to_string(outcome.verdict)}};
  if (!outcome.text.empty()) json["text"] = outcome.text;
  if (outcome.difference)
    json["difference"] = {{"path", outcome.difference->path},
                          {"expected", outcome.difference->expected},
                          {"found", outcome.difference->found}};
  if (outcome.bit) json["bit"] = *outcome.bit;
  return json;
}

}  // namespace

std::string to_string(const Counts& counts) {
  return std::to_string(counts.passed) + " passed, " + std::to_string(counts.failed) + " failed, " +
         std::to_string(counts.not_run) + " not run";
}

std::string junit_report(const Report& report) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node top = document.append_child("testsuites");
  top.append_attribute("name") = for_xml(report.decoder).c_str();
  add_counts(top, report.counts(), report.seconds);
  for (size_t begin = 0; begin < report.cases.size();) {
    const Suite* suite = report.cases[begin].suite;
    pugi::xml_node node = top.append_child("testsuite");
    node.append_attribute("name") = suite->name.c_str();
    Counts counts;
    double seconds = 0;
    size_t end = begin;
    for (; end < report.cases.size() && report.cases[end].suite == suite; ++end) {
      counts.add(report.cases[end].verdict());
      seconds += report.cases[end].seconds;
    }
    add_counts(node, counts, seconds);
    for (; begin < end; ++begin) add_junit_case(node, report.cases[begin]);
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

Json json_report(const Report& report) {
  Json json{{"decoder", report.decoder}, {"cases", json_of(report.counts())}};
  json["results"] = Json::array();
  for (const CaseOutcome& one : report.cases) {
    Json checks = Json::array();
    for (size_t i = 0; i < one.checks.size(); ++i)
      checks.push_back(json_of(one.one->expect[i], one.checks[i]));
    json["results"].push_back({{"suite", one.suite->name},
                               {"case", one.one->name},
                               {"verdict", to_string(one.verdict())},
                               {"seconds", one.seconds},
                               {"checks", std::move(checks)}});
  }
  return json;
}

}  // namespace afx::conformance

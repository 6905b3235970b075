// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <map>
#include <nlohmann/json.hpp>

#include "conformance/html.h"
#include "conformance/report.h"

namespace afx::conformance {
namespace {

const char* css_class(Verdict verdict) {
  if (verdict == Verdict::not_run) return "not-run";
  return to_string(verdict);
}

std::string verdict_html(Verdict verdict) {
  return std::string("<span class=\"") + css_class(verdict) + "\">" + to_string(verdict) +
         "</span>";
}

/// A bar whose parts are as long as the counts.
std::string bar(const Counts& counts) {
  const auto part = [](const char* name, uint64_t count) {
    return count == 0 ? std::string()
                      : "<span class=\"" + std::string(name) +
                            "\" style=\"flex:" + std::to_string(count) + "\"></span>";
  };
  return "<div class=\"bar\">" + part("passed", counts.passed) + part("failed", counts.failed) +
         part("not-run", counts.not_run) + "</div>\n";
}

class HtmlReport {
 public:
  HtmlReport(const Report& report, const std::vector<RuleSet>& rules) : report_(report) {
    for (const RuleSet& set : rules)
      for (const Rule& rule : set.rules) rules_[rule.id] = &rule;
  }

  std::string page() {
    html_ = "<h1>Conformance report</h1>\n";
    summary();
    failures();
    for (size_t at = 0; at < report_.cases.size();) at = suite(at);
    return html_page("Conformance: " + report_.decoder, html_);
  }

 private:
  void summary() {
    const Counts counts = report_.counts();
    html_ += "<p>Decoder: <code>" + html_text(report_.decoder) + "</code></p>\n<p><b>" +
             to_string(counts) + "</b>, of " + std::to_string(counts.all()) + " cases.</p>\n" +
             bar(counts);
  }

  void failures() {
    bool any = false;
    for (const CaseOutcome& one : report_.cases) {
      if (one.verdict() != Verdict::failed) continue;
      if (!any) html_ += "<h2>What failed</h2>\n";
      any = true;
      card(one);
    }
  }

  /// Everything about one case that failed.
  void card(const CaseOutcome& outcome) {
    const Case& one = *outcome.one;
    html_ += "<div class=\"card\">\n<h3>" + html_text(outcome.suite->name + "/" + one.name) +
             "</h3>\n<p>" + html_text(one.about) + "</p>\n<p class=\"dim\"><code>" +
             html_text(one.stream.path) + "</code>, " + html_text(one.kind) +
             "; made by: " + html_text(outcome.suite->origins.at(one.origin).text) + "</p>\n";
    for (size_t i = 0; i < outcome.checks.size(); ++i) check(one.expect[i], outcome.checks[i]);
    covered(one);
    html_ += "</div>\n";
  }

  void check(const Check& check, const Outcome& outcome) {
    html_ += "<p>" + verdict_html(outcome.verdict) + " " + html_text(describe(check));
    if (!outcome.text.empty() && !outcome.difference) html_ += ": " + html_text(outcome.text);
    html_ += "</p>\n";
    if (outcome.difference) difference(outcome);
    if (!outcome.pictures) return;
    html_ += html_picture(outcome.pictures->expected, "expected");
    html_ += html_picture(outcome.pictures->found, "found");
    html_ += html_picture(outcome.pictures->difference, "difference, 8 times as strong");
  }

  void difference(const Outcome& outcome) {
    const auto row = [this](const char* name, const std::string& value) {
      html_ += std::string("<tr><th>") + name + "</th><td class=\"path\">" + html_text(value) +
               "</td></tr>\n";
    };
    html_ += "<table>\n";
    row("first difference", outcome.difference->path);
    row("expected", outcome.difference->expected);
    row("found", outcome.difference->found);
    if (outcome.bit)
      row("coded at", "bit " + std::to_string(*outcome.bit) + " of the file (byte " +
                          std::to_string(*outcome.bit / 8) + ", bit " +
                          std::to_string(*outcome.bit % 8) + " of it)");
    html_ += "</table>\n";
  }

  void covered(const Case& one) {
    if (one.covers.empty()) return;
    html_ += "<details><summary>Rules that this case is for</summary>\n<ul>\n";
    for (const std::string& id : one.covers) {
      const auto rule = rules_.find(id);
      html_ += "<li><code>" + html_text(id) + "</code>";
      if (rule != rules_.end())
        html_ += " (" + html_text(rule->second->section) + "): " + html_text(rule->second->text);
      html_ += "</li>\n";
    }
    html_ += "</ul></details>\n";
  }

  /// The table of one suite, whose cases begin at `at`. Returns where the next begins.
  size_t suite(size_t at) {
    const Suite& suite = *report_.cases[at].suite;
    Counts counts;
    std::string rows;
    for (; at < report_.cases.size() && report_.cases[at].suite == &suite; ++at) {
      counts.add(report_.cases[at].verdict());
      rows += row(report_.cases[at]);
    }
    html_ += "<h2>" + html_text(suite.title) + "</h2>\n<p><code>" + html_text(suite.name) +
             "</code>: " + to_string(counts) + "</p>\n" + bar(counts) + "<details><summary>All " +
             std::to_string(counts.all()) +
             " cases</summary>\n<table>\n<tr><th>case</th><th>what it is "
             "for</th><th>checks</th></tr>\n" +
             rows + "</table></details>\n";
    return at;
  }

  static std::string row(const CaseOutcome& outcome) {
    std::string html = "<tr><td><code>" + html_text(outcome.one->name) + "</code></td><td>" +
                       html_text(outcome.one->about) + "</td><td>";
    for (size_t i = 0; i < outcome.checks.size(); ++i) {
      const Outcome& check = outcome.checks[i];
      html += verdict_html(check.verdict) + " " + html_text(describe(outcome.one->expect[i]));
      if (!check.text.empty()) html += ": " + html_text(check.text);
      html += "<br>";
    }
    return html + "</td></tr>\n";
  }

  const Report& report_;
  std::map<std::string, const Rule*> rules_;
  std::string html_;
};

}  // namespace

std::string html_report(const Report& report, const std::vector<RuleSet>& rules) {
  return HtmlReport(report, rules).page();
}

}  // namespace afx::conformance

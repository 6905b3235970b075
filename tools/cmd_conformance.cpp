// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "conformance/command_decoder.h"
#include "conformance/coverage.h"
#include "conformance/report.h"
#include "conformance/suite_files.h"
#include "tools/commands.h"
#include "tools/formats.h"
#include "tools/locate_value.h"
#include "tools/own_decoder.h"
#include "tools/progress_bar.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

using conformance::Answer;
using conformance::Form;
using conformance::Verdict;

struct ConformanceOptions {
  std::vector<std::string> folders;
  std::string filter;
  std::string decoder;
  double timeout = 60;
  std::vector<std::string> reports;
  std::string coverage;
};

struct AnswerOptions {
  std::string input, output, form = "octree", kind;
  unsigned levels = conformance::kAllLevels;
  unsigned width = 256, height = 256;
};

std::span<const uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

Result<std::vector<conformance::Suite>> read_suites(const std::vector<std::string>& folders) {
  const auto found = conformance::find_suites(folders);
  if (!found.ok()) return found.error();
  std::vector<conformance::Suite> suites;
  for (const std::string& folder : found.value()) {
    auto suite = conformance::read_suite(folder);
    if (!suite.ok()) {
      suite.error().file = folder + "/suite.json";
      return std::move(suite).error();
    }
    suites.push_back(std::move(suite).value());
  }
  return suites;
}

/// Whether the names of the reports say what they are to be. Returns an exit code.
int check_reports(const ConformanceOptions& options, const OutputFiles& outputs,
                  const Session& session) {
  for (const std::string& path : options.reports) {
    const std::string ending = ending_of(path);
    if (ending != "xml" && ending != "json" && ending != "html")
      return session.usage("--report is " + path +
                           " (expected a name that ends in .xml, .json or .html)");
    if (const Status free = outputs.check(path); !free.ok())
      return session.fail(free.error(), path);
  }
  if (options.coverage.empty()) return kDone;
  const Status free = outputs.check(options.coverage);
  return free.ok() ? kDone : session.fail(free.error(), options.coverage);
}

std::string report_text(const std::string& path, const conformance::Report& report,
                        const std::vector<conformance::RuleSet>& rules) {
  const std::string ending = ending_of(path);
  if (ending == "xml") return conformance::junit_report(report);
  if (ending == "html") return conformance::html_report(report, rules);
  constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
  return conformance::json_report(report).dump(1, ' ', false, kReplace) + "\n";
}

/// A line for each check that failed, and with --verbose for each that was not run.
void show_checks(const conformance::Report& report, const Session& session) {
  for (const conformance::CaseOutcome& one : report.cases) {
    for (size_t i = 0; i < one.checks.size(); ++i) {
      const conformance::Outcome& check = one.checks[i];
      if (check.verdict == Verdict::passed) continue;
      if (check.verdict == Verdict::not_run && !session.options.verbose) continue;
      std::cerr << "afx: " << one.suite->folder << '/' << one.one->stream.path << ": "
                << printable(one.one->name) << ": " << conformance::describe(one.one->expect[i])
                << ' ' << to_string(check.verdict) << ": " << printable(check.text) << '\n';
    }
  }
}

int write_reports(const ConformanceOptions& options, const conformance::Report& report,
                  const std::vector<conformance::Suite>& suites,
                  const std::vector<conformance::RuleSet>& rules, OutputFiles& outputs,
                  const Session& session) {
  if (session.options.dry_run) return kDone;
  for (const std::string& path : options.reports)
    if (Status put = outputs.put(path, bytes_of(report_text(path, report, rules))); !put.ok())
      return session.fail(put.error(), path);
  if (!options.coverage.empty()) {
    const std::string page = conformance::coverage_page(rules, suites);
    if (Status put = outputs.put(options.coverage, bytes_of(page)); !put.ok())
      return session.fail(put.error(), options.coverage);
  }
  const Status done = outputs.commit();
  return done.ok() ? kDone : session.fail(done.error());
}

std::unique_ptr<conformance::Decoder> make_decoder(const ConformanceOptions& options,
                                                   const Session& session) {
  if (options.decoder.empty()) return std::make_unique<OwnDecoder>(session.limits);
  return std::make_unique<conformance::CommandDecoder>(options.decoder, options.timeout);
}

int run_conformance(const ConformanceOptions& options, const Session& session) {
  OutputFiles outputs(session.options.overwrite);
  if (const int code = check_reports(options, outputs, session); code != kDone) return code;
  if (!options.decoder.empty() && options.decoder.find("{in}") == std::string::npos)
    return session.usage("--decoder has no {in} (expected a command such as 'decoder {in} {out}')");
  const auto suites = read_suites(options.folders);
  if (!suites.ok()) return session.fail(suites.error());
  const auto rules = conformance::rules_of(suites.value());
  if (!rules.ok()) return session.fail(rules.error());
  const auto decoder = make_decoder(options, session);
  ProgressBar bar(session.options.progress, session.options.quiet);
  const conformance::RunOptions how{
      .filter = options.filter,
      .jobs = session.options.threads,
      .locate =
          [&session](const conformance::Question& question, const std::string& pointer) {
            return locate_value(question, pointer, session.limits);
          },
      .progress = [&bar](double done) { bar.show("judging", done); }};
  const conformance::Report report = conformance::run_suites(suites.value(), *decoder, how);
  if (report.cases.empty())
    return session.usage("--filter " + options.filter + " fits no case of these suites");
  show_checks(report, session);
  const int written =
      write_reports(options, report, suites.value(), rules.value(), outputs, session);
  if (written != kDone) return written;
  const conformance::Counts counts = report.counts();
  if (session.options.json)
    session.result(conformance::json_report(report));
  else
    std::cout << to_string(counts) << '\n';
  return counts.failed == 0 ? kDone : kDifferent;
}

std::string kind_of_input(const AnswerOptions& options) {
  if (!options.kind.empty()) return options.kind;
  const std::string ending = ending_of(options.input);
  if (ending == "afx") return "octree";
  return kind_of_ending(options.input) == Kind::picture ? "picture" : ending;
}

/// Our decoder behind the door of --decoder.
int run_answer(const AnswerOptions& options, const Session& session) {
  const auto form = conformance::form_of(options.form);
  if (!form)
    return session.usage("--as is " + options.form +
                         " (expected octree, commands, tracks, picture, stream or image)");
  const OwnDecoder decoder(session.limits);
  const Answer answer = decoder.ask({.path = options.input,
                                     .kind = kind_of_input(options),
                                     .form = *form,
                                     .levels = options.levels,
                                     .width = options.width,
                                     .height = options.height});
  if (answer.state == Answer::State::failed || answer.state == Answer::State::not_run)
    return session.fail({Errc::not_available, Place::none(), answer.why});
  const bool is_json = *form != Form::stream && *form != Form::image;
  const bool rejected = answer.state == Answer::State::rejected;
  if (is_json || rejected) {
    const std::string text = conformance::json_of_answer(answer).dump() + "\n";
    const Status put = write_file_atomically(options.output, bytes_of(text), true);
    if (!put.ok()) return session.fail(put.error(), options.output);
    return rejected ? kBadInput : kDone;
  }
  const Status put = write_file_atomically(options.output, answer.bytes, true);
  return put.ok() ? kDone : session.fail(put.error(), options.output);
}

void add_answer(CLI::App& parent, Session& session) {
  auto options = std::make_shared<AnswerOptions>();
  CLI::App* command =
      parent.add_subcommand("answer", "What this decoder answers to one question, for --decoder");
  command->add_option("IN", options->input, "Stream")->required();
  command->add_option("OUT", options->output, "File for the answer; - = standard output")
      ->required();
  command->add_option("--as", options->form, "octree, commands, tracks, picture, stream or image");
  command->add_option("--kind", options->kind, "Kind of the stream where its ending does not tell");
  command->add_option("--levels", options->levels, "Only so many levels of an octree");
  command->add_option("--width", options->width, "Of an image")->check(CLI::Range(1U, 4096U));
  command->add_option("--height", options->height, "Of an image")->check(CLI::Range(1U, 4096U));
  command->callback([options, &session] {
    session.command = "conformance answer";
    session.exit = run_answer(*options, session);
  });
}

}  // namespace

void add_conformance(CLI::App& program, Session& session) {
  auto options = std::make_shared<ConformanceOptions>();
  CLI::App* command = program.add_subcommand(
      "conformance", "Judge this decoder or another one by suites of streams");
  command->add_option("SUITE", options->folders, "Folders with suites in them");
  command->add_option("--filter", options->filter,
                      "Only cases whose SUITE/CASE fits this pattern of * and ?");
  command->add_option(
      "--decoder", options->decoder,
      "Judge this command instead; {in}, {out}, {as}, {levels}, {width} and {height} are replaced");
  command->add_option("--timeout", options->timeout, "Seconds for each run of --decoder")
      ->check(CLI::Range(0.1, 86400.0));
  command->add_option(
      "--report", options->reports,
      "File for the outcome: .html for people, .xml (JUnit), .json; may be given several times");
  command->add_option("--coverage", options->coverage,
                      "File for the page of rules and the cases that cover them (.html)");
  command->add_option("--jobs", session.options.threads, "Cases at a time: the same as --threads");
  add_common_options(*command, session, {.outputs = true, .verbose = true, .progress = true});
  command->require_subcommand(0, 1);
  add_answer(*command, session);
  add_generate(*command, session);
  command->callback([options, command, &session] {
    if (!command->get_subcommands().empty()) return;  // it has done its work
    session.command = "conformance";
    session.exit = options->folders.empty()
                       ? session.usage("SUITE is required (expected folders with suites in them)")
                       : run_conformance(*options, session);
  });
}

}  // namespace afx::tools

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "conformance/generator/octree_property.h"
#include "conformance/generator/scene_property.h"
#include "tools/commands.h"
#include "tools/progress_bar.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

using conformance::FailedCase;
using conformance::Property;
using nlohmann::ordered_json;

struct GeneratorOptions {
  uint64_t seed = 1;
  uint64_t cases = 1000;
  std::optional<uint64_t> only;
  std::string kind = "all";
  std::string keep;
};

const std::map<std::string, Property>& properties() {
  static const std::map<std::string, Property> all{{"octree", conformance::octree_property()},
                                                   {"scene", conformance::scene_property()}};
  return all;
}

/// The smallest case that fails, for people and, where they ask for it, in a folder.
int report(const FailedCase& found, const std::string& kind, const GeneratorOptions& options,
           const Session& session) {
  const std::string about = "seed " + std::to_string(options.seed) + ", case " +
                            std::to_string(found.number) + " (" + kind +
                            "): " + printable(found.failure.text);
  std::cerr << "afx: " << about << '\n';
  if (options.keep.empty() || session.options.dry_run) return kDifferent;
  const std::string name =
      kind + "-" + std::to_string(options.seed) + "-" + std::to_string(found.number);
  const Status kept = conformance::keep_case(options.keep, name, about, found.failure.kept);
  return kept.ok() ? int{kDifferent} : session.fail(kept.error(), options.keep);
}

int run_kind(const std::string& kind, const GeneratorOptions& options, const Session& session) {
  ProgressBar bar(session.options.progress, session.options.quiet);
  const auto found = conformance::find_failure(
      properties().at(kind), {.seed = options.seed,
                              .first = options.only.value_or(0),
                              .cases = options.only ? 1 : options.cases,
                              .threads = session.options.threads,
                              .progress = [&bar](double done) { bar.show("generating", done); }});
  return found ? report(*found, kind, options, session) : kDone;
}

int run_generate(const GeneratorOptions& options, const Session& session) {
  if (options.kind != "all" && properties().count(options.kind) == 0)
    return session.usage("--kind is " + options.kind + " (expected octree, scene or all)");
  ordered_json result = ordered_json::array();
  for (const auto& [kind, property] : properties()) {
    if (options.kind != "all" && options.kind != kind) continue;
    const auto begin = std::chrono::steady_clock::now();
    if (const int code = run_kind(kind, options, session); code != kDone) return code;
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    const uint64_t cases = options.only ? 1 : options.cases;
    result.push_back({{"kind", kind}, {"cases", cases}, {"seconds", taken.count()}});
    if (!session.options.json)
      std::cout << counted(cases, kind + " case") << (cases == 1 ? " holds" : " hold") << '\n';
  }
  session.result({{"seed", options.seed}, {"kinds", result}});
  return kDone;
}

}  // namespace

void add_generate(CLI::App& parent, Session& session) {
  auto options = std::make_shared<GeneratorOptions>();
  CLI::App* command = parent.add_subcommand(
      "generate", "Make random streams and check that coders, readers and writers agree on them");
  command->add_option("--seed", options->seed, "What the cases are made from");
  command->add_option("--cases", options->cases, "How many of each kind");
  command->add_option("--case", options->only, "Only the case of this number");
  command->add_option("--kind", options->kind, "octree, scene or all");
  command->add_option("--keep", options->keep,
                      "Folder for a suite with the smallest case that still fails");
  add_common_options(*command, session, {.progress = true});
  command->callback([options, &session] {
    session.command = "conformance generate";
    session.exit = run_generate(*options, session);
  });
}

}  // namespace afx::tools

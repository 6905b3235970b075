// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/session.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

namespace afx::tools {

int exit_code(Errc code) {
  switch (code) {
    case Errc::io:
    case Errc::no_memory:
    case Errc::not_available:
      return kFailed;
    case Errc::truncated:
    case Errc::malformed:
    case Errc::unsupported:
    case Errc::limit_exceeded:
    case Errc::bad_argument:
      break;
  }
  return kBadInput;
}

int Session::fail(const Error& error, const std::string& file) const {
  std::cerr << "afx: " << to_string(error, file) << '\n';
  if (!error.excerpt.empty())
    std::cerr << error.excerpt << (error.excerpt.back() == '\n' ? "" : "\n");
  return exit_code(error.code);
}

int Session::usage(const std::string& text) const {
  std::cerr << "afx: " << text << " (see 'afx " << command << " --help')\n";
  return kUsage;
}

int Session::warn(const Diagnostics& diagnostics, const std::string& file) const {
  if (diagnostics.count() == 0) return kDone;
  const bool shown = !options.quiet || options.strict;
  for (const Warning& warning : diagnostics.warnings()) {
    if (!shown) break;
    const Error as_error{Errc::malformed, warning.place, "warning: " + warning.text};
    std::cerr << "afx: " << to_string(as_error, file) << '\n';
  }
  const uint64_t more = diagnostics.count() - diagnostics.warnings().size();
  if (shown && more > 0)
    std::cerr << "afx: " << file << ": warning: and " << more << " more warnings\n";
  if (!options.strict) return kDone;
  std::cerr << "afx: " << file << ": " << diagnostics.count()
            << " warnings (expected none, --strict)\n";
  return kBadInput;
}

void Session::say(const std::string& line) const {
  if (!options.quiet) std::cerr << line << '\n';
}

void Session::result(const nlohmann::ordered_json& json) const {
  if (options.json) std::cout << json.dump(2) << std::endl;
}

void add_common_options(CLI::App& command, Session& session, bool outputs) {
  CommonOptions& options = session.options;
  const std::string group = "Common options";
  command.add_flag("-q,--quiet", options.quiet, "Say nothing but errors")->group(group);
  command.add_flag("-v,--verbose", options.verbose, "Say more")->group(group);
  command.add_flag("--json", options.json, "Machine-readable result on standard output")
      ->group(group);
  command.add_flag("--strict", options.strict, "Treat warnings as failures")->group(group);
  command
      .add_option("--threads", options.threads, "Threads to use, 0 = all cores (changes no byte)")
      ->check(CLI::Range(0U, 1024U))
      ->group(group);
  if (!outputs) return;
  command.add_flag("-n,--dry-run", options.dry_run, "Say what would be done, write nothing")
      ->group(group);
  command.add_flag("-f,--force", options.overwrite, "Overwrite existing outputs")->group(group);
  command.add_option("--progress", options.progress, "Progress bar: auto, always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->group(group);
}

std::string grouped(uint64_t number) {
  std::string digits = std::to_string(number);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string fixed(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

}  // namespace afx::tools

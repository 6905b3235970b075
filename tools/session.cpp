// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/session.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "afx/file.h"

namespace afx::tools {
namespace {

/// The one place where talk is printed.
void print(const std::string& line) { std::cerr << printable(line) << '\n'; }

}  // namespace

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
  print("afx: " + to_string(error, file));
  if (!error.excerpt.empty()) {
    std::cerr << printable(error.excerpt, "\n\t") << (error.excerpt.back() == '\n' ? "" : "\n");
  }
  return exit_code(error.code);
}

int Session::fail(const Error& error, const std::string& file,
                  const Diagnostics& diagnostics) const {
  show(diagnostics, file);
  return fail(error, file);
}

int Session::fail_query(const Error& error, bool asked, const std::string& file) const {
  return asked ? usage(to_string(error, file)) : fail(error, file);
}

int Session::usage(const std::string& text) const {
  print("afx: " + text + " (see 'afx " + command + (command.empty() ? "" : " ") + "--help')");
  return kUsage;
}

void Session::show(const Diagnostics& diagnostics, const std::string& file) const {
  if (options.quiet && !options.strict) return;
  for (const Warning& warning : diagnostics.warnings()) {
    const Error as_error{Errc::malformed, warning.place, "warning: " + warning.text};
    print("afx: " + to_string(as_error, warning.file.empty() ? file : warning.file));
  }
  const uint64_t more = diagnostics.count() - diagnostics.warnings().size();
  if (more > 0) print("afx: " + file + ": warning: and " + counted(more, "more warning"));
}

int Session::warn(const Diagnostics& diagnostics, const std::string& file) const {
  show(diagnostics, file);
  if (diagnostics.count() == 0 || !options.strict) return kDone;
  print("afx: " + file + ": " + counted(diagnostics.count(), "warning") +
        " (expected none, --strict)");
  return kBadInput;
}

void Session::say(const std::string& line) const {
  if (!options.quiet) print(line);
}

void Session::result(const nlohmann::ordered_json& json) const {
  // A name in an input may be no UTF-8.
  constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
  if (options.json) std::cout << json.dump(2, ' ', false, kReplace) << std::endl;
}

int Session::finish(OutputFiles& outputs, const std::string& output,
                    const std::vector<std::string>& lines, nlohmann::ordered_json json) const {
  if (options.dry_run) {
    json["dryRun"] = true;
  } else if (Status done = outputs.commit(); !done.ok()) {
    return fail(done.error(), output);
  }
  for (const std::string& line : lines)
    say((options.dry_run && !line.starts_with(' ') ? "would write " : "") + line);
  if (output != "-" || options.dry_run) {
    result(json);
  } else if (options.json) {
    say("afx: warning: no --json result: standard output carries the data");
  }
  return kDone;
}

void add_common_options(CLI::App& command, Session& session, const CommonUse& use) {
  CommonOptions& options = session.options;
  const std::string group = "Common options";
  const std::string hidden;  // no group: not in the help
  command.add_flag("-q,--quiet", options.quiet, "Say nothing but errors")->group(group);
  command.add_flag("-v,--verbose", options.verbose, "Say more")
      ->group(use.verbose ? group : hidden);
  command.add_flag("--json", options.json, "Machine-readable result on standard output")
      ->group(group);
  command.add_flag("--strict", options.strict, "Treat warnings as failures")->group(group);
  command
      .add_option("--threads", options.threads, "Threads to use, 0 = all cores (changes no byte)")
      ->check(CLI::Range(0U, 1024U))
      ->group(group);
  command.add_option("--progress", options.progress, "Progress bar: auto, always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->group(use.progress ? group : hidden);
  if (!use.outputs) return;
  command.add_flag("-n,--dry-run", options.dry_run, "Say what would be done, write nothing")
      ->group(group);
  command.add_flag("-f,--force", options.overwrite, "Overwrite existing outputs")->group(group);
}

std::string printable(std::string_view text, std::string_view kept) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte >= 0x20 && byte != 0x7f) || kept.find(c) != std::string_view::npos) {
      out += c;
    } else {
      out += "\\x";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    }
  }
  return out;
}

std::string grouped(uint64_t number) {
  std::string digits = std::to_string(number);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string counted(uint64_t number, const std::string& one) {
  return grouped(number) + " " + one + (number == 1 ? "" : "s");
}

std::string fixed(double number, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

}  // namespace afx::tools

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What every command of the program shares: the common options, messages and exit codes.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace CLI {
class App;
}

namespace afx::tools {

enum Exit : int {
  kDone = 0,
  kFailed = 1,     ///< for a reason outside the input
  kUsage = 2,      ///< the command line is wrong
  kBadInput = 3,   ///< malformed, not supported or beyond a limit
  kDifferent = 4,  ///< compare: the models differ
  kInterrupted = 130
};

struct CommonOptions {
  bool quiet = false;
  bool verbose = false;
  bool dry_run = false;
  bool json = false;
  bool overwrite = false;
  bool strict = false;
  unsigned threads = 0;  ///< 0 = all cores
  std::string progress = "auto";
};

/// One run of the program. Talk goes to standard error, results to standard output.
class Session {
 public:
  CommonOptions options;
  Limits limits;
  int exit = kDone;  ///< what the process returns

  /// Reports a failure in one line (and the excerpt of a text below it) and returns its exit code.
  int fail(const Error& error, const std::string& file = {}) const;
  /// Reports a wrong command line and returns kUsage.
  int usage(const std::string& text) const;
  /// Prints warnings; with --strict they are a failure, and this is kBadInput.
  int warn(const Diagnostics& diagnostics, const std::string& file) const;
  /// A line about the work, unless --quiet.
  void say(const std::string& line) const;
  /// The machine-readable result, where --json asks for it.
  void result(const nlohmann::ordered_json& json) const;

  std::string command;  ///< the subcommand's name, for usage()
};

/// The exit code that a kind of error has.
int exit_code(Errc code);

/// Adds the common options to a subcommand. outputs: whether it writes files (-n, -f).
void add_common_options(CLI::App& command, Session& session, bool outputs);

/// "12,345".
std::string grouped(uint64_t number);
/// With that many digits after the point.
std::string fixed(double number, int digits);

}  // namespace afx::tools

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What every command of the program shares: the common options, messages and exit codes.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace CLI {
class App;
}

namespace afx {
class OutputFiles;
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

/// One run of the program. Talk goes to standard error, results to standard output. Control
/// characters in talk, which may come from an input, are written as \x1b.
class Session {
 public:
  CommonOptions options;
  Limits limits;
  int exit = kDone;  ///< what the process returns

  /// Reports a failure in one line (and the excerpt of a text below it) and returns its exit code.
  int fail(const Error& error, const std::string& file = {}) const;
  /// The same, after the warnings that were collected on the way.
  int fail(const Error& error, const std::string& file, const Diagnostics& diagnostics) const;
  /// Reports that reading failed. asked: because what the command line asks for (--node, --frame,
  /// --resolution) is not there; then it is the command line that is wrong, and this is kUsage.
  int fail_query(const Error& error, bool asked, const std::string& file) const;
  /// Reports a wrong command line and returns kUsage.
  int usage(const std::string& text) const;
  /// Prints warnings; with --strict they are a failure, and this is kBadInput.
  int warn(const Diagnostics& diagnostics, const std::string& file) const;
  /// Prints warnings, no more.
  void show(const Diagnostics& diagnostics, const std::string& file) const;
  /// A line about the work, unless --quiet.
  void say(const std::string& line) const;
  /// The machine-readable result, where --json asks for it.
  void result(const nlohmann::ordered_json& json) const;

  /// The end of every command that writes: commits the outputs, and only when they are there says
  /// so (`lines`, each output's beginning with its name, others with a blank; `json`). With
  /// --dry-run nothing is committed and the lines say what would be written. output: the name of
  /// the first; "-" = standard output holds data, so the result is not printed there. Returns an
  /// exit code.
  int finish(OutputFiles& outputs, const std::string& output, const std::vector<std::string>& lines,
             nlohmann::ordered_json json) const;

  std::string command;  ///< the subcommand's name, for usage()
};

/// The exit code that a kind of error has.
int exit_code(Errc code);

/// Which of the common options have an effect in a command. The others are accepted all the same,
/// so that scripts can give them everywhere, but are not in its help.
struct CommonUse {
  bool outputs = false;  ///< it writes files: -n, -f
  bool verbose = false;
  bool progress = false;
};

/// Adds the common options to a subcommand.
void add_common_options(CLI::App& command, Session& session, const CommonUse& use);

/// The text with every control character but those of `kept` as \xHH.
std::string printable(std::string_view text, std::string_view kept = {});
/// "12,345".
std::string grouped(uint64_t number);
/// "1 voxel", "12,345 voxels".
std::string counted(uint64_t number, const std::string& one);
/// With that many digits after the point.
std::string fixed(double number, int digits);

}  // namespace afx::tools

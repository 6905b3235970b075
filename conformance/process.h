// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

#include "codec/error.h"

namespace afx::conformance {

/// How a process ended.
struct ProcessEnd {
  bool timed_out = false;
  int signal = 0;     ///< that ended it; 0: none
  int exit_code = 0;  ///< where no signal ended it
};

/// Runs a line of the shell without standard input, with standard output and error in files; when
/// the time is over it is killed, with all that it started and has not left its process group.
/// Errors  io: it cannot be started
Result<ProcessEnd> run_process(const std::string& line, const std::string& out_file,
                               const std::string& err_file, double seconds);

/// A text as one word of the shell.
std::string quoted(const std::string& text);

}  // namespace afx::conformance

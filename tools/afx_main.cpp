// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>
#include <new>

#include "afx/file.h"
#include "tools/commands.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

constexpr void (*kCommands[])(CLI::App&, Session&) = {add_build,   add_encode,    add_decode,
                                                      add_info,    add_trace,     add_render,
                                                      add_compare, add_completion};

extern "C" void on_interrupt(int /*signal*/) {
  remove_temporary_files();
  _exit(kInterrupted);
}

int report_usage(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
  std::string command;
  for (const CLI::App* sub : program.get_subcommands()) command = sub->get_name() + " ";
  std::cerr << "afx: " << error.what() << " (see 'afx " << command << "--help')\n";
  return kUsage;
}

int run(int argc, char** argv) {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  std::signal(SIGPIPE, SIG_IGN);
  Session session;
  CLI::App program(
      "MPEG-4 depth-image-based representation: build, encode, decode, inspect, render", "afx");
  program.set_version_flag("--version", std::string("afx " AFX_VERSION));
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  for (const auto add : kCommands) add(program, session);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage(program, error);
  }
  std::cout.flush();
  if (!std::cout)
    return session.fail({Errc::io, Place::none(), "standard output could not be written"});
  return session.exit;
}

}  // namespace
}  // namespace afx::tools

int main(int argc, char** argv) {
  try {
    return afx::tools::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "afx: there is not enough memory\n";
  } catch (const std::exception& error) {
    std::cerr << "afx: " << error.what() << '\n';
  }
  return afx::tools::kFailed;
}

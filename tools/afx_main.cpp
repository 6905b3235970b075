// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <new>
#include <numeric>

#include "afx/file.h"
#include "tools/commands.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

constexpr void (*kCommands[])(CLI::App&, Session&) = {add_build, add_encode,  add_decode,
                                                      add_info,  add_trace,   add_render,
                                                      add_view,  add_compare, add_completion};
/// Commands that are promised, but not in this build.
constexpr const char* kLaterCommands[] = {"conformance"};

extern "C" void on_interrupt(int /*signal*/) {
  remove_temporary_files();
  _exit(kInterrupted);
}

/// Gives closed standard descriptors a place, so that no file of ours gets their number. Used the
/// way they are meant, they fail as closed ones do.
void occupy_standard_descriptors() {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; ++fd) {
    if (fcntl(fd, F_GETFD) != -1 || errno != EBADF) continue;
    const int way = fd == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (open("/dev/null", way) != fd) _exit(kFailed);
  }
}

/// Interrupts clean up, unless the caller (nohup, a shell's background job) wants them ignored.
void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&action.sa_mask, signal);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {};
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
  std::signal(SIGPIPE, SIG_IGN);  // writing reports it
}

/// How many letters must be changed, added or left out to get from one word to the other.
size_t distance(const std::string& a, const std::string& b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

/// Looks at the command's name; returns an exit code. (The parser would call a mistyped one an
/// argument that was not expected.)
int check_command(const CLI::App& program, const std::string& name, const Session& session) {
  std::string nearest;
  size_t least = 3;  // further away it is no slip
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    const size_t away = distance(name, command->get_name());
    if (away == 0) return kDone;
    if (away >= std::min(least, name.size())) continue;
    least = away;
    nearest = command->get_name();
  }
  for (const char* later : kLaterCommands) {
    if (name != later) continue;
    return session.fail({Errc::not_available, Place::none(),
                         "the command '" + name + "' is not in this build (see 'afx --help')"});
  }
  return session.usage("there is no command '" + name + "'" +
                       (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)"));
}

/// What was printed to standard output must have got there.
int check_standard_output(const Session& session, int code) {
  std::cout.flush();
  if (std::cout) return code;
  return session.fail({Errc::io, Place::none(), "standard output could not be written"});
}

int report_parse(const CLI::App& program, const CLI::ParseError& error, Session& session) {
  if (error.get_exit_code() == 0)  // --help, --version
    return check_standard_output(session, program.exit(error));
  for (const CLI::App* sub : program.get_subcommands()) session.command = sub->get_name();
  return session.usage(error.what());
}

int run(int argc, char** argv) {
  catch_interrupts();
  Session session;
  CLI::App program(
      "MPEG-4 depth-image-based representation: build, encode, decode, inspect, render", "afx");
  program.set_version_flag("--version", std::string("afx " AFX_VERSION));
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  for (const auto add : kCommands) add(program, session);
  if (argc > 1 && argv[1][0] != '-') {
    if (const int code = check_command(program, argv[1], session); code != kDone) return code;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_parse(program, error, session);
  }
  return check_standard_output(session, session.exit);
}

}  // namespace
}  // namespace afx::tools

int main(int argc, char** argv) {
  afx::tools::occupy_standard_descriptors();
  try {
    return afx::tools::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "afx: there is not enough memory\n";
  } catch (const std::exception& error) {
    std::cerr << "afx: " << afx::tools::printable(error.what()) << '\n';
  }
  return afx::tools::kFailed;
}

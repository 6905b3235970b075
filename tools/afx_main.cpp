// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <new>
#include <string>

#include "afx/file.h"
#include "nodes/nearest_name.h"
#include "tools/commands.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

constexpr void (*kCommands[])(CLI::App&, Session&) = {
    add_build,  add_encode, add_decode,  add_info,        add_trace,
    add_render, add_view,   add_compare, add_conformance, add_completion};
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

/// Looks at the command's name; returns an exit code. (The parser would call a mistyped one an
/// argument that was not expected.)
int check_command(const CLI::App& program, const std::string& name, const Session& session) {
  nodes::NearestName nearest(name);
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (name == command->get_name()) return kDone;
    nearest.offer(command->get_name());
  }
  return session.usage("there is no command '" + name + "'" + nearest.hint());
}

/// What was printed to standard output must have got there.
int check_standard_output(const Session& session, int code) {
  std::cout.flush();
  if (std::cout) return code;
  return session.fail({Errc::io, Place::none(), "standard output could not be written"});
}

/// What the parser could not place: an option that is mistyped, or a word too many.
std::string unexpected(const CLI::App& command, const CLI::ParseError& error) {
  for (const std::string& word : command.remaining()) {
    if (word.size() < 2 || word[0] != '-') continue;
    nodes::NearestName nearest(word);
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) nearest.offer("--" + name);
    return "there is no option '" + word + "'" + nearest.hint();
  }
  return error.what();
}

int report_parse(const CLI::App& program, const CLI::ParseError& error, Session& session) {
  if (error.get_exit_code() == 0)  // --help, --version
    return check_standard_output(session, program.exit(error));
  std::string text = error.what();
  for (const CLI::App* sub : program.get_subcommands()) {
    session.command = sub->get_name();
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) text = unexpected(*sub, error);
  }
  return session.usage(text);
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

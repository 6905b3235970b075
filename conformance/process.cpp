// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

namespace afx::conformance {
namespace {

using Clock = std::chrono::steady_clock;

/// Starts the shell in a process group of its own. Returns an errno.
int start(const std::string& line, const std::string& out_file, const std::string& err_file,
          pid_t& pid) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  constexpr int kWrite = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, out_file.c_str(), kWrite, 0600);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, err_file.c_str(), kWrite, 0600);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t defaults;
  sigemptyset(&defaults);
  sigaddset(&defaults, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &defaults);
  std::string shell = "/bin/sh", option = "-c", text = line;
  char* const words[] = {shell.data(), option.data(), text.data(), nullptr};
  const int failure = posix_spawn(&pid, "/bin/sh", &files, &attributes, words, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failure;
}

/// Waits until it ends or the time is over, then kills what is left of its group.
ProcessEnd wait_for(pid_t pid, double seconds) {
  ProcessEnd end;
  int status = 0;
  auto nap = std::chrono::microseconds(200);
  const auto last = Clock::now() + std::chrono::duration<double>(seconds);
  while (waitpid(pid, &status, WNOHANG) == 0) {
    if (Clock::now() > last) {
      end.timed_out = true;
      kill(-pid, SIGKILL);
      waitpid(pid, &status, 0);
      break;
    }
    std::this_thread::sleep_for(nap);
    nap = std::min(nap * 2, std::chrono::microseconds(20000));
  }
  kill(-pid, SIGKILL);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  return end;
}

}  // namespace

Result<ProcessEnd> run_process(const std::string& line, const std::string& out_file,
                               const std::string& err_file, double seconds) {
  pid_t pid = 0;
  if (const int failure = start(line, out_file, err_file, pid); failure != 0)
    return Error{Errc::io, Place::none(),
                 std::string("the command cannot be started: ") + std::strerror(failure)};
  return wait_for(pid, seconds);
}

std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'')
      word += "'\\''";
    else
      word += c;
  }
  return word + "'";
}

}  // namespace afx::conformance

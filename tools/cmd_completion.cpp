// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Shell completion, made from the same options as the help.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "tools/commands.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;  // not in the help either
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::string command_names(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(program)) names.push_back(command->get_name());
  return joined(names);
}

void print_bash(const CLI::App& program) {
  std::cout << "_afx() {\n  local word=${COMP_WORDS[COMP_CWORD]} words\n"
               "  case ${COMP_CWORD}:${COMP_WORDS[1]} in\n    1:*) words='"
            << command_names(program) << "' ;;\n";
  for (const CLI::App* command : commands_of(program)) {
    std::cout << "    *:" << command->get_name() << ") words='" << joined(option_names(*command))
              << "' ;;\n";
  }
  std::cout << "  esac\n  if [[ $COMP_CWORD == 1 || $word == -* ]]; then\n"
               "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
               "  else\n    COMPREPLY=($(compgen -f -- \"$word\"))\n  fi\n}\n"
               "complete -o filenames -F _afx afx\n";
}

void print_zsh(const CLI::App& program) {
  std::cout << "#compdef afx\nautoload -U +X bashcompinit && bashcompinit\n";
  print_bash(program);
}

void print_fish(const CLI::App& program) {
  std::cout << "complete -c afx -n __fish_use_subcommand -f -a '" << command_names(program)
            << "'\n";
  for (const CLI::App* command : commands_of(program)) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_lnames().empty() || option->get_group().empty()) continue;
      std::cout << "complete -c afx -n '__fish_seen_subcommand_from " << command->get_name()
                << "' -l " << option->get_lnames().front() << " -d '" << option->get_description()
                << "'\n";
    }
  }
}

}  // namespace

void add_completion(CLI::App& program, Session& session) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("completion", "Prints a completion script for bash, zsh or fish");
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([shell, &program, &session] {
    if (*shell == "bash") print_bash(program);
    if (*shell == "zsh") print_zsh(program);
    if (*shell == "fish") print_fish(program);
    session.exit = kDone;
  });
}

}  // namespace afx::tools

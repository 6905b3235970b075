// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The subcommands. Each adds itself to the program with its options, which the help, the completion
// and the manual are made from, and sets session.exit when it has run.
#pragma once

namespace CLI {
class App;
}

namespace afx::tools {

class Session;

void add_build(CLI::App& program, Session& session);
void add_encode(CLI::App& program, Session& session);
void add_decode(CLI::App& program, Session& session);
void add_info(CLI::App& program, Session& session);
void add_trace(CLI::App& program, Session& session);
void add_render(CLI::App& program, Session& session);
void add_view(CLI::App& program, Session& session);
void add_compare(CLI::App& program, Session& session);
void add_conformance(CLI::App& program, Session& session);
/// A subcommand of conformance.
void add_generate(CLI::App& conformance, Session& session);
void add_completion(CLI::App& program, Session& session);

}  // namespace afx::tools

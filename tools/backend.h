// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <memory>
#include <string>

#include "codec/error.h"
#include "codec/limits.h"
#include "render/renderer.h"

namespace afx::tools {

/// The names of the backends, for --backend.
inline constexpr const char* kBackends[] = {"software", "gl"};

/// Makes a renderer. backend   one of kBackends
/// Errors  not_available: this build or this machine does not have it
Result<std::unique_ptr<render::Renderer>> make_renderer(const std::string& backend,
                                                        const Limits& limits);

}  // namespace afx::tools

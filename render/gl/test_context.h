// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// One context for all tests of this folder.
#pragma once

#include <memory>

#include "render/gl/egl_context.h"

namespace afx::render {

/// The context of this process, or why there is none.
inline const Result<std::unique_ptr<EglContext>>& test_context() {
  static const Result<std::unique_ptr<EglContext>> context = EglContext::make();
  return context;
}

}  // namespace afx::render

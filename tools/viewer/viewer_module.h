// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The boundary between cmd_view.cpp and the module afx_viewer.so, which links GLFW, OpenGL and Dear
// ImGui. Both come out of one build; no exception crosses.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "codec/error.h"
#include "tools/viewer/viewer_model.h"
#include "tools/viewer/viewer_state.h"

namespace afx::tools {

/// What the program wants of the window, and does for it.
struct ViewerHost {
  std::string file;  ///< to open first
  uint32_t width = 1280, height = 800;
  Drawn drawn;
  unsigned threads = 0;

  /// Reads a model and makes it ready, and reports errors and warnings on standard error. Called on
  /// a thread of its own.
  /// doing   is told what is being done, for people
  std::function<Result<std::shared_ptr<const ViewerModel>>(
      const std::string& file, const std::function<void(const std::string&)>& doing)>
      load;
  /// Writes a picture of a model (or of the whole window) into a new file and returns its name.
  /// Called on a thread of its own, one call at a time.
  std::function<Result<std::string>(const std::string& model, const Picture& picture, bool window)>
      save;
};

/// How it ended.
struct ViewerEnd {
  Status status;                    ///< not_available: no display, no OpenGL 3.3
  std::optional<Error> load_error;  ///< why nothing has ever been shown
  /// Threads read or draw, nobody waits for what nobody will see: the process must end by _exit.
  bool still_working = false;
};
}  // namespace afx::tools

extern "C" {

/// Opens the window and returns when it has been closed. The one symbol of the module, by the name
/// "afx_viewer_run". The host must outlive the process where still_working is set.
typedef void (*afx_viewer_run_function)(const afx::tools::ViewerHost* host,
                                        afx::tools::ViewerEnd* end);
}

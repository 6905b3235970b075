// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/viewer_module.h"

#include <exception>
#include <memory>

#include "tools/viewer/viewer_window.h"

extern "C" __attribute__((visibility("default"))) void afx_viewer_run(
    const afx::tools::ViewerHost* host, afx::tools::ViewerEnd* end) {
  try {
    auto viewer = std::make_unique<afx::tools::Viewer>(*host);
    viewer->run(*end);
    if (end->still_working) (void)viewer.release();  // threads need it to the last
  } catch (const std::exception& error) {
    end->status = afx::Error{afx::Errc::no_memory, afx::Place::none(), error.what()};
  }
}

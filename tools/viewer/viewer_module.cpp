// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/viewer_module.h"

#include <exception>
#include <memory>

#include "tools/viewer/viewer_window.h"

extern "C" __attribute__((visibility("default"))) void afx_viewer_run(
    const afx::tools::ViewerHost* host, afx::tools::ViewerEnd* end) {
  std::unique_ptr<afx::tools::Viewer> viewer;
  try {
    viewer = std::make_unique<afx::tools::Viewer>(*host);
    viewer->run(*end);
  } catch (const std::exception& error) {
    end->status = afx::Error{afx::Errc::no_memory, afx::Place::none(), error.what()};
    end->still_working = viewer != nullptr;  // its threads may be
  }
  if (end->still_working) (void)viewer.release();  // threads need it to the last
}

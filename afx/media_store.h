// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <map>
#include <string>

#include "bifs/media.h"
#include "codec/diagnostics.h"
#include "codec/limits.h"

namespace afx {

/// Media by name: what a presentation's MediaSources name and no file holds.
class MediaStore {
 public:
  /// Keeps media under a name; those that had it are dropped.
  void put(const std::string& name, bifs::Media media);
  /// nullptr where there are none of that name. Good until that name is put again.
  [[nodiscard]] const bifs::Media* find(const std::string& name) const;
  [[nodiscard]] bool empty() const { return media_.empty(); }

  /// Looks for a source here, and in files otherwise (import_media). The store and the diagnostics
  /// must outlive it.
  [[nodiscard]] bifs::LoadMedia loader(std::string folder, const Limits& limits,
                                       Diagnostics& diagnostics) const;

 private:
  std::map<std::string, bifs::Media> media_;
};

}  // namespace afx

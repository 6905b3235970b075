// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/media_store.h"

#include <utility>

#include "afx/media_import.h"

namespace afx {

void MediaStore::put(const std::string& name, bifs::Media media) {
  media_.insert_or_assign(name, std::move(media));
}

const bifs::Media* MediaStore::find(const std::string& name) const {
  const auto found = media_.find(name);
  return found == media_.end() ? nullptr : &found->second;
}

bifs::LoadMedia MediaStore::loader(std::string folder, const Limits& limits,
                                   Diagnostics& diagnostics) const {
  return [this, folder = std::move(folder), limits,
          &diagnostics](const bifs::MediaSource& source) -> Result<bifs::Media> {
    if (const bifs::Media* media = find(source.file)) return *media;
    return import_media(source, folder, limits, diagnostics);
  };
}

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/inline_files.h"

#include <string>

namespace afx {

using nodes::NodeView;

Result<SceneFile*> InlineFiles::find(const NodeView& node, const SceneFile& from,
                                     Diagnostics& diagnostics) {
  const auto& urls = node.get<std::vector<nodes::Url>>("url");
  if (urls.empty()) return nullptr;
  auto key = std::pair(&from, node.path());
  if (const auto known = by_node_.find(key); known != by_node_.end()) return known->second;
  const uint64_t bytes = key.second.size() * sizeof(uint32_t) + 128;
  if (bytes > left_.memory)
    return Error{Errc::limit_exceeded, Place::none(),
                 "the Inlines take more memory than the limit"};
  left_.memory -= bytes;
  auto loaded = load(urls, from.source.base);
  if (!loaded.ok() && loaded.error().code == Errc::limit_exceeded) return std::move(loaded).error();
  if (!loaded.ok())
    diagnostics.warn("inline_not_shown", Place::none(), node.label() + ": " + loaded.error().text);
  SceneFile* file = loaded.ok() ? keep(std::move(loaded).value()) : nullptr;
  by_node_.emplace(std::move(key), file);
  return file;
}

Result<InlineScene> InlineFiles::load(std::span<const nodes::Url> urls, const UrlBase& base) {
  if (!load_)
    return Error{Errc::not_available, Place::none(), "scenes that others name are not loaded"};
  if (++loads_ > kMaxInlineFiles)
    return Error{Errc::unsupported, Place::none(),
                 "more than " + std::to_string(kMaxInlineFiles) + " Inlines are not loaded"};
  auto loaded = load_(urls, base);
  if (loaded.ok() && !loaded.value().scene)
    return Error{Errc::bad_argument, Place::none(), "there is no scene in it"};
  return loaded;
}

SceneFile* InlineFiles::keep(InlineScene loaded) {
  for (const auto& file : files_)
    if (!loaded.file.empty() && file->source.file == loaded.file) return file.get();
  files_.push_back(std::make_unique<SceneFile>(std::move(loaded), left_));
  return files_.back().get();
}

}  // namespace afx

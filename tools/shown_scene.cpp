// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/shown_scene.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>

namespace afx::tools {
namespace {

/// Names one file by one name, as far as that can be told without asking the file system.
std::string plain_name(const std::string& path) {
  return std::filesystem::path(path).lexically_normal().string();
}

VisualOptions options_of(const std::string& path, InlineLoader load_inline) {
  VisualOptions options;
  options.load_inline = std::move(load_inline);
  options.file = plain_name(path);
  return options;
}

/// The place in the file and its name go into the text, which is all of it that is shown.
Error in_one_sentence(const Error& error, const std::string& file) {
  return {error.code, Place::none(), to_string(error, file)};
}

}  // namespace

ShownScene::ShownScene(std::unique_ptr<Opened> main, const Limits& limits)
    : main_(std::move(main)),
      limits_(limits),
      reader_(main_->scene.scene, main_->scene.base(),
              options_of(main_->input.path,
                         [this](std::span<const nodes::Url> urls, const UrlBase& base) {
                           return load_inline(urls, base);
                         }),
              limits) {}

Result<std::unique_ptr<ShownScene>> ShownScene::open(Input input, const Limits& limits,
                                                     Diagnostics& diagnostics) {
  auto main = open_file(std::move(input), limits, diagnostics);
  if (!main.ok()) return std::move(main).error();
  return std::unique_ptr<ShownScene>(new ShownScene(std::move(main).value(), limits));
}

Result<VisualScene> ShownScene::read(const std::optional<nodes::Viewer>& viewer,
                                     Diagnostics& diagnostics) {
  of_inlines_ = {};
  auto scene = reader_.read(viewer, diagnostics);
  diagnostics.append(of_inlines_);
  if (!scene.ok()) return in_file(std::move(scene).error(), main_->input.path);
  return scene;
}

Result<std::unique_ptr<ShownScene::Opened>> ShownScene::open_file(Input input, const Limits& limits,
                                                                  Diagnostics& diagnostics) {
  // The scene of an MP4 file refers to its bytes in their place.
  std::unique_ptr<Opened> opened(new Opened{std::move(input), {}});
  auto scene = read_scene(opened->input, limits, diagnostics);
  if (!scene.ok()) return std::move(scene).error();
  opened->scene = std::move(scene).value();
  return opened;
}

Result<InlineScene> ShownScene::load_inline(std::span<const nodes::Url> urls, const UrlBase& base) {
  auto file = open_url(urls, base, limits_);
  if (!file.ok()) return in_one_sentence(file.error(), {});
  UrlFile& found = file.value();
  if (found.stream != nullptr)
    return Error{Errc::unsupported, Place::none(),
                 found.path + " is a stream (expected the name of a scene file)"};
  const std::string name = plain_name(found.path);
  Diagnostics warnings;
  Input input = input_of(name, std::move(found.file), warnings);
  if (!is_scene(input.kind))
    return Error{Errc::unsupported, Place::none(),
                 name + " is " + describe(input.kind) + " (expected a scene)"};
  const uint64_t bytes = input.file.bytes().size();
  auto opened = open_file(std::move(input), limits_, warnings);
  of_inlines_.append(warnings, name);
  if (!opened.ok()) return in_one_sentence(opened.error(), name);
  limits_.file_bytes -= std::min(limits_.file_bytes, bytes);
  const std::shared_ptr<const Opened> kept = std::move(opened).value();
  return InlineScene{{kept, &kept->scene.scene}, kept->scene.base(), name};
}

}  // namespace afx::tools

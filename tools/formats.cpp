// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/formats.h"

#include <algorithm>
#include <filesystem>

#include "afx/picture_io.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

struct Ending {
  const char* ending;
  Kind kind;
};

constexpr Ending kEndings[] = {
    {"wrl", Kind::scene_text}, {"bt", Kind::scene_text}, {"afx", Kind::octree_stream},
    {"oct", Kind::raw_octree}, {"obj", Kind::model},     {"ply", Kind::model},
    {"gltf", Kind::model},     {"glb", Kind::model},     {"dae", Kind::model},
    {"stl", Kind::model},      {"fbx", Kind::model},     {"3ds", Kind::model},
    {"x3d", Kind::model},      {"off", Kind::model},     {"mp4", Kind::mp4},
    {"bifs", Kind::raw_bifs},  {"xmt", Kind::scene_xml}, {"json", Kind::json},
};

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

/// "wrl, bt or oct", each with `mark` in front.
std::string listed(std::span<const char* const> names, const std::string& mark) {
  std::string list;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += mark + names[i];
  }
  return list;
}

/// "jpg" and "jpeg" are one format, "wrl" and "bt" are two.
bool same_format(const std::string& a, const std::string& b) {
  const std::string picture = picture_format_of("x." + a);
  return a == b || (!picture.empty() && picture == picture_format_of("x." + b));
}

}  // namespace

Kind kind_of_format(const std::string& format) {
  const std::string name = lower(format);
  for (const Ending& entry : kEndings) {
    if (name == entry.ending) return entry.kind;
  }
  return picture_format_of("x." + name).empty() ? Kind::unknown : Kind::picture;
}

std::string ending_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  return lower(ending);
}

Kind kind_of_ending(const std::string& path) { return kind_of_format(ending_of(path)); }

const char* describe(Kind kind) {
  switch (kind) {
    case Kind::scene_text:
      return "scene text";
    case Kind::octree_stream:
      return "an OctreeImage stream";
    case Kind::raw_octree:
      return "a raw octree";
    case Kind::picture:
      return "a picture";
    case Kind::model:
      return "a mesh or point cloud";
    case Kind::scene_xml:
      return "an XMT scene";
    case Kind::mp4:
      return "an MP4 file";
    case Kind::raw_bifs:
      return "a raw BIFS stream";
    case Kind::json:
      return "a decoded stream in JSON";
    case Kind::unknown:
      break;
  }
  return "of an unknown kind";
}

bool is_text_scene(Kind kind) { return kind == Kind::scene_text || kind == Kind::scene_xml; }
bool is_coded_scene(Kind kind) { return kind == Kind::mp4 || kind == Kind::raw_bifs; }
bool is_scene(Kind kind) { return is_text_scene(kind) || is_coded_scene(kind); }

int output_format(const Session& session, const std::string& path, const std::string& option,
                  std::span<const char* const> names, std::string& format) {
  const std::string ending = ending_of(path);
  const auto is_ours = [&](const std::string& name) {
    return std::any_of(names.begin(), names.end(),
                       [&](const char* ours) { return same_format(name, ours); });
  };
  const bool told = kind_of_format(ending) != Kind::unknown || is_ours(ending);
  format = told || option.empty() ? ending : lower(option);
  if (!option.empty()) {
    if (kind_of_format(option) == Kind::unknown && !is_ours(lower(option))) {
      return session.usage("--format " + option + " is not known (expected " + listed(names, "") +
                           ")");
    }
    if (told && !same_format(ending, lower(option))) {
      return session.usage("--format " + option + " disagrees with the name " + path +
                           " (--format is for - and for names without a known ending)");
    }
  }
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const char* name) { return same_format(format, name); });
  if (found != names.end()) {
    format = *found;
    return kDone;
  }
  return session.usage("cannot " + session.command + " to " +
                       (told || option.empty() ? path : "--format " + option) + " (expected " +
                       listed(names, ".") + ", or --format)");
}

int check_input_format(const Session& session, const std::string& option,
                       std::span<const char* const> names) {
  if (option.empty()) return kDone;
  const Kind kind = kind_of_format(option);
  const bool known = std::any_of(names.begin(), names.end(), [kind](const char* name) {
    return kind != Kind::unknown && kind_of_format(name) == kind;
  });
  if (known) return kDone;
  return session.usage("--input-format " + option +
                       (kind == Kind::unknown ? " is not known" : " is not read here") +
                       " (expected " + listed(names, "") + ")");
}

}  // namespace afx::tools

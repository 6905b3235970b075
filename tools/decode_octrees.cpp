// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "afx/octree_stream.h"
#include "nodes/scene_writer.h"
#include "tools/decode.h"
#include "tools/name_pattern.h"

namespace afx::tools {
namespace {

constexpr unsigned kAllLevels = 32;

std::vector<uint8_t> scene_text_of(const OctreeFields& fields, uint32_t resolution,
                                   uint32_t textures, bool header) {
  nodes::Scene scene;
  const auto group = scene.add("Group");
  const nodes::NodeId octree = add_octree_image(scene, OctreeNode{resolution, textures, fields});
  (void)scene.append(group.value(), "children", octree);  // an OctreeImage may stand there
  scene.add_root(group.value());
  const std::string text = nodes::write_scene_text(scene, {.vrml_header = header});
  return {text.begin(), text.end()};
}

/// What a raw octree cannot hold is a warning.
void warn_of_lost_indices(const OctreeFields& fields, Diagnostics& diagnostics) {
  if (fields.voxel_image_index.empty()) return;
  diagnostics.warn("lost_indices", Place::none(),
                   "a raw octree has no place for image indices: " +
                       counted(fields.voxel_image_index.size(), "symbol") + " of voxelImageIndex " +
                       (fields.voxel_image_index.size() == 1 ? "is" : "are") + " left out");
}

int check_frames(const DecodeOptions& options, const DecodedOctreeStream& decoded,
                 const OutputFiles& outputs, const Session& session) {
  const NamePattern pattern(options.output);
  const size_t frames = decoded.stream.frames.size();
  if (frames > 1 && !pattern.has_number) {
    return session.usage("the stream has " + std::to_string(frames) + " frames, but " +
                         options.output +
                         " is one file (expected a pattern such as frame_%04d.wrl, or --frame K)");
  }
  for (const OctreeFrameInfo& info : decoded.infos) {
    const std::string name = pattern.name(info.number);
    if (Status free = outputs.check(name); !free.ok()) return session.fail(free.error(), name);
  }
  return kDone;
}

/// Writes what was decoded; returns an exit code.
int write_frames(const DecodeOptions& options, const std::string& format,
                 const DecodedOctreeStream& decoded, OutputFiles& outputs, const Session& session) {
  if (const int code = check_frames(options, decoded, outputs, session); code != kDone) return code;
  const NamePattern pattern(options.output);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::vector<std::string> lines;
  for (size_t i = 0; i < decoded.stream.frames.size(); ++i) {
    const OctreeFields& fields = decoded.stream.frames[i];
    const uint32_t resolution = decoded.infos[i].resolution;
    const std::string name = pattern.name(decoded.infos[i].number);
    const std::vector<uint8_t> bytes =
        format == "oct"
            ? fields.octree
            : scene_text_of(fields, resolution, decoded.stream.textures, format != "bt");
    lines.push_back(name + ": " + counted(bytes.size(), "byte") + ", resolution " +
                    std::to_string(resolution));
    list.push_back({{"output", name}, {"bytes", bytes.size()}, {"octreeResolution", resolution}});
    if (session.options.dry_run) continue;
    if (Status put = outputs.put(name, bytes); !put.ok()) return session.fail(put.error(), name);
  }
  return session.finish(outputs, options.output, lines, {{"outputs", list}});
}

}  // namespace

int decode_octrees(const DecodeOptions& options, const std::string& format, const Input& input,
                   OutputFiles& outputs, const Session& session, Diagnostics& diagnostics) {
  OctreeDecodeOptions how{.levels = options.levels.value_or(kAllLevels),
                          .frame = options.frame,
                          .threads = session.options.threads};
  how.limits = session.limits;
  const DecodedOctreeStream decoded = decode_octree_stream(input.file.bytes(), how, diagnostics);
  const bool whole = decoded.status.ok();
  if (format == "oct" && (whole || options.partial)) {
    for (const OctreeFields& fields : decoded.stream.frames)
      warn_of_lost_indices(fields, diagnostics);
  }
  if (whole) {
    const int warned = session.warn(diagnostics, options.input);
    return warned == kDone ? write_frames(options, format, decoded, outputs, session) : warned;
  }
  session.show(diagnostics, options.input);
  const Error& error = decoded.status.error();
  const int code =
      session.fail_query(error, error.code == Errc::bad_argument, options.input);  // --frame
  const bool strict_failure = session.options.strict && diagnostics.count() > 0;
  if (code == kUsage || !options.partial || strict_failure || decoded.stream.frames.empty())
    return code;
  const int written = write_frames(options, format, decoded, outputs, session);
  return written == kDone ? code : written;
}

}  // namespace afx::tools

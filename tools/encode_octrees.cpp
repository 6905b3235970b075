// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <nlohmann/json.hpp>

#include "afx/file.h"
#include "afx/octree_stream.h"
#include "codec/octree_encoder.h"
#include "tools/encode.h"
#include "tools/input.h"

namespace afx::tools {
namespace {

/// What all frames of a stream have in common; the first one decides.
struct Common {
  uint32_t resolution = 1;
  uint32_t images = 0;
  bool indices = false;
};

Status check_agreement(const Common& here, const Common& first) {
  const auto differs = [](const std::string& text) {
    return Error{Errc::bad_argument, Place::none(),
                 text + " in the first frame (frames of one stream must agree)"};
  };
  if (here.resolution != first.resolution) {
    return differs("octreeResolution is " + std::to_string(here.resolution) + ", but " +
                   std::to_string(first.resolution));
  }
  if (here.images != first.images) {
    return differs("the number of images is " + std::to_string(here.images) + ", but " +
                   std::to_string(first.images));
  }
  if (here.indices != first.indices) {
    return differs(here.indices ? "voxelImageIndex has entries, but none"
                                : "voxelImageIndex is empty, but not");
  }
  return {};
}

/// Checks one input as a frame and adds it to the stream.
Status add_frame(OctreeStream& stream, Common& first, OctreeNode octree) {
  const Common here{octree.resolution, octree.images, !octree.fields.voxel_image_index.empty()};
  if (stream.frames.empty()) {
    first = here;
    stream.resolution = here.resolution;
    stream.textures = here.indices ? here.images : 0;
  }
  if (Status agrees = check_agreement(here, first); !agrees.ok()) return agrees;
  if (stream.textures > kMaxStreamTextures) {
    return Error{Errc::bad_argument, Place::none(),
                 "has " + std::to_string(stream.textures) + " images (a stream holds at most " +
                     std::to_string(kMaxStreamTextures) + ")"};
  }
  if (Status fits = codec::check_octree_fields(octree.fields, octree_levels(here.resolution),
                                               stream.textures);
      !fits.ok())
    return fits;
  stream.frames.push_back(std::move(octree.fields));
  return {};
}

/// Reads one input as the next frame; returns an exit code.
int read_frame(const EncodeOptions& options, const std::string& path, const Session& session,
               OctreeStream& stream, Common& first, std::vector<Kind>& kinds) {
  Diagnostics diagnostics;
  const auto input = open_input(path, options.input_format, session.limits, diagnostics);
  if (!input.ok()) return session.fail(input.error(), path, diagnostics);
  kinds.push_back(input.value().kind);
  if (input.value().kind == Kind::octree_stream) {
    const Error error{Errc::unsupported, Place::none(),
                      "is an OctreeImage stream already (expected scene text or .oct)"};
    return session.fail(error, path, diagnostics);
  }
  OctreeQuery query{.node = options.node, .resolution = options.resolution, .frame = {}};
  auto octree = read_octree(input.value(), query, session.limits, diagnostics);
  if (!octree.ok()) {
    session.show(diagnostics, path);
    return session.fail_query(octree.error(), query.missing_is_usage, path);
  }
  if (Status added = add_frame(stream, first, std::move(octree).value()); !added.ok())
    return session.fail(added.error(), path, diagnostics);
  return session.warn(diagnostics, path);
}

/// Reads all inputs as frames; returns an exit code.
int read_frames(const EncodeOptions& options, const Session& session, OctreeStream& stream) {
  Common first;
  std::vector<Kind> kinds;
  for (const std::string& path : options.inputs) {
    const int code = read_frame(options, path, session, stream, first, kinds);
    if (code != kDone) return code;
  }
  const std::string useless =
      useless_option({.node = options.node, .resolution = options.resolution, .frame = {}}, kinds);
  return useless.empty() ? kDone : session.usage(useless);
}

}  // namespace

int encode_octrees(const EncodeOptions& options, OutputFiles& outputs, const Session& session) {
  OctreeStream stream;
  if (const int code = read_frames(options, session, stream); code != kDone) return code;
  const auto encoded = encode_octree_stream(stream, session.options.threads);
  if (!encoded.ok()) return session.fail(encoded.error(), options.output);
  if (!session.options.dry_run) {
    if (Status put = outputs.put(options.output, encoded.value()); !put.ok())
      return session.fail(put.error(), options.output);
  }
  uint64_t fields = 0;
  for (const OctreeFields& frame : stream.frames)
    fields += frame.octree.size() + frame.voxel_image_index.size();
  const uint64_t bytes = encoded.value().size();
  return session.finish(
      outputs, options.output,
      {options.output + ": " + counted(bytes, "byte") + " from " + counted(fields, "byte") +
       " of fields, " + counted(stream.frames.size(), "frame")},
      {{"output", options.output},
       {"bytes", bytes},
       {"fieldBytes", fields},
       {"frames", stream.frames.size()},
       {"octreeResolution", stream.resolution},
       {"numOfTextures", stream.textures}});
}

}  // namespace afx::tools

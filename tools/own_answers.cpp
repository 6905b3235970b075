// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/own_answers.h"

#include <algorithm>

#include "afx/octree_stream.h"
#include "afx/picture_io.h"
#include "tools/backend.h"
#include "tools/drawing.h"
#include "tools/frame_drawer.h"
#include "tools/render_camera.h"
#include "tools/session.h"

namespace afx::tools {
namespace {

using conformance::Answer;
using conformance::Form;
using conformance::Question;
using nlohmann::json;

/// The frames that were decoded. A frame coarser than the first says so itself.
json json_of(const DecodedOctreeStream& decoded) {
  const uint32_t resolution =
      decoded.infos.empty() ? decoded.stream.resolution : decoded.infos.front().resolution;
  json frames = json::array();
  for (size_t i = 0; i < decoded.infos.size(); ++i) {
    const OctreeFields& fields = decoded.stream.frames[i];
    frames.push_back({{"octree", fields.octree}, {"voxelImageIndex", fields.voxel_image_index}});
    if (decoded.infos[i].resolution != resolution)
      frames.back()["octreeResolution"] = decoded.infos[i].resolution;
  }
  return {{"octreeResolution", resolution},
          {"numOfTextures", decoded.stream.textures},
          {"frames", std::move(frames)}};
}

Answer png_of(const Picture& picture) {
  auto bytes = encode_picture(picture, "png");
  if (!bytes.ok()) return answer_of_error(bytes.error());
  return {.bytes = std::move(bytes).value()};
}

}  // namespace

Answer answer_of_error(const Error& error) {
  const int code = exit_code(error.code);
  if (code != kBadInput) return conformance::failed(to_string(error));
  return {.state = Answer::State::rejected,
          .error = conformance::Finding{to_string(error.code), error.place},
          .error_text = error.text};
}

Answer answer_octree(const Question& question, const Input& input, const Limits& limits,
                     Diagnostics& diagnostics) {
  OctreeDecodeOptions how{.levels = question.levels};
  how.limits = limits;
  const DecodedOctreeStream decoded = decode_octree_stream(input.file.bytes(), how, diagnostics);
  if (question.form == Form::octree) {
    Answer answer;
    if (!decoded.status.ok()) answer = answer_of_error(decoded.status.error());
    if (decoded.has_header && (decoded.status.ok() || !decoded.infos.empty()))
      answer.values = json_of(decoded);
    return answer;
  }
  if (question.form != Form::stream)
    return conformance::not_run("OctreeImage streams are answered as octree and stream alone");
  if (!decoded.status.ok()) return answer_of_error(decoded.status.error());
  auto bytes = encode_octree_stream(decoded.stream);
  if (!bytes.ok()) return conformance::failed(to_string(bytes.error()));
  return {.bytes = std::move(bytes).value()};
}

Answer answer_image(const Question& question, Input input, const Limits& limits,
                    Diagnostics& diagnostics) {
  Session session;
  session.limits = limits;
  session.options.threads = 1;
  Drawing drawing(session, diagnostics);
  if (const Status added = drawing.add_scene(std::move(input)); !added.ok())
    return answer_of_error(added.error());
  if (drawing.viewpoints().empty())
    return conformance::failed("the scene has no Viewpoint to be drawn through");
  CameraOptions by_viewpoint;
  by_viewpoint.viewpoint = "1";
  render::Camera camera;
  const double aspect = static_cast<double>(question.width) / question.height;
  if (choose_camera(by_viewpoint, {drawing.outline(), drawing.viewpoints()}, aspect, false, session,
                    question.path, camera) != kDone)
    return conformance::failed("the Viewpoint cannot be looked through");
  if (const Status seen = drawing.set_viewer(viewer_of(camera), diagnostics); !seen.ok())
    return answer_of_error(seen.error());
  render::RenderOptions options{.width = question.width, .height = question.height, .threads = 1};
  const auto image = drawing.draw(camera, options);
  return image.ok() ? png_of(image.value().picture) : answer_of_error(image.error());
}

}  // namespace afx::tools

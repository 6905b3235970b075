// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The parts of the command build, one for each form that it builds.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "afx/file.h"
#include "afx/picture.h"
#include "codec/error.h"
#include "nodes/scene.h"
#include "tools/model_input.h"
#include "tools/progress_bar.h"
#include "tools/session.h"

namespace afx::tools {

struct BuildCommand {
  std::vector<std::string> inputs;
  std::string output;
  std::string as = "octree";
  uint32_t resolution = 256;
  bool resolution_given = false;
  std::string up;  ///< empty: not given, y
  double scale = 1;
  std::optional<double> fit;
  std::string shade = "auto";
  std::string image_format = "png";
  int jpeg_quality = 90;
  // depth and points
  std::optional<std::string> views;  ///< nothing: 6, of points one from the front
  bool perspective = false;
  bool coverage = false;
  bool depth_in_alpha = false;
  unsigned depth_bits = 0;  ///< 0: chosen
  // octree
  uint32_t image_size = 0;
  unsigned images = 0;
  std::optional<uint64_t> target_size;
  std::optional<double> target_psnr;
  std::vector<double> cube;  ///< centre and side, or empty
};

/// What a build works with besides the model.
struct BuildJob {
  const BuildCommand& command;
  const Session& session;
  ProgressBar& bar;
  OutputFiles& outputs;
  Diagnostics& diagnostics;
  bool& option_is_wrong;       ///< set where an error is about what an option asks for
  glm::dvec3 offset{0, 0, 0};  ///< what was taken off the model, see take_offset
};

/// Puts a model where the options want it. The objects of a scene become pieces of surface if they
/// are to be moved.
Status place_input(ModelInput& model, const BuildJob& job);

/// Takes the middle of a model that lies far from the origin off it, so that what is built of it
/// keeps its precision in the fields of nodes, which are floats.
/// Returns  what was taken off, as floats can hold it; mostly zero
glm::dvec3 take_offset(ModelInput& model);

/// Something built: its scene, and what there is to say.
struct BuiltScene {
  nodes::Scene scene;
  std::vector<std::string> lines;  ///< below the scene's own, each beginning with blanks
  nlohmann::ordered_json json;     ///< members of the result
};

/// Each takes the model, which is in its place, and puts the pictures into the job's outputs.
Result<BuiltScene> build_octree_scene(ModelInput&& model, const BuildJob& job);
Result<BuiltScene> build_depth_scene(ModelInput&& model, const BuildJob& job);
Result<BuiltScene> build_points_scene(ModelInput&& model, const BuildJob& job);

/// The pictures of a scene, written beside it with its name in front.
class PictureFiles {
 public:
  PictureFiles(const BuildJob& job, int jpeg_quality) : job_(job), jpeg_quality_(jpeg_quality) {}

  /// Puts the bytes of an encoded picture in.
  /// suffix    what stands behind the scene's name, e.g. "_front"
  /// Returns   the name as the scene's url has it
  Result<std::string> put(const std::string& suffix, const std::string& format,
                          const std::vector<uint8_t>& bytes);

  /// Encodes and puts a picture in.
  template <class AnyPicture>
  Result<std::string> put(const std::string& suffix, const AnyPicture& picture,
                          const std::string& format, bool colour);

  [[nodiscard]] uint64_t bytes() const { return bytes_; }
  [[nodiscard]] size_t count() const { return count_; }

 private:
  const BuildJob& job_;
  int jpeg_quality_;
  uint64_t bytes_ = 0;
  size_t count_ = 0;
};

/// Adds what every built scene begins with, Group { Transform { } }, and gives the Transform. What
/// was taken off the model is the translation of another one around it.
nodes::NodeId add_transform(nodes::Scene& scene, const glm::dvec3& offset);

}  // namespace afx::tools

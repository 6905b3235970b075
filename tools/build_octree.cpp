// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <cmath>
#include <utility>

#include "afx/builder/image_target.h"
#include "afx/builder/octree_builder.h"
#include "afx/builder/reference_cameras.h"
#include "afx/known_nodes.h"
#include "afx/octree_image.h"
#include "afx/octree_stream.h"
#include "afx/picture_io.h"
#include "tools/build.h"

namespace afx::tools {
namespace {

/// The cube of the one OctreeImage that a model is, if it lies straight in the scene.
std::optional<Cube> cube_of(const ModelInput& model) {
  const auto* models = std::get_if<std::vector<DibrModel>>(&model);
  if (models == nullptr || models->size() != 1) return {};
  if (models->front().octree() == nullptr) return {};
  const glm::dmat4& m = models->front().to_world;
  const double side = m[0][0];
  const glm::dvec3 centre(m[3]);
  glm::dmat4 straight(side);
  straight[3] = glm::dvec4(centre, 1);
  if (!(side > 0) || m != straight) return {};
  return Cube{centre, side};
}

BuildOptions options_of(const ModelInput& model, const BuildJob& job) {
  BuildOptions options;
  options.resolution = job.command.resolution;
  options.cube = cube_of(model);
  if (options.cube && !job.command.resolution_given) {
    const auto& models = std::get<std::vector<DibrModel>>(model);
    options.resolution = models.front().octree()->resolution;
  }
  if (const std::vector<double>& c = job.command.cube; !c.empty())
    options.cube = Cube{glm::dvec3(c[0], c[1], c[2]) - job.offset, c[3]};
  options.image_size = job.command.image_size;
  options.images = job.command.images;
  if (job.command.image_format == "jpeg") {
    options.coder = ImageCoder::jpeg;
    options.symbol_price = kSymbolPrice;  // what JPEG loses hides what that does
  }
  options.threads = job.session.options.threads;
  options.shade = shade_of(job.command.shade);
  options.limits = job.session.limits;
  options.progress = [&job](const char* stage, double done) { job.bar.show(stage, done); };
  return options;
}

Result<BuiltOctree> build(ModelInput&& model, const BuildJob& job) {
  const BuildOptions options = options_of(model, job);
  if (const auto* mesh = std::get_if<Mesh>(&model))
    return build_octree(*mesh, options, job.diagnostics);
  if (const auto* cloud = std::get_if<PointCloud>(&model))
    return build_octree(*cloud, options, job.diagnostics);
  const auto surfels = surfels_of_input(std::move(model), job.session, job.diagnostics);
  if (!surfels.ok()) return surfels.error();
  return build_octree(surfels.value(), options, job.diagnostics);
}

/// The pictures, coded: as PNG, or as JPEG of the quality given or found.
struct CodedPictures {
  std::vector<std::vector<uint8_t>> files;
  int quality = 0;  ///< JPEG
  double psnr = 0;  ///< JPEG: dB of the used pixels
};

/// Bytes of the AFX stream of the fields.
Result<uint64_t> stream_bytes(const OctreeModel& model, const BuildJob& job) {
  OctreeStream stream;
  stream.resolution = model.resolution;
  stream.textures = static_cast<uint32_t>(model.images.size());
  stream.frames.push_back(model.fields);
  const auto bytes = encode_octree_stream(stream, job.session.options.threads);
  if (!bytes.ok()) return bytes.error();
  return bytes.value().size();
}

Result<CodedImages> code_jpeg(const BuiltOctree& built, const BuildJob& job) {
  const BuildCommand& command = job.command;
  const unsigned threads = job.session.options.threads;
  const std::vector<ReferenceImage>& images = built.model.images;
  if (command.target_psnr)
    return code_images_to_psnr(images, built.used, *command.target_psnr, threads);
  if (!command.target_size) return code_images(images, built.used, command.jpeg_quality, threads);
  const auto octree = stream_bytes(built.model, job);
  if (!octree.ok()) return octree.error();
  if (octree.value() >= *command.target_size)
    return Error{Errc::bad_argument, Place::none(),
                 "the octree alone takes " + counted(octree.value(), "byte") +
                     " (expected a greater --target-size or less --resolution)"};
  return code_images_to_size(images, built.used, *command.target_size - octree.value(), threads);
}

Result<CodedPictures> code_pictures(const BuiltOctree& built, const BuildJob& job) {
  CodedPictures coded;
  if (job.command.image_format == "jpeg") {
    auto jpeg = code_jpeg(built, job);
    if (!jpeg.ok()) {
      job.option_is_wrong = jpeg.error().code == Errc::bad_argument;  // a target out of reach
      return std::move(jpeg).error();
    }
    return CodedPictures{std::move(jpeg.value().files), jpeg.value().quality, jpeg.value().psnr};
  }
  for (const ReferenceImage& image : built.model.images) {
    auto bytes = encode_picture(image.picture, "png");
    if (!bytes.ok()) return std::move(bytes).error();
    coded.files.push_back(std::move(bytes).value());
  }
  return coded;
}

void compose(const BuiltOctree& built, const std::vector<std::string>& pictures,
             const glm::dvec3& offset, nodes::Scene& scene) {
  std::vector<ReferenceImageNode> images;
  for (size_t i = 0; i < pictures.size(); ++i)
    images.push_back({built.model.images[i], pictures[i], kReferenceNearPlane, kReferenceFarPlane});
  const nodes::NodeId transform = add_transform(scene, offset);
  const nodes::NodeId octree =
      add_octree_image(scene, built.model.resolution, built.model.fields, images);
  set_known(scene, transform, "translation", glm::vec3(built.statistics.centre));
  set_known(scene, transform, "scale", glm::vec3(static_cast<float>(built.statistics.side)));
  set_known(scene, transform, "children", std::vector<nodes::NodeId>{octree});
}

void describe(const BuiltOctree& built, const PictureFiles& files, BuiltScene& scene) {
  const BuildStatistics& s = built.statistics;
  const double seen =
      s.exposed == 0 ? 100 : 100.0 * static_cast<double>(s.seen) / static_cast<double>(s.exposed);
  const OctreeFields& fields = built.model.fields;
  scene.lines = {"  voxels: " + grouped(s.voxels) + " at resolution " +
                     std::to_string(built.model.resolution) + ", from " + grouped(s.primitives) +
                     " triangles or points",
                 "  octree: " + counted(fields.octree.size(), "byte") +
                     "; image indices: " + counted(fields.voxel_image_index.size(), "symbol"),
                 "  images: " + std::to_string(files.count()) + ", " +
                     counted(files.bytes(), "byte") + "; they show " + fixed(seen, 1) +
                     " % of the outside, colours at " + fixed(s.psnr, 1) + " dB"};
  scene.json = {{"octreeResolution", built.model.resolution},
                {"primitives", s.primitives},
                {"voxels", s.voxels},
                {"octreeBytes", fields.octree.size()},
                {"voxelImageIndexSymbols", fields.voxel_image_index.size()},
                {"images", files.count()},
                {"imageBytes", files.bytes()},
                {"exposedVoxels", s.exposed},
                {"seenVoxels", s.seen},
                {"psnr", s.psnr},
                {"shaded", s.shaded}};
}

}  // namespace

Result<BuiltScene> build_octree_scene(ModelInput&& model, const BuildJob& job) {
  const auto built = build(std::move(model), job);
  if (!built.ok()) return built.error();
  job.bar.show("coding pictures", 0.98);
  const auto coded = code_pictures(built.value(), job);
  if (!coded.ok()) return coded.error();
  PictureFiles files(job, job.command.jpeg_quality);
  std::vector<std::string> names;
  for (size_t i = 0; i < coded.value().files.size(); ++i) {
    const auto name =
        files.put("_" + built.value().names[i], job.command.image_format, coded.value().files[i]);
    if (!name.ok()) return name.error();
    names.push_back(name.value());
  }
  BuiltScene scene;
  compose(built.value(), names, job.offset, scene.scene);
  describe(built.value(), files, scene);
  if (coded.value().quality == 0) return scene;
  scene.lines.push_back("  JPEG quality " + std::to_string(coded.value().quality) +
                        ": the used pixels at " + fixed(coded.value().psnr, 1) + " dB");
  scene.json["jpegQuality"] = coded.value().quality;
  scene.json["imagePsnr"] = coded.value().psnr;
  return scene;
}

}  // namespace afx::tools

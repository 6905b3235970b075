// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <algorithm>
#include <utility>

#include "afx/builder/depth_image_builder.h"
#include "afx/builder/reference_cameras.h"
#include "afx/depth_image_nodes.h"
#include "tools/build.h"
#include "tools/build_views.h"

namespace afx::tools {
namespace {

/// "_front", "_view07": what the pictures of a view are called.
std::string suffix_of(size_t view, size_t views) {
  if (views == kSideViews) return "_" + reference_name(static_cast<unsigned>(view));
  const std::string number = std::to_string(view + 1);
  return "_view" + std::string(number.size() < 2 ? 1 : 0, '0') + number;
}

Result<PictureUrls> put_pictures(const SimpleTexture& texture, const std::string& suffix,
                                 const BuildCommand& command, PictureFiles& files) {
  if (command.depth_in_alpha) {
    const auto both = files.put(suffix, with_depth_as_alpha(texture), "png", true);
    if (!both.ok()) return both.error();
    return PictureUrls{both.value(), {}};
  }
  const auto colour = files.put(suffix, texture.colour, command.image_format, true);
  if (!colour.ok()) return colour.error();
  const auto depth = files.put(suffix + "_depth", texture.depth, "png", false);
  if (!depth.ok()) return depth.error();
  return PictureUrls{colour.value(), depth.value()};
}

/// Takes the opacity off the colours; gives the number of pixels that lose one.
uint64_t make_opaque(SimpleTexture& texture, ImageCoder coder) {
  Picture& colour = texture.colour;
  if (colour.components != 2 && colour.components != 4) return 0;
  Picture opaque(colour.width, colour.height, colour.components - 1);
  std::vector<bool> used(texture.depth.samples.size());
  uint64_t lost = 0;
  for (size_t i = 0; i < used.size(); ++i) {
    const uint8_t* from = colour.samples.data() + i * colour.components;
    std::copy_n(from, opaque.components, opaque.samples.data() + i * opaque.components);
    used[i] = texture.depth.samples[i] != 0;
    if (used[i] && from[opaque.components] != 255) ++lost;
  }
  fill_unused(opaque, used, coder);
  colour = std::move(opaque);
  return lost;
}

/// Where colours are written without opacity, it is taken off.
void drop_opacity(std::vector<DepthImage>& images, ImageCoder coder, const BuildJob& job) {
  uint64_t lost = 0;
  for (DepthImage& image : images)
    lost += make_opaque(std::get<SimpleTexture>(image.texture), coder);
  if (lost == 0) return;
  job.diagnostics.warn("lost_opacity", Place::none(),
                       counted(lost, "pixel") + (lost == 1 ? " becomes" : " become") + " opaque: " +
                           (job.command.depth_in_alpha ? "the alpha channel has the depth"
                                                       : "JPEG has no alpha channel"));
}

double percent(uint64_t part, uint64_t whole) {
  return whole == 0 ? 100 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void describe(const BuiltDepthImages& built, const PictureFiles& files, BuiltScene& scene) {
  scene.lines.push_back("  views: " + std::to_string(built.images.size()) + ", " +
                        counted(files.bytes(), "byte") + " of pictures; " +
                        fixed(percent(built.used, built.pixels), 1) + " % of " +
                        counted(built.pixels, "pixel") + " show the model");
  scene.json = {{"views", built.images.size()},
                {"pictures", files.count()},
                {"imageBytes", files.bytes()},
                {"pixels", built.pixels},
                {"usedPixels", built.used}};
  if (!built.coverage) return;
  scene.lines.push_back("  coverage: " + fixed(100 * built.coverage->part(), 2) +
                        " % of what can be seen from outside");
  scene.json["coverage"] = built.coverage->part();
}

}  // namespace

Result<BuiltScene> build_depth_scene(ModelInput&& model, const BuildJob& job) {
  const auto views = read_views_option(job);
  if (!views.ok()) return views.error();
  auto looked_at = LookedAt::of(std::move(model), job);
  if (!looked_at.ok()) return std::move(looked_at).error();
  DepthImageOptions options;
  options.resolution = job.command.resolution;
  options.orthographic = !job.command.perspective;
  options.depth_bits = job.command.depth_bits == 0 ? 16 : job.command.depth_bits;
  if (job.command.image_format == "jpeg") options.coder = ImageCoder::jpeg;
  options.views = views.value().count;
  options.shots = views.value().shots;
  options.coverage = job.command.coverage;
  options.progress = [&](const char* stage, double done) { job.bar.show(stage, done); };
  options.limits = job.session.limits;
  auto built = build_depth_images(looked_at.value()->views(), options);
  if (!built.ok()) return built.error();
  if (built.value().used == 0) return nothing_to_see();
  auto& images = built.value().images;
  if (job.command.depth_in_alpha || options.coder == ImageCoder::jpeg)
    drop_opacity(images, options.coder, job);
  BuiltScene scene;
  PictureFiles files(job, job.command.jpeg_quality);
  const nodes::NodeId transform = add_transform(scene.scene, job.offset);
  for (size_t i = 0; i < images.size(); ++i) {
    job.bar.show("writing pictures", static_cast<double>(i) / static_cast<double>(images.size()));
    const auto urls = put_pictures(std::get<SimpleTexture>(images[i].texture),
                                   suffix_of(i, images.size()), job.command, files);
    if (!urls.ok()) return urls.error();
    const nodes::NodeId node = add_depth_image(scene.scene, images[i].camera, urls.value());
    (void)scene.scene.append(transform, "children", node);  // known to be right
  }
  describe(built.value(), files, scene);
  return scene;
}

}  // namespace afx::tools

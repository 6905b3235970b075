// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/model_compare.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "afx/builder/cloud_compare.h"
#include "afx/builder/point_surfels.h"
#include "afx/builder/shading.h"
#include "afx/builder/surface_samples.h"
#include "afx/picture_compare.h"
#include "afx/psnr.h"
#include "afx/surfel_sources.h"
#include "afx/voxel_shading.h"
#include "render/view_ring.h"
#include "tools/drawing.h"
#include "tools/model_input.h"
#include "tools/model_sizes.h"

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

/// The points of a mesh have the light on them that a model built from it has.
Result<PointCloud> points_of_mesh(const Mesh& mesh, const ModelCompareOptions& options,
                                  const Session& session) {
  auto cloud = sample_surface(
      mesh,
      {.points = options.points, .threads = session.options.threads, .limits = session.limits});
  if (!cloud.ok() || !is_to_be_shaded(colouring_of(mesh), shade_of(options.shade))) return cloud;
  PointCloud& points = cloud.value();
  const bool coloured = !points.colours.empty();
  points.colours.resize(points.positions.size());
  for (size_t i = 0; i < points.positions.size(); ++i)
    points.colours[i] = lit(coloured, points.colours[i], points.normals[i]);
  return cloud;
}

Result<PointCloud> points_of_model(const ModelInput& model, const ModelCompareOptions& options,
                                   const Session& session, Diagnostics& diagnostics) {
  if (const auto* mesh = std::get_if<Mesh>(&model)) return points_of_mesh(*mesh, options, session);
  if (const auto* cloud = std::get_if<PointCloud>(&model)) return *cloud;
  if (const auto* surfels = std::get_if<Surfels>(&model)) return points_of(*surfels);
  const auto surfels = surfels_of(std::get<std::vector<DibrModel>>(model), session.options.threads,
                                  session.limits, diagnostics);
  if (!surfels.ok()) return surfels.error();
  return points_of(surfels.value());
}

/// dB as JSON has it: nothing where it is infinite.
Json decibels(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
std::string decibel_text(double value) {
  return std::isfinite(value) ? fixed(value, 2) + " dB" : "equal";
}

void tell_points(const CloudDifference& d, size_t a, size_t b, ModelDistance& distance) {
  const auto part = [&d](double mean_squared) { return std::sqrt(mean_squared) / d.peak; };
  Json& json = distance.json;
  json["pointsA"] = a;
  json["pointsB"] = b;
  json["peak"] = d.peak;
  json["d1"] = part(d.both.to_point.mean_squared);
  json["d1Psnr"] = decibels(d.both.to_point.psnr);
  json["d1AToB"] = part(d.a_to_b.to_point.mean_squared);
  json["d1BToA"] = part(d.b_to_a.to_point.mean_squared);
  json["d2"] = part(d.both.to_plane.mean_squared);
  json["d2Psnr"] = decibels(d.both.to_plane.psnr);
  json["hausdorff"] = d.both.to_point.largest / d.peak;
  const auto percent = [](const Json& of) { return fixed(100 * of.get<double>(), 4) + " %"; };
  distance.lines.push_back("points: D1 " + percent(json["d1"]) + " of the longest side (" +
                           decibel_text(d.both.to_point.psnr) + "), D2 " + percent(json["d2"]) +
                           " (" + decibel_text(d.both.to_plane.psnr) + "), largest " +
                           percent(json["hausdorff"]) + "; of " + grouped(a) + " and " +
                           grouped(b) + " points");
  if (!d.has_colours) return;
  const glm::dvec3 squared = d.both.rgb.mean_squared;
  const double mean = (squared.x + squared.y + squared.z) / 3;
  const double colour = psnr_of(mean);
  json["colour"] = decibels(colour);
  json["colourY"] = decibels(d.both.ycbcr.psnr.x);
  distance.lines.push_back("colours of matching points: " + decibel_text(colour) + ", luma " +
                           decibel_text(d.both.ycbcr.psnr.x));
}

/// Over mid grey: RGB.
Picture over_grey(const Picture& rgba) {
  Picture rgb(rgba.width, rgba.height, 3);
  for (size_t i = 0; i < size_t{rgba.width} * rgba.height; ++i) {
    const uint8_t* from = rgba.samples.data() + i * 4;
    for (size_t k = 0; k < 3; ++k)
      rgb.samples[i * 3 + k] =
          static_cast<uint8_t>((from[k] * from[3] + 128U * (255U - from[3]) + 127U) / 255U);
  }
  return rgb;
}

/// Sums over the pixels where either picture shows something.
struct PictureSum {
  double squared = 0;
  uint64_t samples = 0;
  double ssim = 0;
  unsigned views = 0;

  Status add(const Picture& a, const Picture& b) {
    const Picture x = over_grey(a), y = over_grey(b);
    for (size_t i = 0; i < size_t{a.width} * a.height; ++i) {
      if (a.samples[i * 4 + 3] == 0 && b.samples[i * 4 + 3] == 0) continue;
      for (size_t k = 0; k < 3; ++k) {
        const double d = x.samples[i * 3 + k] - y.samples[i * 3 + k];
        squared += d * d;
      }
      samples += 3;
    }
    const auto difference = compare_pictures(x, y);
    if (!difference.ok()) return difference.error();
    ssim += difference.value().ssim;
    ++views;
    return {};
  }
};

Status compare_views(const Drawing& a, const Drawing& b, const ModelCompareOptions& options,
                     const Session& session, ModelDistance& distance) {
  render::RenderOptions how;
  how.width = how.height = options.size;
  how.threads = session.options.threads;
  PictureSum sum;
  const std::vector<glm::dvec3> outline = a.outline();
  for (const render::View& view : render::view_ring(options.views)) {
    const auto camera = render::fit_camera(outline, view, 1);
    if (!camera.ok()) return camera.error();
    const auto first = a.draw(camera.value(), how);
    if (!first.ok()) return first.error();
    const auto second = b.draw(camera.value(), how);
    if (!second.ok()) return second.error();
    if (Status added = sum.add(first.value().picture, second.value().picture); !added.ok())
      return added;
  }
  const double mean = sum.samples == 0 ? 0 : sum.squared / static_cast<double>(sum.samples);
  const double all = psnr_of(mean);
  distance.json["views"] = sum.views;
  distance.json["psnr"] = decibels(all);
  distance.json["ssim"] = sum.ssim / sum.views;
  distance.lines.push_back("pictures from " + counted(sum.views, "side") + ": " +
                           decibel_text(all) + ", SSIM " + fixed(sum.ssim / sum.views, 4));
  return {};
}

}  // namespace

Result<ModelDistance> compare_models(const Input& a, const Input& b,
                                     const ModelCompareOptions& options, OctreeQuery& query,
                                     const Session& session, Diagnostics (&diagnostics)[2]) {
  const Input* inputs[] = {&a, &b};
  std::vector<PointCloud> clouds;
  Diagnostics unheard;  // taking the points has said it all
  Drawing drawings[] = {Drawing(session, unheard), Drawing(session, unheard)};
  for (size_t i = 0; i < 2; ++i) {
    auto model = read_model_input(*inputs[i], query, session, diagnostics[i]);
    if (!model.ok()) return std::move(model).error();
    auto cloud = points_of_model(model.value(), options, session, diagnostics[i]);
    if (!cloud.ok()) return in_file(std::move(cloud).error(), inputs[i]->path);
    clouds.push_back(std::move(cloud).value());
    if (options.views == 0) continue;
    const Status added = drawings[i].add(std::move(model).value(), shade_of(options.shade));
    if (!added.ok()) return in_file(added.error(), inputs[i]->path);
  }
  const auto difference =
      compare_clouds(clouds[0], clouds[1],
                     {.peak = 0, .threads = session.options.threads, .limits = session.limits});
  if (!difference.ok()) return difference.error();
  ModelDistance distance;
  for (size_t i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "A" : "B";
    const Json sizes = model_sizes(*inputs[i], session);
    distance.json["size" + name] = sizes;
    distance.lines.push_back(name + ": " + size_text(sizes));
  }
  tell_points(difference.value(), clouds[0].positions.size(), clouds[1].positions.size(), distance);
  if (options.views == 0) return distance;
  const Status compared = compare_views(drawings[0], drawings[1], options, session, distance);
  if (!compared.ok()) return compared.error();
  return distance;
}

}  // namespace afx::tools

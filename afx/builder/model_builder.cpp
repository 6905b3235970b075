// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/model_builder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

#include "afx/builder/exposure.h"
#include "afx/builder/image_candidates.h"
#include "afx/builder/image_fill.h"
#include "afx/builder/index_choice.h"
#include "afx/builder/reference_views.h"
#include "afx/builder/view_choice.h"
#include "afx/octree_stream.h"
#include "afx/psnr.h"
#include "codec/octree_voxels.h"
#include "codec/parallel.h"

namespace afx {
namespace {

// Each thread has pictures of its own, of up to 3 size^2 pixels of this many bytes.
constexpr uint64_t kDrawingBytes = 27;
constexpr unsigned most_threads(uint32_t size) { return size <= 1024 ? 4 : 2; }

// A voxel is off where a component is wrong by more.
constexpr uint32_t kOff = 16;

// A decibel is worth the same everywhere, so the squared difference that a symbol of the index may
// cost grows with the mean that there is anyhow: this much times that of the best images, or of
// what the voxels are then found to have, within bounds. Measured: up to 0.2 dB are lost; JPEG of
// quality 90, whose own error is some 7 at each voxel, asks for the greatest.
constexpr double kPriceOfBest = 2;
constexpr double kPriceOfShown = 3;
constexpr double kLeastPrice = 0.25;

// Views are tried that show this part of the exposed voxels anew.
constexpr double kLeastGain = 1.0 / 500;

uint32_t worst_component(const uint8_t* shown, Rgba8 own) {
  return static_cast<uint32_t>(std::max(
      {std::abs(shown[0] - own.r), std::abs(shown[1] - own.g), std::abs(shown[2] - own.b)}));
}

// Of a mean squared difference of three components, in dB.
double capped_psnr(double squared) { return std::min(99.0, psnr_of(squared / 3)); }

Error beyond_limit(const std::string& what, uint64_t bytes, const Limits& limits) {
  return {Errc::limit_exceeded, Place::none(),
          what + " takes " + std::to_string(bytes) + " bytes (expected at most " +
              std::to_string(limits.memory) + ")"};
}

class ModelBuilder {
 public:
  ModelBuilder(SurfaceVoxels voxels, unsigned levels, uint32_t resolution,
               const BuildOptions& options)
      : voxels_(std::move(voxels)), levels_(levels), options_(options) {
    size_ = options.image_size != 0 ? options.image_size : 1U << levels;
    threads_ = std::min(thread_count(options.threads), most_threads(size_));
    built_.model.resolution = resolution;
  }

  Result<BuiltOctree> build() {
    if (Status fits = check_memory(); !fits.ok()) return fits.error();
    coordinates_.reserve(voxels_.codes.size());
    for (const uint64_t code : voxels_.codes) coordinates_.push_back(codec::morton_decode(code));
    exposed_ = exposed_voxels(coordinates_, levels_, options_.threads);
    report("choosing views", 0.68);
    choose_views();
    if (Status fits = fit_threads(); !fits.ok()) return fits.error();
    report("drawing images", 0.74);
    const JudgedVoxels judged{coordinates_, voxels_.colours, voxels_.normals, exposed_, levels_};
    parallel_for(candidates_.size(), threads_, [&](size_t k) { weigh(candidates_[k], judged); });
    report("choosing images", 0.85);
    if (options_.images == 0) drop_dear_images(candidates_, exposed_);
    least_difference_ = least_difference(candidates_, exposed_);
    if (Status drawn = choose_and_draw(); !drawn.ok()) return drawn.error();
    name_images();
    report("octree", 0.98);
    OctreeFields& fields = built_.model.fields;
    fields.octree = codec::octree_from_morton(voxels_.codes, levels_);
    fields.voxel_image_index = codec::octree_image_index(fields.octree, levels_, choice_);
    take_statistics();
    report("octree", 1);
    return std::move(built_);
  }

 private:
  void report(const char* stage, double done) {
    if (options_.progress) options_.progress(stage, done);
  }

  void choose_views() {
    for (unsigned view = 0; view < kSideViews; ++view)
      candidates_.push_back({view, side_camera(view, size_)});
    const ViewChoice choice{most_images() - kSideViews, options_.images == 0 ? kLeastGain : 0,
                            options_.threads};
    for (const glm::dvec3& direction : choose_directions(voxels_.codes, levels_, choice)) {
      const auto view = static_cast<unsigned>(candidates_.size());
      candidates_.push_back({view, slanting_camera(direction, size_)});
    }
  }

  // What all voxels have for one image.
  [[nodiscard]] uint64_t candidate_bytes() const {
    return voxels_.codes.size() * kCandidateBytes + 1;
  }

  [[nodiscard]] Status check_memory() const {
    const uint64_t least = 2 * kSideViews * candidate_bytes();
    if (least <= options_.limits.memory) return {};
    return beyond_limit("to choose from six images", least, options_.limits);
  }

  // Fewer threads where their pictures would take more memory than there may be.
  Status fit_threads() {
    uint64_t largest = 0;
    for (const ImageCandidate& candidate : candidates_)
      largest = std::max(largest, uint64_t{candidate.camera.width} * candidate.camera.height);
    const uint64_t fit = options_.limits.memory / (largest * kDrawingBytes);
    if (fit == 0)
      return beyond_limit("to draw an image of " + std::to_string(largest) + " pixels",
                          largest * kDrawingBytes, options_.limits);
    threads_ = static_cast<unsigned>(std::min<uint64_t>(threads_, fit));
    return {};
  }

  // As many as there is memory for: what each voxel has for each image may take half of it.
  [[nodiscard]] unsigned most_images() const {
    const uint64_t fit = options_.limits.memory / 2 / candidate_bytes();
    const unsigned wanted = options_.images == 0 ? kMaxStreamTextures : options_.images;
    return static_cast<unsigned>(std::clamp<uint64_t>(fit, kSideViews, wanted));
  }

  // What the images then show may ask for a lower price.
  Status choose_and_draw() {
    const double price =
        options_.symbol_price.value_or(in_bounds(kPriceOfBest * least_difference_));
    choose_images(price);
    report("drawing images", 0.91);
    if (Status drawn = draw_images(); !drawn.ok()) return drawn;
    const double lower = in_bounds(kPriceOfShown * shown_.squared);
    if (options_.symbol_price || lower >= price) return {};
    choose_images(lower);
    report("drawing images", 0.95);
    return draw_images();
  }

  static double in_bounds(double price) { return std::clamp(price, kLeastPrice, kSymbolPrice); }

  // Images that no exposed voxel takes go, and the hidden ones that took them choose again.
  void choose_images(double price) {
    for (size_t before = 0; before != candidates_.size();) {
      before = candidates_.size();
      choice_ = choose_index(
          voxels_.codes, levels_, static_cast<unsigned>(candidates_.size()),
          [this](size_t i, std::span<double> costs) {
            for (size_t k = 0; k < costs.size(); ++k) costs[k] = candidates_[k].cost(i);
          },
          price);
      const std::vector<uint64_t> users = count_users();
      size_t k = 0;
      std::erase_if(candidates_, [&](const ImageCandidate&) { return users[k++] == 0; });
    }
  }

  // How many exposed voxels take each image.
  [[nodiscard]] std::vector<uint64_t> count_users() const {
    std::vector<uint64_t> users(candidates_.size());
    for (size_t i = 0; i < choice_.size(); ++i) users[choice_[i] - 1U] += exposed_[i];
    return users;
  }

  // Those from elsewhere than the sides are numbered without gaps.
  void name_images() {
    unsigned next = kSideViews;
    for (const ImageCandidate& candidate : candidates_)
      built_.names.push_back(reference_name(candidate.view < kSideViews ? candidate.view : next++));
  }

  Status draw_images() {
    std::vector<ReferenceCamera> cameras(candidates_.size());
    parallel_for(cameras.size(), threads_, [&](size_t k) { cameras[k] = cropped_to_use(k); });
    uint64_t bytes = 0;
    for (const ReferenceCamera& camera : cameras)
      bytes += 3 * uint64_t{camera.width} * camera.height;
    if (bytes > options_.limits.memory)
      return beyond_limit("a set of " + std::to_string(cameras.size()) + " images", bytes,
                          options_.limits);
    built_.model.images.resize(cameras.size());
    built_.used.resize(cameras.size());
    parallel_for(cameras.size(), threads_, [&](size_t k) { draw_image(k, cameras[k]); });
    look_at_images();
    return {};
  }

  // The camera of an image, its picture no larger than the voxels that take it ask for.
  [[nodiscard]] ReferenceCamera cropped_to_use(size_t k) const {
    const ReferenceCamera& camera = candidates_[k].camera;
    const ReferenceView view(camera, levels_);
    uint32_t left = camera.width, top = camera.height, right = 0, bottom = 0;
    for (size_t i = 0; i < choice_.size(); ++i) {
      if (choice_[i] != k + 1) continue;
      const auto [x, y] = view.pixel(coordinates_[i]);
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
    return cropped(camera, left, top, right - left + 1, bottom - top + 1);
  }

  // Each pixel has the colour of the voxels that take it. What it shows of others is free, too:
  // keeping that takes JPEG 45 to 90 % more bytes at the same PSNR, and coarser levels of the
  // octree, which may look there, gain 1 dB at most or lose.
  void draw_image(size_t k, const ReferenceCamera& camera) {
    const ReferenceView view(camera, levels_);
    const std::vector<bool>& seen = candidates_[k].seen;
    Picture picture(camera.width, camera.height, 3);
    std::vector<bool> used(view.pixels());
    const auto takes = [&](size_t i) { return choice_[i] == k + 1 && exposed_[i] != 0; };
    draw_voxels(
        view, coordinates_, voxels_.colours, [&](size_t i) { return takes(i) && seen[i]; }, picture,
        used);
    std::vector<bool> drawn = used;
    const auto is_free = [&](size_t i) { return !drawn[view.place(view.pixel(coordinates_[i]))]; };
    draw_voxels(
        view, coordinates_, voxels_.colours,
        [&](size_t i) { return takes(i) && !seen[i] && is_free(i); }, picture, used);
    fill_unused(picture, used, options_.coder);
    ReferenceImage& image = built_.model.images[k];
    image = camera.image;
    image.picture = std::move(picture);
    built_.used[k] = std::move(used);
  }

  // Compares what the exposed voxels have with their own colours.
  void look_at_images() {
    std::vector<ReferenceView> views;
    for (const ReferenceImage& image : built_.model.images)
      views.emplace_back(ReferenceCamera{image, image.picture.width, image.picture.height},
                         levels_);
    shown_ = {};
    for (size_t i = 0; i < choice_.size(); ++i) {
      if (exposed_[i] == 0) continue;
      const unsigned k = choice_[i] - 1U;
      const auto [x, y] = views[k].pixel(coordinates_[i]);
      const uint8_t* pixel = built_.model.images[k].picture.pixel(x, y);
      shown_.squared += squared_difference(pixel, voxels_.colours[i]);
      const uint32_t worst = worst_component(pixel, voxels_.colours[i]);
      shown_.worst = std::max(shown_.worst, worst);
      if (worst > kOff) ++shown_.off;
    }
    shown_.squared /= static_cast<double>(std::count(exposed_.begin(), exposed_.end(), 1));
  }

  void take_statistics() {
    BuildStatistics& statistics = built_.statistics;
    statistics.voxels = voxels_.codes.size();
    statistics.index_symbols = built_.model.fields.voxel_image_index.size();
    for (const std::vector<bool>& used : built_.used) {
      statistics.pixels += used.size();
      statistics.used_pixels += static_cast<uint64_t>(std::count(used.begin(), used.end(), true));
    }
    for (size_t i = 0; i < coordinates_.size(); ++i) {
      if (exposed_[i] == 0) continue;
      ++statistics.exposed;
      if (std::any_of(candidates_.begin(), candidates_.end(),
                      [i](const ImageCandidate& c) { return c.seen[i]; }))
        ++statistics.seen;
    }
    statistics.worst = shown_.worst;
    statistics.off = shown_.off;
    statistics.psnr = capped_psnr(shown_.squared);
    statistics.best_psnr = capped_psnr(least_difference_);
  }

  SurfaceVoxels voxels_;
  unsigned levels_;
  const BuildOptions& options_;
  uint32_t size_;
  unsigned threads_;
  std::vector<Voxel> coordinates_;
  std::vector<uint8_t> exposed_;
  std::vector<ImageCandidate> candidates_;
  double least_difference_ = 0;
  struct {
    double squared = 0;  // the mean difference
    uint32_t worst = 0;
    uint64_t off = 0;
  } shown_;
  std::vector<uint8_t> choice_;
  BuiltOctree built_;
};

}  // namespace

Result<BuiltOctree> build_model(SurfaceVoxels voxels, unsigned levels, uint32_t resolution,
                                const BuildOptions& options) {
  return ModelBuilder(std::move(voxels), levels, resolution, options).build();
}

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/depth_image_builder.h"

#include <algorithm>
#include <string>
#include <utility>

namespace afx {
namespace {

Error refused(const std::string& text) { return {Errc::bad_argument, Place::none(), text}; }

Status check_options(const DepthImageOptions& options) {
  if (options.resolution < 1 || options.resolution > kMaxPictureResolution)
    return refused("the resolution is " + std::to_string(options.resolution) +
                   " (expected 1 to 16384)");
  if (options.views > kMostViews || options.shots.size() > kMostViews)
    return refused("there are " +
                   std::to_string(std::max<size_t>(options.views, options.shots.size())) +
                   " views (expected at most 255)");
  return {};
}

Status check_memory(const std::vector<Shot>& shots, const Limits& limits) {
  constexpr uint64_t kPixelBytes = 5;  // colour and depth
  uint64_t bytes = 0;
  for (const Shot& shot : shots)
    bytes += std::min(uint64_t{shot.width} * shot.height, uint64_t{1} << 50) * kPixelBytes;
  if (bytes <= limits.memory) return {};
  return Error{Errc::limit_exceeded, Place::none(),
               "the pictures of " + std::to_string(shots.size()) + " views take " +
                   std::to_string(bytes) + " bytes (expected at most " +
                   std::to_string(limits.memory) + ")"};
}

class DepthImageBuilder {
 public:
  DepthImageBuilder(const ViewSource& source, const DepthImageOptions& options)
      : source_(source), options_(options) {}

  Result<BuiltDepthImages> build() {
    const bool measured = options_.coverage || (options_.views == 0 && options_.shots.empty());
    if (measured) {
      auto meter = CoverageMeter::of(source_, [this](double d) { report("looking", 0.5 * d); });
      if (!meter.ok()) return std::move(meter).error();
      meter_ = std::move(meter).value();
    }
    const std::vector<Shot> shots = views();
    if (Status fits = check_memory(shots, options_.limits); !fits.ok()) return fits.error();
    const double before = measured ? 0.5 : 0;
    for (const Shot& shot : shots) {
      report("drawing pictures", before + (1 - before) * static_cast<double>(built_.images.size()) /
                                              static_cast<double>(shots.size()));
      auto image = source_.take(shot, options_.depth_bits);
      if (!image.ok()) return std::move(image).error();
      finish(std::get<SimpleTexture>(image.value().texture));
      built_.images.push_back(std::move(image).value());
    }
    if (!meter_) return std::move(built_);
    const auto coverage = meter_->measure(shots);
    if (!coverage.ok()) return coverage.error();
    built_.coverage = coverage.value();
    return std::move(built_);
  }

 private:
  void report(const char* stage, double done) const {
    if (options_.progress) options_.progress(stage, done);
  }

  [[nodiscard]] std::vector<Shot> views() const {
    if (!options_.shots.empty()) return options_.shots;
    std::vector<Shot> shots;
    for (const glm::dvec3& direction :
         options_.views == 0 ? meter_->choose() : even_directions(options_.views))
      shots.push_back(view_from(source_, direction, {options_.resolution, options_.orthographic}));
    return shots;
  }

  // Pixels that see nothing get colours that cost little; with alpha, that says what is not seen.
  void finish(SimpleTexture& texture) {
    const std::vector<uint16_t>& depths = texture.depth.samples;
    std::vector<bool> used(depths.size());
    for (size_t i = 0; i < depths.size(); ++i) used[i] = depths[i] != 0;
    built_.pixels += used.size();
    built_.used += static_cast<uint64_t>(std::count(used.begin(), used.end(), true));
    if (texture.colour.components == 3) fill_unused(texture.colour, used, options_.coder);
  }

  const ViewSource& source_;
  const DepthImageOptions& options_;
  std::optional<CoverageMeter> meter_;
  BuiltDepthImages built_;
};

}  // namespace

Result<BuiltDepthImages> build_depth_images(const ViewSource& source,
                                            const DepthImageOptions& options) {
  if (Status right = check_options(options); !right.ok()) return right.error();
  return DepthImageBuilder(source, options).build();
}

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/rgbd_reader.h"

#include <algorithm>
#include <cmath>

#include "afx/builder/rgbd_description.h"
#include "afx/builder/rgbd_frame.h"
#include "afx/file.h"
#include "afx/picture_io.h"
#include "afx/pixel_pieces.h"
#include "afx/surfel_sources.h"

namespace afx {
namespace {

/// Reads what a file describes.
class RgbdReader {
 public:
  RgbdReader(const std::string& path, unsigned threads, const Limits& limits,
             Diagnostics& diagnostics)
      : path_(path), threads_(threads), limits_(limits), diagnostics_(diagnostics) {}

  Result<Surfels> read() {
    const auto file = MappedFile::open(path_, limits_);
    if (!file.ok()) return file.error();
    const auto frames = read_rgbd_description(file.value().bytes(), limits_, diagnostics_);
    if (!frames.ok()) {
      Error error = frames.error();
      error.file = path_;
      return error;
    }
    Surfels all;
    for (const RgbdDescription& frame : frames.value())
      if (Status status = add_frame(frame, all); !status.ok()) return status.error();
    if (empty_ > 0)
      diagnostics_.warn("empty_frame", Place::none(),
                        std::to_string(empty_) + " of " + std::to_string(frames.value().size()) +
                            " frames have no valid depth");
    return all;
  }

 private:
  [[nodiscard]] Error bad(const std::string& text) const {
    return {Errc::bad_argument, Place::none(), text, {}, path_};
  }

  Status add_frame(const RgbdDescription& d, Surfels& all) {
    RgbdFrame frame = d.frame;
    if (Status s = read_depth(d, frame); !s.ok()) return s;
    if (Status s = cut_background(d, frame); !s.ok()) return s;
    const bool empty = std::all_of(frame.distances.begin(), frame.distances.end(),
                                   [](float distance) { return distance == 0; });
    if (empty) {
      ++empty_;
      return {};
    }
    drop_flying_pixels(frame);
    auto colour = read_named<Picture>(d.colour, decode_picture);
    if (!colour.ok()) return colour.error();
    frame.colour = without_alpha(std::move(colour).value());
    const auto surfels = surfels_of(frame, threads_, limits_);
    if (!surfels.ok()) return surfels.error();
    if (Status s = check_surfel_memory(uint64_t{all.size()} + surfels.value().size(), limits_);
        !s.ok())
      return s;
    if (!are_near_enough(surfels.value())) return bad(d.pose + " moves points beyond 1e37");
    append(surfels.value(), glm::dmat4(1), all);
    return {};
  }

  /// Reads a picture that a member names.
  template <class P, class Decode>
  [[nodiscard]] Result<P> read_named(const RgbdName& of, Decode&& decode) const {
    const std::string path = of.name.front() == '/' ? of.name : folder_of(path_) + "/" + of.name;
    const auto tell = [&](Error error) {
      error.file = path;
      error.text += " (" + of.member + " of " + path_ + ")";
      return error;
    };
    const auto file = MappedFile::open_regular(path, limits_);
    if (!file.ok()) return tell(file.error());
    Result<P> picture = decode(file.value().bytes(), path, limits_);
    return picture.ok() ? std::move(picture) : Result<P>(tell(picture.error()));
  }

  Status read_depth(const RgbdDescription& d, RgbdFrame& frame) const {
    bool integers = true;
    const auto decode = [&](std::span<const uint8_t> bytes, const std::string& name,
                            const Limits& limits) -> Result<FloatPicture> {
      const auto deep = decode_deep_picture(bytes, name, limits);
      if (deep.ok()) {
        const DeepPicture& p = deep.value();
        return FloatPicture{p.width, p.height, p.components, {p.samples.begin(), p.samples.end()}};
      }
      integers = false;
      if (deep.error().code != Errc::unsupported) return deep.error();
      return decode_float_picture(bytes, name, limits);
    };
    const auto picture = read_named<FloatPicture>(d.depth, decode);
    if (!picture.ok()) return picture.error();
    const FloatPicture& depth = picture.value();
    if (depth.components > 2)
      return bad(d.depth.member + " has " + std::to_string(depth.components) +
                 " components (expected one of depth)");
    if (integers && d.depth_scale.value == 0)
      return bad(d.depth_scale.member + " is missing (" + d.depth.name + " has integers)");
    if (Status s = check_size(d.width, depth.width, d.depth); !s.ok()) return s;
    if (Status s = check_size(d.height, depth.height, d.depth); !s.ok()) return s;
    frame.width = depth.width;
    frame.height = depth.height;
    frame.step = integers ? d.depth_scale.value : 0;
    const double unit = integers ? d.depth_scale.value : 1;
    frame.distances.resize(size_t{depth.width} * depth.height);
    for (size_t n = 0; n < frame.distances.size(); ++n) {
      const double distance = unit * static_cast<double>(depth.samples[n * depth.components]);
      const bool valid = std::isfinite(distance) && distance > 0 && distance < 1e37 &&
                         distance >= d.near && distance <= d.far;
      frame.distances[n] = valid ? static_cast<float>(distance) : 0.0F;
    }
    return {};
  }

  [[nodiscard]] Status check_size(const RgbdNumber& told, uint32_t is,
                                  const RgbdName& depth) const {
    if (told.value == 0 || told.value == is) return {};
    return bad(told.member + " is " + rgbd_text(told.value) + " (" + depth.name + " has " +
               std::to_string(is) + ")");
  }

  Status cut_background(const RgbdDescription& d, RgbdFrame& frame) const {
    if (d.mask.name.empty()) return {};
    const auto picture = read_named<Picture>(d.mask, decode_picture);
    if (!picture.ok()) return picture.error();
    const Picture& mask = picture.value();
    for (uint32_t y = 0; y < frame.height; ++y)
      for (uint32_t x = 0; x < frame.width; ++x) {
        const auto place = [](uint32_t at, uint32_t of, uint32_t size) {
          return static_cast<uint32_t>((2 * uint64_t{at} + 1) * size / (2 * uint64_t{of}));
        };
        const Rgba8 seen =
            colour_at(mask, place(x, frame.width, mask.width), place(y, frame.height, mask.height));
        if (seen.r == 0 && seen.g == 0 && seen.b == 0)
          frame.distances[size_t{y} * frame.width + x] = 0;
      }
    return {};
  }

  static Picture without_alpha(Picture picture) {
    if (picture.components % 2 != 0) return picture;
    Picture plain(picture.width, picture.height, picture.components - 1);
    const size_t n = plain.components;
    for (size_t at = 0; at < plain.samples.size(); ++at)
      plain.samples[at] = picture.samples[at / n * (n + 1) + at % n];
    return plain;
  }

  const std::string& path_;
  unsigned threads_;
  const Limits& limits_;
  Diagnostics& diagnostics_;
  uint64_t empty_ = 0;
};

}  // namespace

Result<Surfels> read_rgbd(const std::string& path, unsigned threads, const Limits& limits,
                          Diagnostics& diagnostics) {
  return RgbdReader(path, threads, limits, diagnostics).read();
}

}  // namespace afx

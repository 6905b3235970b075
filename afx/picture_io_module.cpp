// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The module afx_pictures.so: pictures by OpenImageIO. Everything that throws stays in here.
#include "afx/picture_io_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "afx/srgb.h"

namespace {

struct Failure {
  int code;
  std::string text;
};

int fail(afx_picture_error* error, int code, const std::string& text) {
  error->code = code;
  // One line, without the full stops and line ends of the library's messages.
  std::string line;
  for (const char c : text) line += c == '\n' || c == '\r' ? ' ' : c;
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  std::snprintf(error->text, sizeof error->text, "%s", line.c_str());
  return code;
}

// Runs `work`, which throws Failure or whatever the library throws.
template <class Work>
int guarded(afx_picture_error* error, Work&& work) {
  error->code = 0;
  error->text[0] = 0;
  try {
    work();
    return 0;
  } catch (const Failure& failure) {
    return fail(error, failure.code, failure.text);
  } catch (const std::bad_alloc&) {
    return fail(error, kAfxPictureNoMemory, "the picture does not fit into memory");
  } catch (const std::exception& thrown) {
    return fail(error, kAfxPictureMalformed, thrown.what());
  } catch (...) {
    return fail(error, kAfxPictureMalformed, "the picture reader failed");
  }
}

std::string or_default(const std::string& message, const char* otherwise) {
  return message.empty() ? otherwise : message;
}

// An open input on bytes in memory. The members' order matters: the input goes before its bytes.
struct Input {
  OIIO::Filesystem::IOMemReader bytes;
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;

  explicit Input(const afx_picture_read_request& request)
      : bytes(const_cast<void*>(request.bytes), request.size) {  // an old interface; it only reads
    const std::string name = std::string("memory.") + request.format;
    input = OIIO::ImageInput::create(request.format);
    if (!input || !input->supports("ioproxy"))
      throw Failure{kAfxPictureUnsupported,
                    or_default(OIIO::geterror(), "the picture format cannot be read from memory")};
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    input->set_ioproxy(&bytes);
    if (!input->open(name, spec, config))
      throw Failure{kAfxPictureMalformed,
                    or_default(input->geterror(), "the picture cannot be opened")};
  }
};

// The kind of samples that is handed over; whether the stored ones are of it, as asked.
OIIO::TypeDesc sample_type(const afx_picture_read_request& request, const OIIO::ImageSpec& spec) {
  if (request.samples == kAfxSamplesShown) return OIIO::TypeDesc::UINT8;
  if (request.samples == kAfxSamplesFloat) {
    if (spec.format.is_floating_point()) return OIIO::TypeDesc::FLOAT;
    throw Failure{kAfxPictureUnsupported, "samples are integers (expected floating point)"};
  }
  if (spec.format == OIIO::TypeDesc::UINT8) return OIIO::TypeDesc::UINT8;
  if (spec.format == OIIO::TypeDesc::UINT16) return OIIO::TypeDesc::UINT16;
  throw Failure{kAfxPictureUnsupported, "samples are neither 8 nor 16 bit integers"};
}

// Whether 8 bits cannot take over the samples as they are.
bool is_linear(const OIIO::ImageSpec& spec) {
  return spec.format != OIIO::TypeDesc::UINT8 && spec.format != OIIO::TypeDesc::UINT16;
}

void check_size(const afx_picture_read_request& request, const OIIO::ImageSpec& spec,
                uint64_t sample_bytes) {
  if (spec.width <= 0 || spec.height <= 0 || spec.depth > 1 || spec.nchannels <= 0)
    throw Failure{kAfxPictureMalformed, "the picture has no pixels, or is a volume"};
  const uint64_t pixels = static_cast<uint64_t>(spec.width) * static_cast<uint64_t>(spec.height);
  const auto channels = static_cast<uint64_t>(std::min(spec.nchannels, 4));
  if (pixels > request.max_pixels || pixels > request.max_bytes / (channels * sample_bytes))
    throw Failure{kAfxPictureLimit, "the picture has " + std::to_string(spec.width) + " x " +
                                        std::to_string(spec.height) +
                                        " pixels (more than the limit)"};
}

void read_pixels(Input& in, int channels, OIIO::TypeDesc type, void* to) {
  const bool read = in.input->read_image(0, 0, 0, channels, type, to);
  // A truncated JPEG reads "well" and leaves only a message.
  const std::string message = in.input->geterror();
  if (!read || !message.empty())
    throw Failure{kAfxPictureMalformed,
                  or_default(message, "the picture's samples cannot be read")};
}

// Floating point holds linear light; alpha is linear in both.
void read_linear(Input& in, int channels, uint8_t* to) {
  const size_t pixels = static_cast<size_t>(in.spec.width) * static_cast<size_t>(in.spec.height);
  const auto n = static_cast<size_t>(channels);
  const bool has_alpha = n % 2 == 0;
  const bool premultiplied = has_alpha && std::strcmp(in.input->format_name(), "openexr") == 0;
  std::vector<float> samples(pixels * n);
  read_pixels(in, channels, OIIO::TypeDesc::FLOAT, samples.data());
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    const float* from = &samples[pixel * n];
    const float alpha = has_alpha ? from[n - 1] : 1;
    const float share = premultiplied && alpha > 0 ? alpha : 1;
    uint8_t* out = to + pixel * n;
    for (size_t k = 0; k < n; ++k) out[k] = afx::linear_to_srgb(from[k] / share);
    if (has_alpha)
      out[n - 1] = static_cast<uint8_t>(std::lround(std::clamp(alpha, 0.0F, 1.0F) * 255.0F));
  }
}

void read_picture(const afx_picture_read_request& request, afx_picture_allocate allocate,
                  void* user) {
  Input in(request);
  const OIIO::TypeDesc type = sample_type(request, in.spec);
  const bool to_srgb = request.samples == kAfxSamplesShown && is_linear(in.spec);
  check_size(request, in.spec, to_srgb ? sizeof(float) : type.size());
  const int channels = std::min(in.spec.nchannels, 4);
  const afx_picture_shape shape{
      static_cast<uint32_t>(in.spec.width), static_cast<uint32_t>(in.spec.height),
      static_cast<uint32_t>(channels), static_cast<uint32_t>(type.size())};
  void* to = allocate(user, &shape);
  if (to == nullptr) throw std::bad_alloc();
  if (to_srgb)
    read_linear(in, channels, static_cast<uint8_t*>(to));
  else
    read_pixels(in, channels, type, to);
}

OIIO::ImageSpec spec_for(const afx_picture_write_request& request) {
  const afx_picture_shape& shape = request.shape;
  OIIO::ImageSpec spec(static_cast<int>(shape.width), static_cast<int>(shape.height),
                       static_cast<int>(shape.components),
                       shape.sample_bytes == 2 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("oiio:ColorSpace", request.colour != 0 ? "sRGB" : "");
  // Each only where it is meant: others would write them into the file as text.
  const std::string_view format = request.format;
  if (format == "jpeg") {
    spec.attribute("compression", "jpeg:" + std::to_string(request.jpeg_quality));
    spec.attribute("jpeg:subsampling", "4:4:4");  // on hard silhouettes 11 dB better than 4:2:0
  } else if (format == "png") {
    spec.attribute("png:compressionLevel", request.png_compression);
  }
  return spec;
}

// Colours in half precision, Z in single.
OIIO::ImageSpec exr_spec_for(const afx_picture_write_request& request) {
  const afx_picture_shape& shape = request.shape;
  const auto colours = static_cast<int>(shape.components);
  const int channels = colours + (request.depth != nullptr ? 1 : 0);
  OIIO::ImageSpec spec(static_cast<int>(shape.width), static_cast<int>(shape.height), channels,
                       OIIO::TypeDesc::HALF);
  constexpr std::array<const char*, 4> kColours{"R", "G", "B", "A"};
  constexpr std::array<const char*, 4> kGreys{"Y", "A"};
  spec.channelnames.clear();
  for (size_t k = 0; k < shape.components; ++k)
    spec.channelnames.emplace_back(colours > 2 ? kColours[k] : kGreys[k]);
  spec.alpha_channel = colours % 2 == 0 ? colours - 1 : -1;
  if (request.depth != nullptr) {
    spec.channelnames.emplace_back("Z");
    spec.z_channel = colours;
    spec.channelformats.assign(static_cast<size_t>(channels), OIIO::TypeDesc::HALF);
    spec.channelformats.back() = OIIO::TypeDesc::FLOAT;
  }
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "");  // otherwise it is the time of writing
  return spec;
}

// Premultiplied linear light of a row, and its distances.
void make_exr_row(const afx_picture_write_request& request, uint32_t y, std::vector<float>& row) {
  const size_t n = request.shape.components;
  const size_t width = request.shape.width;
  const size_t step = n + (request.depth != nullptr ? 1 : 0);
  const auto* from = static_cast<const uint8_t*>(request.samples) + width * y * n;
  const bool has_alpha = n % 2 == 0;
  const std::array<float, 256>& linear = afx::srgb_to_linear();
  for (size_t x = 0; x < width; ++x, from += n) {
    float* to = &row[x * step];
    const float alpha = has_alpha ? static_cast<float>(from[n - 1]) / 255.0F : 1.0F;
    for (size_t k = 0; k < n; ++k)
      to[k] = request.colour != 0 ? linear[from[k]] * alpha : static_cast<float>(from[k]) / 255.0F;
    if (has_alpha) to[n - 1] = alpha;
    if (request.depth != nullptr) to[n] = request.depth[width * y + x];
  }
}

// Row by row: a large picture would take four times its memory in floating point.
bool write_exr_rows(const afx_picture_write_request& request, OIIO::ImageOutput& output) {
  constexpr uint32_t kRows = 16;  // that are compressed together
  const OIIO::ImageSpec& spec = output.spec();
  const size_t length = size_t{request.shape.width} * static_cast<size_t>(spec.nchannels);
  std::vector<float> row(length), rows;
  for (uint32_t y = 0; y < request.shape.height; y += kRows) {
    const uint32_t end = std::min(y + kRows, request.shape.height);
    rows.clear();
    for (uint32_t at = y; at < end; ++at) {
      make_exr_row(request, at, row);
      rows.insert(rows.end(), row.begin(), row.end());
    }
    if (!output.write_scanlines(static_cast<int>(y), static_cast<int>(end), 0,
                                OIIO::TypeDesc::FLOAT, rows.data()))
      return false;
  }
  return true;
}

void write_picture(const afx_picture_write_request& request, afx_picture_sink sink, void* user) {
  std::vector<unsigned char> bytes;
  {
    const std::string name = std::string("memory.") + request.format;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    const auto output = OIIO::ImageOutput::create(request.format);
    if (!output || !output->supports("ioproxy"))
      throw Failure{kAfxPictureUnsupported,
                    or_default(OIIO::geterror(), "the picture format cannot be written")};
    const bool exr = std::string_view(request.format) == "openexr";
    const OIIO::ImageSpec spec = exr ? exr_spec_for(request) : spec_for(request);
    output->set_ioproxy(&proxy);
    const bool written =
        output->open(name, spec) && (exr ? write_exr_rows(request, *output)
                                         : output->write_image(spec.format, request.samples));
    if (!written || !output->close())
      throw Failure{kAfxPictureUnsupported,
                    or_default(output->geterror(), "the picture cannot be written")};
  }
  if (sink(user, bytes.data(), bytes.size()) != 0) throw std::bad_alloc();
}

int read_entry(const afx_picture_read_request* request, afx_picture_allocate allocate, void* user,
               afx_picture_error* error) {
  return guarded(error, [&] { read_picture(*request, allocate, user); });
}

int write_entry(const afx_picture_write_request* request, afx_picture_sink sink, void* user,
                afx_picture_error* error) {
  return guarded(error, [&] { write_picture(*request, sink, user); });
}

}  // namespace

extern "C" __attribute__((visibility("default"))) const afx_picture_module*
afx_picture_module_get() {
  static const afx_picture_module module{kAfxPictureModuleVersion, read_entry, write_entry};
  // Whoever calls us has threads of its own, and says how many.
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", 1);
  return &module;
}

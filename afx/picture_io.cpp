// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/picture_io.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <type_traits>

#include "afx/file.h"
#include "afx/module_loader.h"
#include "afx/picture_io_module.h"

namespace afx {
namespace {

// The module, once it was found; otherwise why not.
struct Module {
  const afx_picture_module* functions = nullptr;
  std::string problem;
};

Module load_module() {
  const ModuleSymbol found =
      find_in_module("afx_pictures", "afx_picture_module_get", "the module for pictures");
  if (found.symbol == nullptr) return {nullptr, found.problem};
  const auto* functions = reinterpret_cast<afx_picture_module_get_function>(found.symbol)();
  if (functions->version == kAfxPictureModuleVersion) return {functions, {}};
  return {nullptr, "the module for pictures is of another version"};
}

// Loaded at the first call and kept; OpenImageIO does not survive being unloaded.
const Module& module() {
  static const Module loaded = load_module();
  return loaded;
}

struct FormatRow {
  const char* format;        // OpenImageIO's name
  size_t offset;             // where in the file
  std::string_view mark;     // these bytes stand
  std::string_view endings;  // separated by blanks
  bool written = false;      // whether we write it too
};

using std::string_view_literals::operator""sv;
constexpr std::string_view kPngMark = "\x89PNG\r\n\x1A\n"sv;
constexpr std::array kFormats{
    FormatRow{"png", 0, kPngMark, "png", true},
    FormatRow{"jpeg", 0, "\xFF\xD8\xFF"sv, "jpg jpeg jpe", true},
    FormatRow{"tiff", 0, "II*\0"sv, "tif tiff"},
    FormatRow{"tiff", 0, "MM\0*"sv, ""},
    FormatRow{"bmp", 0, "BM"sv, "bmp", true},
    FormatRow{"gif", 0, "GIF8"sv, "gif"},
    FormatRow{"webp", 8, "WEBP"sv, "webp"},
    FormatRow{"psd", 0, "8BPS"sv, "psd"},
    FormatRow{"dds", 0, "DDS "sv, "dds"},
    FormatRow{"openexr", 0, "\x76\x2F\x31\x01"sv, "exr", true},
    FormatRow{"hdr", 0, "#?"sv, "hdr"},
    FormatRow{"jpeg2000", 0, "\0\0\0\x0CjP  "sv, "jp2 j2k"},
    FormatRow{"jpeg2000", 0, "\xFF\x4F\xFF\x51"sv, ""},
    FormatRow{"pnm", 0, "P1"sv, "pnm pbm pgm ppm"},
    FormatRow{"pnm", 0, "P2"sv, ""},
    FormatRow{"pnm", 0, "P3"sv, ""},
    FormatRow{"pnm", 0, "P4"sv, ""},
    FormatRow{"pnm", 0, "P5"sv, ""},
    FormatRow{"pnm", 0, "P6"sv, ""},
    FormatRow{"targa", 0, {}, "tga", true},
};

bool has_word(std::string_view words, std::string_view word) {
  for (size_t at = 0; at < words.size();) {
    const size_t end = std::min(words.find(' ', at), words.size());
    if (words.substr(at, end - at) == word) return true;
    at = end + 1;
  }
  return false;
}

// ending   without its dot, in capitals or not
std::string format_of_ending(std::string ending) {
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  if (ending.empty()) return {};
  for (const FormatRow& row : kFormats)
    if (has_word(row.endings, ending)) return row.format;
  return {};
}

Errc errc_of(int code) {
  if (code == kAfxPictureUnsupported) return Errc::unsupported;
  if (code == kAfxPictureLimit) return Errc::limit_exceeded;
  return code == kAfxPictureNoMemory ? Errc::no_memory : Errc::malformed;
}

// Gives the module the memory of a picture's samples.
template <class P>
void* allocate_picture(void* user, const afx_picture_shape* shape) {
  P& picture = *static_cast<P*>(user);
  picture.width = shape->width;
  picture.height = shape->height;
  picture.components = shape->components;
  const size_t count = size_t{shape->width} * shape->height * shape->components;
  try {
    if constexpr (std::is_same_v<P, DeepPicture>) picture.bits = shape->sample_bytes * 8;
    picture.samples.resize(count);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
  return picture.samples.data();
}

// Whether the chunks of a PNG run past the end of the file. A chunk: four bytes of length,
// four of name, data, four of checksum; IEND is the last. Known beforehand because libpng would
// tell standard error. Source: ISO/IEC 15948, datastream structure.
bool is_cut_png(std::span<const uint8_t> bytes) {
  constexpr size_t kAround = 12;
  size_t at = kPngMark.size();
  while (bytes.size() - at >= kAround) {
    const uint8_t* chunk = bytes.data() + at;
    const size_t length =
        size_t{chunk[0]} << 24 | size_t{chunk[1]} << 16 | size_t{chunk[2]} << 8 | chunk[3];
    if (length > bytes.size() - at - kAround) return true;
    if (std::memcmp(chunk + 4, "IEND", 4) == 0) return false;
    at += length + kAround;
  }
  return true;
}

template <class P>
Result<P> decode(std::span<const uint8_t> bytes, const std::string& name, const Limits& limits) {
  std::string format = picture_format_of_content(bytes);
  if (format.empty() && picture_format_of(name) == "targa") format = "targa";
  if (format.empty())
    return Error{Errc::unsupported,
                 {},
                 "is not a picture of a known format (expected PNG, JPEG, TIFF or the like)",
                 {},
                 name};
  if (format == "png" && is_cut_png(bytes))
    return Error{Errc::truncated,
                 Place::at_byte(bytes.size()),
                 "the file ends inside the PNG picture",
                 {},
                 name};
  if (module().functions == nullptr)
    return Error{Errc::not_available, {}, module().problem, {}, name};
  const int samples = std::is_same_v<P, DeepPicture>    ? kAfxSamplesStored
                      : std::is_same_v<P, FloatPicture> ? kAfxSamplesFloat
                                                        : kAfxSamplesShown;
  const afx_picture_read_request request{format.c_str(), bytes.data(),          bytes.size(),
                                         samples,        limits.picture_pixels, limits.memory};
  P picture;
  afx_picture_error error{};
  if (module().functions->read(&request, allocate_picture<P>, &picture, &error) != 0)
    return Error{errc_of(error.code), {}, error.text, {}, name};
  return picture;
}

// The library widens grey PNGs of less than 8 bits by multiplying; this takes it back. Bytes 24 and
// 25 of a PNG are the bits of a sample and its kind (0 = grey). Source: ISO/IEC 15948, IHDR.
void narrow_png(std::span<const uint8_t> bytes, DeepPicture& picture) {
  if (picture_format_of_content(bytes) != "png" || bytes.size() < 26 || bytes[25] != 0) return;
  const unsigned bits = bytes[24];
  if (bits == 0 || bits >= 8 || picture.components != 1) return;
  const unsigned step = 255U / ((1U << bits) - 1U);
  for (uint16_t& sample : picture.samples) sample = static_cast<uint16_t>(sample / step);
  picture.bits = bits;
}

// The samples of 8 bits and less were read as bytes into the first half of the memory.
void widen_bytes(DeepPicture& picture) {
  if (picture.bits > 8) return;
  const auto* bytes = reinterpret_cast<const uint8_t*>(picture.samples.data());
  for (size_t i = picture.samples.size(); i-- > 0;) {
    const uint8_t sample = bytes[i];
    picture.samples[i] = sample;  // position 2i: never in front of a byte that is still to be read
  }
}

int append_bytes(void* user, const void* bytes, size_t size) {
  try {
    const auto* from = static_cast<const uint8_t*>(bytes);
    static_cast<std::vector<uint8_t>*>(user)->assign(from, from + size);
    return 0;
  } catch (const std::bad_alloc&) {
    return 1;
  }
}

Error refused(const std::string& text) { return Error{Errc::bad_argument, {}, text, {}, {}}; }

// format   OpenImageIO's name
Status check_picture(const afx_picture_shape& shape, size_t count, std::string_view format) {
  if (shape.width == 0 || shape.height == 0) return refused("the picture is empty");
  if (shape.components < 1 || shape.components > 4 ||
      count != uint64_t{shape.width} * shape.height * shape.components)
    return refused("the picture's samples do not fit its size");
  if (shape.width > INT_MAX / 8 || shape.height > INT_MAX / 8)
    return refused("the picture is too wide or high");
  if (format == "jpeg" && (shape.components % 2 == 0 || shape.sample_bytes != 1))
    return refused("JPEG has neither alpha nor more than 8 bits a sample");
  if (format == "openexr" && shape.sample_bytes != 1)
    return refused("OpenEXR is not written from integers of more than 8 bits");
  return {};
}

Status check_options(const afx_picture_shape& shape, std::string_view format,
                     const PictureOptions& options) {
  if (options.jpeg_quality < 1 || options.jpeg_quality > 100)
    return refused("the JPEG quality is not in 1..100");
  if (options.png_compression < 0 || options.png_compression > 9)
    return refused("the PNG compression is not in 0..9");
  if (options.depth.empty()) return {};
  if (format != "openexr") return refused("of the picture formats OpenEXR alone holds depth");
  if (options.depth.size() != uint64_t{shape.width} * shape.height)
    return refused("the depths do not fit the picture's size");
  return {};
}

Result<std::vector<uint8_t>> encode(const afx_picture_shape& shape, const void* samples,
                                    size_t count, std::string_view format,
                                    const PictureOptions& options) {
  std::string name = format_of_ending(std::string(format));
  if (name.empty()) name = format;
  const bool known = std::any_of(kFormats.begin(), kFormats.end(), [&](const FormatRow& row) {
    return row.written && name == row.format;
  });
  if (!known)
    return Error{Errc::unsupported,
                 {},
                 "pictures cannot be written as " + name + " (expected png or jpeg)",
                 {},
                 {}};
  if (Status fits = check_picture(shape, count, name); !fits.ok()) return fits.error();
  if (Status fits = check_options(shape, name, options); !fits.ok()) return fits.error();
  if (module().functions == nullptr)
    return Error{Errc::not_available, {}, module().problem, {}, {}};
  const afx_picture_write_request request{name.c_str(),
                                          shape,
                                          samples,
                                          options.jpeg_quality,
                                          options.png_compression,
                                          options.colour ? 1 : 0,
                                          options.depth.empty() ? nullptr : options.depth.data()};
  std::vector<uint8_t> bytes;
  afx_picture_error error{};
  if (module().functions->write(&request, append_bytes, &bytes, &error) != 0)
    return Error{errc_of(error.code), {}, error.text, {}, {}};
  return bytes;
}

}  // namespace

std::string picture_format_of(std::string_view path) {
  const size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return {};
  return format_of_ending(std::string(path.substr(dot + 1)));
}

std::string picture_format_of_content(std::span<const uint8_t> bytes) {
  for (const FormatRow& row : kFormats) {
    if (row.mark.empty() || bytes.size() < row.offset + row.mark.size()) continue;
    if (std::memcmp(bytes.data() + row.offset, row.mark.data(), row.mark.size()) == 0)
      return row.format;
  }
  return {};
}

Result<Picture> decode_picture(std::span<const uint8_t> bytes, const std::string& name,
                               const Limits& limits) {
  return decode<Picture>(bytes, name, limits);
}

Result<DeepPicture> decode_deep_picture(std::span<const uint8_t> bytes, const std::string& name,
                                        const Limits& limits) {
  Result<DeepPicture> picture = decode<DeepPicture>(bytes, name, limits);
  if (!picture.ok()) return picture;
  widen_bytes(picture.value());
  narrow_png(bytes, picture.value());
  return picture;
}

Result<FloatPicture> decode_float_picture(std::span<const uint8_t> bytes, const std::string& name,
                                          const Limits& limits) {
  return decode<FloatPicture>(bytes, name, limits);
}

Result<Picture> read_picture(const std::string& path, const Limits& limits) {
  const Result<MappedFile> file = MappedFile::open(path, limits);
  if (!file.ok()) return file.error();
  return decode_picture(file.value().bytes(), path, limits);
}

Result<DeepPicture> read_deep_picture(const std::string& path, const Limits& limits) {
  const Result<MappedFile> file = MappedFile::open(path, limits);
  if (!file.ok()) return file.error();
  return decode_deep_picture(file.value().bytes(), path, limits);
}

Result<std::vector<uint8_t>> encode_picture(const Picture& picture, std::string_view format,
                                            const PictureOptions& options) {
  const afx_picture_shape shape{picture.width, picture.height, picture.components, 1};
  return encode(shape, picture.samples.data(), picture.samples.size(), format, options);
}

Result<std::vector<uint8_t>> encode_picture(const DeepPicture& picture, std::string_view format,
                                            const PictureOptions& options) {
  afx_picture_shape shape{picture.width, picture.height, picture.components, 2};
  if (picture.bits > 8)
    return encode(shape, picture.samples.data(), picture.samples.size(), format, options);
  shape.sample_bytes = 1;
  std::vector<uint8_t> bytes(picture.samples.size());
  std::transform(
      picture.samples.begin(), picture.samples.end(), bytes.begin(),
      [](uint16_t sample) { return static_cast<uint8_t>(std::min<uint16_t>(sample, 255)); });
  return encode(shape, bytes.data(), bytes.size(), format, options);
}

Status write_picture(const std::string& path, const Picture& picture, const PictureOptions& options,
                     bool overwrite) {
  const std::string format = picture_format_of(path);
  if (format.empty())
    return Error{Errc::unsupported,
                 {},
                 "has no ending of a picture format (expected .png or .jpg)",
                 {},
                 path};
  Result<std::vector<uint8_t>> bytes = encode_picture(picture, format, options);
  if (!bytes.ok()) {
    bytes.error().file = path;
    return bytes.error();
  }
  return write_file_atomically(path, bytes.value(), overwrite);
}

}  // namespace afx

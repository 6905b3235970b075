// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Point clouds in PLY.
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>

#include "afx/builder/model_reader.h"
#include "afx/builder/ply_header.h"

namespace afx {
namespace {

// What a property is to us.
enum Role : uint8_t { kX, kY, kZ, kRed, kGreen, kBlue, kNormalX, kNormalY, kNormalZ, kRoles };
constexpr int kNone = -1;

int role_of(std::string_view name) {
  constexpr std::string_view kDiffuse = "diffuse_";
  if (name.substr(0, kDiffuse.size()) == kDiffuse) name.remove_prefix(kDiffuse.size());
  constexpr std::array<std::string_view, kRoles> kNames{"x",    "y",  "z",  "red", "green",
                                                        "blue", "nx", "ny", "nz"};
  const auto* at = std::find(kNames.begin(), kNames.end(), name);
  return at == kNames.end() ? kNone : static_cast<int>(at - kNames.begin());
}

template <class T>
double value_of(const uint8_t* bytes, bool swapped) {
  std::array<uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (swapped) std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<T>(raw));
}

double binary_value(const uint8_t* bytes, PlyType type, bool swapped) {
  switch (type) {
    case PlyType::int8:
      return value_of<int8_t>(bytes, swapped);
    case PlyType::uint8:
      return value_of<uint8_t>(bytes, swapped);
    case PlyType::int16:
      return value_of<int16_t>(bytes, swapped);
    case PlyType::uint16:
      return value_of<uint16_t>(bytes, swapped);
    case PlyType::int32:
      return value_of<int32_t>(bytes, swapped);
    case PlyType::uint32:
      return value_of<uint32_t>(bytes, swapped);
    case PlyType::float32:
      return value_of<float>(bytes, swapped);
    case PlyType::float64:
      return value_of<double>(bytes, swapped);
  }
  return 0;
}

// The values of one element in turn, wherever they come from.
class ValueSource {
 public:
  virtual ~ValueSource() = default;
  virtual Status next(PlyType type, double& value) = 0;

  // Reads what stands for one property; of lists the entries are passed over.
  Status read(const PlyProperty& property, double& value) {
    if (!property.is_list) return next(property.type, value);
    double count = 0;
    if (Status status = next(property.count_type, count); !status.ok()) return status;
    if (!(count >= 0)) return negative_list();
    double entry = 0;
    for (double i = 0; i < count; ++i)
      if (Status status = next(property.type, entry); !status.ok()) return status;
    return {};
  }

 private:
  virtual Status negative_list() = 0;
};

class BinarySource final : public ValueSource {
 public:
  BinarySource(std::span<const uint8_t> bytes, size_t at, bool big_endian)
      : bytes_(bytes),
        at_(at),
        swapped_(big_endian == (std::endian::native == std::endian::little)) {}

  Status next(PlyType type, double& value) override {
    const size_t size = ply_size(type);
    if (bytes_.size() - at_ < size)
      return Error{Errc::truncated,
                   Place::at_byte(bytes_.size()),
                   "the file ends inside the PLY data",
                   {},
                   {}};
    value = binary_value(bytes_.data() + at_, type, swapped_);
    at_ += size;
    return {};
  }
  [[nodiscard]] uint64_t left() const { return bytes_.size() - at_; }
  void skip(uint64_t size) { at_ += size; }

 private:
  Status negative_list() override {
    return Error{Errc::malformed, Place::at_byte(at_), "a list has a negative length", {}, {}};
  }

  std::span<const uint8_t> bytes_;
  size_t at_;
  bool swapped_;
};

class TextSource final : public ValueSource {
 public:
  TextSource(std::span<const uint8_t> bytes, const PlyHeader& header)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()),
        at_(header.size),
        line_begin_(header.size),
        line_(header.lines + 1) {}

  Status next(PlyType, double& value) override {
    skip_blanks();
    if (at_ >= text_.size())
      return Error{Errc::truncated,
                   Place::at_line(line_, column()),
                   "the file ends inside the PLY data",
                   {},
                   {}};
    const char* begin = text_.data() + at_;
    const char* end = text_.data() + text_.size();
    if (*begin == '+') ++begin;  // from_chars takes none
    const auto [stop, problem] = std::from_chars(begin, end, value);
    const bool whole = stop == end || is_blank(*stop);
    // Numbers that a double cannot hold count as not finite, and are dropped later.
    if (problem == std::errc::result_out_of_range)
      value = std::numeric_limits<double>::quiet_NaN();
    else if (problem != std::errc() || !whole)
      return Error{Errc::malformed,
                   Place::at_line(line_, column()),
                   "this is not a number (expected a value of the PLY data)",
                   {},
                   {}};
    at_ = static_cast<size_t>(stop - text_.data());
    return {};
  }
  [[nodiscard]] uint64_t left() const { return text_.size() - at_; }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  void skip_blanks() {
    for (; at_ < text_.size() && is_blank(text_[at_]); ++at_)
      if (text_[at_] == '\n') {
        ++line_;
        line_begin_ = at_ + 1;
      }
  }
  [[nodiscard]] uint32_t column() const {
    return static_cast<uint32_t>(std::min<size_t>(at_ - std::min(at_, line_begin_), 0xFFFFFFFE) +
                                 1);
  }
  Status negative_list() override {
    return Error{
        Errc::malformed, Place::at_line(line_, column()), "a list has a negative length", {}, {}};
  }

  std::string_view text_;
  size_t at_;
  size_t line_begin_;
  uint32_t line_;
};

uint8_t to_byte(double value, PlyType type) {
  double scaled = value;
  if (type == PlyType::float32 || type == PlyType::float64) scaled = value * 255;
  if (type == PlyType::uint16) scaled = value / 257;
  return static_cast<uint8_t>(scaled >= 0 ? std::lround(std::min(scaled, 255.0)) : 0);  // NaN: 0
}

// Takes the vertices one by one.
class PointCollector {
 public:
  explicit PointCollector(const PlyElement& vertex) : vertex_(vertex) {
    for (const PlyProperty& property : vertex.properties) {
      const int role = property.is_list ? kNone : role_of(property.name);
      roles_.push_back(role);
      if (role == kNone) continue;
      present_[static_cast<size_t>(role)] = true;
      types_[static_cast<size_t>(role)] = property.type;
    }
  }

  [[nodiscard]] bool has_position() const { return has(kX); }
  [[nodiscard]] bool has_colour() const { return has(kRed); }
  [[nodiscard]] bool has_normal() const { return has(kNormalX); }

  void reserve(size_t count) {
    cloud_.positions.reserve(count);
    if (has_colour()) cloud_.colours.reserve(count);
    if (has_normal()) cloud_.normals.reserve(count);
  }

  Status read_vertex(ValueSource& source) {
    std::array<double, kRoles> values{};
    for (size_t i = 0; i < roles_.size(); ++i) {
      double value = 0;
      if (Status status = source.read(vertex_.properties[i], value); !status.ok()) return status;
      if (roles_[i] != kNone) values[static_cast<size_t>(roles_[i])] = value;
    }
    add(values);
    return {};
  }

  PointCloud finish(Diagnostics& diagnostics) {
    if (dropped_ > 0)
      diagnostics.warn(
          "non_finite", {},
          std::to_string(dropped_) + " points with coordinates that are not finite were left out");
    return std::move(cloud_);
  }

 private:
  [[nodiscard]] bool has(size_t first) const {
    return present_[first] && present_[first + 1] && present_[first + 2];
  }

  void add(const std::array<double, kRoles>& v) {
    const glm::dvec3 place(v[kX], v[kY], v[kZ]);
    // Coordinates beyond what a float holds cannot be worked with either.
    const auto usable = [](double c) { return std::abs(c) < 1e37; };
    if (!usable(place.x) || !usable(place.y) || !usable(place.z)) {
      ++dropped_;
      return;
    }
    if (cloud_.positions.empty()) cloud_.origin = place;
    cloud_.positions.emplace_back(place - cloud_.origin);
    if (has_colour())
      cloud_.colours.push_back({to_byte(v[kRed], types_[kRed]), to_byte(v[kGreen], types_[kGreen]),
                                to_byte(v[kBlue], types_[kBlue]), 255});
    if (!has_normal()) return;
    const glm::vec3 normal(glm::dvec3(v[kNormalX], v[kNormalY], v[kNormalZ]));
    const bool finite =
        std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
    cloud_.normals.push_back(finite ? normal : glm::vec3(0));
  }

  const PlyElement& vertex_;
  std::vector<int> roles_;  // of each property
  std::array<bool, kRoles> present_{};
  std::array<PlyType, kRoles> types_{};
  PointCloud cloud_;
  uint64_t dropped_ = 0;
};

// Passes over the elements before the vertices.
Status skip_element(const PlyElement& element, ValueSource& source) {
  double ignored = 0;
  if (element.properties.empty()) return {};
  for (uint64_t i = 0; i < element.count; ++i)
    for (const PlyProperty& property : element.properties)
      if (Status status = source.read(property, ignored); !status.ok()) return status;
  return {};
}

Status skip_to_vertices(const PlyHeader& header, BinarySource& source, uint64_t file_size) {
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") return {};
    const size_t stride = element.stride();
    if (stride == 0) {
      if (Status status = skip_element(element, source); !status.ok()) return status;
    } else if (element.count > source.left() / stride) {
      return Error{
          Errc::truncated, Place::at_byte(file_size), "the file ends inside the PLY data", {}, {}};
    } else {
      source.skip(element.count * stride);
    }
  }
  return {};
}

Status skip_to_vertices(const PlyHeader& header, TextSource& source, uint64_t) {
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") return {};
    if (Status status = skip_element(element, source); !status.ok()) return status;
  }
  return {};
}

// The least that one vertex takes in the file: so a count cannot ask for more memory than the file
// has bytes for.
uint64_t least_bytes(const PlyElement& vertex, PlyFormat format) {
  uint64_t bytes = 0;
  for (const PlyProperty& property : vertex.properties) {
    const size_t size = ply_size(property.is_list ? property.count_type : property.type);
    bytes += format == PlyFormat::ascii ? 2 : size;  // a digit and a blank
  }
  return bytes;
}

template <class Source>
Result<PointCloud> read_vertices(const PlyHeader& header, const PlyElement& vertex, Source source,
                                 uint64_t file_size, const Limits& limits,
                                 Diagnostics& diagnostics) {
  if (Status status = skip_to_vertices(header, source, file_size); !status.ok())
    return status.error();
  PointCollector points(vertex);
  // The last number of a text needs no blank after it.
  if (vertex.count > (source.left() + 1) / least_bytes(vertex, header.format))
    return Error{Errc::truncated,
                 Place::at_byte(file_size),
                 "the file ends before its " + std::to_string(vertex.count) + " vertices",
                 {},
                 {}};
  if (vertex.count > limits.memory / 28)  // bytes of a point with everything
    return Error{Errc::limit_exceeded,
                 {},
                 std::to_string(vertex.count) + " points take more memory than the limit",
                 {},
                 {}};
  points.reserve(vertex.count);
  for (uint64_t i = 0; i < vertex.count; ++i)
    if (Status status = points.read_vertex(source); !status.ok()) return status.error();
  PointCloud cloud = points.finish(diagnostics);
  if (cloud.positions.empty())
    return Error{Errc::malformed, {}, "no point has finite coordinates", {}, {}};
  return cloud;
}

}  // namespace

PlyKind ply_kind(std::span<const uint8_t> bytes) {
  if (!is_ply(bytes)) return PlyKind::not_ply;
  const Result<PlyHeader> header = read_ply_header(bytes);
  if (!header.ok()) return PlyKind::points;  // whose reader says what is wrong
  for (const char* name : {"face", "tristrips"}) {
    const PlyElement* element = header.value().find(name);
    if (element != nullptr && element->count > 0) return PlyKind::mesh;
  }
  return PlyKind::points;
}

Result<PointCloud> read_ply_points(std::span<const uint8_t> bytes, const Limits& limits,
                                   Diagnostics& diagnostics) {
  const Result<PlyHeader> result = read_ply_header(bytes);
  if (!result.ok()) return result.error();
  const PlyHeader& header = result.value();
  const PlyElement* vertex = header.find("vertex");
  if (vertex == nullptr || vertex->count == 0)
    return Error{Errc::malformed, {}, "the file has no vertices", {}, {}};
  if (!PointCollector(*vertex).has_position())
    return Error{Errc::malformed, {}, "the vertices have no x, y and z", {}, {}};
  if (header.format == PlyFormat::ascii)
    return read_vertices(header, *vertex, TextSource(bytes, header), bytes.size(), limits,
                         diagnostics);
  const BinarySource source(bytes, header.size, header.format == PlyFormat::big_endian);
  return read_vertices(header, *vertex, source, bytes.size(), limits, diagnostics);
}

}  // namespace afx

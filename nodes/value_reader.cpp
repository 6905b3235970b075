// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "nodes/value_reader.h"

#include <type_traits>

#include "nodes/byte_text.h"

namespace afx::nodes {

namespace {

template <class T>
constexpr size_t numbers_in() {
  if constexpr (std::is_arithmetic_v<T>) return 1;
  if constexpr (std::is_same_v<T, glm::vec2>) return 2;
  if constexpr (std::is_same_v<T, glm::vec3>) return 3;
  if constexpr (std::is_same_v<T, glm::vec4> || std::is_same_v<T, Rotation>) return 4;
  return 0;
}

}  // namespace

bool Budget::take(TextCursor& in, uint64_t count, uint64_t bytes_each) {
  if (count > values_)
    in.fail(Errc::limit_exceeded, in.offset(), "more values than the limit scene_values allows");
  else if (count > memory_ / bytes_each)
    in.fail(Errc::limit_exceeded, in.offset(), "more data than the limit memory allows");
  if (!in.ok()) return false;
  values_ -= count;
  memory_ -= count * bytes_each;
  return true;
}

template <class T>
std::vector<T> ValueReader::read_list() {
  std::vector<T> list;
  constexpr size_t kNumbers = numbers_in<T>();
  const size_t opened = (in_.skip_space(), in_.offset());
  if (!in_.accept('[')) {
    if (budget_.take(in_, 1, sizeof(T))) read_one(list.emplace_back());
    return list;
  }
  // Numbers are counted first, so that memory is that of the values and not of a growing vector.
  if constexpr (kNumbers != 0) {
    const size_t expected = in_.count_tokens_in_list() / kNumbers;
    if (!budget_.take(in_, expected, sizeof(T))) return list;
    list.reserve(expected);
  }
  for (char next = in_.peek(); next != ']'; next = in_.peek()) {
    if (next == '\0' && in_.at_end()) {
      in_.fail_unclosed(opened, "']'");
      return {};
    }
    if (list.size() == list.capacity() && kNumbers == 0 &&
        !budget_.take(in_, list.size() + 1, sizeof(T)))
      return {};
    read_one(list.emplace_back());
    in_.note_progress();
  }
  in_.accept(']');
  return list;
}

template <class T>
FieldValue ValueReader::read_as() {
  T value{};
  if (budget_.take(in_, 1, sizeof(T))) read_one(value);
  return value;
}

FieldValue ValueReader::read(FieldType type) {
  using enum FieldType;
  switch (type) {
    case sf_bool:
      return read_as<bool>();
    case sf_float:
      return read_as<float>();
    case sf_time:
      return read_as<double>();
    case sf_int32:
      return read_as<int32_t>();
    case sf_script:
    case sf_string:
      return read_as<std::string>();
    case sf_color:
    case sf_vec3f:
      return read_as<glm::vec3>();
    case sf_vec2f:
      return read_as<glm::vec2>();
    case sf_rotation:
      return read_as<Rotation>();
    case sf_image:
      return read_as<Image>();
    case sf_vec4f:
      return read_as<glm::vec4>();
    case sf_url:
      return read_as<Url>();
    case sf_command_buffer:
      return read_as<CommandBuffer>();
    case mf_bool:
      return read_list<uint8_t>();
    case mf_float:
      return read_list<float>();
    case mf_time:
      return read_list<double>();
    case mf_int32:
      return read_list<int32_t>();
    case mf_script:
    case mf_string:
      return read_list<std::string>();
    case mf_color:
    case mf_vec3f:
      return read_list<glm::vec3>();
    case mf_vec2f:
      return read_list<glm::vec2>();
    case mf_rotation:
      return read_list<Rotation>();
    case mf_image:
      return read_list<Image>();
    case mf_vec4f:
      return read_list<glm::vec4>();
    case mf_url:
      return read_list<Url>();
    case sf_node:
    case mf_node:
      break;  // whoever knows the scene reads nodes
  }
  return zero_value(type);
}

void ValueReader::read_one(std::string& value) {
  value = in_.string();
  budget_.take(in_, 1, value.size() + 1);
}

void ValueReader::read_one(Url& value) {
  const char next = in_.peek();
  const size_t begin = in_.offset();
  if (next == '"') {
    std::string text;
    read_one(text);
    value = Url::from_text(text);
    return;
  }
  // The peer writes object descriptors without quotes: 10 or od:10.
  const std::string_view token = in_.take_token();
  value = Url::from_text(token);
  if (!value.is_descriptor() && in_.ok())
    in_.fail(in_.at_end() && token.empty() ? Errc::truncated : Errc::malformed, begin,
             "found " + quoted(token) +
                 " [expected a URL in quotes, or an object descriptor 0 to 1023]");
}

void ValueReader::read_floats(float* out, unsigned count) {
  for (unsigned i = 0; i < count; ++i) {
    if (i > 0 && in_.peek() == ']')
      return in_.fail(Errc::malformed, in_.offset(),
                      "the list ends inside a value [expected numbers by " + std::to_string(count) +
                          ", " + std::to_string(count - i) + " more]");
    out[i] = in_.float32();
  }
}

void ValueReader::read_one(Image& value) {
  const size_t begin = (in_.skip_space(), in_.offset());
  value.width = in_.uint32();
  value.height = in_.uint32();
  value.components = in_.uint32();
  if (!in_.ok()) return;
  if (value.components > 4)
    return in_.fail(
        Errc::malformed, begin,
        "an image of " + std::to_string(value.components) + " components [expected 0 to 4]");
  const uint64_t pixels = uint64_t{value.width} * value.height;
  if (pixels > limits_.picture_pixels)
    return in_.fail(
        Errc::limit_exceeded, begin,
        "an image of " + std::to_string(pixels) + " pixels is beyond the limit picture_pixels");
  if (value.components == 0 || pixels == 0) return;
  // A pixel takes two characters at least: no memory for more than can be there.
  if (pixels > in_.bytes_left())
    return in_.fail(Errc::truncated, begin,
                    "the text ends inside an image of " + std::to_string(pixels) + " pixels");
  if (budget_.take(in_, pixels * value.components, 1)) read_pixels(value);
}

void ValueReader::read_pixels(Image& image) {
  const uint64_t pixels = uint64_t{image.width} * image.height;
  const uint32_t largest =
      image.components == 4 ? UINT32_MAX : (uint32_t{1} << 8 * image.components) - 1;
  image.samples.resize(pixels * image.components);
  uint8_t* out = image.samples.data();
  for (uint64_t i = 0; i < pixels && in_.ok(); ++i) {
    in_.note_progress();
    in_.skip_space();
    const size_t begin = in_.offset();
    const uint32_t pixel = in_.uint32();
    if (pixel > largest)
      in_.fail(Errc::malformed, begin,
               "a pixel value of " + std::to_string(pixel) + " [expected at most " +
                   std::to_string(largest) + " for " + std::to_string(image.components) +
                   " components]");
    for (uint32_t c = image.components; c-- > 0;) *out++ = static_cast<uint8_t>(pixel >> 8 * c);
  }
  if (!in_.ok()) image = {};
}

std::string ValueReader::read_bytes() {
  const size_t begin = (in_.skip_space(), in_.offset());
  std::string text;
  read_one(text);
  if (!in_.ok()) return {};
  constexpr std::string_view kFile = "file:";
  Result<std::string> bytes = Error{};
  if (!text.starts_with(kFile)) {
    bytes = bytes_of_text(text);
  } else if (load_file_) {
    bytes = load_file_(std::string_view(text).substr(kFile.size()));
  } else {
    bytes = Error{Errc::unsupported, {}, quoted(text) + ": files cannot be loaded here", {}, {}};
  }
  if (bytes.ok()) return std::move(bytes).value();
  in_.fail(bytes.error().code, begin, bytes.error().text);
  return {};
}

}  // namespace afx::nodes

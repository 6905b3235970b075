// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/ply_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

namespace afx {
namespace {

// Hostile headers are refused before they cost memory.
constexpr size_t kMostElements = 64;
constexpr size_t kMostProperties = 1024;
constexpr size_t kLongestLine = 4096;

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array kTypeNames{
    TypeName{"char", PlyType::int8},      TypeName{"int8", PlyType::int8},
    TypeName{"uchar", PlyType::uint8},    TypeName{"uint8", PlyType::uint8},
    TypeName{"short", PlyType::int16},    TypeName{"int16", PlyType::int16},
    TypeName{"ushort", PlyType::uint16},  TypeName{"uint16", PlyType::uint16},
    TypeName{"int", PlyType::int32},      TypeName{"int32", PlyType::int32},
    TypeName{"uint", PlyType::uint32},    TypeName{"uint32", PlyType::uint32},
    TypeName{"float", PlyType::float32},  TypeName{"float32", PlyType::float32},
    TypeName{"double", PlyType::float64}, TypeName{"float64", PlyType::float64},
};

std::optional<PlyType> type_of(std::string_view name) {
  for (const TypeName& row : kTypeNames)
    if (row.name == name) return row.type;
  return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlank = " \t";
  for (size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos;) {
    const size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

// Reads the header line by line.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view text) : text_(text) {}

  Result<PlyHeader> read() {
    bool format_known = false;
    while (const std::optional<std::string_view> line = next_line()) {
      const std::vector<std::string_view> words = words_of(*line);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      Status status;
      if (header_.lines == 1) {
        if (words[0] != "ply")
          status = wrong("this is no PLY file (expected \"ply\" in the first line)");
      } else if (words[0] == "format") {
        status = read_format(words);
        format_known = true;
      } else if (words[0] == "element") {
        status = read_element(words);
      } else if (words[0] == "property") {
        status = read_property(words);
      } else if (words[0] == "end_header") {
        if (!format_known) return wrong("the header has no format line").error();
        header_.size = at_;
        return std::move(header_);
      }
      if (!status.ok()) return status.error();
    }
    if (at_ < text_.size())
      return wrong("a line of the header is longer than 4096 characters").error();
    return Error{Errc::truncated,
                 Place::at_byte(text_.size()),
                 "the file ends inside the PLY header",
                 {},
                 {}};
  }

 private:
  std::optional<std::string_view> next_line() {
    const size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos || end - at_ > kLongestLine) {
      if (end == std::string_view::npos && text_.size() - at_ <= kLongestLine) at_ = text_.size();
      return std::nullopt;
    }
    std::string_view line = text_.substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    at_ = end + 1;
    ++header_.lines;
    return line;
  }

  [[nodiscard]] Status wrong(const std::string& text) const {
    return Error{Errc::malformed, Place::at_line(header_.lines, 1), text, {}, {}};
  }

  Status read_format(const std::vector<std::string_view>& words) {
    const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
    if (name == "ascii")
      header_.format = PlyFormat::ascii;
    else if (name == "binary_little_endian")
      header_.format = PlyFormat::little_endian;
    else if (name == "binary_big_endian")
      header_.format = PlyFormat::big_endian;
    else
      return wrong("unknown format (expected ascii, binary_little_endian or binary_big_endian)");
    return {};
  }

  Status read_element(const std::vector<std::string_view>& words) {
    PlyElement element;
    if (words.size() < 3) return wrong("an element lacks its name or count");
    element.name = words[1];
    const char* end = words[2].data() + words[2].size();
    const auto [stop, problem] = std::from_chars(words[2].data(), end, element.count);
    if (problem != std::errc() || stop != end)
      return wrong("the count of an element is not a number");
    if (header_.elements.size() >= kMostElements) return wrong("more than 64 kinds of elements");
    header_.elements.push_back(std::move(element));
    return {};
  }

  Status read_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) return wrong("a property stands before the first element");
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    const bool is_list = words.size() > 1 && words[1] == "list";
    if (words.size() < (is_list ? 5U : 3U)) return wrong("a property lacks its type or name");
    const std::optional<PlyType> type = type_of(words[is_list ? 3 : 1]);
    const std::optional<PlyType> count_type = is_list ? type_of(words[2]) : PlyType::uint8;
    if (!type || !count_type)
      return wrong("unknown type of a property (expected e.g. float or uchar)");
    if (*count_type == PlyType::float32 || *count_type == PlyType::float64)
      return wrong("the length of a list is not an integer");
    if (properties.size() >= kMostProperties) return wrong("more than 1024 properties");
    properties.push_back({std::string(words[is_list ? 4 : 2]), *type, is_list, *count_type});
    return {};
  }

  std::string_view text_;
  size_t at_ = 0;
  PlyHeader header_;
};

}  // namespace

size_t ply_size(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 1;
}

size_t PlyElement::stride() const {
  size_t size = 0;
  for (const PlyProperty& property : properties) {
    if (property.is_list) return 0;
    size += ply_size(property.type);
  }
  return size;
}

const PlyElement* PlyHeader::find(const std::string& name) const {
  for (const PlyElement& element : elements)
    if (element.name == name) return &element;
  return nullptr;
}

bool is_ply(std::span<const uint8_t> bytes) {
  return bytes.size() >= 4 && bytes[0] == 'p' && bytes[1] == 'l' && bytes[2] == 'y' &&
         (bytes[3] == '\n' || bytes[3] == '\r');
}

Result<PlyHeader> read_ply_header(std::span<const uint8_t> bytes) {
  return HeaderReader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}).read();
}

}  // namespace afx

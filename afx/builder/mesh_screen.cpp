// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/mesh_screen.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>
#include <vector>

#include "afx/builder/ply_header.h"

namespace afx {
namespace {

// A count below that costs little memory, whatever the file; and coordinates are not counts.
constexpr uint64_t kHarmlessCount = uint64_t{1} << 22;

Error too_deep() {
  return Error{Errc::limit_exceeded,
               {},
               "nested deeper than " + std::to_string(kMostMeshNesting) + " levels",
               {},
               {}};
}

Error too_short(uint64_t size, uint64_t count, const std::string& what) {
  return Error{Errc::truncated,
               Place::at_byte(size),
               "the file ends before its " + std::to_string(count) + " " + what,
               {},
               {}};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string ending_of(const std::string& path) {
  const size_t dot = path.find_last_of("./");
  if (dot == std::string::npos || path[dot] == '/') return {};
  std::string ending = path.substr(dot + 1);
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

// The number that begins at `at`, which moves behind it; no digits are 0, too many the largest.
uint64_t number_at(std::string_view text, size_t& at) {
  constexpr uint64_t kMost = ~uint64_t{0};
  uint64_t value = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    const auto digit = static_cast<uint64_t>(text[at] - '0');
    value = value > (kMost - digit) / 10 ? kMost : value * 10 + digit;
  }
  return value;
}

// Behind the string in quotes that begins at `at`.
size_t after_string(std::string_view text, size_t at, bool escapes) {
  for (++at; at < text.size() && text[at] != '"'; ++at)
    if (escapes && text[at] == '\\') ++at;
  return std::min(at + 1, text.size());
}

// The least that one element takes in the file.
uint64_t least_bytes(const PlyElement& element, PlyFormat format) {
  uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += format == PlyFormat::ascii
                 ? 2  // a digit and a blank
                 : ply_size(property.is_list ? property.count_type : property.type);
  return std::max<uint64_t>(bytes, 1);
}

uint64_t ply_integer(std::span<const uint8_t> bytes, bool big_endian) {
  uint64_t value = 0;
  for (size_t k = 0; k < bytes.size(); ++k)
    value |= uint64_t{bytes[big_endian ? bytes.size() - 1 - k : k]} << (8 * k);
  return value;
}

// Walks over the data of a binary file, whose lists say how long they are one by one.
Status screen_ply_lists(std::span<const uint8_t> bytes, const PlyHeader& header) {
  std::span<const uint8_t> rest = bytes.subspan(header.size);
  const auto skip = [&](uint64_t size) {
    const bool there = size <= rest.size();
    if (there) rest = rest.subspan(size);
    return there;
  };
  for (const PlyElement& element : header.elements) {
    for (uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& p : element.properties) {
        const size_t head = p.is_list ? ply_size(p.count_type) : 0;
        if (head > rest.size()) return too_short(bytes.size(), element.count, element.name + "s");
        const uint64_t entries =
            p.is_list ? ply_integer(rest.first(head), header.format == PlyFormat::big_endian) : 1;
        if (!skip(head) || !skip(entries * ply_size(p.type)))
          return too_short(bytes.size(), entries, "entries of a list");
      }
    }
  }
  return {};
}

Status screen_ply(std::span<const uint8_t> bytes, const Limits& limits) {
  const Result<PlyHeader> header = read_ply_header(bytes);
  if (!header.ok()) return header.error();
  uint64_t left = bytes.size() - header.value().size + 1;  // the last number needs no blank
  uint64_t memory = limits.memory;
  for (const PlyElement& element : header.value().elements) {
    const uint64_t least = least_bytes(element, header.value().format);
    const std::string what = element.name == "face"     ? "faces"
                             : element.name == "vertex" ? "vertices"
                                                        : "elements \"" + element.name + "\"";
    if (element.count > left / least) return too_short(bytes.size(), element.count, what);
    left -= element.count * least;
    constexpr uint64_t kElementBytes = 16;  // what the mesh holds of one at least
    if (element.count > memory / kElementBytes)
      return Error{Errc::limit_exceeded,
                   {},
                   std::to_string(element.count) + " " + what + " take more memory than the limit",
                   {},
                   {}};
    memory -= element.count * kElementBytes;
  }
  return header.value().format == PlyFormat::ascii ? Status()
                                                   : screen_ply_lists(bytes, header.value());
}

// "OFF", in front of it letters for what vertices have, behind it the counts of vertices, faces and
// edges.
bool is_off(const std::string& ending, std::string_view text) {
  const std::string_view first = text.substr(0, std::min(text.find_first_of(" \t\r\n"), size_t{8}));
  return ending == "off" || (first.size() >= 3 && first.substr(first.size() - 3) == "OFF");
}

Status screen_off(std::string_view text) {
  size_t at = std::min(text.find("OFF"), text.size());
  at = at == text.size() ? 0 : at + 3;
  constexpr uint64_t kVertex = 6, kFace = 2;  // "0 0 0\n" and "0\n"
  const uint64_t least[] = {kVertex, kFace};
  const char* const names[] = {"vertices", "faces"};
  uint64_t needed = 0;
  for (int k = 0; k < 2; ++k) {
    while (at < text.size() && (is_blank(text[at]) || text[at] == '#'))
      at = text[at] == '#' ? std::min(text.find('\n', at), text.size()) : at + 1;
    const uint64_t count = number_at(text, at);
    if (count > text.size() || (needed += count * least[k]) > text.size() + 1)
      return too_short(text.size(), count, names[k]);
  }
  return {};
}

// Brackets of JSON outside its strings.
Status screen_json(std::string_view text) {
  unsigned depth = 0;
  for (size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"') {
      at = after_string(text, at, true);
      continue;
    }
    if ((c == '{' || c == '[') && ++depth > kMostMeshNesting) return too_deep();
    if ((c == '}' || c == ']') && depth > 0) --depth;
    ++at;
  }
  return {};
}

// A GLB: 12 bytes, then a chunk of JSON with its length and kind in front, little-endian. The chunk
// of binary data behind it has no brackets to count. Source: glTF 2.0, GLB file format.
std::string_view json_of_glb(std::string_view text) {
  constexpr size_t kBefore = 20;
  if (text.size() < kBefore) return {};
  uint32_t length = 0;
  for (size_t k = 0; k < 4; ++k) length |= uint32_t{static_cast<uint8_t>(text[12 + k])} << (8 * k);
  return text.substr(kBefore, length);
}

// Behind the "<" of a comment, a CDATA section, an instruction or a declaration; `at` otherwise.
size_t after_special(std::string_view text, size_t at) {
  const auto behind = [&](std::string_view begin, std::string_view end) {
    if (text.substr(at, begin.size()) != begin) return at;
    const size_t found = text.find(end, at + begin.size());
    return found == std::string_view::npos ? text.size() : found + end.size();
  };
  for (const auto& [begin, end] : {std::pair<std::string_view, std::string_view>{"!--", "-->"},
                                   {"![CDATA[", "]]>"},
                                   {"?", "?>"},
                                   {"!", ">"}})
    if (const size_t to = behind(begin, end); to != at) return to;
  return at;
}

// Behind the ">" of a tag; `closed` is whether it ends in "/>".
size_t after_tag(std::string_view text, size_t at, bool& closed) {
  for (char quote = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      break;
    }
  }
  closed = at > 0 && at < text.size() && text[at - 1] == '/';
  return std::min(at + 1, text.size());
}

Status screen_xml(std::string_view text) {
  unsigned depth = 0;
  for (size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    ++at;
    if (const size_t to = after_special(text, at); to != at) {
      at = to;
      continue;
    }
    const bool ends = at < text.size() && text[at] == '/';
    bool closed = false;
    at = after_tag(text, at, closed);
    if (ends && depth > 0) --depth;
    if (!ends && !closed && ++depth > kMostMeshNesting) return too_deep();
  }
  return {};
}

// Blocks in braces, as text files of .x and .fbx have them; in .x also the counts of meshes.
class BlockScreen {
 public:
  BlockScreen(std::string_view text, size_t first, bool counts)
      : text_(text), first_(first), counts_(counts) {}

  Status run() {
    for (size_t at = first_; at < text_.size();) {
      const char c = text_[at];
      if (c == '"') {
        at = after_string(text_, at, false);
      } else if (counts_ && (c == '#' || text_.substr(at, 2) == "//")) {
        at = std::min(text_.find('\n', at), text_.size());
      } else if (is_word(c)) {
        const uint64_t count = word(at);
        if (count > std::max<uint64_t>(text_.size(), kHarmlessCount))
          return too_short(text_.size(), count, "entries of a mesh");
      } else {
        if (c == '{' && !open()) return too_deep();
        if (c == '}') close();
        ++at;
      }
    }
    return {};
  }

 private:
  // Moves behind a word; the number it is where counts stand, otherwise 0.
  uint64_t word(size_t& at) {
    const size_t first = at;
    while (at < text_.size() && is_word(text_[at])) ++at;
    const std::string_view word = text_.substr(first, at - first);
    if (!is_digit(word[0])) {
      // "Mesh name {": of the words in front of a brace the first is its kind.
      if (kind_.empty()) kind_ = word;
      return 0;
    }
    kind_ = {};
    const bool whole = (first == 0 || (text_[first - 1] != '.' && text_[first - 1] != '-')) &&
                       (at >= text_.size() || text_[at] != '.') &&
                       std::all_of(word.begin(), word.end(), is_digit);
    if (!counts_ || !whole || !is_mesh_.back()) return 0;
    size_t begin = first;
    return number_at(text_, begin);
  }

  bool open() {
    is_mesh_.push_back(kind_.substr(0, 4) == "Mesh" || kind_ == "SkinWeights");
    kind_ = {};
    return is_mesh_.size() <= kMostMeshNesting + 1;
  }

  void close() {
    if (is_mesh_.size() > 1) is_mesh_.pop_back();
    kind_ = {};
  }

  std::string_view text_;
  size_t first_;  // byte of the text
  bool counts_;
  std::string_view kind_;                // the first word since the last brace or number
  std::vector<bool> is_mesh_ = {false};  // for each open block: its numbers are counts and indices
};

}  // namespace

Status screen_mesh_file(const std::string& path, std::span<const uint8_t> bytes,
                        const Limits& limits) {
  if (is_ply(bytes)) return screen_ply(bytes, limits);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string ending = ending_of(path);
  if (text.substr(0, 4) == "glTF") return screen_json(json_of_glb(text));
  constexpr size_t kHead = 16;  // of a .x file: mark, version, kind, width of floats
  if (text.substr(0, 4) == "xof " && text.size() >= kHead)
    return text.substr(8, 3) == "txt" ? BlockScreen(text, kHead, true).run() : Status();
  if (ending == "fbx" && text.substr(0, 7) != "Kaydara") return BlockScreen(text, 0, false).run();
  if (is_off(ending, text)) return screen_off(text);
  const std::string_view mark = "\xEF\xBB\xBF";
  size_t first = text.substr(0, 3) == mark ? 3 : 0;
  while (first < text.size() && is_blank(text[first])) ++first;
  const char begin = first < text.size() ? text[first] : ' ';
  if (begin == '{' || begin == '[' || ending == "gltf") return screen_json(text);
  return begin == '<' ? screen_xml(text) : Status();
}

}  // namespace afx

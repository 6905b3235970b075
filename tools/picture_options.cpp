// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/picture_options.h"

#include <charconv>

#include "render/renderer.h"

namespace afx::tools {

bool parse_size(const std::string& text, uint32_t& width, uint32_t& height) {
  const char* end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, width);
  if (w.ec != std::errc() || w.ptr == end || *w.ptr != 'x') return false;
  const auto h = std::from_chars(w.ptr + 1, end, height);
  const auto fits = [](uint32_t side) { return side >= 1 && side <= render::kMaxSide; };
  return h.ec == std::errc() && h.ptr == end && fits(width) && fits(height);
}

bool parse_colour(const std::string& text, Rgba8& colour) {
  if (text == "transparent") colour = {0, 0, 0, 0};
  if (text == "white") colour = {255, 255, 255, 255};
  if (text == "black") colour = {0, 0, 0, 255};
  if (text == "transparent" || text == "white" || text == "black") return true;
  uint32_t value = 0;
  if (text.size() != 7 && text.size() != 9) return false;
  const auto parsed = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  if (text[0] != '#' || parsed.ec != std::errc() || parsed.ptr != text.data() + text.size())
    return false;
  if (text.size() == 7) value = value << 8 | 0xff;
  colour = {static_cast<uint8_t>(value >> 24), static_cast<uint8_t>(value >> 16),
            static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
  return true;
}

}  // namespace afx::tools

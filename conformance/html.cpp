// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/html.h"

namespace afx::conformance {
namespace {

constexpr std::string_view kStyle = R"(
  :root { color-scheme: light dark; --line: #8884; --good: #2a7d3f; --bad: #c0262d; --none: #8a6d00; }
  body { font: 15px/1.5 system-ui, sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem; }
  h1 { font-size: 1.6rem; } h2 { font-size: 1.25rem; margin-top: 2.5rem; }
  h3 { font-size: 1.05rem; margin: 0 0 .3rem; }
  code, pre, .path { font-family: ui-monospace, monospace; font-size: .9em; overflow-wrap: anywhere; }
  table { border-collapse: collapse; width: 100%; }
  th, td { text-align: left; vertical-align: top; padding: .3rem .6rem; border-bottom: 1px solid var(--line); }
  .passed { color: var(--good); } .failed { color: var(--bad); } .not-run { color: var(--none); }
  .number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  .card { border: 1px solid var(--line); border-left: 5px solid var(--bad); border-radius: 4px;
          padding: .8rem 1rem; margin: 1rem 0; }
  .card p { margin: .3rem 0; } .dim { opacity: .75; }
  .bar { display: flex; height: .7rem; border-radius: 4px; overflow: hidden; margin: .5rem 0 1rem; }
  .bar span.passed { background: var(--good); } .bar span.failed { background: var(--bad); }
  .bar span.not-run { background: var(--none); }
  figure { display: inline-block; margin: .5rem 1rem .5rem 0; } figcaption { font-size: .85em; }
  figure img { image-rendering: pixelated; max-width: 22rem; border: 1px solid var(--line); }
  summary { cursor: pointer; } tr.gap td { background: #c0262d22; color: var(--bad); }
  .strip { display: block; width: 15rem; height: 1rem; background: #8882; fill: var(--good); }
  .rule { white-space: nowrap; }
)";

constexpr char kHex[] = "0123456789abcdef";

std::string as_hex(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  return {'\\', 'x', kHex[value >> 4], kHex[value & 15]};
}

/// The length of the UTF-8 character at the beginning; 0 where there is none.
size_t utf8_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const size_t length = first < 0x80       ? 1
                        : first >> 5 == 6  ? 2
                        : first >> 4 == 14 ? 3
                        : first >> 3 == 30 ? 4
                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80) return 0;
  return length;
}

std::string base64(std::span<const uint8_t> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string html;
  while (!text.empty()) {
    const char c = text[0];
    size_t length = utf8_length(text);
    if (c == '&') {
      html += "&amp;";
    } else if (c == '<') {
      html += "&lt;";
    } else if (c == '>') {
      html += "&gt;";
    } else if (c == '"') {
      html += "&quot;";
    } else if (length == 0 || (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7F) {
      html += as_hex(c);
      length = 1;
    } else {
      html += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return html;
}

std::string html_picture(std::span<const uint8_t> png, std::string_view caption) {
  return "<figure><img alt=\"" + html_text(caption) + "\" src=\"data:image/png;base64," +
         base64(png) + "\"><figcaption>" + html_text(caption) + "</figcaption></figure>\n";
}

std::string html_page(std::string_view title, std::string_view body) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>";
  page += html_text(title);
  page += "</title>\n<style>";
  page += kStyle;
  page += "</style>\n</head>\n<body>\n";
  page += body;
  page += "</body>\n</html>\n";
  return page;
}

}  // namespace afx::conformance

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What the pages for people are put together from.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace afx::conformance {

/// Text as HTML shows it; control characters and bytes that are no UTF-8 as \xHH.
std::string html_text(std::string_view text);

/// A PNG file as an <img> that needs no file.
std::string html_picture(std::span<const uint8_t> png, std::string_view caption);

/// The page around a body, with its style.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace afx::conformance

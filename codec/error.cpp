// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "codec/error.h"

namespace afx {

const char* to_string(Errc code) {
  switch (code) {
    case Errc::truncated:
      return "truncated";
    case Errc::malformed:
      return "malformed";
    case Errc::unsupported:
      return "unsupported";
    case Errc::limit_exceeded:
      return "limit_exceeded";
    case Errc::bad_argument:
      return "bad_argument";
    case Errc::no_memory:
      return "no_memory";
    case Errc::io:
      return "io";
    case Errc::not_available:
      return "not_available";
  }
  return "unknown";
}

std::string to_string(const Place& place) {
  switch (place.kind) {
    case Place::Kind::none:
      return {};
    case Place::Kind::text:
      return std::to_string(place.line) + ":" + std::to_string(place.column);
    case Place::Kind::bit:
      break;
  }
  std::string text = std::to_string(place.bit / 8);
  if (place.bit % 8 != 0) text += "." + std::to_string(place.bit % 8);
  return text;
}

std::string to_string(const Error& error, const std::string& file) {
  std::string out = error.file.empty() ? file : error.file;
  const std::string where = to_string(error.place);
  if (!where.empty()) out += (out.empty() ? "" : ":") + where;
  if (!out.empty()) out += ": ";
  return out + error.text;
}

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "conformance/generator/keep_case.h"

#include <filesystem>

#include "conformance/sha256.h"
#include "conformance/temporary_folder.h"

namespace afx::conformance {

namespace {

using nlohmann::json;

std::span<const uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

}  // namespace

Status keep_case(const std::string& folder, const std::string& name, const std::string& about,
                 const KeptCase& kept) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) return Error{Errc::io, Place::none(), failure.message(), {}, folder};
  const std::string stream = name + "." + (kept.kind == "octree" ? "afx" : kept.kind);
  if (Status put = write_whole_file(folder + "/" + stream, kept.stream); !put.ok()) return put;
  json checks = json::array();
  for (const KeptCheck& one : kept.checks) {
    checks.push_back(one.check);
    if (one.expected.is_null()) continue;
    const std::string file = name + "-" + std::to_string(checks.size()) + ".json";
    const std::string text = one.expected.dump() + "\n";
    if (Status put = write_whole_file(folder + "/" + file, bytes_of(text)); !put.ok()) return put;
    checks.back()["file"] = file;
    checks.back()["sha256"] = sha256(bytes_of(text));
  }
  const json suite = {
      {"suite", name},
      {"title", "A case of the generator"},
      {"origins", {{"generator", {{"text", "made by the generator"}, {"licence", "CC0-1.0"}}}}},
      {"cases",
       {{{"name", name},
         {"about", about},
         {"kind", kept.kind},
         {"stream", stream},
         {"sha256", sha256(kept.stream)},
         {"origin", "generator"},
         {"expect", checks}}}}};
  const std::string text = suite.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
  return write_whole_file(folder + "/suite.json", bytes_of(text));
}

}  // namespace afx::conformance

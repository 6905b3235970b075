// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Decoding against decoded.json, which an independent reader made.
#include "bifs/decoded_json.h"
#include "bifs/decoder.h"
#include "bifs/vectors_test_support.h"

namespace afx::bifs {

namespace {

using nlohmann::json;

/// The first difference between two documents, as a path; empty if there is none. Numbers are equal
/// if they are the same binary64, or, below the normal range of binary32, the same binary32: the
/// reader printed more digits there than the shortest form has.
std::string difference(const json& a, const json& b, const std::string& path) {
  if (a.is_number() && b.is_number()) {
    const double x = a.get<double>();
    const double y = b.get<double>();
    const bool denormal = std::abs(x) < 1.2e-38 && std::abs(x) > 1e-46;
    if (x == y || (denormal && static_cast<float>(x) == static_cast<float>(y))) return {};
    return path + ": " + a.dump() + " and " + b.dump();
  }
  if (a.type() != b.type()) return path + ": " + a.dump() + " and " + b.dump();
  if (a.is_object()) {
    for (const auto& [key, value] : a.items()) {
      if (!b.contains(key)) return path + "/" + key + " is missing";
      const std::string found = difference(value, b[key], path + "/" + key);
      if (!found.empty()) return found;
    }
    for (const auto& [key, value] : b.items())
      if (!a.contains(key)) return path + "/" + key + " is too much";
    return {};
  }
  if (a.is_array()) {
    if (a.size() != b.size())
      return path + ": " + std::to_string(a.size()) + " and " + std::to_string(b.size());
    for (size_t i = 0; i < a.size(); ++i) {
      const std::string found = difference(a[i], b[i], path + "/" + std::to_string(i));
      if (!found.empty()) return found;
    }
    return {};
  }
  return a == b ? std::string{} : path + ": " + a.dump() + " and " + b.dump();
}

}  // namespace

class BifsVectors : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, BifsVectors, testing::ValuesIn(vector_names()),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return "n" + name;
                         });

TEST(BifsVectorSet, HasAllThirtySevenVectors) { EXPECT_EQ(vector_names().size(), 37U); }

TEST_P(BifsVectors, TheConfigurationIsAsDecoded) {
  const BifsVector vector = load_vector(GetParam());
  EXPECT_EQ(difference(vector.decoded["config"], json::parse(config_json(vector.config)), ""), "");
}

TEST_P(BifsVectors, TheConfigurationIsWrittenBackToTheSameBytes) {
  const BifsVector vector = load_vector(GetParam());
  const auto written = write_config(vector.config);
  ASSERT_TRUE(written.ok());
  const auto path =
      std::filesystem::path(AFX_SOURCE_DIR) / "conformance/bifs" / GetParam() / "cfg.bin";
  EXPECT_EQ(written.value(), file_bytes(path));
}

TEST_P(BifsVectors, EveryAccessUnitDecodesToTheValuesOfTheIndependentReader) {
  const BifsVector vector = load_vector(GetParam());
  BifsDecoder decoder(vector.config);
  CommandJsonWriter writer;
  for (size_t i = 0; i < vector.units.size(); ++i) {
    const json& expected = vector.decoded["accessUnits"][i];
    json commands = json::array();
    const auto sink = [&](const Command& command, const nodes::Scene& scene) {
      commands.push_back(json::parse(writer.write(command, scene)));
    };
    Diagnostics diagnostics;
    const auto frame = decoder.decode(vector.units[i], diagnostics, sink);
    const std::string unit = "/" + std::to_string(i);
    if (expected.contains("error")) {
      ASSERT_FALSE(frame.ok());
      EXPECT_EQ(frame.error().code, Errc::truncated);
      EXPECT_EQ(frame.error().place, Place::at_bit(expected["bit"].get<uint64_t>()));
      continue;
    }
    ASSERT_TRUE(frame.ok()) << to_string(frame.error());
    EXPECT_EQ(difference(expected["commands"], commands, unit), "");
    EXPECT_EQ(frame.value().bits_used, expected["bitsUsed"].get<uint64_t>());
  }
}

}  // namespace afx::bifs

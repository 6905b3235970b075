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
  const auto path = std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac" /
                    GetParam() / "cfg.bin";
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

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Encoding against the bits that GPAC's MP4Box made of the same scenes.
#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "bifs/vectors_test_support.h"

namespace afx::bifs {

namespace {

/// Vectors whose bits are not those of the values they decode to
/// (conformance/suites/bifs-gpac/README.md).
constexpr const char* kNotTheSame[] = {
    "18-quant-efficient-float",    // a denormal whose 14 bits are 0 is coded as if it were not 0
    "19-quant-normals-rotations",  // the peer codes the wrong angle
    "33-peer-proto-id-clash"};     // cannot be decoded

std::string bits(const Bytes& bytes) {
  std::string text;
  for (const uint8_t byte : bytes)
    for (int bit = 7; bit >= 0; --bit) text += (byte >> bit & 1) != 0 ? '1' : '0';
  return text;
}

std::string first_difference(const Bytes& expected, const Bytes& found) {
  const std::string a = bits(expected);
  const std::string b = bits(found);
  size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  if (at == a.size() && at == b.size()) return {};
  const size_t from = at < 16 ? 0 : at - 16;
  return "bit " + std::to_string(at) + ": expected " + a.substr(from, 60) + ", found " +
         b.substr(from, 60);
}

std::vector<std::string> encodable() {
  std::vector<std::string> names = vector_names();
  for (const char* name : kNotTheSame) std::erase(names, name);
  return names;
}

}  // namespace

class BifsReencoding : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, BifsReencoding, testing::ValuesIn(encodable()),
                         [](const auto& param) {
                           std::string name = param.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return "n" + name;
                         });

TEST_P(BifsReencoding, TheDecodedCommandsGiveTheSameBitsAgain) {
  const BifsVector vector = load_vector(GetParam());
  BifsDecoder decoder(vector.config);
  BifsEncoder encoder(vector.config);
  for (size_t i = 0; i < vector.units.size(); ++i) {
    const auto sink = [&](const Command& command, const nodes::Scene& scene) {
      const Status added = encoder.add(command, scene);
      EXPECT_TRUE(added.ok()) << to_string(added.error());
    };
    Diagnostics diagnostics;
    const auto frame = decoder.decode(vector.units[i], diagnostics, sink);
    ASSERT_TRUE(frame.ok()) << to_string(frame.error());
    const auto bytes = encoder.finish();
    ASSERT_TRUE(bytes.ok()) << to_string(bytes.error());
    EXPECT_EQ(first_difference(vector.units[i], bytes.value()), "") << "access unit " << i;
  }
}

}  // namespace afx::bifs

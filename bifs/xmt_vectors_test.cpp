// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// XMT-A against the vectors: what GPAC wrote of them is read to what they decode to; what is
// written of them is read to the same commands and gives the same bits.
#include <gmock/gmock.h>

#include "bifs/decoded_json.h"
#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "bifs/vectors_test_support.h"
#include "bifs/xmt_reader.h"
#include "bifs/xmt_writer.h"

namespace afx::bifs {

namespace {

using nlohmann::json;

/// Denormals of binary32 have fewer digits than either side prints.
bool near_enough(double a, double b, double tolerance) {
  return a == b || static_cast<float>(a) == static_cast<float>(b) ||
         std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

/// The first difference between two documents, as a path; empty if there is none.
std::string difference(const json& a, const json& b, double tolerance, const std::string& path) {
  if (a.is_number() && b.is_number() && near_enough(a.get<double>(), b.get<double>(), tolerance))
    return {};
  if (a.type() != b.type() || !a.is_structured() || a.size() != b.size())
    return a == b ? std::string() : path + ": " + a.dump() + " and " + b.dump();
  for (const auto& [key, value] : a.items()) {
    const json other = a.is_array() ? b[std::stoul(key)] : b.value(key, json());
    const std::string found = difference(value, other, tolerance, path + "/" + key);
    if (!found.empty()) return found;
  }
  return {};
}

/// Without the names of nodes and ROUTEs, which streams without USENAMES do not have.
void drop_names(json& value) {
  if (value.is_object() && (value.contains("node") || value.contains("from"))) value.erase("name");
  for (auto& inner : value)
    if (inner.is_structured()) drop_names(inner);
}

/// What a sink hears: the commands as JSON, by time, and the bits that they encode to.
class Listener final : public PresentationSink {
 public:
  explicit Listener(const BifsConfig& config) : encoder_(config) {}

  Status begin(const InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t time, bool random_access) override {
    json unit = {{"time", time}, {"commands", json::array()}};
    if (random_access) unit["rap"] = true;
    units.push_back(std::move(unit));
    encoded_ = {};
    return {};
  }
  Status add(const Command& command, const nodes::Scene& before) override {
    units.back()["commands"].push_back(json::parse(writer_.write(command, before)));
    const Status added = encoder_.add(command, before);
    if (!added.ok()) encoded_ = added;
    return {};
  }
  Status end_frame() override {
    const auto frame = encoder_.finish();
    bits.push_back(frame.ok() && encoded_.ok() ? frame.value() : Bytes{});
    return {};
  }
  Status object_descriptors(uint64_t, bool, const OdCommands&) override { return {}; }
  Status end() override { return {}; }

  json units = json::array();
  std::vector<Bytes> bits;

 private:
  CommandJsonWriter writer_;
  BifsEncoder encoder_;
  Status encoded_;
};

/// Decodes a vector into a sink, as far as it can be decoded.
void decode_into(const BifsVector& vector, PresentationSink& sink) {
  BifsDecoder decoder(vector.config);
  InitialObjectDescriptor initial;
  initial.in_file = false;
  ASSERT_TRUE(sink.begin(initial).ok());
  for (size_t i = 0; i < vector.units.size(); ++i) {
    const json& unit = vector.decoded["accessUnits"][i];
    if (unit.contains("error")) break;
    ASSERT_TRUE(sink.begin_frame(unit["time"], i == 0).ok());
    Diagnostics warnings;
    const auto frame = decoder.decode(vector.units[i], warnings,
                                      [&](const Command& command, const nodes::Scene& scene) {
                                        const Status told = sink.add(command, scene);
                                        EXPECT_TRUE(told.ok()) << to_string(told.error());
                                      });
    ASSERT_TRUE(frame.ok());
    ASSERT_TRUE(sink.end_frame().ok());
  }
  ASSERT_TRUE(sink.end().ok());
}

std::filesystem::path peer_file(const std::string& name) {
  return std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac" / name / "gpac.xmt";
}

std::string text_of_file(const std::filesystem::path& path) {
  const Bytes bytes = file_bytes(path);
  return {bytes.begin(), bytes.end()};
}

constexpr double kSixDigits = 6e-6;  // the significant ones that GPAC writes

/// What GPAC's text of a vector has lost, so that it cannot be read.
struct Refused {
  const char* name;
  uint32_t line;  ///< where reading stops
  const char* text;
};
constexpr Refused kRefused[] = {
    {"21-proto-basic", 97, "there is a PROTO 'Proto0' already"},  // every PROTO is called Proto0
    {"22-proto-nested", 59, "there is a PROTO 'Proto0' already"},
    {"23-externproto", 40, "there is a PROTO 'Proto0' already"},
    {"33-peer-proto-id-clash", 38, "there is a PROTO 'Proto0' already"},
    {"27-strings-utf8", 36, "'&#55348;' is no character"},  // surrogates: no well-formed XML
};

/// The vectors with a text of GPAC that can be read.
std::vector<std::string> readable_peer_files() {
  std::vector<std::string> names;
  for (const std::string& name : vector_names()) {
    const bool refused = std::any_of(std::begin(kRefused), std::end(kRefused),
                                     [&](const Refused& row) { return row.name == name; });
    if (!refused && std::filesystem::exists(peer_file(name))) names.push_back(name);
  }
  return names;
}

/// GPAC lays scripts out anew.
void drop_script_space(json& value) {
  if (value.is_object() && value.contains("javascript")) {
    auto text = value["javascript"].get<std::string>();
    std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
    value["javascript"] = text;
  }
  for (auto& inner : value)
    if (inner.is_structured()) drop_script_space(inner);
}

void drop_normals(json& value) {
  for (const char* field :
       {"vector", "direction", "rotation", "orientation", "axisOfRotation", "keyValue"})
    if (value.is_object()) value.erase(field);
  for (auto& inner : value)
    if (inner.is_structured()) drop_normals(inner);
}

/// Takes away what GPAC's texts do not have right.
void forgive(const std::string& name, size_t unit, json& commands) {
  drop_script_space(commands);
  // A command that is not in the stream.
  if (name == "29-script-conditional" && unit == 1 && commands.size() == 3) commands.erase(2);
  // Normals and rotations with a negative component: another value.
  if (name == "19-quant-normals-rotations") drop_normals(commands);
}

std::string name_of_test(const testing::TestParamInfo<std::string>& param) {
  std::string name = param.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return "n" + name;
}

}  // namespace

class XmtVectors : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, XmtVectors, testing::ValuesIn(vector_names()), name_of_test);

TEST_P(XmtVectors, WhatIsWrittenIsReadToTheSameCommandsAndBits) {
  const BifsVector vector = load_vector(GetParam());
  std::string text;
  XmtWriter writer([&](std::string_view piece) {
    text += piece;
    return Status{};
  });
  decode_into(vector, writer);
  Listener decoded(vector.config), read(vector.config);
  decode_into(vector, decoded);

  Diagnostics warnings;
  auto presentation = read_xmt(text, {}, warnings);
  ASSERT_TRUE(presentation.ok()) << to_string(presentation.error()) << "\n" << text;
  EXPECT_EQ(warnings.count(), 0U);
  const bool use_names = !decoded.units.empty() && decoded.units[0]["commands"][0]["useNames"];
  ASSERT_TRUE(play(presentation.value(), read, warnings).ok());
  if (!use_names) drop_names(read.units);
  EXPECT_EQ(difference(decoded.units, read.units, 0, ""), "") << text;
  EXPECT_EQ(decoded.bits, read.bits);
}

TEST_P(XmtVectors, WhatIsReadIsWrittenTheSameAgain) {
  std::string first, second;
  const auto append_to = [](std::string& text) {
    return [&text](std::string_view piece) {
      text += piece;
      return Status{};
    };
  };
  XmtWriter writer(append_to(first)), again(append_to(second));
  decode_into(load_vector(GetParam()), writer);
  Diagnostics warnings;
  auto presentation = read_xmt(first, {}, warnings);
  ASSERT_TRUE(presentation.ok()) << to_string(presentation.error());
  ASSERT_TRUE(play(presentation.value(), again, warnings).ok());
  // A decode has no header, and what a text has is that of the default.
  EXPECT_EQ(first, second);
}

class PeerXmt : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, PeerXmt, testing::ValuesIn(readable_peer_files()), name_of_test);

TEST_P(PeerXmt, IsReadToWhatTheVectorDecodesTo) {
  const BifsVector vector = load_vector(GetParam());
  Diagnostics warnings;
  auto presentation = read_xmt(text_of_file(peer_file(GetParam())), {}, warnings);
  ASSERT_TRUE(presentation.ok()) << to_string(presentation.error());
  Listener read(vector.config);
  ASSERT_TRUE(play(presentation.value(), read, warnings).ok());
  const auto& expected = vector.decoded["accessUnits"];
  ASSERT_EQ(read.units.size(), expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(read.units[i]["time"], expected[i]["time"]);
    if (!expected[0]["commands"][0]["useNames"]) drop_names(read.units[i]["commands"]);
    json wanted = expected[i]["commands"];
    forgive(GetParam(), i, wanted);
    forgive(GetParam(), i, read.units[i]["commands"]);
    EXPECT_EQ(difference(wanted, read.units[i]["commands"], kSixDigits, ""), "");
  }
}

TEST(PeerXmtThatIsNoneOrAmbiguous, IsRefusedWhereItIs) {
  for (const Refused& row : kRefused) {
    Diagnostics warnings;
    const auto read = read_xmt(text_of_file(peer_file(row.name)), {}, warnings);
    ASSERT_FALSE(read.ok()) << row.name;
    EXPECT_EQ(read.error().code, Errc::malformed) << row.name;
    EXPECT_EQ(read.error().place.line, row.line) << row.name;
    EXPECT_THAT(read.error().text, testing::HasSubstr(row.text)) << row.name;
  }
}

}  // namespace afx::bifs

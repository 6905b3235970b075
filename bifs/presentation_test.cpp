// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Text to streams and back, against the streams that GPAC's MP4Box made of the same texts.
#include "bifs/bt_reader.h"
#include "bifs/bt_writer.h"
#include "bifs/decoded_json.h"
#include "bifs/encoding_setup.h"
#include "bifs/mp4_presentation_reader.h"
#include "bifs/mp4_presentation_writer.h"
#include "bifs/mp4_reader.h"
#include "bifs/mp4_writer.h"
#include "bifs/raw_bifs_writer.h"
#include "bifs/vectors_test_support.h"

namespace afx::bifs {

namespace {

std::vector<std::string> vectors_without(std::string_view left_out) {
  std::vector<std::string> names = vector_names();
  std::erase(names, left_out);
  return names;
}

std::string text_of(const std::filesystem::path& path) {
  const Bytes bytes = file_bytes(path);
  return {bytes.begin(), bytes.end()};
}

std::filesystem::path folder_of(const std::string& name) {
  return std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac" / name;
}

nodes::SceneReadOptions with_files(const std::string& name) {
  nodes::SceneReadOptions options;
  options.like_gpac = true;
  options.load_file = [name](std::string_view file) -> Result<std::string> {
    return text_of(folder_of(name) / std::string(file));
  };
  return options;
}

Presentation read_scene_bt(const std::string& name, const EncodingChoices& choices) {
  Diagnostics diagnostics;
  auto read = read_bt(text_of(folder_of(name) / "scene.bt"), {}, diagnostics, with_files(name));
  EXPECT_TRUE(read.ok()) << to_string(read.error());
  if (!read.ok()) return {};
  const Status ready = set_up_encoding(read.value(), choices, diagnostics);
  EXPECT_TRUE(ready.ok()) << to_string(ready.error());
  return std::move(read).value();
}

/// Commands as JSON, access unit by access unit.
class JsonSink final : public PresentationSink {
 public:
  std::vector<std::string> units;
  Status begin(const InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t time, bool) override {
    units.push_back(std::to_string(time) + ":");
    return {};
  }
  Status add(const Command& command, const nodes::Scene& before) override {
    units.back() += "\n" + writer_.write(command, before);
    return {};
  }
  Status end_frame() override { return {}; }
  Status object_descriptors(uint64_t, bool, const OdCommands&) override { return {}; }
  Status end() override { return {}; }

 private:
  CommandJsonWriter writer_;
};

/// Streams that a text takes from an MP4 file: from those bytes, whatever it is called.
LoadMedia media_of(const Bytes& file) {
  return [&file](const MediaSource& source) -> Result<Media> {
    Diagnostics diagnostics;
    const auto movie =
        std::make_shared<Mp4Movie>(read_mp4(mp4_source(file), {}, diagnostics).value());
    const auto id =
        static_cast<uint32_t>(std::stoul(source.file.substr(source.file.find('#') + 1)));
    const Mp4Track* const track = find_track(*movie, id);
    if (track == nullptr) return Error{Errc::io, Place::none(), "no such track"};
    return Media{*track, [&file, movie, track](size_t sample) {
                   return read_sample(mp4_source(file), *track, sample, {});
                 }};
  };
}

Bytes to_mp4(Presentation& presentation, const EncodingChoices& choices, const LoadMedia& media) {
  Bytes out;
  const Mp4Sink keep = [&out](std::span<const uint8_t> part) -> Status {
    out.insert(out.end(), part.begin(), part.end());
    return {};
  };
  Mp4PresentationWriter writer(keep, {encode_options(choices), media});
  Diagnostics diagnostics;
  const Status done = play(presentation, writer, diagnostics);
  EXPECT_TRUE(done.ok()) << to_string(done.error());
  return out;
}

Mp4Movie movie_of(const Bytes& file) {
  Diagnostics diagnostics;
  auto movie = read_mp4(mp4_source(file), {}, diagnostics);
  EXPECT_TRUE(movie.ok()) << to_string(movie.error());
  return movie.ok() ? std::move(movie).value() : Mp4Movie{};
}

template <class Sink>
nodes::Scene decode_to(const Bytes& file, Sink& sink) {
  Diagnostics diagnostics;
  PresentationDecodeOptions options;
  options.file_name = "x.mp4";
  auto scene = decode_presentation(mp4_source(file), movie_of(file), options, &sink, diagnostics);
  EXPECT_TRUE(scene.ok()) << to_string(scene.error());
  return scene.ok() ? std::move(scene).value() : nodes::Scene();
}

std::string to_bt(const Bytes& file) {
  std::string text;
  BtWriter writer([&text](std::string_view piece) -> Status {
    text += piece;
    return {};
  });
  decode_to(file, writer);
  return text;
}

std::vector<std::string> to_json(const Bytes& file) {
  JsonSink sink;
  decode_to(file, sink);
  return sink.units;
}

/// All samples of all tracks, by track ID.
std::map<uint32_t, std::vector<Bytes>> streams_of(const Bytes& file) {
  std::map<uint32_t, std::vector<Bytes>> streams;
  const Mp4Movie movie = movie_of(file);
  for (const Mp4Track& track : movie.tracks)
    for (size_t i = 0; i < track.samples.size(); ++i)
      streams[track.id].push_back(read_sample(mp4_source(file), track, i, {}).value());
  return streams;
}

}  // namespace

std::string test_name(const testing::TestParamInfo<std::string>& vector) {
  std::string name = vector.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return "n" + name;
}

/// 19: the peer codes the wrong angles (conformance/suites/bifs-gpac/README.md).
class EncodedLikeGpac : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, EncodedLikeGpac,
                         testing::ValuesIn(vectors_without("19-quant-normals-rotations")),
                         test_name);

/// 33: the peer's file cannot be decoded.
class ThroughText : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, ThroughText,
                         testing::ValuesIn(vectors_without("33-peer-proto-id-clash")), test_name);

TEST_P(EncodedLikeGpac, TheTextGivesTheConfigurationAndTheBitsOfGpac) {
  using enum EncodingChoices::Names;
  const EncodingChoices choices{.like_gpac = true,
                                .names = GetParam() == "30-names" ? always : automatic};
  Presentation presentation = read_scene_bt(GetParam(), choices);
  Diagnostics diagnostics;
  RawBifsWriter writer(encode_options(choices), diagnostics);
  const Status done = play(presentation, writer, diagnostics);
  ASSERT_TRUE(done.ok()) << to_string(done.error());
  const BifsVector vector = load_vector(GetParam());
  EXPECT_EQ(writer.scene().config, file_bytes(folder_of(GetParam()) / "cfg.bin"));
  ASSERT_EQ(writer.scene().units.size(), vector.units.size());
  for (size_t i = 0; i < vector.units.size(); ++i) {
    EXPECT_EQ(writer.scene().units[i].bytes, vector.units[i]) << "access unit " << i;
    EXPECT_EQ(writer.scene().units[i].time, vector.decoded["accessUnits"][i]["time"]);
  }
}

TEST_P(ThroughText, TheJsonOfTheFileIsThatOfTheIndependentReader) {
  const Bytes file = file_bytes(std::filesystem::path(AFX_SOURCE_DIR) /
                                "conformance/suites/bifs-gpac" / GetParam() / "scene.mp4");
  std::string text;
  const nodes::TextSink keep = [&text](std::string_view piece) -> Status {
    text += piece;
    return {};
  };
  Diagnostics diagnostics;
  PresentationDecodeOptions options;
  options.drop_coding_quantizers = false;
  const Status done = decode_as_json(mp4_source(file), movie_of(file), options, keep, diagnostics);
  ASSERT_TRUE(done.ok()) << to_string(done.error());
  EXPECT_EQ(difference(load_vector(GetParam()).decoded, nlohmann::json::parse(text), ""), "");
}

TEST_P(ThroughText, FromTheSecondTimeOnTheStreamsAreTheSame) {
  const EncodingChoices choices;
  Bytes file = file_bytes(std::filesystem::path(AFX_SOURCE_DIR) / "conformance/suites/bifs-gpac" /
                          GetParam() / "scene.mp4");
  std::vector<Bytes> files = {file};
  std::vector<std::string> texts;
  for (int round = 0; round < 3; ++round) {
    texts.push_back(to_bt(files.back()));
    Diagnostics diagnostics;
    auto read = read_bt(texts.back(), {}, diagnostics);
    ASSERT_TRUE(read.ok()) << to_string(read.error()) << "\n" << texts.back();
    ASSERT_TRUE(set_up_encoding(read.value(), choices, diagnostics).ok());
    const Bytes last = files.back();
    files.push_back(to_mp4(read.value(), choices, media_of(last)));
  }
  EXPECT_EQ(texts[1], texts[2]);
  EXPECT_EQ(streams_of(files[1]), streams_of(files[2]));
  EXPECT_EQ(files[2], files[3]);
  const bool quantized_wrong = GetParam() == "19-quant-normals-rotations";  // the peer's angles
  const bool protos_wrong = GetParam() == "22-proto-nested";                // IDs cut to one bit
  if (quantized_wrong || protos_wrong) return;
  EXPECT_EQ(to_json(files[0]), to_json(files[1]));
}

// The buffer is read when the command is whole, and the body of the PROTO has ended then.
TEST(CommandBuffers, InAProtoBodySpeakOfTheNodesThere) {
  Diagnostics diagnostics;
  auto read = read_bt(
      "PROTO P [] { Group { children [ DEF A Transform {} DEF C Conditional { buffer {\n"
      "REPLACE A.scale BY 1 2 3 } } ] } } DEF A Group {}",
      {}, diagnostics);
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  ASSERT_TRUE(set_up_encoding(read.value(), {}, diagnostics).ok());
  RawBifsWriter writer({}, diagnostics);
  ASSERT_TRUE(play(read.value(), writer, diagnostics).ok());
  const auto bytes = write_raw_bifs(writer.scene());
  ASSERT_TRUE(bytes.ok());
  const auto scene = decode_presentation(
      mp4_source(bytes.value()), movie_of_raw_bifs(writer.scene()), {}, nullptr, diagnostics);
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  const auto& body = scene.value().scope(scene.value().proto(nodes::ProtoId{0U}).body);
  const auto* conditional = scene.value().find<nodes::CommandBuffer>(body.names.at("C"), "buffer");
  const auto* buffer = dynamic_cast<const BufferedCommands*>(conditional->content.get());
  ASSERT_NE(buffer, nullptr);
  ASSERT_EQ(buffer->commands.size(), 1U);
  EXPECT_EQ(std::get<FieldReplacement>(buffer->commands[0]).target.node, body.names.at("A"));
}

TEST(Samples, ThatCannotBeReadAreNamedOnceWithTheirPlaceInThisFile) {
  const Bytes file = file_bytes(folder_of("24-commands-basic") / "scene.mp4");
  Mp4Movie movie = movie_of(file);
  const auto error_of = [&](const Mp4Source& source) {
    Diagnostics diagnostics;
    const auto scene = decode_presentation(source, movie, {}, nullptr, diagnostics);
    return scene.ok() ? Error{} : scene.error();
  };
  const uint64_t begin = movie.tracks[0].samples[0].offset;
  const Error cut = error_of(mp4_source(std::span(file).first(begin)));
  EXPECT_EQ(cut.place, Place::at_byte(begin));
  EXPECT_EQ(cut.text,
            "track 1, sample 0: it ends behind the file of " + std::to_string(begin) + " bytes");
  movie.tracks[0].entries[0].in_this_file = false;
  const Error elsewhere = error_of(mp4_source(file));
  EXPECT_EQ(elsewhere.place, Place::none());
  EXPECT_EQ(elsewhere.text, "track 1, sample 0: it lies in another file, which is not read");
}

}  // namespace afx::bifs

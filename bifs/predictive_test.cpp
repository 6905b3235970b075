// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Predictive MF fields in frames: every category in every mode, by hand, cut off and damaged.
#include <bit>
#include <cmath>
#include <random>
#include <set>

#include "bifs/decoded_json.h"
#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "bifs/predictive_encoder.h"
#include "bifs/vectors_test_support.h"

namespace afx::bifs {

namespace {

using nodes::NodeId;
using nodes::Scene;
using Codes = std::vector<QuantizedDirection>;

constexpr size_t kPoints = 40;

BifsConfig predictive_config() {
  BifsConfig config;
  config.version = 2;
  config.use_predictive_field = true;
  return config;
}

EncodeOptions predictively() {
  EncodeOptions options;
  options.predictive = true;
  return options;
}

std::string text(const Bytes& bytes, size_t size) {
  std::string out;
  for (size_t i = 0; i < size; ++i) out += (bytes[i / 8] >> (7 - i % 8) & 1) != 0 ? '1' : '0';
  return out;
}
std::string text(const std::vector<bool>& bits) {
  std::string out;
  for (const bool bit : bits) out += bit ? '1' : '0';
  return out;
}
std::string number(uint64_t value, unsigned bits) {
  std::string out;
  for (unsigned bit = bits; bit-- > 0;) out += (value >> bit & 1) != 0 ? '1' : '0';
  return out;
}
/// Without the blanks between the elements.
std::string dense(std::string bits) {
  std::erase(bits, ' ');
  return bits;
}
Bytes bytes(const std::string& bits) {
  Bytes out((bits.size() + 7) / 8);
  for (size_t i = 0; i < bits.size(); ++i)
    if (bits[i] == '1') out[i / 8] = static_cast<uint8_t>(out[i / 8] | 0x80U >> i % 8);
  return out;
}

/// A list in a scene and how it is quantized there.
struct Sample {
  const char* name;
  PredictiveLayout layout;
  Codes codes;
  NodeId node;
  std::string field;

  /// The plain form in its vector shape, from usePredictive on.
  [[nodiscard]] std::string plain() const {
    const unsigned width = static_cast<unsigned>(std::bit_width(codes.size()));
    std::string out = "000" + number(width, 5) + number(codes.size(), width);
    for (const QuantizedDirection& code : codes) {
      if (layout.has_sign()) out += code.negative ? '1' : '0';
      if (layout.is_direction()) out += number(code.orientation, 2);
      for (size_t i = 0; i < layout.components; ++i) out += number(code.components[i], layout.bits);
    }
    return out;
  }
};

/// A scene with lists of all types and categories that are quantized, all of them smooth.
class PredictiveScene {
 public:
  PredictiveScene() {
    group_ = add("Group");
    add_quantizer();
    add_shapes();
    add_interpolators();
    const NodeId image = child("OctreeImage");
    std::vector<int32_t> octree(kPoints);
    for (size_t i = 0; i < kPoints; ++i) octree[i] = 100 + static_cast<int32_t>(i * i / 20);
    put("integer 13", image, "octree", octree, {1, 8}, [](int32_t v) { return one(v); });
    set(image, "voxelImageIndex", std::vector<int32_t>(5, 3));  // a plain rest of the frame
  }

  [[nodiscard]] std::vector<Command> commands() const {
    SceneReplacement command;
    command.root = group_;
    return {command};
  }
  Scene scene;
  std::vector<Sample> samples;

 private:
  struct Form {
    size_t bounds;
    unsigned bits;
  };

  NodeId add(const char* type) { return scene.add(type).value(); }
  NodeId child(const char* type) {
    const NodeId node = add(type);
    EXPECT_TRUE(scene.append(group_, "children", node).ok());
    return node;
  }
  template <class T>
  void set(NodeId node, const char* field, const T& value) {
    EXPECT_TRUE(scene.set(node, field, value).ok()) << field;
  }

  template <class T, class CodesOf>
  void put(const char* name, NodeId node, const char* field, const std::vector<T>& list, Form form,
           CodesOf codes_of) {
    set(node, field, list);
    const auto& definition = *scene.node(node).definition;
    ElementCoding coding;
    coding.kind = std::string(name).starts_with("normal")     ? ElementCoding::Kind::normal
                  : std::string(name).starts_with("rotation") ? ElementCoding::Kind::rotation
                  : std::is_same_v<T, int32_t>                ? ElementCoding::Kind::integer
                                                              : ElementCoding::Kind::linear;
    coding.bits = form.bits;
    const PredictiveLayout layout(definition.field(definition.find(field)), coding);
    EXPECT_EQ(layout.bounds, form.bounds) << name;
    Sample sample{name, layout, {}, node, field};
    for (const T& element : list) sample.codes.push_back(codes_of(element));
    samples.push_back(sample);
  }

  static QuantizedDirection one(int32_t code) {
    return {false, 0, {static_cast<uint32_t>(code), 0, 0}};
  }
  static QuantizedDirection linear(std::initializer_list<float> values, float lo, float hi,
                                   unsigned bits) {
    QuantizedDirection out;
    size_t i = 0;
    for (const float v : values) out.components[i++] = quantize(v, lo, hi, bits);
    return out;
  }

  void add_quantizer() {
    const NodeId quantizer = child("QuantizationParameter");
    for (const char* on : {"position3DQuant", "position2DQuant", "colorQuant", "keyQuant",
                           "textureCoordinateQuant", "normalQuant", "sizeQuant"})
      set(quantizer, on, true);
    set(quantizer, "position3DMin", glm::vec3(-2));
    set(quantizer, "position3DMax", glm::vec3(2));
    set(quantizer, "position3DNbBits", int32_t{10});
    set(quantizer, "position2DMin", glm::vec2(-2));
    set(quantizer, "position2DMax", glm::vec2(2));
    set(quantizer, "position2DNbBits", int32_t{9});
    set(quantizer, "sizeMin", 0.0F);
    set(quantizer, "sizeMax", 4.0F);
    set(quantizer, "sizeNbBits", int32_t{12});
    set(quantizer, "normalNbBits", int32_t{7});
  }

  template <class T, class F>
  static std::vector<T> list_of(F f) {
    std::vector<T> list;
    for (size_t i = 0; i < kPoints; ++i) list.push_back(f(0.17F * static_cast<float>(i)));
    return list;
  }

  void add_shapes() {
    const auto shape = [&](const char* geometry) {
      const NodeId node = add(geometry);
      set(child("Shape"), "geometry", node);
      return node;
    };
    const NodeId grid = shape("ElevationGrid");
    put("linear 11", grid, "height", list_of<float>([](float t) { return 2 + std::sin(t); }),
        {1, 12}, [](float v) { return linear({v}, 0, 4, 12); });
    const NodeId faces = shape("IndexedFaceSet");
    const auto part = [&](NodeId node, const char* field, const char* type) {
      const NodeId made = add(type);
      set(node, field, made);
      return made;
    };
    put("linear 4", part(faces, "color", "Color"), "color",
        list_of<glm::vec3>([](float t) { return glm::vec3(t / 7, 1 - t / 7, 0.5F); }), {1, 8},
        [](const glm::vec3& v) {
          return linear({v.x, v.y, v.z}, 0, 1, 8);
        });
    put("linear 1", part(faces, "coord", "Coordinate"), "point",
        list_of<glm::vec3>([](float t) { return glm::vec3(std::cos(t), std::sin(t), t / 5); }),
        {3, 10}, [](const glm::vec3& v) {
          return linear({v.x, v.y, v.z}, -2, 2, 10);
        });
    auto normals =
        list_of<glm::vec3>([](float t) { return glm::vec3(std::cos(t), std::sin(t), 0.3F); });
    for (size_t i = 10; i < kPoints; i += 10) normals[i] = -normals[i];
    put("normal 9", part(faces, "normal", "Normal"), "vector", normals, {1, 7},
        [](const glm::vec3& v) { return quantize_normal(v, 7); });
    put("linear 5", part(faces, "texCoord", "TextureCoordinate"), "point",
        list_of<glm::vec2>([](float t) { return glm::vec2(t / 7, t * t / 49); }), {1, 16},
        [](const glm::vec2& v) {
          return linear({v.x, v.y}, 0, 1, 16);
        });
    std::vector<int32_t> index(kPoints);
    for (size_t i = 0; i < kPoints; ++i) index[i] = i % 4 == 3 ? -1 : static_cast<int32_t>(i);
    put("integer 14", faces, "coordIndex", index, {1, 6}, [](int32_t v) { return one(v + 1); });
    const NodeId flat = shape("IndexedFaceSet2D");
    put("linear 2", part(flat, "coord", "Coordinate2D"), "point",
        list_of<glm::vec2>([](float t) { return glm::vec2(std::cos(t), std::sin(t)); }), {2, 9},
        [](const glm::vec2& v) {
          return linear({v.x, v.y}, -2, 2, 9);
        });
  }

  void add_interpolators() {
    const NodeId turning = child("OrientationInterpolator");
    put("linear 8", turning, "key", list_of<float>([](float t) { return t / 7; }), {1, 8},
        [](float v) { return linear({v}, 0, 1, 8); });
    put("rotation 10", turning, "keyValue", list_of<nodes::Rotation>([](float t) {
          return nodes::Rotation{0.6F, 0.8F, 0, t};
        }),
        {1, 7}, [](const nodes::Rotation& v) { return quantize_rotation(v, 7); });
  }

  NodeId group_;
};

const PredictivePlan kPlans[] = {{IntraMode::first, 0, 13},       {IntraMode::periodic, 1, 13},
                                 {IntraMode::periodic, 7, 13},    {IntraMode::periodic, 20, 13},
                                 {IntraMode::periodic, 1000, 13}, {IntraMode::flagged, 0, 0},
                                 {IntraMode::flagged, 0, 2},      {IntraMode::flagged, 0, 13}};

Result<CommandFrame> decode_bytes(const Bytes& frame, Scene* scene = nullptr,
                                  Diagnostics* diagnostics = nullptr, const Limits& limits = {},
                                  const codec::Trace* trace = nullptr) {
  Diagnostics unheard;
  BifsDecoder decoder(predictive_config(), limits);
  auto result = decoder.decode(frame, diagnostics != nullptr ? *diagnostics : unheard, {}, trace);
  if (scene != nullptr) *scene = decoder.take_scene();
  return result;
}

/// The commands of a frame as text, floats to the last bit.
std::string json_of(const Bytes& frame) {
  std::string json;
  CommandJsonWriter writer;
  Diagnostics diagnostics;
  BifsDecoder decoder(predictive_config());
  const auto decoded = decoder.decode(
      frame, diagnostics,
      [&](const Command& command, const Scene& scene) { json += writer.write(command, scene); });
  EXPECT_TRUE(decoded.ok()) << to_string(decoded.error());
  return json;
}

/// The frame of the scene with all lists plain, as bits without padding.
struct PlainFrame {
  PredictiveScene input;
  std::string json;
  std::string bits;

  PlainFrame() {
    EncodeOptions options;
    options.lists = EncodeOptions::Form::compact;
    BifsEncoder encoder(predictive_config(), options);
    const auto frame = encode_frame(encoder, input.scene, input.commands());
    EXPECT_TRUE(frame.ok()) << to_string(frame.error());
    const auto commands = decode_bytes(frame.value());
    EXPECT_TRUE(commands.ok()) << to_string(commands.error());
    json = json_of(frame.value());
    bits = text(frame.value(), commands.value().bits_used);
  }

  /// The frame with other bits from usePredictive of this list on.
  [[nodiscard]] std::string with(const Sample& sample, const std::string& other) const {
    const std::string plain = sample.plain();
    const size_t at = bits.find(plain);
    EXPECT_NE(at, std::string::npos) << sample.name;
    EXPECT_EQ(bits.find(plain, at + 1), std::string::npos) << sample.name;
    return bits.substr(0, at) + dense(other) + bits.substr(at + plain.size());
  }

  [[nodiscard]] const Sample& sample(const std::string& name) const {
    for (const Sample& s : input.samples)
      if (s.name == name) return s;
    ADD_FAILURE() << name;
    return input.samples.front();
  }

  /// The octree of the frame with these bits behind usePredictive 1.
  [[nodiscard]] Result<CommandFrame> decode_octree(const std::string& coded,
                                                   Scene* scene = nullptr) const {
    return decode_bytes(bytes(with(sample("integer 13"), "1" + coded)), scene);
  }
};

std::vector<int32_t> octree_of(const Scene& scene) {
  for (size_t n = 0; n < scene.node_count(); ++n) {
    const NodeId id{static_cast<uint32_t>(n)};
    if (scene.node(id).definition->name == "OctreeImage")
      return scene.get<std::vector<int32_t>>(id, "octree");
  }
  return {};
}

Codes integers(std::initializer_list<uint32_t> values) {
  Codes codes;
  for (const uint32_t v : values) codes.push_back({false, 0, {v, 0, 0}});
  return codes;
}

}  // namespace

TEST(PredictiveFields, EveryCategoryInEveryModeDecodesToWhatThePlainFormDoes) {
  const PlainFrame plain;
  EXPECT_EQ(plain.input.samples.size(), 10U);
  for (const Sample& sample : plain.input.samples) {
    for (const PredictivePlan& plan : kPlans) {
      const std::string about = std::string(sample.name) + " mode " +
                                std::to_string(static_cast<int>(plan.mode)) + " " +
                                std::to_string(plan.period + plan.window_bits);
      const auto coded = encode_predictive(sample.layout, sample.codes, plan);
      ASSERT_TRUE(coded) << about;
      const std::string frame = plain.with(sample, "1" + text(*coded));
      Diagnostics diagnostics;
      const auto decoded = decode_bytes(bytes(frame), nullptr, &diagnostics);
      ASSERT_TRUE(decoded.ok()) << about << " " << to_string(decoded.error());
      EXPECT_EQ(decoded.value().bits_used, frame.size()) << about;
      EXPECT_TRUE(diagnostics.warnings().empty()) << about;
      EXPECT_EQ(json_of(bytes(frame)), plain.json) << about;
    }
  }
}

TEST(PredictiveFields, HaveTheBitsWorkedOutByHand) {
  const PlainFrame plain;
  const PredictiveLayout& layout = plain.sample("integer 13").layout;
  // count 3 in 2 bits, mode 0, compNbBits 0, compMin 1 + 256 in 9 bits, first value 10; each
  // residual is 1, the only symbol: no bits, and 01 at the end.
  const auto ramp = encode_predictive(layout, integers({10, 11, 12}), {});
  ASSERT_TRUE(ramp);
  EXPECT_EQ(text(*ramp), dense("00010 11 00 00000 100000001 00001010 01"));
  // Residuals 1 and -1: 2 bits from -1. Symbol 2 of {1, 1, 1, 1} is [16384, 32767]: 01. Symbol 0 of
  // {1, 1, 2, 1} is [52428, 65535]: 11 and then [13104, 65535]. The end: below 16384, 01.
  const auto peak = encode_predictive(layout, integers({10, 11, 10}), {});
  ASSERT_TRUE(peak);
  EXPECT_EQ(text(*peak), dense("00010 11 00 00010 011111111 00001010 011101"));
  Scene scene;
  ASSERT_TRUE(plain.decode_octree(text(*peak), &scene).ok());
  EXPECT_EQ(octree_of(scene), (std::vector<int32_t>{10, 11, 10}));
  // Period 2: the values 10, 11 | 200, 203; the second period has new parameters, 3 + 256.
  const auto periods =
      encode_predictive(layout, integers({10, 11, 200, 203}), {IntraMode::periodic, 2, 13});
  ASSERT_TRUE(periods);
  EXPECT_EQ(
      text(*periods),
      dense("00011 100 01 00010 10 00000 100000001 00001010 01 1 00000 100000011 11001000 01"));
  // A flag before each value: 0 of {1, 1} is 1; then 1 of {2, 1} is [0, 21844], 0 and [0, 43689];
  // the end 01. The new value has a 0 for its parameters.
  const auto jump = encode_predictive(layout, integers({10, 11, 200}), {IntraMode::flagged, 0, 2});
  ASSERT_TRUE(jump);
  EXPECT_EQ(text(*jump), dense("00010 11 10 00000 100000001 00001010 1001 0 11001000"));
}

TEST(PredictiveFields, OfNoneOrOneValueHaveNoArithmeticCode) {
  const PlainFrame plain;
  Scene scene;
  const auto none = plain.decode_octree("00000 00 00000 100000000", &scene);
  ASSERT_TRUE(none.ok()) << to_string(none.error());
  EXPECT_TRUE(octree_of(scene).empty());
  const auto one = plain.decode_octree("00001 1 00 00000 100000000 01001101", &scene);
  ASSERT_TRUE(one.ok()) << to_string(one.error());
  EXPECT_EQ(octree_of(scene), (std::vector<int32_t>{77}));
}

TEST(PredictiveFields, EachBadFieldIsRefused) {
  const PlainFrame plain;
  PredictiveLayout wide = plain.sample("integer 13").layout;
  const std::string out_of_range = text(*encode_predictive(wide, integers({0, 200, 400}), {}));
  const struct {
    std::string coded;
    const char* text;
  } cases[] = {
      {"00010 11 11", "intraMode is 3, which is reserved"},
      {"00010 11 01 00000", "the intra period is 0"},
      {"00010 11 00 01110", "compNbBits is 14"},
      {"00010 11 00 11111", "compNbBits is 31"},
      {out_of_range, "a predicted value is outside the range of the quantizer"},
  };
  for (const auto& bad : cases) {
    const auto frame = plain.decode_octree(bad.coded);
    ASSERT_FALSE(frame.ok()) << bad.text;
    EXPECT_EQ(frame.error().code, Errc::malformed);
    EXPECT_NE(frame.error().text.find(bad.text), std::string::npos) << frame.error().text;
    EXPECT_NE(frame.error().text.find("octree/PredictiveMFField"), std::string::npos);
  }
}

TEST(PredictiveFields, OfAValueOutOfRangeAreMalformedAlsoWhereTheDataEndBehindTheirWholeCode) {
  const PlainFrame plain;
  const Sample& octree = plain.sample("integer 13");
  const std::string coded = text(*encode_predictive(octree.layout, integers({0, 200, 400}), {}));
  const size_t end = plain.bits.find(octree.plain()) + 1 + coded.size();
  const std::string frame = plain.with(octree, "1" + coded).substr(0, end);
  const auto refused = decode_bytes(bytes(frame));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Errc::malformed) << to_string(refused.error());
  EXPECT_NE(refused.error().text.find("outside the range"), std::string::npos);
}

TEST(PredictiveFields, ThatAreNotQuantizedAreRefused) {
  Scene scene;
  SceneReplacement command;
  command.root = scene.add("Group").value();
  const NodeId image = scene.add("OctreeImage").value();
  ASSERT_TRUE(scene.append(command.root, "children", image).ok());
  ASSERT_TRUE(scene.set(image, "octree", std::vector<int32_t>{1, 2, 3, 4}).ok());
  BifsEncoder encoder(predictive_config(), predictively());
  const auto frame = encode_frame(encoder, scene, {command});
  ASSERT_TRUE(frame.ok());
  ASSERT_TRUE(decode_bytes(frame.value()).ok());
  // usePredictive, reserved, isList and the first endFlag stand before the value 1 of 32 bits.
  std::string bits = text(frame.value(), frame.value().size() * 8);
  const size_t at = bits.find("0010" + number(1, 32));
  ASSERT_NE(at, std::string::npos);
  bits[at] = '1';
  const auto refused = decode_bytes(bytes(bits));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, Errc::malformed);
  EXPECT_NE(refused.error().text.find("a field that is not quantized"), std::string::npos);
}

TEST(PredictiveFields, ValuesAndModelsWithoutBitsAreLimited) {
  const PlainFrame plain;
  const Sample& octree = plain.sample("integer 13");
  // 2^30 values of the only residual 0, in a few bits.
  const std::string many =
      "1 11111" + number(uint32_t{1} << 30, 31) + "00 00000 100000000 00000000 01";
  const auto values = decode_bytes(bytes(plain.with(octree, many)));
  ASSERT_FALSE(values.ok());
  EXPECT_EQ(values.error().code, Errc::limit_exceeded);
  // New models of 2^13 symbols for every second value.
  std::string renewed = "1" + number(12, 5) + number(2000, 12) + "01 00010 10";
  const std::string parameters = "01101 000000000";
  for (int i = 0; i < 1000; ++i)
    renewed += (i == 0 ? "" : "1") + parameters + number(100, 8) + number(0x1FFF - 256, 13) + "01";
  ASSERT_TRUE(decode_bytes(bytes(plain.with(octree, renewed))).ok());
  Limits limits;
  limits.scene_values = 100000;
  const auto models = decode_bytes(bytes(plain.with(octree, renewed)), nullptr, nullptr, limits);
  ASSERT_FALSE(models.ok());
  EXPECT_EQ(models.error().code, Errc::limit_exceeded) << to_string(models.error());
}

TEST(PredictiveFields, EveryTruncationIsAnErrorInside) {
  const PlainFrame plain;
  const PredictivePlan plans[] = {
      {IntraMode::first, 0, 13}, {IntraMode::periodic, 7, 13}, {IntraMode::flagged, 0, 2}};
  for (const Sample& sample : plain.input.samples) {
    if (std::string(sample.name) == "integer 13") continue;  // the last: few bits follow it
    for (const PredictivePlan& plan : plans) {
      const auto coded = encode_predictive(sample.layout, sample.codes, plan);
      ASSERT_TRUE(coded);
      const Bytes whole = bytes(plain.with(sample, "1" + text(*coded)));
      const size_t begin = plain.bits.find(sample.plain()) / 8;
      for (size_t size = begin; size <= begin + coded->size() / 8 + 1; ++size) {
        const auto end = whole.begin() + static_cast<ptrdiff_t>(size);
        const auto cut = decode_bytes(Bytes(whole.begin(), end));
        ASSERT_FALSE(cut.ok()) << sample.name << " " << size;
        ASSERT_LE(cut.error().place.bit, size * 8) << sample.name;
        ASSERT_EQ(cut.error().code, Errc::truncated) << sample.name << to_string(cut.error());
      }
    }
  }
}

TEST(PredictiveFields, DamagedOnesAreAFrameOrAnErrorWithAPlace) {
  const PlainFrame plain;
  std::mt19937 random(5);
  Limits limits;
  limits.memory = 1 << 24;
  limits.scene_values = 1 << 18;
  for (const Sample& sample : plain.input.samples) {
    for (const PredictivePlan& plan : kPlans) {
      const auto coded = encode_predictive(sample.layout, sample.codes, plan);
      const std::string frame = plain.with(sample, "1" + text(*coded));
      const size_t begin = plain.bits.find(sample.plain());
      for (int round = 0; round < 25; ++round) {
        std::string damaged = frame;
        for (unsigned i = 0; i <= random() % 3; ++i) {
          char& bit = damaged[begin + random() % coded->size()];
          bit = bit == '0' ? '1' : '0';
        }
        const auto decoded = decode_bytes(bytes(damaged), nullptr, nullptr, limits);
        if (decoded.ok()) continue;
        EXPECT_EQ(decoded.error().place.kind, Place::Kind::bit);
        EXPECT_LE(decoded.error().place.bit, damaged.size() + 7);
        EXPECT_NE(decoded.error().text.find("commandFrame"), std::string::npos);
      }
    }
  }
}

TEST(PredictiveFields, AnEndThatNoEncoderWritesIsAWarning) {
  const PlainFrame plain;
  // The ramp of HaveTheBitsWorkedOutByHand with 11 in place of 01, which still is in the interval.
  Scene scene;
  Diagnostics diagnostics;
  const std::string frame =
      plain.with(plain.sample("integer 13"), "1 00010 11 00 00000 100000001 00001010 11");
  const auto decoded = decode_bytes(bytes(frame), &scene, &diagnostics);
  ASSERT_TRUE(decoded.ok()) << to_string(decoded.error());
  EXPECT_EQ(octree_of(scene), (std::vector<int32_t>{10, 11, 12}));
  ASSERT_EQ(diagnostics.warnings().size(), 1U);
  EXPECT_EQ(diagnostics.warnings()[0].code, "residual_ending");
}

TEST(PredictiveFields, AreTracedElementByElementWithoutGaps) {
  const PlainFrame plain;
  const Sample& octree = plain.sample("integer 13");
  const auto coded = encode_predictive(octree.layout, octree.codes, {IntraMode::periodic, 7, 13});
  const std::string frame = plain.with(octree, "1" + text(*coded));
  std::set<std::string> names;
  uint64_t next = 0;
  const codec::Trace trace = [&](const codec::TraceElement& element) {
    EXPECT_TRUE(element.width == 0 || element.bit == next) << element.path;
    EXPECT_EQ(number(element.value, element.width),
              frame.substr(element.bit, element.width) +
                  std::string(element.bit + element.width > frame.size()
                                  ? element.bit + element.width - frame.size()
                                  : 0,
                              '0'));
    next = element.bit + element.width;
    const size_t part = element.path.find("PredictiveMFField/");
    if (part != std::string_view::npos) names.insert(std::string(element.path.substr(part + 18)));
  };
  ASSERT_TRUE(decode_bytes(bytes(frame), nullptr, nullptr, {}, &trace).ok());
  EXPECT_EQ(names, (std::set<std::string>{"nbBits", "count", "intraMode", "periodNbBits", "period",
                                          "compNbBits", "compMin", "component", "newParameters",
                                          "residuals"}));
}

TEST(PredictiveEncoding, IsShorterForSmoothListsAndGivesTheSameValues) {
  const PlainFrame plain;
  PredictiveScene input;
  BifsEncoder encoder(predictive_config(), predictively());
  const auto frame = encode_frame(encoder, input.scene, input.commands());
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  EXPECT_LT(frame.value().size() * 10, bytes(plain.bits).size() * 8);
  EXPECT_EQ(json_of(frame.value()), plain.json);
}

TEST(PredictiveEncoding, IsLeftAloneWhereNothingIsGainedOrAllowed) {
  const auto encode = [](const BifsConfig& config, const EncodeOptions& options, bool noise) {
    PredictiveScene input;
    std::mt19937 random(3);
    if (noise) {
      for (const Sample& sample : input.samples) {
        if (std::string(sample.name) != "integer 13") continue;
        std::vector<int32_t> octree(kPoints);
        for (int32_t& v : octree) v = static_cast<int32_t>(random() % 256);
        EXPECT_TRUE(input.scene.set(sample.node, "octree", octree).ok());
        EXPECT_TRUE(input.scene.set(sample.node, "voxelImageIndex", std::vector<int32_t>{}).ok());
        SceneReplacement command;
        command.root = input.scene.add("Group").value();
        const NodeId quantizer = input.scene.add("QuantizationParameter").value();
        EXPECT_TRUE(input.scene.append(command.root, "children", quantizer).ok());
        EXPECT_TRUE(input.scene.append(command.root, "children", sample.node).ok());
        BifsEncoder encoder(config, options);
        return encode_frame(encoder, input.scene, {command}).value();
      }
    }
    BifsEncoder encoder(config, options);
    return encode_frame(encoder, input.scene, input.commands()).value();
  };
  BifsConfig plain_config = predictive_config();
  plain_config.use_predictive_field = false;
  EXPECT_EQ(encode(plain_config, predictively(), false), encode(plain_config, {}, false));
  EXPECT_LT(encode(predictive_config(), predictively(), false).size(),
            encode(predictive_config(), {}, false).size());
  EXPECT_EQ(encode(predictive_config(), predictively(), true),
            encode(predictive_config(), {}, true));
}

TEST(PredictiveEncoding, OfTheVectorsDecodesToTheSameCommands) {
  for (const std::string& name : vector_names()) {
    if (name.starts_with("33") || name.starts_with("19")) continue;  // cannot be coded again
    const BifsVector vector = load_vector(name);
    BifsConfig config = vector.config;
    config.version = 2;
    config.use_predictive_field = true;
    BifsDecoder decoder(vector.config), again(config);
    BifsEncoder encoder(config, predictively()), plain(vector.config);
    BifsDecoder plain_again(vector.config);
    for (const Bytes& unit : vector.units) {
      const auto sink = [&](const Command& command, const Scene& scene) {
        EXPECT_TRUE(encoder.add(command, scene).ok()) << name;
        EXPECT_TRUE(plain.add(command, scene).ok()) << name;
      };
      Diagnostics diagnostics;
      ASSERT_TRUE(decoder.decode(unit, diagnostics, sink).ok()) << name;
      const auto json_of = [&](BifsDecoder& reader, const Result<Bytes>& frame) {
        std::string json;
        CommandJsonWriter writer;
        const auto write = [&](const Command& command, const Scene& scene) {
          json += writer.write(command, scene);
        };
        const auto decoded = reader.decode(frame.value(), diagnostics, write);
        EXPECT_TRUE(decoded.ok()) << name << " " << to_string(decoded.error());
        return json;
      };
      EXPECT_EQ(json_of(again, encoder.finish()), json_of(plain_again, plain.finish())) << name;
    }
  }
}

}  // namespace afx::bifs

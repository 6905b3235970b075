// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/quantize_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "bifs/quantizer.h"

namespace afx::bifs {

namespace {

using nodes::NodeId;
using nodes::Scene;
using Bytes = std::vector<uint8_t>;
using Points = std::vector<glm::vec3>;
using Indices = std::vector<int32_t>;

BifsConfig four_bits() {
  BifsConfig config;
  config.node_id_bits = 4;
  return config;
}

Points random_points(size_t count, float lo, float hi) {
  std::mt19937 generator(7);
  const auto next = [&] {
    const double unit = static_cast<double>(generator()) / 4294967295.0;
    return std::clamp(static_cast<float>(lo + (double{hi} - lo) * unit), lo, hi);
  };
  Points points(count);
  for (glm::vec3& point : points) {
    point.x = next();
    point.y = next() / 2;
    point.z = next() / 4;
  }
  return points;
}

/// A Shape with an IndexedFaceSet of 100 points, colours and texture coordinates in a Group.
struct Sample {
  Presentation presentation;
  NodeId root, faces, coord, color;

  explicit Sample(uint32_t root_id = 0) {
    Scene& scene = presentation.scene;
    root = scene.add("Group").value();
    scene.node(root).id = root_id;
    faces = scene.add("IndexedFaceSet").value();
    coord = scene.add("Coordinate").value();
    color = scene.add("Color").value();
    const NodeId shape = scene.add("Shape").value();
    set(coord, "point", random_points(100, -5, 11));
    set(color, "color", random_points(100, 0, 1));
    set(faces, "coord", coord);
    set(faces, "color", color);
    set(faces, "coordIndex", Indices{0, 99, 50, -1, 3, 2, 1, -1});
    set(faces, "colorIndex", Indices{0, 98, 50, -1, 3, 2, 1, -1});
    set(shape, "geometry", faces);
    EXPECT_TRUE(scene.append(root, "children", shape).ok());
    SceneReplacement begin;
    begin.root = root;
    add_frame({begin});
  }
  void set(NodeId node, const char* field, nodes::FieldValue value) {
    const Status done = presentation.scene.set(node, field, std::move(value));
    EXPECT_TRUE(done.ok()) << done.error().text;
  }
  void add_frame(std::vector<Command> commands) {
    AccessUnit unit;
    unit.commands = std::move(commands);
    presentation.units.push_back(std::move(unit));
  }
  [[nodiscard]] FieldRef ref(NodeId node, const char* field) const {
    return {node, presentation.scene.node(node).definition->find(field)};
  }
  QuantizeReport quantize(const QuantizeOptions& options = {}) {
    const auto report = quantize_scene(presentation, options);
    EXPECT_TRUE(report.ok()) << to_string(report.error());
    return report.ok() ? report.value() : QuantizeReport{};
  }
  /// The frames; the scene is then as it is at the end.
  std::vector<Bytes> encode() {
    BifsEncoder encoder(four_bits());
    std::vector<Bytes> frames;
    for (const AccessUnit& unit : presentation.units) {
      const auto bytes =
          encode_frame(encoder, presentation.scene, std::get<std::vector<Command>>(unit.commands));
      EXPECT_TRUE(bytes.ok()) << to_string(bytes.error());
      frames.push_back(bytes.ok() ? bytes.value() : Bytes{});
    }
    return frames;
  }
};

Scene decode(const std::vector<Bytes>& frames) {
  BifsDecoder decoder(four_bits());
  Diagnostics diagnostics;
  for (const Bytes& bytes : frames) {
    const auto frame = decoder.decode(bytes, diagnostics);
    EXPECT_TRUE(frame.ok()) << to_string(frame.error());
  }
  EXPECT_TRUE(diagnostics.warnings().empty());
  return decoder.take_scene();
}

/// The last node of a type that the decoder met.
NodeId node_of(const Scene& scene, const std::string& type) {
  NodeId found;
  for (size_t i = 0; i < scene.node_count(); ++i)
    if (scene.type_name(NodeId{i}) == type) found = NodeId{i};
  EXPECT_TRUE(found.valid()) << type;
  return found;
}

const QuantizedField& row(const QuantizeReport& report, const std::string& node) {
  static const QuantizedField kNone;
  for (const QuantizedField& field : report.fields)
    if (field.node == node) return field;
  ADD_FAILURE() << "no row of " << node;
  return kNone;
}

std::string reason(const QuantizeReport& report, const std::string& category) {
  for (const UnquantizedCategory& one : report.left_out)
    if (one.category == category) return one.reason;
  return {};
}

double greatest_difference(const Points& a, const Points& b) {
  EXPECT_EQ(a.size(), b.size());
  double greatest = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    for (int c = 0; c < 3; ++c)
      greatest = std::max(greatest, std::abs(double{a[i][c]} - double{b[i][c]}));
  return greatest;
}

size_t size(const std::vector<Bytes>& frames) {
  size_t sum = 0;
  for (const Bytes& bytes : frames) sum += bytes.size();
  return sum;
}

}  // namespace

TEST(QuantizeScene, EveryDecodedValueIsWithinItsStatedBoundAndTheErrorIsAsReported) {
  Sample sample;
  const Points points = sample.presentation.scene.get<Points>(sample.coord, "point");
  const Points colors = sample.presentation.scene.get<Points>(sample.color, "color");
  const QuantizeReport report = sample.quantize();
  const Scene decoded = decode(sample.encode());
  const double point_error =
      greatest_difference(points, decoded.get<Points>(node_of(decoded, "Coordinate"), "point"));
  const double color_error =
      greatest_difference(colors, decoded.get<Points>(node_of(decoded, "Color"), "color"));
  const QuantizedField& coordinate = row(report, "Coordinate");
  EXPECT_EQ(coordinate.category, "position3D");
  EXPECT_EQ(coordinate.field, "point");
  EXPECT_EQ(coordinate.values, 100U);
  EXPECT_EQ(coordinate.bits, 16U);
  EXPECT_EQ(coordinate.largest_error, point_error);
  EXPECT_LE(point_error, coordinate.bound);
  EXPECT_GT(point_error, coordinate.bound / 2);  // a hundred values come near
  // No component is wider than 16: half a step is at most 16 / 65535 / 2.
  EXPECT_LE(coordinate.bound, 16.0 / 65535 / 2 + 20e-6);
  const QuantizedField& color = row(report, "Color");
  EXPECT_EQ(color.bits, 8U);
  EXPECT_EQ(color.largest_error, color_error);
  EXPECT_LE(color_error, color.bound);
  EXPECT_LE(color.bound, 1.0 / 255 / 2 + 2e-6);
}

TEST(QuantizeScene, DecodedValuesLieOnTheGridOfTheFormulaInLongDouble) {
  Sample sample;
  const Points points = sample.presentation.scene.get<Points>(sample.coord, "point");
  (void)sample.quantize();
  const Scene decoded = decode(sample.encode());
  const auto& back = decoded.get<Points>(node_of(decoded, "Coordinate"), "point");
  for (int c = 0; c < 3; ++c) {
    long double lo = points[0][c];
    long double hi = lo;
    for (const glm::vec3& point : points) {
      lo = std::min<long double>(lo, point[c]);
      hi = std::max<long double>(hi, point[c]);
    }
    const long double step = (hi - lo) / 65535;
    for (size_t i = 0; i < points.size(); ++i) {
      const long double code = std::round((back[i][c] - lo) / step);
      ASSERT_NEAR(static_cast<double>(lo + step * code), back[i][c], 2e-6);  // on the grid
      // The nearest point of it, or nearly so: binary32 moves a code by 3 % of a step.
      ASSERT_LE(std::abs(points[i][c] - lo - step * code), 0.53L * step);
    }
  }
}

TEST(QuantizeScene, AComponentWithoutBoundsIsNotLost) {
  for (const float weight : {1.0F, 0.0F}) {
    Sample sample;
    Scene& scene = sample.presentation.scene;
    const NodeId print = scene.add("FootPrintSetNode").value();
    const NodeId curve = scene.add("NurbsCurve2D").value();
    Points points = random_points(100, 0, 8);
    for (glm::vec3& point : points) point.z = weight;
    sample.set(curve, "controlPoint", points);
    EXPECT_TRUE(scene.append(print, "children", curve).ok());
    EXPECT_TRUE(scene.append(sample.root, "children", print).ok());
    const std::string expected =
        "NurbsCurve2D.controlPoint: a component for which position2DMin and Max have no number";
    EXPECT_EQ(reason(sample.quantize(), "position2D"), weight == 1 ? expected : "");
    const Scene decoded = decode(sample.encode());
    for (const glm::vec3& point :
         decoded.get<Points>(node_of(decoded, "NurbsCurve2D"), "controlPoint"))
      EXPECT_EQ(point.z, weight);
  }
}

TEST(QuantizeScene, TheStreamIsLessThanTwoThirdsAsLong) {
  Sample plain;
  Sample quantized;
  (void)quantized.quantize();
  // 300 numbers of 32 bits become 16, 300 become 8; the quantizer takes some 500 bits.
  EXPECT_LT(size(quantized.encode()) * 3, size(plain.encode()) * 2);
}

TEST(QuantizeScene, IndicesStayExact) {
  Sample sample;
  (void)sample.quantize();
  const Scene decoded = decode(sample.encode());
  const NodeId faces = node_of(decoded, "IndexedFaceSet");
  EXPECT_EQ(decoded.get<Indices>(faces, "coordIndex"), (Indices{0, 99, 50, -1, 3, 2, 1, -1}));
  EXPECT_EQ(decoded.get<Indices>(faces, "colorIndex"), (Indices{0, 98, 50, -1, 3, 2, 1, -1}));
}

TEST(QuantizeScene, AnIntegerThatDoesNotFitIsRefused) {
  Sample sample;
  sample.set(sample.faces, "colorIndex", Indices{0, 128, -1});
  const size_t nodes = sample.presentation.scene.node_count();
  const auto report = quantize_scene(sample.presentation);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().code, Errc::bad_argument);
  EXPECT_NE(report.error().text.find("IndexedFaceSet: an integer that cannot be coded"),
            std::string::npos);
  EXPECT_EQ(sample.presentation.scene.node_count(), nodes);
}

TEST(QuantizeScene, AQuantizerThatIsThereAlreadyIsRefused) {
  Sample sample;
  const NodeId own = sample.presentation.scene.add("QuantizationParameter").value();
  ASSERT_TRUE(sample.presentation.scene.append(sample.root, "children", own).ok());
  const auto in_scene = quantize_scene(sample.presentation);
  ASSERT_FALSE(in_scene.ok());
  EXPECT_NE(in_scene.error().text.find("has quantizers already"), std::string::npos);
  Sample global;
  const NodeId node = global.presentation.scene.add("QuantizationParameter").value();
  global.add_frame({GlobalQuantizer{node}});
  EXPECT_FALSE(quantize_scene(global.presentation).ok());
}

TEST(QuantizeScene, TheQuantizerIsTheFirstChildOfTheRoot) {
  Sample sample;
  (void)sample.quantize();
  const Scene& scene = sample.presentation.scene;
  const auto& children = scene.get<std::vector<NodeId>>(sample.root, "children");
  ASSERT_EQ(children.size(), 2U);
  ASSERT_TRUE(is_quantizer(scene, children[0]));
  EXPECT_TRUE(scene.get<bool>(children[0], "position3DQuant"));
  EXPECT_TRUE(scene.get<bool>(children[0], "colorQuant"));
  EXPECT_FALSE(scene.get<bool>(children[0], "normalQuant"));
  EXPECT_FALSE(scene.get<bool>(children[0], "keyQuant"));
}

TEST(QuantizeScene, CommandsThatCountTheRootsChildrenStillMeanTheSame) {
  Sample sample(1);
  sample.add_frame({IndexedValueDeletion{sample.ref(sample.root, "children"), {}}});
  (void)sample.quantize();
  const Scene decoded = decode(sample.encode());
  const auto& top = decoded.get<std::vector<NodeId>>(decoded.roots()[0], "children");
  ASSERT_EQ(top.size(), 2U);
  EXPECT_TRUE(is_quantizer(decoded, top[0]));
  EXPECT_TRUE(decoded.get<std::vector<NodeId>>(top[1], "children").empty());
}

TEST(QuantizeScene, LaterCommandsAreQuantizedAlike) {
  Sample sample;
  sample.presentation.scene.node(sample.coord).id = 3;
  const Points moved = random_points(100, -50, 20);
  sample.add_frame({FieldReplacement{sample.ref(sample.coord, "point"), moved}});
  const QuantizeReport report = sample.quantize();
  EXPECT_EQ(report.commands_left_out, "");
  const QuantizedField& coordinate = row(report, "Coordinate");
  EXPECT_EQ(coordinate.values, 200U);
  const std::vector<Bytes> frames = sample.encode();
  EXPECT_LT(frames[1].size(), 620U);  // 300 numbers of 16 bits
  const Scene decoded = decode(frames);
  const double error =
      greatest_difference(moved, decoded.get<Points>(node_of(decoded, "Coordinate"), "point"));
  EXPECT_LE(error, coordinate.bound);
  EXPECT_GT(error, 0);
}

TEST(QuantizeScene, ASecondSceneIsQuantizedToo) {
  Sample sample;
  Scene& scene = sample.presentation.scene;
  const Points points = random_points(100, 20, 30);
  const NodeId coord = scene.add("Coordinate").value();
  const NodeId set = scene.add("PointSet").value();
  const NodeId shape = scene.add("Shape").value();
  SceneReplacement second;
  second.root = scene.add("OrderedGroup").value();
  sample.set(coord, "point", points);
  sample.set(set, "coord", coord);
  sample.set(shape, "geometry", set);
  ASSERT_TRUE(scene.append(second.root, "children", shape).ok());
  sample.add_frame({second});
  const QuantizeReport report = sample.quantize();
  const std::vector<Bytes> frames = sample.encode();
  EXPECT_LT(frames[1].size(), 700U);  // 600 bytes of values, and the quantizer
  const Scene decoded = decode(frames);
  EXPECT_LE(
      greatest_difference(points, decoded.get<Points>(node_of(decoded, "Coordinate"), "point")),
      row(report, "Coordinate").bound);
  // Its fields may count its children: the quantizer stands in a root around it.
  const auto& children = decoded.get<std::vector<NodeId>>(decoded.roots()[0], "children");
  ASSERT_EQ(children.size(), 2U);
  EXPECT_TRUE(is_quantizer(decoded, children[0]));
  EXPECT_EQ(decoded.type_name(children[1]), "OrderedGroup");
}

TEST(QuantizeScene, ANodeThatComesWithTwoScenesIsRefused) {
  Sample sample;
  SceneReplacement again;
  again.root = sample.root;
  sample.add_frame({again});
  const auto report = quantize_scene(sample.presentation);
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().text.find("comes with two scenes"), std::string::npos);
}

TEST(QuantizeScene, ANewNodeThatCountsOlderPointsLeavesTheCommandsExact) {
  Sample sample(1);
  Scene& scene = sample.presentation.scene;
  scene.node(sample.coord).id = 3;
  const NodeId lines = scene.add("IndexedLineSet").value();
  const NodeId shape = scene.add("Shape").value();
  sample.set(lines, "coord", sample.coord);
  sample.set(lines, "coordIndex", Indices{0, 99, -1});
  sample.set(shape, "geometry", lines);
  sample.add_frame({FieldReplacement{sample.ref(sample.coord, "point"), Points(3)},
                    NodeInsertion{sample.root, {Position::Kind::last, 0}, shape}});
  EXPECT_NE(sample.quantize().commands_left_out.find("IndexedLineSet"), std::string::npos);
  const Scene decoded = decode(sample.encode());
  EXPECT_EQ(decoded.get<Indices>(node_of(decoded, "IndexedLineSet"), "coordIndex"),
            (Indices{0, 99, -1}));
}

TEST(QuantizeScene, CommandsWithIndicesAreLeftExact) {
  Sample sample;
  sample.presentation.scene.node(sample.coord).id = 3;
  sample.presentation.scene.node(sample.faces).id = 4;
  const Points moved = random_points(100, -50, 20);
  sample.add_frame({FieldReplacement{sample.ref(sample.coord, "point"), moved},
                    FieldReplacement{sample.ref(sample.faces, "set_coordIndex"), Indices{0, 1}}});
  const QuantizeReport report = sample.quantize();
  const bool has_category = sample.presentation.scene.node(sample.faces)
                                .definition->field(sample.ref(sample.faces, "set_coordIndex").field)
                                .quant_category != 0;
  EXPECT_EQ(report.commands_left_out.empty(), !has_category);
  const Scene decoded = decode(sample.encode());
  EXPECT_EQ(decoded.get<Indices>(node_of(decoded, "IndexedFaceSet"), "coordIndex"),
            (Indices{0, 1}));
}

TEST(QuantizeScene, AnIntegerOutOfRangeInACommandLeavesTheCommandsExact) {
  Sample sample;
  const NodeId chosen = sample.presentation.scene.add("Switch").value();
  ASSERT_TRUE(sample.presentation.scene.append(sample.root, "children", chosen).ok());
  sample.presentation.scene.node(chosen).id = 2;
  sample.presentation.scene.node(sample.coord).id = 3;
  const Points moved = random_points(100, -50, 20);
  sample.add_frame({FieldReplacement{sample.ref(sample.coord, "point"), moved},
                    FieldReplacement{sample.ref(chosen, "whichChoice"), 5000}});
  const QuantizeReport report = sample.quantize();
  EXPECT_NE(report.commands_left_out.find("Switch.whichChoice"), std::string::npos);
  EXPECT_EQ(row(report, "Coordinate").values, 100U);
  const Scene decoded = decode(sample.encode());
  EXPECT_EQ(decoded.get<Points>(node_of(decoded, "Coordinate"), "point"), moved);
}

TEST(QuantizeScene, ALargestErrorGivesTheFewestBitsThatKeepIt) {
  Sample sample;
  QuantizeOptions options;
  // A step of at most 2 / 1000 of the range: 1 / (2^9 - 1) is below that, 1 / (2^8 - 1) is not.
  options.categories["position3D"].largest_error = 0.001;
  EXPECT_EQ(row(sample.quantize(options), "Coordinate").bits, 9U);
  Sample fine;
  options.categories["position3D"].largest_error = 1e-9;
  const QuantizeReport report = fine.quantize(options);
  EXPECT_NE(reason(report, "position3D").find("31 bits do not reach"), std::string::npos);
}

TEST(QuantizeScene, WhatCodingCannotHoldStaysOffWithItsReason) {
  const float inf = std::numeric_limits<float>::infinity();
  Sample sample;
  Points points = random_points(100, -5, 11);
  points[50].y = inf;
  sample.set(sample.coord, "point", points);
  Points colors = random_points(100, 0, 1);
  colors[3].x = 1.5F;
  sample.set(sample.color, "color", colors);
  Scene& scene = sample.presentation.scene;
  const NodeId grid = scene.add("ElevationGrid").value();
  const NodeId shape = scene.add("Shape").value();
  sample.set(grid, "xDimension", 2);
  sample.set(shape, "geometry", grid);
  ASSERT_TRUE(scene.append(sample.root, "children", shape).ok());
  const QuantizeReport report = sample.quantize();
  EXPECT_NE(reason(report, "position3D").find("an infinity or NaN"), std::string::npos);
  EXPECT_NE(reason(report, "color").find("Color.color: a value outside"), std::string::npos);
  EXPECT_NE(reason(report, "size").find("xDimension holds integers"), std::string::npos);
  EXPECT_TRUE(report.fields.empty());
  EXPECT_EQ(scene.get<std::vector<NodeId>>(sample.root, "children").size(), 2U);  // unchanged
  const Scene decoded = decode(sample.encode());
  EXPECT_EQ(decoded.get<int32_t>(node_of(decoded, "ElevationGrid"), "xDimension"), 2);
}

TEST(QuantizeScene, FieldsWithoutBoundsAreOnlyForOthersThanGpac) {
  for (const bool for_gpac : {true, false}) {
    Sample sample;
    const NodeId animator = sample.presentation.scene.add("PositionAnimator").value();
    std::vector<float> keys(50);
    for (size_t i = 0; i < keys.size(); ++i) keys[i] = static_cast<float>(i) / 49;
    sample.set(animator, "key", keys);
    ASSERT_TRUE(sample.presentation.scene.append(sample.root, "children", animator).ok());
    QuantizeOptions options;
    options.for_gpac = for_gpac;
    const QuantizeReport report = sample.quantize(options);
    EXPECT_EQ(reason(report, "key").find("no bounds") != std::string::npos, for_gpac);
    const Scene decoded = decode(sample.encode());
    const auto& back = decoded.get<std::vector<float>>(node_of(decoded, "PositionAnimator"), "key");
    EXPECT_EQ(back == keys, for_gpac);
    for (size_t i = 0; i < keys.size(); ++i) EXPECT_NEAR(back[i], keys[i], 1.0 / 65535 / 2 + 2e-6);
  }
}

TEST(QuantizeScene, NormalsAreQuantizedForOthersThanGpac) {
  for (const bool for_gpac : {true, false}) {
    Sample sample;
    const NodeId normal = sample.presentation.scene.add("Normal").value();
    const Points vectors = random_points(100, -1, 1);
    sample.set(normal, "vector", vectors);
    sample.set(sample.faces, "normal", normal);
    QuantizeOptions options;
    options.for_gpac = for_gpac;
    const QuantizeReport report = sample.quantize(options);
    const Scene decoded = decode(sample.encode());
    const auto& back = decoded.get<Points>(node_of(decoded, "Normal"), "vector");
    if (for_gpac) {
      EXPECT_EQ(back, vectors);
      EXPECT_NE(reason(report, "normal").find("GPAC"), std::string::npos);
      continue;
    }
    double worst = 0;
    for (size_t i = 0; i < vectors.size(); ++i) {
      const glm::dvec3 a(vectors[i]);
      const glm::dvec3 b(back[i]);
      const double cosine = (a.x * b.x + a.y * b.y + a.z * b.z) / std::hypot(a.x, a.y, a.z) /
                            std::hypot(b.x, b.y, b.z);
      worst = std::max(worst, std::acos(std::min(cosine, 1.0)));
    }
    EXPECT_NEAR(row(report, "Normal").largest_error, worst, 1e-6);
    EXPECT_LE(worst, row(report, "Normal").bound);
    EXPECT_LT(row(report, "Normal").bound, 0.0005);
  }
}

TEST(QuantizeScene, ChoicesOutOfRangeAreRefused) {
  for (const unsigned bits : {0U, 32U}) {
    Sample sample;
    QuantizeOptions options;
    options.categories["color"].bits = bits;
    EXPECT_FALSE(quantize_scene(sample.presentation, options).ok());
  }
  Sample sample;
  QuantizeOptions options;
  options.categories["colour"] = {};
  const auto report = quantize_scene(sample.presentation, options);
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.error().text.find("no quantization category 'colour'"), std::string::npos);
}

TEST(QuantizeScene, ACategoryThatIsSwitchedOffOrHasTooLittleStaysExact) {
  Sample sample;
  sample.set(sample.color, "color", Points{{0.1F, 0.2F, 0.3F}});
  sample.set(sample.faces, "colorIndex", Indices{});
  QuantizeOptions options;
  options.categories["position3D"].on = false;
  const QuantizeReport report = sample.quantize(options);
  EXPECT_EQ(reason(report, "position3D"), "it is switched off");
  EXPECT_EQ(reason(report, "color"), "it would not make the stream shorter");
}

}  // namespace afx::bifs

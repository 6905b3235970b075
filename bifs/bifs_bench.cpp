// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scenes that are nearly all values, from commands to bits and back. The rows "by element" do the
// same work without runs of numbers: a trace hears every number that is decoded, and the list form
// has a bit before every element. A figure is the ratio of two rows of one run.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bifs/decoder.h"
#include "bifs/encoder.h"
#include "nodes/scene.h"

namespace afx::bifs {
namespace {

using nodes::NodeId;
using nodes::Scene;

std::vector<int32_t> integers(size_t count, uint32_t first, uint32_t range) {
  std::mt19937 random(1);
  std::vector<int32_t> list(count);
  for (int32_t& value : list) value = static_cast<int32_t>(first + random() % range);
  return list;
}

std::vector<glm::vec3> triples(size_t count) {
  std::mt19937 random(2);
  const auto unit = [&random] { return static_cast<float>(random()) / 4294967296.0F; };
  std::vector<glm::vec3> list(count);
  for (glm::vec3& value : list) value = {unit(), unit(), unit()};
  return list;
}

struct Model {
  std::string name;
  Scene scene;
  SceneReplacement command;
};

NodeId add(Scene& scene, const char* type) { return scene.add(type).value(); }

/// A scene begins with a grouping node.
NodeId grouped(Scene& scene, NodeId node) {
  const NodeId group = add(scene, "Group");
  (void)scene.append(group, "children", node);
  return group;
}

template <class Value>
void give(Scene& scene, NodeId node, const char* field, Value value) {
  (void)scene.set(node, field, std::move(value));
}

Model octree_image() {
  Model m{"OctreeImage", {}, {}};
  const NodeId image = add(m.scene, "OctreeImage");
  give(m.scene, image, "octree", integers(1'000'000, 1, 255));
  give(m.scene, image, "voxelImageIndex", integers(300'000, 0, 6));
  m.command.root = grouped(m.scene, image);
  return m;
}

Model point_texture() {
  Model m{"PointTexture", {}, {}};
  const NodeId image = add(m.scene, "DepthImage");
  const NodeId texture = add(m.scene, "PointTexture");
  give(m.scene, texture, "depth", integers(1'000'000, 0, 127));
  give(m.scene, texture, "color", triples(500'000));
  give(m.scene, image, "diTexture", texture);
  m.command.root = grouped(m.scene, image);
  return m;
}

Model face_set() {
  Model m{"IndexedFaceSet", {}, {}};
  const NodeId shape = add(m.scene, "Shape");
  const NodeId faces = add(m.scene, "IndexedFaceSet");
  const NodeId points = add(m.scene, "Coordinate");
  std::vector<int32_t> corners = integers(2'000'000, 0, 500'000);
  for (size_t i = 3; i < corners.size(); i += 4) corners[i] = -1;
  give(m.scene, points, "point", triples(500'000));
  give(m.scene, faces, "coordIndex", std::move(corners));
  give(m.scene, faces, "coord", points);
  give(m.scene, shape, "geometry", faces);
  m.command.root = grouped(m.scene, shape);
  return m;
}

std::vector<uint8_t> encoded(const Model& m, EncodeOptions::Form lists) {
  EncodeOptions options;
  options.lists = lists;
  BifsEncoder encoder(BifsConfig{}, options);
  (void)encoder.add(m.command, m.scene);
  return encoder.finish().value();
}

void count_bytes(benchmark::State& state, size_t bytes) {
  state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(bytes));
}

void encode(benchmark::State& state, const Model& m, EncodeOptions::Form lists) {
  size_t bytes = 0;
  for (auto _ : state) bytes = encoded(m, lists).size();
  count_bytes(state, bytes);
}

void decode(benchmark::State& state, const Model& m, const codec::Trace* trace) {
  const std::vector<uint8_t> bytes = encoded(m, EncodeOptions::Form::compact);
  for (auto _ : state) {
    Diagnostics diagnostics;
    BifsDecoder decoder(BifsConfig{});
    if (!decoder.decode(bytes, diagnostics, {}, trace).ok()) state.SkipWithError("not decoded");
  }
  count_bytes(state, bytes.size());
}

}  // namespace
}  // namespace afx::bifs

int main(int argc, char** argv) {
  using namespace afx;
  using namespace afx::bifs;
  const Model models[] = {octree_image(), point_texture(), face_set()};
  const codec::Trace silent = [](const codec::TraceElement&) {};
  const auto add_row = [](const std::string& name, auto run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  using Form = EncodeOptions::Form;
  for (const Model& m : models) {
    const Model* const model = &m;
    add_row("encode/" + m.name + "/by element",
            [=](benchmark::State& state) { encode(state, *model, Form::list); });
    add_row("encode/" + m.name + "/fast",
            [=](benchmark::State& state) { encode(state, *model, Form::compact); });
    add_row("decode/" + m.name + "/by element",
            [=, &silent](benchmark::State& state) { decode(state, *model, &silent); });
    add_row("decode/" + m.name + "/fast",
            [=](benchmark::State& state) { decode(state, *model, nullptr); });
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}

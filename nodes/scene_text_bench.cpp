// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scene text that is nearly all numbers, and from_chars alone over the same numbers: reading is to
// be no slower than a third of that.
#include <benchmark/benchmark.h>

#include <charconv>
#include <cstdio>
#include <random>
#include <string>

#include "nodes/definitions.h"
#include "nodes/scene_reader.h"
#include "nodes/scene_writer.h"

namespace {

using namespace afx;

constexpr size_t kBytes = 50'000'000;

const char* const kHeads[] = {"OctreeImage { octreeResolution 256 octree [",
                              "PointTexture { color [", "Coordinate { point ["};

/// Octree bytes 1..255, as an octree of a surface has them; or floats as written by a program that
/// prints six significant digits; or floats in their shortest exact form.
std::string numbers(int kind) {
  std::string text;
  text.reserve(kBytes + 64);
  std::mt19937 random(1);
  char buffer[40];
  for (size_t i = 0; text.size() < kBytes; ++i) {
    const double unit = static_cast<double>(random()) / 4294967296.0;
    if (kind == 0) std::snprintf(buffer, sizeof buffer, "%d", static_cast<int>(random() % 255) + 1);
    if (kind == 1) std::snprintf(buffer, sizeof buffer, "%.6g", unit);
    char* end = buffer + std::char_traits<char>::length(buffer);
    if (kind == 2)
      end = std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(unit * 200 - 100)).ptr;
    text.append(buffer, end);
    text += i % 24 == 23 ? '\n' : ' ';
  }
  return text;
}

std::string scene_of(int kind) {
  std::string list = numbers(kind);
  // Lists of triples end with a whole one.
  size_t count = 0;
  for (const char c : list) count += c == ' ' || c == '\n' ? 1 : 0;
  for (; kind != 0 && count % 3 != 0; ++count) list += "0 ";
  return kHeads[kind] + list + "] }\n";
}

template <class T>
uint64_t from_chars_alone(const std::string& text, size_t begin) {
  const char* at = text.data() + begin;
  const char* const end = text.data() + text.find(']');
  uint64_t count = 0;
  while (at != end) {
    T value{};
    at = std::from_chars(at, end, value).ptr;
    benchmark::DoNotOptimize(value);
    ++count;
    while (at != end && (*at == ' ' || *at == '\n')) ++at;
  }
  return count;
}

void read_text(benchmark::State& state) {
  const std::string text = scene_of(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    Diagnostics diagnostics;
    const auto scene = nodes::read_scene_text(text, {}, diagnostics);
    if (!scene.ok()) state.SkipWithError(to_string(scene.error()).c_str());
    benchmark::DoNotOptimize(scene);
  }
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * text.size()));
}

void from_chars_only(benchmark::State& state) {
  const int kind = static_cast<int>(state.range(0));
  const std::string text = scene_of(kind);
  const size_t begin = std::char_traits<char>::length(kHeads[kind]);
  for (auto _ : state)
    benchmark::DoNotOptimize(kind == 0 ? from_chars_alone<int32_t>(text, begin)
                                       : from_chars_alone<float>(text, begin));
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * text.size()));
}

void write_text(benchmark::State& state) {
  Diagnostics diagnostics;
  const auto scene =
      nodes::read_scene_text(scene_of(static_cast<int>(state.range(0))), {}, diagnostics);
  size_t bytes = 0;
  for (auto _ : state) bytes = nodes::write_scene_text(scene.value()).size();
  state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * bytes));
}

void parse_definitions(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(
        nodes::read_definitions({nodes::kDefinitionTexts, nodes::kDefinitionTextCount}));
}

}  // namespace

// 0 octree bytes, 1 short floats (triples), 2 exact floats (triples)
BENCHMARK(read_text)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(from_chars_only)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(write_text)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);
BENCHMARK(parse_definitions)->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "nodes/traversal.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/model_compare.h"
#include "tools/octree_compare.h"
#include "tools/picture_verdict.h"
#include "tools/scene_input.h"
#include "tools/session.h"
#include "tools/thresholds.h"

namespace afx::tools {
namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
  std::string inputs[2];
  ModelCompareOptions models;
  std::string of_models;  ///< the first option of `models` that was given; empty: none
  std::vector<std::string> thresholds;
  bool exact = false;
  std::optional<uint32_t> resolution;
  std::string node;
  std::string input_format;
};

Verdict compare_scenes(const nodes::Scene& a, const nodes::Scene& b) {
  return nodes::equal(a, b) ? same("the scenes are the same") : differ("the scenes differ");
}

int report(const Verdict& verdict, const Session& session) {
  if (session.options.json) {
    session.result(verdict.json);
  } else {
    std::cout << verdict.text << '\n';
  }
  return verdict.different ? kDifferent : kDone;
}

/// Kinds that are never equal to anything but can be measured.
bool is_measured_only(Kind kind) { return kind == Kind::model || kind == Kind::json; }

/// What of the two inputs is compared.
enum class Way { pictures, scenes, models, octrees };

Way way_of(Kind a, Kind b, const CompareOptions& options) {
  if (a == Kind::picture) return Way::pictures;
  if (is_scene(a) && is_scene(b) && options.node.empty()) return Way::scenes;
  return is_measured_only(a) || is_measured_only(b) ? Way::models : Way::octrees;
}

/// A sentence about an option that does nothing here; empty: there is none.
std::string useless_option(Way way, const CompareOptions& options) {
  const bool models = way == Way::models || (way == Way::scenes && !options.exact);
  if (options.exact && way != Way::scenes) return "--exact is for two scenes";
  if (options.exact && !options.thresholds.empty())
    return "--exact and --max-error exclude each other";
  if (!models && !options.of_models.empty())
    return options.of_models + " is for models that are measured, not for " +
           (way == Way::pictures ? "pictures"
            : options.exact      ? "--exact"
                                 : "the fields of octrees");
  if (way == Way::octrees && !options.thresholds.empty())
    return "--max-error is for what is measured, not for the fields of octrees";
  if (way == Way::models && !options.node.empty())
    return "--node is for the fields of octrees, not for models that are measured";
  return {};
}

/// Lets thresholds decide, where there are some.
void judge(const CompareOptions& options, Verdict& verdict) {
  if (options.thresholds.empty()) return;
  const std::vector<std::string> broken = broken_thresholds(options.thresholds, verdict.json);
  verdict.different = !broken.empty();
  verdict.json["broken"] = broken;
  for (const std::string& text : broken) verdict.text += "\nbeyond the limit: " + text;
}

/// Whether all errors of a distance are 0 (a PSNR that is infinite is null).
bool no_difference(const Json& json) {
  const auto is_infinite = [&json](const char* name) {
    return !json.contains(name) || json[name].is_null();
  };
  return json["hausdorff"] == 0.0 && is_infinite("colour") && is_infinite("psnr");
}

/// How far apart two models are, whose sameness is judged by that if `known` says nothing of it.
/// What is known stands if nothing can be measured, unless there are thresholds.
int measure_models(const Input& a, const Input& b, const CompareOptions& options,
                   const Session& session, const std::optional<Verdict>& known,
                   Diagnostics (&diagnostics)[2]) {
  OctreeQuery query{.node = {}, .resolution = options.resolution, .frame = {}};
  const auto distance = compare_models(a, b, options.models, query, session, diagnostics);
  if (!distance.ok()) {
    const Error& error = distance.error();
    if (!known || !options.thresholds.empty())
      return session.fail_query(error, query.missing_is_usage, a.path);
    Diagnostics failure;
    failure.warn("not_measured", error.place,
                 "how far apart the models are is not measured: " + error.text);
    diagnostics[0].append(failure, error.file);
    return report(*known, session);
  }
  Verdict verdict =
      known ? *known
            : (no_difference(distance.value().json) ? same("nothing that was measured differs")
                                                    : differ("the models differ"));
  verdict.json.update(distance.value().json);
  for (const std::string& line : distance.value().lines)
    verdict.text += (verdict.text.empty() ? "" : "\n") + line;
  judge(options, verdict);
  return report(verdict, session);
}

/// Adds the warnings of reading an input again that its first reading did not give.
void add_new(const Diagnostics& again, Diagnostics& diagnostics) {
  const std::vector<Warning> known = diagnostics.warnings();
  for (const Warning& warning : again.warnings()) {
    const bool is_known = std::any_of(known.begin(), known.end(), [&](const Warning& other) {
      return other.code == warning.code && other.place == warning.place &&
             other.text == warning.text && other.file == warning.file;
    });
    if (is_known) continue;
    Diagnostics one;
    one.warn(warning.code, warning.place, warning.text);
    diagnostics.append(one, warning.file);
  }
}

bool has_dibr_nodes(const nodes::Scene& scene) {
  const auto objects = nodes::find_dibr_objects(scene);
  return objects.ok() && !objects.value().empty();
}

int compare_scene_files(const Input& a, const Input& b, const CompareOptions& options,
                        const Session& session, Diagnostics (&diagnostics)[2]) {
  const auto first = read_plain_scene(a, session.limits, diagnostics[0]);
  if (!first.ok()) return session.fail(first.error(), a.path);
  const auto second = read_plain_scene(b, session.limits, diagnostics[1]);
  if (!second.ok()) return session.fail(second.error(), b.path);
  Verdict verdict = compare_scenes(first.value(), second.value());
  if (!verdict.different) return report(verdict, session);
  if (options.exact || !has_dibr_nodes(first.value()) || !has_dibr_nodes(second.value())) {
    judge(options, verdict);
    return report(verdict, session);
  }
  Diagnostics again[2];
  const int code = measure_models(a, b, options, session, verdict, again);
  for (size_t i = 0; i < 2; ++i) add_new(again[i], diagnostics[i]);
  return code;
}

int compare_picture_files(const Input& a, const Input& b, const CompareOptions& options,
                          const Session& session) {
  auto verdict = compare_two_pictures(a, b, session.limits);
  if (!verdict.ok()) return session.fail(verdict.error(), a.path);
  if (verdict.value().different) judge(options, verdict.value());
  return report(verdict.value(), session);
}

int compare_octree_files(const Input& a, const Input& b, const CompareOptions& options,
                         const Session& session, Diagnostics (&diagnostics)[2]) {
  OctreeQuery query{.node = options.node, .resolution = options.resolution, .frame = {}};
  const auto first = octrees_of(a, query, session, diagnostics[0]);
  if (!first.ok()) return session.fail_query(first.error(), query.missing_is_usage, a.path);
  const auto second = octrees_of(b, query, session, diagnostics[1]);
  if (!second.ok()) return session.fail_query(second.error(), query.missing_is_usage, b.path);
  return report(compare_octrees(first.value(), second.value(), session.limits), session);
}

int compare_inputs(const Input& a, const Input& b, const CompareOptions& options,
                   const Session& session, Diagnostics (&diagnostics)[2]) {
  const bool pictures = a.kind == Kind::picture;
  if (pictures != (b.kind == Kind::picture)) {
    return session.usage("cannot compare a picture with " +
                         std::string(describe(pictures ? b.kind : a.kind)));
  }
  const Way way = way_of(a.kind, b.kind, options);
  if (const std::string useless = useless_option(way, options); !useless.empty())
    return session.usage(useless);
  switch (way) {
    case Way::pictures:
      return compare_picture_files(a, b, options, session);
    case Way::scenes:
      return compare_scene_files(a, b, options, session, diagnostics);
    case Way::models:
      return measure_models(a, b, options, session, {}, diagnostics);
    case Way::octrees:
      break;
  }
  return compare_octree_files(a, b, options, session, diagnostics);
}

int compare(const CompareOptions& options, const Session& session) {
  constexpr const char* kInputs[] = {"afx", "oct", "wrl", "bt", "png"};
  if (const int code = check_input_format(session, options.input_format, kInputs); code != kDone)
    return code;
  if (const std::string wrong = check_thresholds(options.thresholds); !wrong.empty())
    return session.usage(wrong);
  Diagnostics diagnostics[2];
  const auto a =
      open_model_input(options.inputs[0], options.input_format, session.limits, diagnostics[0]);
  if (!a.ok()) return session.fail(a.error());
  const auto b =
      open_model_input(options.inputs[1], options.input_format, session.limits, diagnostics[1]);
  if (!b.ok()) return session.fail(b.error());
  const Kind kinds[] = {a.value().kind, b.value().kind};
  const std::string useless =
      useless_option({.node = options.node, .resolution = options.resolution, .frame = {}}, kinds);
  if (!useless.empty()) return session.usage(useless);
  int code = compare_inputs(a.value(), b.value(), options, session, diagnostics);
  for (int i = 0; i < 2; ++i) {
    const int warned = session.warn(diagnostics[i], options.inputs[i]);
    if (code == kDone) code = warned;
  }
  return code;
}

}  // namespace

void add_compare(CLI::App& program, Session& session) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = program.add_subcommand(
      "compare",
      "Are two files the same model or picture, and if not, how far apart; exit code 4 "
      "if not");
  command
      ->add_option("A", options->inputs[0],
                   "Scene, stream (.afx), raw octree (.oct), mesh, points, RGB-D pictures (.json) "
                   "or picture; where they are measured, the reference")
      ->required();
  command
      ->add_option("B", options->inputs[1],
                   "The other; two scenes are compared whole, streams and octrees by their fields")
      ->required();
  command
      ->add_option("--max-error", options->thresholds,
                   "NAME=NUMBER, also several: exit code 0 if all are kept. At most: d1, d2, "
                   "hausdorff (parts of A's longest side); at least: colour, psnr (dB), ssim")
      ->expected(1)
      ->take_all();
  command->add_flag("--exact", options->exact, "Scenes: only whether they are the same");
  command->add_option("--views", options->models.views, "Pictures that models are compared by")
      ->check(CLI::Range(0U, 360U))
      ->capture_default_str();
  command->add_option("--size", options->models.size, "Width and height of these pictures")
      ->check(CLI::Range(16U, 4096U))
      ->capture_default_str();
  command->add_option("--points", options->models.points, "Points that a mesh is sampled at")
      ->check(CLI::Range(size_t{1}, size_t{100000000}))
      ->capture_default_str();
  command
      ->add_option("--shade", options->models.shade,
                   "Light painted on meshes, as build does: auto, always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  command->add_option("--resolution", options->resolution, "octreeResolution of raw octrees")
      ->check(CLI::Range(1U, 2147483647U));
  command->add_option("--node", options->node, "DEF name of the OctreeImage to compare");
  command->add_option("--input-format", options->input_format,
                      "Kind of both inputs: afx, oct, wrl, bt or a picture's");
  add_common_options(*command, session, {});
  command->callback([options, command, &session] {
    for (const char* name : {"--views", "--size", "--points", "--shade"})
      if (options->of_models.empty() && command->count(name) > 0) options->of_models = name;
    session.command = "compare";
    session.exit = compare(*options, session);
  });
}

}  // namespace afx::tools

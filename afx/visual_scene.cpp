// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/visual_scene.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "afx/inline_files.h"
#include "afx/node_error.h"
#include "afx/shapes/geometry_nodes.h"
#include "afx/shapes/light_nodes.h"
#include "afx/shapes/matrix_parts.h"
#include "afx/shapes/surroundings_nodes.h"

namespace afx {
namespace {

using nodes::NodeView;
using nodes::SceneObject;
using Kind = SceneObject::Kind;

/// What has been warned of, each once.
using Said = std::set<std::string>;

/// One reading, for one viewer.
class Reading {
 public:
  Reading(InlineFiles& inlines, Said& said, const std::optional<nodes::Viewer>& viewer,
          const Limits& limits)
      : inlines_(inlines), said_(said), viewer_(viewer), limits_(limits) {
    // An object takes some hundred bytes.
    visits_ = std::min(visits_, limits.memory / 512);
  }

  Result<VisualScene> read(SceneFile& main, Diagnostics& diagnostics) {
    if (Status status = add_file(main, glm::dmat4(1), diagnostics); !status.ok())
      return status.error();
    warn_unknown(diagnostics);
    if (Status status = spread_lights(); !status.ok()) return status.error();
    return std::move(out_);
  }

 private:
  /// A light and the shapes that it falls on.
  struct LightRange {
    uint32_t light = 0;
    bool everything = false;
    size_t begin = 0, end = 0;
  };

  Status add_file(SceneFile& file, const glm::dmat4& to_world, Diagnostics& diagnostics) {
    nodes::TraversalOptions options;
    options.viewer = viewer_;
    options.to_world = to_world;
    options.max_visits = visits_;
    const auto found = nodes::find_scene_objects(*file.source.scene, options);
    if (!found.ok()) return found.error();
    visits_ -= found.value().visits;
    out_.depends_on_viewer |= found.value().depends_on_viewer;
    chain_.push_back(&file);
    std::vector<size_t> shapes;  // how many there are before each object
    std::vector<std::pair<const SceneObject*, uint32_t>> lights;
    for (const SceneObject& object : found.value().objects) {
      shapes.push_back(out_.shapes.size());
      if (object.kind == Kind::light)
        lights.emplace_back(&object, static_cast<uint32_t>(out_.lights.size()));
      if (Status status = add(object, file, diagnostics); !status.ok()) return status;
    }
    shapes.push_back(out_.shapes.size());
    chain_.pop_back();
    for (const auto& [object, light] : lights)
      ranges_.push_back({light, out_.lights[light].kind != Light::Kind::directional,
                         shapes[object->lit_begin], shapes[object->lit_end]});
    return {};
  }

  Status add(const SceneObject& object, SceneFile& file, Diagnostics& diagnostics) {
    if (const auto dibr = nodes::dibr_object(object)) return add_model(*dibr, file, diagnostics);
    const NodeView& node = object.nodes.front();
    if (!is_usable(object.to_world))
      return bad_node(node,
                      "the matrix of its place has numbers beyond all size (expected at most "
                      "1e60)");
    if (object.kind == Kind::shape) return add_shape(object, file, diagnostics);
    if (object.kind == Kind::light) return add_light(object);
    if (object.kind == Kind::inline_scene) return add_inline(object, file, diagnostics);
    if (chain_.size() > 1) return {};
    if (object.kind == Kind::viewpoint) return add_viewpoint(object);
    if (std::exchange(bound_[static_cast<size_t>(object.kind)], true)) return {};
    if (object.kind == Kind::background) return add_backdrop(object, file, diagnostics);
    return object.kind == Kind::fog ? add_fog(object) : add_navigation(object);
  }

  Status add_model(const nodes::DibrObject& object, SceneFile& file, Diagnostics& diagnostics) {
    auto model = file.models.read(object, diagnostics);
    if (!model.ok()) return std::move(model).error();
    out_.models.push_back(std::move(model).value());
    return {};
  }

  Status add_shape(const SceneObject& object, SceneFile& file, Diagnostics& diagnostics) {
    const NodeView& node = object.nodes.front();
    const NodeView geometry_node = node.child("geometry");
    if (!is_known_geometry(geometry_node.type())) {
      ++unknown_[std::string(geometry_node.type())];
      return {};
    }
    auto geometry = file.shapes.geometry(geometry_node);
    if (!geometry.ok()) return std::move(geometry).error();
    if (geometry.value()->indices.empty()) return {};
    auto look = file.shapes.look(node.child("appearance"), diagnostics);
    if (!look.ok()) return std::move(look).error();
    out_.shapes.push_back(
        {std::move(geometry).value(), std::move(look).value(), object.to_world, {}});
    return {};
  }

  Status add_light(const SceneObject& object) {
    auto light = read_light(object.nodes.front(), object.to_world);
    if (!light.ok()) return std::move(light).error();
    out_.lights.push_back(light.value());
    return {};
  }

  Status add_inline(const SceneObject& object, SceneFile& from, Diagnostics& diagnostics) {
    const NodeView& node = object.nodes.front();
    if (chain_.size() > kMaxInlineDepth) {
      warn_inline(node, "it stands in more than " + std::to_string(kMaxInlineDepth) + " others",
                  diagnostics);
      return {};
    }
    const auto file = inlines_.find(node, from, diagnostics);
    if (!file.ok()) return file.error();
    if (file.value() == nullptr) return {};
    if (is_open(*file.value())) {
      warn_inline(node, file.value()->source.file + " inlines itself", diagnostics);
      return {};
    }
    Diagnostics own;
    Status status = add_file(*file.value(), object.to_world, own);
    diagnostics.append(own, file.value()->source.file);
    if (status.ok()) return status;
    Error error = status.error();
    if (error.file.empty()) error.file = file.value()->source.file;
    return error;
  }

  [[nodiscard]] bool is_open(const SceneFile& file) const {
    return std::any_of(chain_.begin(), chain_.end(), [&](const SceneFile* other) {
      return other == &file ||
             (!file.source.file.empty() && other->source.file == file.source.file);
    });
  }

  void warn_inline(const NodeView& node, const std::string& why, Diagnostics& diagnostics) {
    if (said_.insert(why).second)
      diagnostics.warn("inline_not_shown", Place::none(), node.label() + ": " + why);
  }

  Status add_viewpoint(const SceneObject& object) {
    auto view = read_viewpoint(object.nodes.front(), object.to_world);
    if (!view.ok()) return std::move(view).error();
    out_.viewpoints.push_back(std::move(view).value());
    return {};
  }

  Status add_backdrop(const SceneObject& object, SceneFile& file, Diagnostics& diagnostics) {
    auto backdrop = file.shapes.backdrop(object.nodes.front(), diagnostics);
    if (!backdrop.ok()) return std::move(backdrop).error();
    out_.backdrop = *backdrop.value();
    out_.backdrop->to_world = rotation_part(object.to_world);
    return {};
  }

  Status add_fog(const SceneObject& object) {
    auto fog = read_fog(object.nodes.front(), object.to_world);
    if (!fog.ok()) return std::move(fog).error();
    out_.fog = fog.value();
    return {};
  }

  Status add_navigation(const SceneObject& object) {
    auto navigation = read_navigation(object.nodes.front());
    if (!navigation.ok()) return std::move(navigation).error();
    out_.navigation = std::move(navigation).value();
    return {};
  }

  void warn_unknown(Diagnostics& diagnostics) {
    uint64_t count = 0;
    std::string types;
    bool is_new = false;
    for (const auto& [type, shapes] : unknown_) {
      count += shapes;
      types += (types.empty() ? "" : ", ") + std::to_string(shapes) + " of " + type;
      is_new |= said_.insert("geometry " + type).second;
    }
    if (is_new)
      diagnostics.warn("unknown_geometry", Place::none(),
                       "shapes that are not shown: " + std::to_string(count) + " (" + types + ")");
  }

  Status spread_lights() {
    std::sort(ranges_.begin(), ranges_.end(),
              [](const LightRange& a, const LightRange& b) { return a.light < b.light; });
    uint64_t pairs = 0;
    for (LightRange& range : ranges_) {
      if (range.everything) range = {range.light, true, 0, out_.shapes.size()};
      pairs += range.end - range.begin;
    }
    if (pairs > limits_.memory / (2 * sizeof(uint32_t)))
      return Error{Errc::limit_exceeded, Place::none(),
                   std::to_string(out_.lights.size()) + " lights fall on " +
                       std::to_string(out_.shapes.size()) + " shapes, more than the limit"};
    for (const LightRange& range : ranges_)
      for (size_t shape = range.begin; shape < range.end; ++shape)
        out_.shapes[shape].lights.push_back(range.light);
    return {};
  }

  InlineFiles& inlines_;
  Said& said_;
  const std::optional<nodes::Viewer>& viewer_;
  const Limits& limits_;
  uint64_t visits_ = nodes::TraversalOptions{}.max_visits;  // left for all files together
  VisualScene out_;
  std::vector<LightRange> ranges_;
  std::vector<const SceneFile*> chain_;  // the files that are being read, from the main one on
  std::map<std::string, uint64_t> unknown_;
  bool bound_[static_cast<size_t>(Kind::inline_scene) + 1] = {};  // whether there was one, by Kind
};

}  // namespace

class VisualSceneReader::Parts {
 public:
  Parts(const nodes::Scene& scene, UrlBase base, VisualOptions options, const Limits& limits)
      : limits_(limits),
        left_(limits),
        // Not owned: the caller keeps it.
        main_({std::shared_ptr<const nodes::Scene>(std::shared_ptr<void>(), &scene),
               std::move(base), std::move(options.file)},
              left_),
        inlines_(std::move(options.load_inline), left_) {}

  Result<VisualScene> read(const std::optional<nodes::Viewer>& viewer, Diagnostics& diagnostics) {
    return Reading(inlines_, said_, viewer, limits_).read(main_, diagnostics);
  }

 private:
  Limits limits_, left_;
  SceneFile main_;
  InlineFiles inlines_;
  Said said_;
};

VisualSceneReader::VisualSceneReader(const nodes::Scene& scene, UrlBase base, VisualOptions options,
                                     const Limits& limits)
    : parts_(std::make_unique<Parts>(scene, std::move(base), std::move(options), limits)) {}
VisualSceneReader::VisualSceneReader(VisualSceneReader&&) noexcept = default;
VisualSceneReader& VisualSceneReader::operator=(VisualSceneReader&&) noexcept = default;
VisualSceneReader::~VisualSceneReader() = default;

Result<VisualScene> VisualSceneReader::read(const std::optional<nodes::Viewer>& viewer,
                                            Diagnostics& diagnostics) {
  return parts_->read(viewer, diagnostics);
}

Result<VisualScene> read_visual_scene(const nodes::Scene& scene, const UrlBase& base,
                                      const VisualOptions& options, const Limits& limits,
                                      Diagnostics& diagnostics) {
  return VisualSceneReader(scene, base, options, limits).read(options.viewer, diagnostics);
}

}  // namespace afx

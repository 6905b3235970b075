// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/shapes/surroundings_nodes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <string>
#include <utility>

#include "afx/node_error.h"
#include "afx/node_rotation.h"
#include "afx/picture_io.h"
#include "afx/shapes/field_reader.h"
#include "afx/shapes/matrix_parts.h"

namespace afx {
namespace {

using nodes::NodeView;

constexpr float kRounding = 0.01F;  // 1.571 is common for a quarter turn

/// Sky or ground: colours, and the angles from the second on.
class RampReader {
 public:
  RampReader(const NodeView& node, Diagnostics& diagnostics)
      : node_(node), diagnostics_(diagnostics) {}

  Status read(const char* colour_field, const char* angle_field, float most,
              std::vector<glm::vec3>& colours, std::vector<float>& angles) {
    colours = node_.get<std::vector<glm::vec3>>(colour_field);
    angles = node_.get<std::vector<float>>(angle_field);
    for (glm::vec3& c : colours) {
      if (std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z)) return not_numbers(colour_field);
      c = glm::clamp(c, 0.0F, 1.0F);
    }
    for (const float angle : angles)
      if (std::isnan(angle)) return not_numbers(angle_field);
    fit(angle_field, most, colours, angles);
    return {};
  }

 private:
  void fit(const char* field, float most, std::vector<glm::vec3>& colours,
           std::vector<float>& angles) {
    const size_t wanted = colours.empty() ? 0 : colours.size() - 1;
    if (angles.size() != wanted)
      warn(std::string("field ") + field + " has " + std::to_string(angles.size()) +
           " angles for " + std::to_string(colours.size()) + " colours (expected " +
           std::to_string(wanted) + ")");
    if (angles.size() > wanted) angles.resize(wanted);
    if (colours.size() > angles.size() + 1) colours.resize(angles.size() + 1);
    float last = 0;
    for (float& angle : angles) {
      if (angle < last || angle > most + kRounding)
        warn(std::string("field ") + field + ": " + number_text(angle) + " (expected " +
             number_text(last) + " to " + number_text(most) + ")");
      last = angle = std::clamp(angle, last, most);
    }
  }

  void warn(const std::string& text) {
    diagnostics_.warn("background_angles", Place::none(), node_.label() + ": " + text);
  }
  [[nodiscard]] Error not_numbers(const char* field) const {
    return bad_node(node_, std::string("field ") + field + " has a nan (expected numbers)");
  }

  const NodeView& node_;
  Diagnostics& diagnostics_;
};

/// A picture that a Background names; null where it cannot be read.
Result<std::shared_ptr<const Picture>> read_picture(const NodeView& node, const char* field,
                                                    const UrlBase& base, const Limits& limits,
                                                    Diagnostics& diagnostics) {
  using Shared = std::shared_ptr<const Picture>;
  const auto& urls = node.get<std::vector<nodes::Url>>(field);
  if (urls.empty()) return Shared();
  const auto file = open_url(urls, base, limits);
  auto picture = file.ok() ? decode_picture(file.value().file.bytes(), file.value().path, limits)
                           : Result<Picture>(file.error());
  if (picture.ok()) return Shared(std::make_shared<Picture>(std::move(picture).value()));
  const Error& error = picture.error();
  if (error.code == Errc::limit_exceeded) return bad_node(node, error.text, error.code);
  diagnostics.warn("background_picture", Place::none(),
                   node.label() + ": field " + field + ": " + error.text);
  return Shared();
}

Result<Backdrop> read_background_2d(const NodeView& node, Diagnostics& diagnostics) {
  Backdrop out;
  FieldReader fields(node);
  out.sky_colours = {fields.colour("backColor")};
  if (!fields.ok()) return fields.error();
  if (!node.get<std::vector<nodes::Url>>("url").empty())
    diagnostics.warn("background_picture", Place::none(),
                     node.label() + ": its picture is not shown");
  return out;
}

}  // namespace

Result<Backdrop> read_backdrop(const NodeView& node, const UrlBase& base, const Limits& limits,
                               Diagnostics& diagnostics) {
  if (node.type() == "Background2D") return read_background_2d(node, diagnostics);
  Backdrop out;
  RampReader ramps(node, diagnostics);
  constexpr auto kHalfTurn = static_cast<float>(std::numbers::pi);
  if (Status status =
          ramps.read("skyColor", "skyAngle", kHalfTurn, out.sky_colours, out.sky_angles);
      !status.ok())
    return status.error();
  if (out.sky_colours.empty()) out.sky_colours = {glm::vec3(0)};
  if (Status status = ramps.read("groundColor", "groundAngle", kHalfTurn / 2, out.ground_colours,
                                 out.ground_angles);
      !status.ok())
    return status.error();
  Limits left = limits;  // for the pictures together
  const char* const fields[] = {"frontUrl", "backUrl", "leftUrl",
                                "rightUrl", "topUrl",  "bottomUrl"};
  for (size_t i = 0; i < out.pictures.size(); ++i) {
    auto picture = read_picture(node, fields[i], base, left, diagnostics);
    if (!picture.ok()) return std::move(picture).error();
    out.pictures[i] = std::move(picture).value();
    if (out.pictures[i])
      left.memory -= std::min<uint64_t>(left.memory, out.pictures[i]->samples.size());
  }
  return out;
}

Result<std::optional<Fog>> read_fog(const NodeView& node, const glm::dmat4& to_world) {
  Fog fog;
  FieldReader fields(node);
  fog.colour = fields.colour("color");
  fog.visibility_range =
      static_cast<double>(fields.at_least("visibilityRange", 0)) * uniform_scale(to_world);
  fog.exponential = node.get<std::string>("fogType") == "EXPONENTIAL";
  if (!fields.ok()) return fields.error();
  return fog.visibility_range > 0 ? std::optional<Fog>(fog) : std::nullopt;
}

Result<Viewpoint> read_viewpoint(const NodeView& node, const glm::dmat4& to_world) {
  Viewpoint view;
  FieldReader fields(node);
  view.name = node.node().name;
  view.description = node.get<std::string>("description");
  view.position = glm::dvec3(to_world * glm::dvec4(fields.finite3("position"), 1));
  const float angle = node.get<float>("fieldOfView");
  if (!(angle > 0 && angle < static_cast<float>(std::numbers::pi)))
    fields.fail("fieldOfView", number_text(angle), "above 0, below pi");
  view.field_of_view = angle;
  const auto& turn = node.get<nodes::Rotation>("orientation");
  if (!std::isfinite(turn.x) || !std::isfinite(turn.y) || !std::isfinite(turn.z) ||
      !std::isfinite(turn.angle))
    fields.fail("orientation", "not finite", "finite numbers");
  if (!fields.ok()) return fields.error();
  view.orientation =
      glm::normalize(glm::dquat(rotation_part(to_world)) * quaternion_of<double>(turn));
  return view;
}

Result<Navigation> read_navigation(const NodeView& node) {
  Navigation out;
  FieldReader fields(node);
  out.headlight = node.get<bool>("headlight");
  out.speed = fields.at_least("speed", 0);
  out.visibility_limit = fields.at_least("visibilityLimit", 0);
  out.types = node.get<std::vector<std::string>>("type");
  if (!fields.ok()) return fields.error();
  return out;
}

}  // namespace afx

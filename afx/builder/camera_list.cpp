// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/camera_list.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "afx/builder/json_text.h"
#include "afx/builder/view_plan.h"
#include "afx/node_rotation.h"

namespace afx {
namespace {

using Json = nlohmann::json;

Error wrong(const std::string& path, const std::string& text, Errc code = Errc::malformed) {
  return {code, Place::none(), path + " " + text};
}

// Reads the members of one camera; the first error sticks.
class CameraReader {
 public:
  CameraReader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {}

  Result<Shot> read() {
    if (!json_.is_object()) return wrong(path_, "is not an object");
    Shot shot;
    DepthCamera& camera = shot.camera;
    numbers("position", &camera.position.x, 3);
    numbers("fieldOfView", &camera.field_of_view.x, 2);
    numbers("nearPlane", &camera.near_plane, 1);
    numbers("farPlane", &camera.far_plane, 1);
    if (json_.contains("orientation")) {
      double turn[4] = {};
      numbers("orientation", turn, 4);
      camera.orientation =
          quaternion_of<double>({static_cast<float>(turn[0]), static_cast<float>(turn[1]),
                                 static_cast<float>(turn[2]), static_cast<float>(turn[3])});
    }
    if (json_.contains("orthographic")) {
      if (!json_["orthographic"].is_boolean()) fail("orthographic", "is not true or false");
      camera.orthographic = json_["orthographic"] == true;
    }
    shot.width = size("width");
    shot.height = size("height");
    for (const auto& [name, value] : json_.items()) refuse_unknown(name);
    if (!status_.ok()) return status_.error();
    camera = as_in_node(camera);
    if (Status right = check_depth_camera(camera); !right.ok())
      return wrong(path_ + ":", right.error().text, Errc::bad_argument);
    return shot;
  }

 private:
  void fail(const std::string& member, const std::string& text, Errc code = Errc::malformed) {
    if (status_.ok()) status_ = wrong(path_ + "." + member, text, code);
  }

  void numbers(const char* member, double* to, size_t count) {
    const auto found = json_.find(member);
    if (found == json_.end()) return fail(member, "is missing");
    const auto kind =
        count == 1 ? "is not a number" : "is not a list of " + std::to_string(count) + " numbers";
    if (count == 1 && found->is_number()) {
      *to = found->get<double>();
      return;
    }
    if (!found->is_array() || found->size() != count) return fail(member, kind);
    for (size_t i = 0; i < count; ++i) {
      if (!(*found)[i].is_number()) return fail(member, kind);
      to[i] = (*found)[i].get<double>();
    }
  }

  uint32_t size(const char* member) {
    const auto found = json_.find(member);
    if (found == json_.end()) return fail(member, "is missing"), 0;
    if (!found->is_number_integer()) return fail(member, "is not a whole number"), 0;
    const auto value = found->get<int64_t>();
    if (value < 1 || value > 65535)
      return fail(member, "is " + std::to_string(value) + " (expected 1 to 65535)",
                  Errc::bad_argument),
             0;
    return static_cast<uint32_t>(value);
  }

  void refuse_unknown(const std::string& name) {
    for (const char* known : {"position", "orientation", "orthographic", "fieldOfView", "nearPlane",
                              "farPlane", "width", "height"})
      if (name == known) return;
    fail(name, "is not known");
  }

  const Json& json_;
  std::string path_;
  Status status_;
};

}  // namespace

Result<std::vector<Shot>> read_camera_list(std::span<const uint8_t> bytes, const Limits& limits) {
  const auto parsed = parse_json(bytes, limits);
  if (!parsed.ok()) return parsed.error();
  const Json& json = parsed.value();
  if (!json.is_object() || !json.contains("cameras") || !json["cameras"].is_array())
    return Error{Errc::malformed, Place::none(), "has no list named cameras"};
  const Json& cameras = json["cameras"];
  if (cameras.empty() || cameras.size() > kMostViews)
    return Error{Errc::bad_argument, Place::none(),
                 "has " + std::to_string(cameras.size()) + " cameras (expected 1 to 255)"};
  std::vector<Shot> shots;
  for (size_t i = 0; i < cameras.size(); ++i) {
    auto shot = CameraReader(cameras[i], "cameras[" + std::to_string(i) + "]").read();
    if (!shot.ok()) return std::move(shot).error();
    shots.push_back(shot.value());
  }
  return shots;
}

}  // namespace afx

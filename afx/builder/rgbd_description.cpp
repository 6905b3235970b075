// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/builder/rgbd_description.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <locale>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <utility>

#include "afx/builder/json_text.h"

namespace afx {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 16> kMembers{
    "colour", "depth", "mask",  "pose",   "near",       "far",        "fx",         "fy",
    "cx",     "cy",    "width", "height", "depthScale", "convention", "intrinsics", "frames"};

/// The fields of one frame. The first problem is kept; what is asked after it has no meaning.
class FrameFields {
 public:
  FrameFields(const Json& top, size_t frame) {
    const std::string path = "frames[" + std::to_string(frame) + "]";
    add_scope(top["frames"][frame], path + ".");
    add_scope(top, "");
    if (!top["frames"][frame].is_object()) fail(path, "is not an object");
  }

  [[nodiscard]] const Status& status() const { return status_; }

  void fail(const std::string& path, const std::string& problem) {
    if (status_.ok()) status_ = Error{Errc::bad_argument, Place::none(), path + " " + problem};
  }

  [[nodiscard]] bool has(const char* key) const { return find(key).value != nullptr; }
  /// Where a member stands, or would in the frame.
  [[nodiscard]] std::string path_of(const char* key) const { return find(key).path; }

  std::string text(const char* key) {
    const Member member = required(key);
    if (member.value == nullptr) return {};
    if (member.value->is_string() && !member.value->get_ref<const std::string&>().empty())
      return member.value->get<std::string>();
    fail(member.path, "is not a text");
    return {};
  }

  double number(const char* key) {
    const Member member = required(key);
    if (member.value == nullptr) return 0;
    if (!member.value->is_number()) fail(member.path, "is not a number");
    return member.value->is_number() ? member.value->get<double>() : 0;
  }

  double positive(const char* key) {
    const double value = number(key);
    if (!(value > 0)) fail(path_of(key), "is " + rgbd_text(value) + " (expected more than 0)");
    return value;
  }

  /// 16 numbers in rows.
  glm::dmat4 matrix(const char* key) {
    const Member member = required(key);
    glm::dmat4 m(1);
    if (member.value == nullptr) return m;
    const auto is_row = [](const Json& row) {
      return row.is_array() && row.size() == 4 &&
             std::all_of(row.begin(), row.end(), [](const Json& v) { return v.is_number(); });
    };
    const Json& rows = *member.value;
    if (!rows.is_array() || rows.size() != 4 || !std::all_of(rows.begin(), rows.end(), is_row)) {
      fail(member.path, "is not a matrix of four rows of four numbers");
      return m;
    }
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        m[column][row] = rows[static_cast<size_t>(row)][static_cast<size_t>(column)].get<double>();
    return m;
  }

 private:
  struct Member {
    const Json* value;
    std::string path;
  };

  void add_scope(const Json& object, const std::string& prefix) {
    if (!object.is_object()) return;
    scopes_.push_back({&object, prefix});
    const auto intrinsics = object.find("intrinsics");
    if (intrinsics == object.end()) return;
    if (intrinsics->is_object())
      scopes_.push_back({&*intrinsics, prefix + "intrinsics."});
    else
      fail(prefix + "intrinsics", "is not an object");
  }

  [[nodiscard]] Member find(const char* key) const {
    for (const Member& scope : scopes_) {
      const auto found = scope.value->find(key);
      if (found != scope.value->end()) return {&*found, scope.path + key};
    }
    return {nullptr, scopes_.empty() ? key : scopes_.front().path + key};
  }

  Member required(const char* key) {
    Member member = find(key);
    if (member.value == nullptr) fail(member.path, "is missing");
    return member;
  }

  std::vector<Member> scopes_;  // objects, with what stands in front of their members' names
  Status status_;
};

void check_pose(const glm::dmat4& pose, FrameFields& fields) {
  const std::string path = fields.path_of("pose");
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(pose[column][row])) return fields.fail(path, "is not finite");
  for (int column = 0; column < 4; ++column)
    if (pose[column][3] != (column == 3 ? 1 : 0))
      return fields.fail(path, "is not affine (expected a last row of 0 0 0 1)");
  const double volume = glm::determinant(glm::dmat3(pose));
  if (!std::isfinite(volume) || volume == 0) fields.fail(path, "cannot be inverted");
}

Result<RgbdDescription> describe(const Json& top, size_t number) {
  FrameFields fields(top, number);
  RgbdDescription d;
  d.colour = {fields.text("colour"), fields.path_of("colour")};
  d.depth = {fields.text("depth"), fields.path_of("depth")};
  if (fields.has("mask")) d.mask = {fields.text("mask"), fields.path_of("mask")};
  RgbdFrame& frame = d.frame;
  frame.fx = fields.positive("fx");
  frame.fy = fields.positive("fy");
  frame.cx = fields.number("cx");
  frame.cy = fields.number("cy");
  const auto optional = [&](const char* key) -> RgbdNumber {
    return {fields.has(key) ? fields.positive(key) : 0, fields.path_of(key)};
  };
  d.width = optional("width");
  d.height = optional("height");
  d.depth_scale = optional("depthScale");
  if (fields.has("near")) d.near = fields.number("near");
  if (fields.has("far")) d.far = fields.number("far");
  if (!(d.far > d.near))
    fields.fail(fields.path_of("far"),
                "is " + rgbd_text(d.far) + " (expected more than near, " + rgbd_text(d.near) + ")");
  frame.to_world = fields.matrix("pose");
  check_pose(frame.to_world, fields);
  d.pose = fields.path_of("pose");
  const std::string convention = fields.has("convention") ? fields.text("convention") : "opencv";
  if (convention != "opencv" && convention != "opengl")
    fields.fail(fields.path_of("convention"),
                "is \"" + convention + "\" (expected \"opencv\" or \"opengl\")");
  if (!fields.status().ok()) return fields.status().error();
  if (convention == "opencv") {  // y and z the other way
    frame.to_world[1] *= -1;
    frame.to_world[2] *= -1;
  }
  return d;
}

Status check_frames(const Json& top) {
  const auto bad = [](const char* text) { return Error{Errc::bad_argument, Place::none(), text}; };
  if (!top.is_object()) return bad("the JSON is not an object");
  const auto frames = top.find("frames");
  if (frames == top.end()) return bad("frames is missing");
  if (!frames->is_array() || frames->empty())
    return bad("frames is not a list of one frame or more");
  return {};
}

void warn_of_others(const Json& object, const std::string& prefix, Diagnostics& diagnostics) {
  for (const auto& [key, value] : object.items())
    if (std::find(kMembers.begin(), kMembers.end(), key) == kMembers.end())
      diagnostics.warn("unknown_member", Place::none(), prefix + key + " is not known");
}

// Of the object and its "intrinsics"; what is nested deeper is never read.
void warn_of_unknown(const Json& object, const std::string& prefix, Diagnostics& diagnostics) {
  warn_of_others(object, prefix, diagnostics);
  const auto intrinsics = object.find("intrinsics");
  if (intrinsics != object.end() && intrinsics->is_object())
    warn_of_others(*intrinsics, prefix + "intrinsics.", diagnostics);
}

}  // namespace

std::string rgbd_text(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

Result<std::vector<RgbdDescription>> read_rgbd_description(std::span<const uint8_t> bytes,
                                                           const Limits& limits,
                                                           Diagnostics& diagnostics) {
  const Result<Json> parsed = parse_json(bytes, limits);
  if (!parsed.ok()) return parsed.error();
  const Json& top = parsed.value();
  if (Status s = check_frames(top); !s.ok()) return s.error();
  warn_of_unknown(top, "", diagnostics);
  std::vector<RgbdDescription> frames;
  for (size_t n = 0; n < top["frames"].size(); ++n) {
    auto frame = describe(top, n);
    if (!frame.ok()) return frame.error();
    warn_of_unknown(top["frames"][n], "frames[" + std::to_string(n) + "].", diagnostics);
    frames.push_back(std::move(frame).value());
  }
  return frames;
}

}  // namespace afx

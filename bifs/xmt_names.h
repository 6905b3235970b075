// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Names that XMT-A has for what BT and BIFS call otherwise, for reader and writer.
#pragma once

#include <array>
#include <string_view>

#include "nodes/field_value.h"

namespace afx::bifs {

/// How interfaces call a type, and the attribute that holds a value of it.
struct XmtType {
  nodes::FieldType type;
  std::string_view name;        ///< "Vector3Array"
  const char* value_attribute;  ///< "vector3ArrayValue"; nodes and buffers: the element instead
};

inline constexpr XmtType kXmtTypes[] = {
    {nodes::FieldType::sf_bool, "Boolean", "booleanValue"},
    {nodes::FieldType::sf_int32, "Integer", "intValue"},
    {nodes::FieldType::sf_float, "Float", "floatValue"},
    {nodes::FieldType::sf_time, "Time", "timeValue"},
    {nodes::FieldType::sf_string, "String", "stringValue"},
    {nodes::FieldType::sf_url, "Url", "urlValue"},
    {nodes::FieldType::sf_script, "Script", "scriptValue"},
    {nodes::FieldType::sf_color, "Color", "colorValue"},
    {nodes::FieldType::sf_vec2f, "Vector2", "vector2Value"},
    {nodes::FieldType::sf_vec3f, "Vector3", "vector3Value"},
    {nodes::FieldType::sf_vec4f, "Vector4", "vector4Value"},
    {nodes::FieldType::sf_rotation, "Rotation", "rotationValue"},
    {nodes::FieldType::sf_image, "Image", "imageValue"},
    {nodes::FieldType::sf_node, "Node", "node"},
    {nodes::FieldType::sf_command_buffer, "CommandBuffer", "buffer"},
    {nodes::FieldType::mf_bool, "Booleans", "booleanArrayValue"},
    {nodes::FieldType::mf_int32, "Integers", "intArrayValue"},
    {nodes::FieldType::mf_float, "Floats", "floatArrayValue"},
    {nodes::FieldType::mf_time, "Times", "timeArrayValue"},
    {nodes::FieldType::mf_string, "Strings", "stringArrayValue"},
    {nodes::FieldType::mf_url, "Urls", "urlArrayValue"},
    {nodes::FieldType::mf_script, "Scripts", "scriptArrayValue"},
    {nodes::FieldType::mf_color, "Colors", "colorArrayValue"},
    {nodes::FieldType::mf_vec2f, "Vector2Array", "vector2ArrayValue"},
    {nodes::FieldType::mf_vec3f, "Vector3Array", "vector3ArrayValue"},
    {nodes::FieldType::mf_vec4f, "Vector4Array", "vector4ArrayValue"},
    {nodes::FieldType::mf_rotation, "Rotations", "rotationArrayValue"},
    {nodes::FieldType::mf_image, "Images", "imageArrayValue"},
    {nodes::FieldType::mf_node, "Nodes", "nodes"},
};

constexpr const XmtType& xmt_type(nodes::FieldType type) {
  for (const XmtType& row : kXmtTypes)
    if (row.type == type) return row;
  return kXmtTypes[0];
}

/// Quantization categories by their numbers; 0 is none.
inline constexpr std::array<std::string_view, 16> kXmtQuantCategories = {
    "none",   "position3D", "position2D",       "drawingOrder", "color",     "textureCoordinate",
    "angle",  "scale",      "interpolatorKeys", "normals",      "rotations", "size3D",
    "size2D", "linear",     "coordIndex",       "reserved"};

/// Attributes of nodes that are no fields.
inline constexpr const char* kXmtDef = "DEF";
inline constexpr const char* kXmtUse = "USE";
inline constexpr const char* kXmtId = "binaryID";

/// Values of `extended`: commands that the schema of XMT-A does not have.
namespace xmt_extended {
inline constexpr std::string_view kFields = "fields", kIndices = "indices",
                                  kGlobalQuantizer = "globalQuant", kXReplace = "xreplace",
                                  kProtos = "protos", kAllProtos = "allProtos",
                                  kDeletion = "deleteEx";
}  // namespace xmt_extended

}  // namespace afx::bifs

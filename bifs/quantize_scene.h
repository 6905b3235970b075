// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Puts a quantizer into a presentation, with errors that are known beforehand. Values stay as they
// are: they change when the presentation is encoded and decoded.
// Source: spec/bifs.md 9.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bifs/presentation.h"

namespace afx::bifs {

/// How the values of a category are quantized.
struct CategoryChoice {
  bool on = true;
  unsigned bits = 16;  ///< of a component, 1..31; normal: 2..31
  /// If it is given, as few bits as keep every error within it: relative to the range of the
  /// category's values (of each component), for normal to half a turn. Above 0, below 1.
  std::optional<double> largest_error = std::nullopt;
};

/// By what the fields of a QuantizationParameter begin with: position3D, position2D, drawOrder,
/// color, textureCoordinate, angle, scale, key, normal (rotations too), size.
using CategoryChoices = std::map<std::string, CategoryChoice, std::less<>>;

/// All on: color with 8 bits, normal with 12, the others with 16.
CategoryChoices default_choices();

struct QuantizeOptions {
  CategoryChoices categories = default_choices();  ///< one that is missing is off
  /// Leave out what GPAC gets wrong: normals and rotations, and categories with fields whose
  /// definition has no bounds (such as PositionAnimator.key).
  bool for_gpac = true;
};

/// What quantization does to one field of one type of node. Errors are in the units of the field,
/// of a component; of normals and rotations they are angles in radians.
struct QuantizedField {
  std::string category;  ///< as in CategoryChoices
  std::string node;
  std::string field;
  uint64_t values = 0;       ///< elements of lists count each
  unsigned bits = 0;         ///< of a component
  double bound = 0;          ///< no error is greater: half a step, and what binary32 adds
  double largest_error = 0;  ///< the greatest that is made
};

/// A category that has values and is not quantized, and why.
struct UnquantizedCategory {
  std::string category;
  std::string reason;
};

struct QuantizeReport {
  std::vector<QuantizedField> fields;  ///< in the order of category, node and field
  std::vector<UnquantizedCategory> left_out;
  /// Why commands that change a scene are coded without a quantizer; empty if none are.
  std::string commands_left_out;
};

/// Quantizes a presentation: every scene in it gets a QuantizationParameter that counts for all of
/// it, and, where the commands that follow have values to quantize, a global one behind its
/// SceneReplacement, for the former does not reach them. PROTOs that come with a scene, command
/// buffers and commands before the first scene are not quantized.
///
/// In a scene the quantizer is the first child of the root, or, where commands can address the root
/// or its other fields count its children, of a new root of the same type that holds the old one.
///
/// Min and Max are those of the values that occur, over the whole presentation, so that all lie
/// inside. A category stays off, and the report says why, where coding cannot hold its values: an
/// infinity or NaN, a value outside the range of its field or of Min and Max, SFInt32 fields, a
/// range too wide for binary32, no direction, `largest_error` too small; and where it would save
/// nothing. With every category off nothing is changed.
///
/// Under a quantizer the integers of categories 13 and 14 are written in few bits, without error.
/// Where they do not fit, the commands are left without quantizer, and scenes are refused.
///
/// Errors: bad_argument, and nothing is changed: a choice out of range or of an unknown name; the
/// presentation has quantizers already; an integer that does not fit; a node that comes with two
/// scenes; the root is no grouping node.
Result<QuantizeReport> quantize_scene(Presentation& presentation,
                                      const QuantizeOptions& options = {});

}  // namespace afx::bifs

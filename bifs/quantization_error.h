// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The errors that quantization makes: how great they may be, and how great they are.
#pragma once

#include <type_traits>
#include <vector>

#include "bifs/quantizer.h"

namespace afx::bifs {

/// Calls visit(float, number of the component) for each component of a value or list of values of
/// the types that are quantized linearly; for others not at all.
template <class Visit>
void for_each_component(const nodes::FieldValue& value, Visit visit) {
  const auto one = [&]<class T>(const T& v) {
    if constexpr (std::is_same_v<T, float>) {
      visit(v, size_t{0});
    } else if constexpr (std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3>) {
      for (size_t i = 0; i < size_t{T::length()}; ++i) visit(v[static_cast<int>(i)], i);
    }
  };
  std::visit(
      [&]<class T>(const T& v) {
        if constexpr (requires { v.begin(); }) {
          for (const auto& element : v) one(element);
        } else {
          one(v);
        }
      },
      value);
}

/// No value of the range has a greater error: half a step, and what binary32 arithmetic adds. Kind
/// linear: of a component; bits 1 or more; hi - lo times 2^bits must not overflow. Normal and
/// rotation: the angle between the directions or rotations in radians; bits 2 or more.
double error_bound(const ElementCoding& coding, size_t component);

/// The greatest error of the elements of a value, in the same measure. Kind normal: a vector of no
/// length has no direction and no error.
double largest_error(const ElementCoding& coding, const nodes::FieldValue& value);

}  // namespace afx::bifs

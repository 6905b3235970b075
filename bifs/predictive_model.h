// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// What decoder and encoder of predictive MF fields must do alike: how a value follows from the one
// before it. The structure:
//
//   u(5) n, u(n) count
//   u(2) intraMode; 1: u(5) k, u(k) period
//   parameters: u(5) compNbBits, then for each bound u(NbBits + 1) = compMin + 2^NbBits
//   count times a value: intra or predicted; the first is intra
//     intra:      behind the first one, u(1) newParameters and if 1 parameters; then
//                 normals u(1) direction; normals, rotations u(2) orientation; u(NbBits) components
//     predicted:  symbols of an arithmetic code: normals 1 if the direction flips; then for each
//                 component its residual - compMin
//     intraMode 2: before every value but the first, a symbol: 1 intra, 0 predicted
//
// Source: ISO/IEC 14496-11, PredictiveMFField (clauses not checked); spec/bifs.md 10.
// Not verified against any other program: GPAC has no encoder for it and its decoder is switched
// off. Where the description leaves a choice, this is the one made here:
//   - An arithmetic code begins with the first symbol behind an intra value, as if the data began
//     there, and ends before the next intra value and at the end, with the two bits that settle it.
//     Nothing is written where no symbol is. All modes end their code alike.
//   - The zeros that make a stuffing bit are counted from the begin of a code. The bit, a 1, stands
//     before the bit that follows 22 zeros, so none stands at the end.
//   - The models live through intra values; new parameters begin all of them anew.
//   - A component has the bound and model of its number, or the last where there are fewer.
//   - A count of 0 is followed by the rest of the header and nothing else.
//   - A predicted value outside the quantizer's range is an error and does not wrap round.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <vector>

#include "bifs/quantizer.h"

namespace afx::bifs {

/// When a value is written whole and not as the difference to the one before.
enum class IntraMode : uint8_t { first = 0, periodic = 1, flagged = 2 };

/// Element types that may be coded predictively (SFColor is a glm::vec3).
template <class T>
concept Predictable = std::same_as<T, int32_t> || std::same_as<T, float> ||
    std::same_as<T, glm::vec2> || std::same_as<T, glm::vec3> || std::same_as<T, nodes::Rotation>;
template <class T>
inline constexpr bool kIsPredictableList = false;
template <Predictable T>
inline constexpr bool kIsPredictableList<std::vector<T>> = true;

/// The form of the quantized elements of a field. An element is a QuantizedDirection; numbers that
/// are no directions use its components only.
struct PredictiveLayout {
  ElementCoding::Kind kind = ElementCoding::Kind::linear;  ///< not plain
  unsigned bits = 0;                                       ///< NbBits of a component, 0..31
  size_t components = 1;                                   ///< 1..3
  size_t bounds = 1;                                       ///< and models, 1..3

  PredictiveLayout(const nodes::FieldDefinition& field, const ElementCoding& coding);

  [[nodiscard]] bool is_direction() const {
    return kind == ElementCoding::Kind::normal || kind == ElementCoding::Kind::rotation;
  }
  [[nodiscard]] bool has_sign() const { return kind == ElementCoding::Kind::normal; }
  [[nodiscard]] size_t bound_of(size_t component) const {
    return component < bounds ? component : bounds - 1;
  }
};

/// compNbBits and compMin.
struct PredictiveParameters {
  unsigned width = 0;                ///< of a residual, 0..13
  std::array<int64_t, 3> minimum{};  ///< least residual of each bound, -2^NbBits .. 2^NbBits - 1
};

/// How a value differs from the one before it.
struct PredictiveStep {
  bool flip = false;  ///< normals: the direction becomes the other one
  std::array<int64_t, 3> residual{};
};

/// The value that follows `previous`; none where it is outside the range of the components.
///
/// A component of a direction is an angle of up to 45 degrees to each side of the axis of its
/// `orientation`. A residual may lead beyond, to where another axis is nearer: that one becomes the
/// orientation and the angle is measured from there. Beyond the edge on the negative side the new
/// axis points the other way: the components change their signs, and a normal its direction. Beyond
/// a second edge there is no value.
std::optional<QuantizedDirection> predicted_value(const PredictiveLayout& layout,
                                                  const QuantizedDirection& previous,
                                                  const PredictiveStep& step);

/// The step with predicted_value(layout, previous, step) == next; of two the shorter one (to a
/// direction exactly on an edge, seen from the other side, there is only a long one). The
/// components of `next` must be of a value that quantize gives.
PredictiveStep step_between(const PredictiveLayout& layout, const QuantizedDirection& previous,
                            const QuantizedDirection& next);

}  // namespace afx::bifs

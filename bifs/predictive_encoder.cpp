// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Predictive MF fields. The structure, its source and its doubts: predictive_model.h.
#include "bifs/predictive_encoder.h"

#include <algorithm>
#include <cmath>

#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"
#include "bifs/residual_encoder.h"

namespace afx::bifs {

namespace {

using Kind = ElementCoding::Kind;

/// Least and greatest residual of each bound.
struct ResidualRange {
  std::array<std::optional<int64_t>, 3> least, greatest;
};

class PredictiveEncoder {
 public:
  PredictiveEncoder(const PredictiveLayout& layout, std::span<const QuantizedDirection> values,
                    const PredictivePlan& plan)
      : layout_(layout), values_(values), plan_(plan) {
    for (size_t i = 1; i < values.size(); ++i)
      steps_.push_back(step_between(layout, values[i - 1], values[i]));
  }

  std::optional<std::vector<bool>> encode() {
    if (!adopt(range_from(0))) return std::nullopt;
    put_header();
    for (size_t i = 0; i < values_.size(); ++i) {
      const bool intra = is_intra(i);
      if (plan_.mode == IntraMode::flagged && i > 0) code().encode(intra_model_, intra ? 1 : 0);
      if (!intra) {
        put_predicted(step_to(i));
      } else if (!put_intra(i)) {
        return std::nullopt;
      }
    }
    end_code();
    return std::move(out_);
  }

 private:
  [[nodiscard]] const PredictiveStep& step_to(size_t i) const { return steps_[i - 1]; }

  [[nodiscard]] bool is_intra(size_t i) const {
    if (i == 0) return true;
    if (plan_.mode == IntraMode::periodic) return i % plan_.period == 0;
    return plan_.mode == IntraMode::flagged && !is_in_window(step_to(i));
  }

  [[nodiscard]] bool is_in_window(const PredictiveStep& step) const {
    const int64_t half = (int64_t{1} << plan_.window_bits) / 2;
    return std::all_of(step.residual.begin(), step.residual.end(), [half](int64_t residual) {
      return residual == 0 || (residual >= -half && residual < half);
    });
  }

  /// The residuals from value i on: of its period, or of all.
  [[nodiscard]] ResidualRange range_from(size_t i) const {
    const bool all = plan_.mode != IntraMode::periodic;
    const size_t end =
        all ? values_.size() : std::min<uint64_t>(values_.size(), uint64_t{i} + plan_.period);
    ResidualRange range;
    for (++i; i < end; ++i) {
      if (is_intra(i)) continue;
      for (size_t k = 0; k < layout_.components; ++k) {
        const int64_t residual = step_to(i).residual[k];
        auto& least = range.least[layout_.bound_of(k)];
        auto& greatest = range.greatest[layout_.bound_of(k)];
        least = std::min(least.value_or(residual), residual);
        greatest = std::max(greatest.value_or(residual), residual);
      }
    }
    return range;
  }

  /// Whether the parameters at work hold these residuals.
  [[nodiscard]] bool holds(const ResidualRange& range) const {
    const int64_t count = int64_t{1} << parameters_.width;
    for (size_t i = 0; i < layout_.bounds; ++i) {
      const int64_t minimum = parameters_.minimum[i];
      if (range.least[i] && (*range.least[i] < minimum || *range.greatest[i] >= minimum + count))
        return false;
    }
    return true;
  }

  /// Makes the narrowest parameters for these residuals those at work, and new models.
  [[nodiscard]] bool adopt(const ResidualRange& range) {
    parameters_ = {};
    for (size_t i = 0; i < layout_.bounds; ++i) {
      if (!range.least[i]) continue;
      parameters_.minimum[i] = *range.least[i];
      const auto spread = static_cast<uint64_t>(*range.greatest[i] - *range.least[i]);
      parameters_.width = std::max(parameters_.width, bits_for(spread));
      if (*range.least[i] < -(int64_t{1} << layout_.bits)) return false;
    }
    if (parameters_.width > FrequencyModel::kMaxSymbolBits) return false;
    intra_model_ = FrequencyModel(2);
    flip_model_ = FrequencyModel(2);
    models_.assign(layout_.bounds, FrequencyModel(uint32_t{1} << parameters_.width));
    return true;
  }

  void put(uint64_t value, unsigned bits) {
    for (unsigned bit = bits; bit-- > 0;) out_.push_back((value >> bit & 1U) != 0);
  }
  void put_sized(uint64_t value) {
    put(bits_for(value), 5);
    put(value, bits_for(value));
  }

  void put_header() {
    put_sized(values_.size());
    put(static_cast<uint64_t>(plan_.mode), 2);
    if (plan_.mode == IntraMode::periodic) put_sized(plan_.period);
    put_parameters();
  }

  void put_parameters() {
    put(parameters_.width, 5);
    for (size_t i = 0; i < layout_.bounds; ++i)
      put(static_cast<uint64_t>(parameters_.minimum[i] + (int64_t{1} << layout_.bits)),
          layout_.bits + 1);
  }

  [[nodiscard]] bool put_intra(size_t i) {
    end_code();
    if (i > 0) {
      const ResidualRange range =
          plan_.mode == IntraMode::periodic ? range_from(i) : ResidualRange{};
      const bool renew = !holds(range);
      put(renew ? 1 : 0, 1);
      if (renew && !adopt(range)) return false;
      if (renew) put_parameters();
    }
    const QuantizedDirection& value = values_[i];
    if (layout_.has_sign()) put(value.negative ? 1 : 0, 1);
    if (layout_.is_direction()) put(value.orientation, 2);
    for (size_t k = 0; k < layout_.components; ++k) put(value.components[k], layout_.bits);
    return true;
  }

  void put_predicted(const PredictiveStep& step) {
    if (layout_.has_sign()) code().encode(flip_model_, step.flip ? 1 : 0);
    for (size_t k = 0; k < layout_.components; ++k) {
      const size_t bound = layout_.bound_of(k);
      const auto symbol = static_cast<uint32_t>(step.residual[k] - parameters_.minimum[bound]);
      code().encode(models_[bound], symbol);
    }
  }

  ResidualEncoder& code() {
    if (!code_) code_.emplace(out_);
    return *code_;
  }
  void end_code() {
    if (code_) code_->finish();
    code_.reset();
  }

  const PredictiveLayout& layout_;
  std::span<const QuantizedDirection> values_;
  const PredictivePlan& plan_;
  std::vector<PredictiveStep> steps_;  // [i] leads from value i to i + 1
  PredictiveParameters parameters_;
  FrequencyModel intra_model_;
  FrequencyModel flip_model_;
  std::vector<FrequencyModel> models_;  // of each bound
  std::optional<ResidualEncoder> code_;
  std::vector<bool> out_;
};

std::optional<QuantizedDirection> linear_codes(std::initializer_list<float> values,
                                               const ElementCoding& coding) {
  QuantizedDirection codes;
  size_t i = 0;
  for (const float value : values) {
    if (!std::isfinite(coding.hi[i] - coding.lo[i])) return std::nullopt;
    codes.components[i] = quantize(value, coding.lo[i], coding.hi[i], coding.bits);
    ++i;
  }
  return codes;
}

/// The codes of an element; none where the plain form cannot hold it either.
std::optional<QuantizedDirection> codes_of(int32_t value, const ElementCoding& coding) {
  const int64_t code = int64_t{value} - coding.offset;
  if (code < 0 || code >> coding.bits != 0) return std::nullopt;
  QuantizedDirection codes;
  codes.components[0] = static_cast<uint32_t>(code);
  return codes;
}
std::optional<QuantizedDirection> codes_of(float v, const ElementCoding& coding) {
  return linear_codes({v}, coding);
}
std::optional<QuantizedDirection> codes_of(const glm::vec2& v, const ElementCoding& coding) {
  return linear_codes({v.x, v.y}, coding);
}
std::optional<QuantizedDirection> codes_of(const glm::vec3& v, const ElementCoding& coding) {
  if (coding.kind != Kind::normal) return linear_codes({v.x, v.y, v.z}, coding);
  if (coding.bits < 2) return std::nullopt;
  return quantize_normal(v, coding.bits);
}
std::optional<QuantizedDirection> codes_of(const nodes::Rotation& v, const ElementCoding& coding) {
  if (coding.bits < 2) return std::nullopt;
  return quantize_rotation(v, coding.bits);
}

/// The codes of all; empty where one has none.
template <Predictable T>
std::vector<QuantizedDirection> all_codes(const std::vector<T>& list, const ElementCoding& coding) {
  std::vector<QuantizedDirection> codes;
  for (const T& element : list) {
    const auto one = codes_of(element, coding);
    if (!one) return {};
    codes.push_back(*one);
  }
  return codes;
}

/// Bits of the plain form behind usePredictive, list or vector.
uint64_t plain_bits(const PredictiveLayout& layout, uint64_t count) {
  const uint64_t element = layout.components * layout.bits + (layout.is_direction() ? 2 : 0) +
                           (layout.has_sign() ? 1 : 0);
  return 2 + std::min(count + 1, uint64_t{bits_for(count)} + 5) + count * element;
}

}  // namespace

std::optional<std::vector<bool>> encode_predictive(const PredictiveLayout& layout,
                                                   std::span<const QuantizedDirection> values,
                                                   const PredictivePlan& plan) {
  if (values.empty() || (plan.mode == IntraMode::periodic && plan.period == 0)) return std::nullopt;
  return PredictiveEncoder(layout, values, plan).encode();
}

std::optional<std::vector<bool>> shortest_predictive(const PredictiveLayout& layout,
                                                     std::span<const QuantizedDirection> values) {
  std::optional<std::vector<bool>> best = encode_predictive(layout, values, {});
  for (unsigned bits = 0; bits <= std::min(layout.bits, FrequencyModel::kMaxSymbolBits); ++bits) {
    auto other = encode_predictive(layout, values, {IntraMode::flagged, 0, bits});
    if (other && (!best || other->size() < best->size())) best = std::move(other);
  }
  return best;
}

/// Writes usePredictive and, where it is 1, the field. False: the plain form is to follow.
bool FrameEncoder::predictive(const nodes::FieldDefinition& field, const ElementCoding& coding,
                              const nodes::FieldValue& written) {
  std::optional<std::vector<bool>> bits;
  if (options_.predictive && coding.kind != Kind::plain) {
    const PredictiveLayout layout(field, coding);
    std::visit(
        [&]<class T>(const T& list) {
          if constexpr (kIsPredictableList<T>)
            bits = shortest_predictive(layout, all_codes(list, coding));
          if (bits && bits->size() >= plain_bits(layout, element_count(written))) bits.reset();
        },
        written);
  }
  put_flag(bits.has_value());
  if (!bits) return false;
  for (const bool bit : *bits) put_flag(bit);
  return true;
}

}  // namespace afx::bifs

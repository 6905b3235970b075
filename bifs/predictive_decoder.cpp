// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Predictive MF fields. The structure, its source and its doubts: predictive_model.h.
#include <algorithm>
#include <optional>
#include <string>

#include "bifs/decoder_frame.h"
#include "bifs/predictive_model.h"
#include "bifs/residual_decoder.h"

namespace afx::bifs {

/// Decodes one predictive MF field, from behind usePredictive.
class PredictiveDecoder {
 public:
  PredictiveDecoder(FrameDecoder& in, const nodes::FieldDefinition& field,
                    const ElementCoding& coding)
      : in_(in), coding_(coding), layout_(field, coding) {}

  template <class T>
  void read(std::vector<T>& out) {
    read_header();
    if (!in_.take(count_, sizeof(T))) return;
    for (uint32_t i = 0; i < count_ && in_.ok(); ++i) {
      if (is_intra(i)) {
        read_intra(i > 0);
      } else {
        read_predicted();
      }
      T element{};
      if (in_.ok()) restore(element);
      out.push_back(element);
    }
    end_code();
  }

 private:
  uint32_t u(unsigned bits, std::string_view name) { return in_.u(bits, name); }

  void read_header() {
    count_ = u(u(5, "nbBits"), "count");
    const uint32_t mode = u(2, "intraMode");
    if (mode == 3)
      return in_.fail(Errc::malformed, "intraMode is 3, which is reserved [expected 0 to 2]");
    mode_ = static_cast<IntraMode>(mode);
    if (mode_ == IntraMode::periodic) {
      period_ = u(u(5, "periodNbBits"), "period");
      if (period_ == 0) in_.fail(Errc::malformed, "the intra period is 0 [expected 1 or more]");
    }
    read_parameters();
  }

  /// Parameters, and new models for them.
  void read_parameters() {
    parameters_.width = u(5, "compNbBits");
    if (parameters_.width > FrequencyModel::kMaxSymbolBits)
      return in_.fail(Errc::malformed, "compNbBits is " + std::to_string(parameters_.width) +
                                           ": the frequencies of so many residuals do not fit the "
                                           "arithmetic coder [expected 0 to 13]");
    for (size_t i = 0; i < layout_.bounds; ++i)
      parameters_.minimum[i] =
          int64_t{u(layout_.bits + 1, "compMin")} - (int64_t{1} << layout_.bits);
    intra_model_ = FrequencyModel(2);
    flip_model_ = FrequencyModel(2);
    models_.clear();  // made when a residual needs them
  }

  /// Whether value i is intra.
  bool is_intra(uint32_t i) {
    if (i == 0) return true;
    if (mode_ == IntraMode::periodic) return i % period_ == 0;
    return mode_ == IntraMode::flagged && code().decode(intra_model_) == 1;
  }

  void read_intra(bool may_renew) {
    end_code();
    if (may_renew && u(1, "newParameters") != 0) read_parameters();
    if (!in_.ok()) return;
    if (layout_.is_direction()) {
      value_ = in_.read_direction(layout_.has_sign(), layout_.components, layout_.bits);
    } else {
      for (size_t i = 0; i < layout_.components; ++i)
        value_.components[i] = u(layout_.bits, "component");
    }
  }

  void read_predicted() {
    if (models_.empty() && !make_models()) return;
    PredictiveStep step;
    step.flip = layout_.has_sign() && code().decode(flip_model_) == 1;
    for (size_t i = 0; i < layout_.components; ++i) {
      const size_t bound = layout_.bound_of(i);
      step.residual[i] = parameters_.minimum[bound] + int64_t{code().decode(models_[bound])};
    }
    const auto next = predicted_value(layout_, value_, step);
    if (next && in_.in_->bit() + code_->bits() <= uint64_t{in_.data_.size()} * 8) {
      value_ = *next;
      return;
    }
    end_code();  // fails where the data end and the value may have been guessed
    in_.fail(Errc::malformed,
             "a predicted value is outside the range of the quantizer [expected residuals that "
             "stay within it]");
  }

  /// Their symbols count as values, so that models renewed over and over are limited too.
  bool make_models() {
    const uint32_t symbols = uint32_t{1} << parameters_.width;
    if (!in_.take(uint64_t{symbols} * layout_.bounds, 0)) return false;
    models_.assign(layout_.bounds, FrequencyModel(symbols));
    return true;
  }

  ResidualDecoder& code() {
    if (!code_) code_.emplace(in_.data_, in_.in_->bit());
    return *code_;
  }

  /// Goes on behind the code, if one is open.
  void end_code() {
    if (!code_ || !in_.ok()) return;
    for (uint64_t left = code_->bits(); left > 0 && in_.ok();) {
      const auto part = static_cast<unsigned>(std::min<uint64_t>(left, 32));
      u(part, "residuals");
      left -= part;
    }
    if (!code_->is_stuffed_well())
      in_.fail(Errc::malformed, "22 zeros in a row in the residuals [expected a 1 behind them]");
    if (!code_->ends_well()) warn_of_ending(code_->looked_past_end());
    code_.reset();
  }

  /// Where the data end too, symbols have been guessed from the zeros behind them.
  void warn_of_ending(bool at_end_of_data) {
    if (at_end_of_data) in_.fail(Errc::truncated, "the data end inside residuals");
    if (in_.ok())
      in_.warn("residual_ending",
               "the residuals do not end as an encoder leaves them: they may be damaged");
  }

  [[nodiscard]] float component(size_t i) const {
    return dequantize(value_.components[i], coding_.lo[i], coding_.hi[i], coding_.bits);
  }
  void restore(int32_t& out) const {
    // Modulo 2^32 where a hostile bound asks for it, as in the plain form.
    out = static_cast<int32_t>(int64_t{value_.components[0]} + coding_.offset);
  }
  void restore(float& out) const { out = component(0); }
  void restore(glm::vec2& out) const { out = {component(0), component(1)}; }
  void restore(glm::vec3& out) {
    if (layout_.kind == ElementCoding::Kind::normal)
      return restore(out, dequantize_normal(value_, layout_.bits));
    out = {component(0), component(1), component(2)};
  }
  void restore(nodes::Rotation& out) { restore(out, dequantize_rotation(value_, layout_.bits)); }
  template <class T>
  void restore(T& out, const Result<T>& direction) {
    if (direction.ok()) {
      out = direction.value();
    } else {
      in_.fail(direction.error().code, direction.error().text);
    }
  }

  FrameDecoder& in_;
  const ElementCoding& coding_;
  PredictiveLayout layout_;
  uint32_t count_ = 0;
  IntraMode mode_ = IntraMode::first;
  uint32_t period_ = 0;
  PredictiveParameters parameters_;
  FrequencyModel intra_model_;
  FrequencyModel flip_model_;
  std::vector<FrequencyModel> models_;  // of each bound
  std::optional<ResidualDecoder> code_;
  QuantizedDirection value_;
};

/// Fields that are not quantized numbers have been refused before.
nodes::FieldValue FrameDecoder::read_predictive(const nodes::FieldDefinition& field,
                                                const ElementCoding& coding) {
  const Part part(*this, "PredictiveMFField");
  nodes::FieldValue value = zero_value(field.type);
  PredictiveDecoder decoder(*this, field, coding);
  std::visit(
      [&]<class T>(T& list) {
        if constexpr (kIsPredictableList<T>) decoder.read(list);
      },
      value);
  return value;
}

}  // namespace afx::bifs

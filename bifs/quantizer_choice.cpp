// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/quantizer_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "nodes/definitions.h"

namespace afx::bifs {

namespace {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeDefinition;
using Kind = ElementCoding::Kind;

constexpr unsigned kMaxBits = 31;
constexpr unsigned kFloatBits = 32;
constexpr const char* kNormal = "normal";

unsigned least_bits(const std::string& name) { return name == kNormal ? 2 : 1; }

/// Numbers in an element of these types; 0 for types that are never quantized.
unsigned component_count(FieldType type) {
  switch (element_type(type)) {
    case FieldType::sf_float:
    case FieldType::sf_int32:
      return 1;
    case FieldType::sf_vec2f:
      return 2;
    case FieldType::sf_vec3f:
    case FieldType::sf_color:
      return 3;
    case FieldType::sf_rotation:
      return 4;
    default:
      return 0;
  }
}

/// Whether the category quantizes fields of that type.
bool is_quantized_type(const FieldDefinition& field) {
  const bool is_rotation = element_type(field.type) == FieldType::sf_rotation;
  if (field.quant_category == kCategoryNormal)
    return element_type(field.type) == FieldType::sf_vec3f;
  if (field.quant_category == kCategoryRotation) return is_rotation;
  return component_count(field.type) > 0 && !is_rotation;
}

/// As the coding compares: in binary32.
bool is_in(const std::optional<nodes::Bounds>& bounds, float value) {
  return !bounds ||
         (value >= static_cast<float>(bounds->lower) && value <= static_cast<float>(bounds->upper));
}

/// One category and its values.
class Category {
 public:
  Category(std::string name, const CategoryChoice& choice)
      : name_(std::move(name)), choice_(choice), bits_(choice.bits) {}

  void add(const QuantizedValue& value) {
    values_.push_back(value);
    has_rotations_ = has_rotations_ || value.field->quant_category == kCategoryRotation;
  }
  [[nodiscard]] bool is_empty() const { return values_.empty(); }

  /// Finds range and bits. Returns why the category cannot be quantized; empty: it can.
  std::string prepare(bool for_gpac) {
    if (!choice_.on) return "it is switched off";
    std::string obstacle = name_ == kNormal ? check_directions(for_gpac) : find_range(for_gpac);
    if (obstacle.empty()) obstacle = find_bits();
    if (obstacle.empty() && !saves()) obstacle = "it would not make the stream shorter";
    return obstacle;
  }

  void put_fields(std::vector<nodes::FieldEntry>& out) const {
    put(out, "NbBits", static_cast<int32_t>(bits_));
    if (name_ == kNormal) return;
    put(out, "Min", bound(lo_));
    put(out, "Max", bound(hi_));
  }

 private:
  using Range = std::array<float, 3>;

  std::string check_directions(bool for_gpac) const {
    if (for_gpac) return "GPAC decodes normals and rotations wrongly";
    for (const QuantizedValue& value : values_)
      if (!has_directions(*value.value))
        return label(value) + ": a value without direction, or an infinity or NaN";
    return {};
  }

  static bool has_directions(const FieldValue& value) {
    const auto fits = []<class T>(const T& v) {
      if constexpr (std::is_same_v<T, glm::vec3>) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && v != glm::vec3(0);
      } else if constexpr (std::is_same_v<T, nodes::Rotation>) {
        return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) &&
               std::isfinite(v.angle);
      } else {
        return true;
      }
    };
    return std::visit(
        [&]<class T>(const T& v) {
          if constexpr (requires { v.begin(); }) {
            return std::all_of(v.begin(), v.end(), fits);
          } else {
            return fits(v);
          }
        },
        value);
  }

  std::string find_range(bool for_gpac) {
    lo_.fill(std::numeric_limits<float>::infinity());
    hi_.fill(-std::numeric_limits<float>::infinity());
    for (const QuantizedValue& value : values_) {
      if (element_type(value.field->type) == FieldType::sf_int32)
        return label(value) + " holds integers";
      if (for_gpac && !value.field->bounds)
        return label(value) + " has no bounds, without which GPAC decodes it wrongly";
      std::string obstacle = add_to_range(value);
      if (!obstacle.empty()) return obstacle;
    }
    for (size_t i = 0; i < lo_.size(); ++i)
      if (lo_[i] > hi_[i]) lo_[i] = hi_[i] = 0;  // a component that no value has
    return check_range();
  }

  std::string add_to_range(const QuantizedValue& value) {
    const auto& bounds = value.field->bounds;
    bool is_finite = true;
    bool is_inside = true;
    bool is_codable = true;
    for_each_component(*value.value, [&](float v, size_t component) {
      const size_t i = is_vector() ? component : 0;
      is_codable = is_codable && (i < used_components() || v == 0);
      is_finite = is_finite && std::isfinite(v);
      is_inside = is_inside && is_in(bounds, v);
      lo_[i] = std::min(lo_[i], v);
      hi_[i] = std::max(hi_[i], v);
    });
    if (!is_finite) return label(value) + ": an infinity or NaN";
    if (!is_codable)  // such as the weights of a NurbsCurve2D: category 2 has two bounds
      return label(value) + ": a component for which " + name_ + "Min and Max have no number";
    return is_inside ? std::string{} : label(value) + ": a value outside the range of the field";
  }

  /// Whether Min and Max may have the values.
  std::string check_range() const {
    const FieldDefinition& min = definition_of("Min");
    const FieldDefinition& max = definition_of("Max");
    for (size_t i = 0; i < used_components(); ++i)
      if (!is_in(min.bounds, lo_[i]) || !is_in(max.bounds, hi_[i]))
        return "a value outside the range of " + min.name + " and " + max.name;
    return {};
  }

  std::string find_bits() {
    if (is_constant()) bits_ = 1;
    if (choice_.largest_error && !is_constant()) {
      bits_ = least_bits(name_);
      while (bits_ <= kMaxBits && !is_within(*choice_.largest_error)) ++bits_;
      if (bits_ > kMaxBits) return "31 bits do not reach the largest error that is asked for";
    }
    for (size_t i = 0; i < used_components(); ++i)
      if (std::ldexp(double{hi_[i]} - lo_[i], static_cast<int>(bits_)) >
          double{std::numeric_limits<float>::max()})
        return "a range too wide for binary32";
    return {};
  }

  [[nodiscard]] bool is_within(double relative_error) const {
    ElementCoding coding;
    coding.bits = bits_;
    if (name_ == kNormal) {
      coding.kind = has_rotations_ ? Kind::rotation : Kind::normal;
      return error_bound(coding, 0) <= relative_error * std::numbers::pi;
    }
    coding.kind = Kind::linear;
    coding.lo = lo_;
    coding.hi = hi_;
    for (size_t i = 0; i < used_components(); ++i)
      if (error_bound(coding, i) > relative_error * (double{hi_[i]} - lo_[i])) return false;
    return true;
  }

  /// Whether the values become shorter by more than the fields of the quantizer cost.
  [[nodiscard]] bool saves() const {
    const auto bits = static_cast<int64_t>(bits_);
    int64_t saved = 0;
    for (const QuantizedValue& value : values_) {
      const auto count = static_cast<int64_t>(element_count(*value.value));
      const auto components = int64_t{component_count(value.field->type)};
      int64_t written = components * bits;
      if (value.field->quant_category == kCategoryNormal) written = 3 + 2 * bits;
      if (value.field->quant_category == kCategoryRotation) written = 2 + 3 * bits;
      saved += count * (components * kFloatBits - written);
    }
    const size_t numbers = name_ == kNormal ? 1 : 1 + 2 * used_components();
    return saved > static_cast<int64_t>(numbers * kFloatBits);
  }

  /// Whether Min and Max have a number for each component.
  [[nodiscard]] bool is_vector() const { return used_components() > 1; }
  [[nodiscard]] size_t used_components() const {
    if (name_ == kNormal) return 0;
    return component_count(definition_of("Min").type);
  }
  [[nodiscard]] bool is_constant() const { return name_ != kNormal && lo_ == hi_; }

  [[nodiscard]] const FieldDefinition& definition_of(const char* suffix) const {
    const NodeDefinition& definition = quantizer_definition();
    return definition.field(definition.find(name_ + suffix));
  }
  [[nodiscard]] FieldValue bound(const Range& range) const {
    if (used_components() == 3) return glm::vec3(range[0], range[1], range[2]);
    if (used_components() == 2) return glm::vec2(range[0], range[1]);
    return range[0];
  }
  void put(std::vector<nodes::FieldEntry>& out, const char* suffix, FieldValue value) const {
    out.push_back({quantizer_definition().find(name_ + suffix), std::move(value)});
  }
  static std::string label(const QuantizedValue& value) {
    return value.node->name + "." + value.field->name;
  }

  std::string name_;
  CategoryChoice choice_;
  std::vector<QuantizedValue> values_;
  bool has_rotations_ = false;
  Range lo_{}, hi_{};
  unsigned bits_;
};

Quantizer make_quantizer(const std::vector<nodes::FieldEntry>& fields) {
  nodes::Scene scene;
  const nodes::NodeId node = scene.add(quantizer_definition());
  for (const nodes::FieldEntry& entry : fields) scene.set_unchecked(node, entry.field, entry.value);
  return Quantizer::from_node(scene, node);
}

}  // namespace

CategoryChoices default_choices() {
  CategoryChoices choices;
  for (const CategoryFields& fields : category_fields()) choices[fields.prefix] = {};
  choices["color"].bits = 8;
  choices[kNormal].bits = 12;
  return choices;
}

std::string category_name(uint8_t category) {
  for (const CategoryFields& fields : category_fields())
    if (fields.category == category) return fields.prefix;
  return {};
}

Status check_choices(const CategoryChoices& choices) {
  const CategoryChoices known = default_choices();
  for (const auto& [name, choice] : choices) {
    if (!known.contains(name))
      return Error{Errc::bad_argument,
                   {},
                   "no quantization category '" + name + "' [expected position3D, color, ...]"};
    if (choice.bits < least_bits(name) || choice.bits > kMaxBits)
      return Error{Errc::bad_argument,
                   {},
                   name + " with " + std::to_string(choice.bits) + " bits [expected " +
                       std::to_string(least_bits(name)) + " to 31]"};
    if (choice.largest_error && !(*choice.largest_error > 0 && *choice.largest_error < 1))
      return Error{Errc::bad_argument,
                   {},
                   "the largest error of " + name + " [expected one above 0 and below 1]"};
  }
  return {};
}

double bound_of(const FieldDefinition& field, const ElementCoding& coding) {
  const bool is_linear = coding.kind == Kind::linear;
  double bound = 0;
  for (size_t i = 0; i < (is_linear ? component_count(field.type) : 1); ++i)
    bound = std::max(bound, error_bound(coding, i));
  return bound;
}

QuantizerChoice choose_quantizer(const std::vector<QuantizedValue>& values,
                                 const QuantizeOptions& options,
                                 std::vector<UnquantizedCategory>& left_out) {
  std::map<std::string, Category> categories;
  for (const CategoryFields& fields : category_fields()) {
    const auto given = options.categories.find(fields.prefix);
    const CategoryChoice choice =
        given != options.categories.end() ? given->second : CategoryChoice{.on = false};
    categories.try_emplace(fields.prefix, fields.prefix, choice);
  }
  for (const QuantizedValue& value : values)
    if (const auto found = categories.find(category_name(value.field->quant_category));
        found != categories.end() && is_quantized_type(*value.field))
      found->second.add(value);
  QuantizerChoice chosen;
  for (auto& [name, category] : categories) {
    const std::string obstacle = category.is_empty() ? "" : category.prepare(options.for_gpac);
    const bool is_on = !category.is_empty() && obstacle.empty();
    if (!obstacle.empty()) left_out.push_back({name, obstacle});
    chosen.fields.push_back({quantizer_definition().find(name + "Quant"), is_on});
    if (is_on) category.put_fields(chosen.fields);
    chosen.is_any_on = chosen.is_any_on || is_on;
  }
  chosen.quantizer = make_quantizer(chosen.fields);
  return chosen;
}

}  // namespace afx::bifs

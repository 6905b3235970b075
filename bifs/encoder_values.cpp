// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, field values (clauses not checked); spec/bifs.md 8 and 9.
#include <bit>
#include <cmath>
#include <type_traits>
#include <utility>

#include "bifs/encoder_frame.h"
#include "bifs/node_codes.h"
#include "bifs/number_run.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeId;
using Kind = ElementCoding::Kind;

namespace {

template <class T>
inline constexpr bool kIsList = false;
template <class T>
inline constexpr bool kIsList<std::vector<T>> = true;

constexpr uint32_t kMaxImageSide = 4095;
constexpr uint32_t kMaxComponents = 4;

}  // namespace

ElementCoding FrameEncoder::coding_of(const FieldDefinition& field,
                                      const nodes::NodeDefinition& layout,
                                      std::span<const nodes::FieldEntry> values) {
  const bool wants_points = quantizer_ != nullptr && field.quant_category == kCategoryIndex;
  const Result<ElementCoding> coding = element_coding(
      field, quantizer_, wants_points ? point_count(*scene_, layout, values) : std::nullopt);
  if (coding.ok()) return coding.value();
  fail(Errc::bad_argument, coding.error().text);
  return {};
}

void FrameEncoder::value(const FieldDefinition& field, const ElementCoding& coding,
                         const FieldValue& written, NodeId script_node, bool may_predict) {
  if (!holds(field.type, written)) return fail(Errc::bad_argument, "a value of another type");
  if (!is_multiple(field.type)) return element(field, coding, written);
  if (may_predict && config_.use_predictive_field && predictive(field, coding, written)) return;
  std::visit(
      [&]<class T>(const T& list) {
        if constexpr (std::is_same_v<T, std::vector<NodeId>>) {
          node_list(list, field, script_node);
        } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
          if (field.type != FieldType::mf_script)
            return multiple(list.size(), [&](size_t i) { one(list[i], coding); });
          const bool carries_fields =
              script_node.valid() && scene_->node(script_node).own_definition != nullptr;
          if (list.empty() && carries_fields)  // the fields need a text to stand with
            return multiple(1, [&](size_t) { script(script_node, {}); });
          multiple(list.size(),
                   [&](size_t i) { script(i == 0 ? script_node : NodeId{}, list[i]); });
        } else if constexpr (kIsList<T>) {
          multiple(
              list.size(), [&](size_t i) { one(list[i], coding); },
              [&] { return put_run(list, coding); });
        }
      },
      written);
}

void FrameEncoder::element(const FieldDefinition& field, const ElementCoding& coding,
                           const FieldValue& written) {
  const FieldType type = element_type(field.type);
  if (!holds(type, written)) return fail(Errc::bad_argument, "an element of another type");
  if (type == FieldType::sf_node) return node(*std::get_if<NodeId>(&written), field.data_type);
  if (type == FieldType::sf_script) return script({}, *std::get_if<std::string>(&written));
  std::visit(
      [&]<class T>(const T& v) {
        if constexpr (!kIsList<T>) one(v, coding);
      },
      written);
}

/// write_all  writes all elements of the vector form at once, if it can
template <class WriteElement, class WriteAll>
void FrameEncoder::multiple(size_t count, WriteElement write_one, WriteAll write_all) {
  put_flag(false);  // reserved
  const bool as_list =
      options_.lists == EncodeOptions::Form::list ||
      (options_.lists == EncodeOptions::Form::shorter && bits_for(count) + 5 > count + 1);
  put_flag(as_list);
  if (!as_list) put_sized(count);
  if (!as_list && ok() && write_all()) return;
  for (size_t i = 0; i < count && ok(); ++i) {
    if (as_list) put_flag(false);  // endFlag
    write_one(i);
  }
  if (as_list) put_flag(true);
}

template <class WriteElement>
void FrameEncoder::multiple(size_t count, WriteElement write_one) {
  multiple(count, write_one, [] { return false; });
}

/// Elements that are numbers of one width; false where they are not, or the quantizer cannot hold
/// one of them.
template <class T>
bool FrameEncoder::put_run(const std::vector<T>& list, const ElementCoding& coding) {
  const std::optional<unsigned> width = number_width<T>(coding);
  if (!width || !fit_numbers(list, coding)) return false;
  codec::BitWriter::Run run(out_->writer, list.size() * kNumbersIn<T>, *width);
  if constexpr (kNumbersIn<T> != 0)
    for (const T& element : list)
      to_numbers(element, coding, [&](uint32_t number) { run.u(number); });
  return true;
}

/// Elements of a list of nodes: a QuantizationParameter among them counts for those behind it.
void FrameEncoder::node_list(const std::vector<NodeId>& list, const FieldDefinition& field,
                             NodeId holder) {
  const Quantizer* const outer = quantizer_;
  std::optional<Quantizer> own;
  unsigned siblings_left = 0;  // of a local quantizer, itself included
  const auto write_one = [&](size_t i) {
    node(list[i], field.data_type);
    if (is_quantizer(*scene_, list[i])) {
      own = Quantizer::from_node(*scene_, list[i]);
      quantizer_ = &*own;
      siblings_left = own->is_local() ? 2 : 0;
    }
    if (siblings_left > 0 && --siblings_left == 0) quantizer_ = outer;
  };
  const std::vector<bool> is_marked = coding_quantizers(list, field, holder);
  if (is_marked.empty()) {
    multiple(list.size(), write_one);
    quantizer_ = outer;
    return;
  }
  put_flag(false);  // reserved
  put_flag(true);   // isList: in the vector form the peer takes no quantizer for local
  for (size_t i = 0; i < list.size() && ok(); ++i) {
    put_flag(false);  // endFlag
    if (is_marked[i]) {
      put_coding_quantizer(field.data_type);
      put_flag(false);  // endFlag
      quantizer_ = &coding_quantizer().quantizer;
    }
    write_one(i);
    if (is_marked[i]) quantizer_ = outer;
  }
  put_flag(true);  // endFlag
  quantizer_ = outer;
}

void FrameEncoder::one(bool v, const ElementCoding&) { put_flag(v); }
void FrameEncoder::one(uint8_t v, const ElementCoding&) { put_flag(v != 0); }

void FrameEncoder::one(int32_t v, const ElementCoding& coding) {
  if (coding.kind != Kind::integer) return put(static_cast<uint32_t>(v), 32);
  const int64_t code = int64_t{v} - coding.offset;
  const int64_t last = (int64_t{1} << coding.bits) - 1;
  if (code < 0 || code > last)
    return fail(Errc::bad_argument, std::to_string(v) +
                                        " cannot be written under this quantizer [expected " +
                                        std::to_string(coding.offset) + " to " +
                                        std::to_string(last + coding.offset) + "]");
  put(static_cast<uint64_t>(code), coding.bits);
}

void FrameEncoder::one(float v, const ElementCoding& coding) { put_float(v, coding, 0); }
void FrameEncoder::one(double v, const ElementCoding&) { put(std::bit_cast<uint64_t>(v), 64); }

void FrameEncoder::one(const std::string& v, const ElementCoding&) {
  put_sized(v.size());
  put_bytes({reinterpret_cast<const uint8_t*>(v.data()), v.size()});
}

void FrameEncoder::one(const nodes::Url& v, const ElementCoding& coding) {
  put_flag(v.is_descriptor());
  if (v.is_descriptor()) return put(static_cast<uint32_t>(v.object_descriptor), 10);
  one(v.text, coding);
}

void FrameEncoder::one(const glm::vec2& v, const ElementCoding& coding) {
  put_float(v.x, coding, 0);
  put_float(v.y, coding, 1);
}

void FrameEncoder::one(const glm::vec3& v, const ElementCoding& coding) {
  if (coding.kind == Kind::normal)
    return put_direction(quantize_normal(v, coding.bits), true, 2, coding.bits);
  put_float(v.x, coding, 0);
  put_float(v.y, coding, 1);
  put_float(v.z, coding, 2);
}

void FrameEncoder::one(const glm::vec4& v, const ElementCoding& coding) {
  for (int i = 0; i < 4; ++i) put_float(v[i], coding, 0);
}

void FrameEncoder::one(const nodes::Rotation& v, const ElementCoding& coding) {
  if (coding.kind == Kind::rotation)
    return put_direction(quantize_rotation(v, coding.bits), false, 3, coding.bits);
  put_float(v.x, coding, 0);
  put_float(v.y, coding, 0);
  put_float(v.z, coding, 0);
  put_float(v.angle, coding, 0);
}

void FrameEncoder::one(const nodes::Image& v, const ElementCoding&) {
  const bool fits = v.width <= kMaxImageSide && v.height <= kMaxImageSide &&
                    v.components <= kMaxComponents &&
                    v.samples.size() == size_t{v.width} * v.height * v.components;
  if (!fits)
    return fail(Errc::bad_argument,
                "an image of " + std::to_string(v.width) + " x " + std::to_string(v.height) +
                    " pixels with " + std::to_string(v.components) +
                    " components [expected sides up to 4095 and as many samples as that makes]");
  if (v.components == 0 && v.width != 0 && v.height != 0)
    return fail(Errc::bad_argument, "pixels without components [expected 1 to 4 components]");
  put(v.width, 12);
  put(v.height, 12);
  // An image of nothing is said to have four components, as the peer has it.
  put(v.components == 0 ? kMaxComponents - 1 : v.components - 1, 2);
  put_bytes(v.samples);
}

/// A command buffer is a frame of its own, coded without a quantizer.
void FrameEncoder::one(const nodes::CommandBuffer& v, const ElementCoding&) {
  const auto* buffer = dynamic_cast<const BufferedCommands*>(v.content.get());
  if (buffer == nullptr && v.text.find_first_not_of(" \t\r\n") != std::string::npos)
    return fail(Errc::unsupported, "a command buffer that is only text [expected its commands]");
  if (buffer == nullptr || buffer->commands.empty()) return put(0, 5);
  Output inner;
  Output* const outer = std::exchange(out_, &inner);
  const Quantizer* const quantizer = std::exchange(quantizer_, nullptr);
  const bool use_names = use_names_;
  for (const Command& c : buffer->commands) command(c);
  put_flag(false);  // moreCommands
  use_names_ = use_names;
  quantizer_ = quantizer;
  out_ = outer;
  put_sized(inner.bytes.size());
  put_bytes(inner.bytes);
}

void FrameEncoder::one(NodeId, const ElementCoding&) {}

void FrameEncoder::put_float(float v, const ElementCoding& coding, size_t component) {
  if (coding.kind == Kind::linear) {
    const float lo = coding.lo[component];
    const float hi = coding.hi[component];
    if (!std::isfinite(hi - lo))
      return fail(Errc::bad_argument,
                  "a quantizer without bounds for this field [expected Min and Max]");
    return put(quantize(v, lo, hi, coding.bits), coding.bits);
  }
  if (coding.efficient_floats) return put_efficient_float(v);
  put(std::bit_cast<uint32_t>(v), 32);
}

void FrameEncoder::put_efficient_float(float v) {
  const Result<EfficientFloat> result = to_efficient_float(v);
  if (!result.ok()) return fail(result.error().code, result.error().text);
  const EfficientFloat& parts = result.value();
  put(parts.mantissa_length, 4);
  if (parts.mantissa_length == 0) return;
  put(parts.exponent_length, 3);
  put_flag(parts.negative);
  put(parts.mantissa, parts.mantissa_length - 1);
  if (parts.exponent_length == 0) return;
  put_flag(parts.exponent_negative);
  put(parts.exponent, parts.exponent_length - 1);
}

void FrameEncoder::put_direction(const QuantizedDirection& direction, bool has_sign,
                                 size_t components, unsigned bits) {
  if (bits < 2)
    return fail(Errc::bad_argument, "normalNbBits is " + std::to_string(bits) +
                                        " [expected 2 to 31, or normalQuant FALSE]");
  if (has_sign) put_flag(direction.negative);
  put(direction.orientation, 2);
  for (size_t i = 0; i < components; ++i) put(direction.components[i], bits);
}

}  // namespace afx::bifs

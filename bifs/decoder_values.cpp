// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-11, field values (clauses not checked); spec/bifs.md 8 and 9.
#include <algorithm>
#include <bit>
#include <type_traits>
#include <utility>

#include "bifs/coding_quantizer.h"
#include "bifs/decoder_frame.h"
#include "bifs/number_run.h"

namespace afx::bifs {

using nodes::FieldDefinition;
using nodes::FieldType;
using nodes::FieldValue;
using nodes::NodeId;
using Kind = ElementCoding::Kind;

namespace {

template <class T>
struct ElementOf {};
template <class T>
struct ElementOf<std::vector<T>> {
  using type = T;
};
template <class T>
concept List = requires {
  typename ElementOf<T>::type;
};

}  // namespace

ElementCoding FrameDecoder::coding_of(const FieldDefinition& field,
                                      const nodes::NodeDefinition& layout,
                                      std::span<const nodes::FieldEntry> values) {
  const bool wants_points = quantizer_ != nullptr && field.quant_category == kCategoryIndex;
  const Result<ElementCoding> coding = element_coding(
      field, quantizer_, wants_points ? point_count(state_.scene, layout, values) : std::nullopt);
  if (coding.ok()) return coding.value();
  fail(coding.error().code, coding.error().text);
  return {};
}

FieldValue FrameDecoder::read_value(const FieldDefinition& field, const ElementCoding& coding,
                                    NodeId script, bool may_predict) {
  if (!is_multiple(field.type)) return read_element(field, coding);
  if (may_predict && state_.config.use_predictive_field && read_prediction_flag(coding))
    return read_predictive(field, coding);
  FieldValue value = zero_value(field.type);
  if (field.type == FieldType::mf_script) {
    auto& scripts = std::get<std::vector<std::string>>(value);
    read_multiple(sizeof(std::string), [&] { scripts.push_back(read_script(script)); });
    return value;
  }
  std::visit(
      [&]<class T>(T& list) {
        if constexpr (std::is_same_v<T, std::vector<NodeId>>) {
          read_node_list(list, field, script);
        } else if constexpr (List<T>) {
          using Element = typename ElementOf<T>::type;
          const auto read_next = [&] {
            Element element{};
            read_one(element, coding);
            list.push_back(std::move(element));
          };
          const auto read_all = [&](uint32_t count) { return read_run(list, count, coding); };
          read_multiple(sizeof(Element), read_next, read_all);
        }
      },
      value);
  return value;
}

FieldValue FrameDecoder::read_element(const FieldDefinition& field, const ElementCoding& coding) {
  const FieldType type = element_type(field.type);
  if (type == FieldType::sf_node) return read_node(field.data_type);
  if (type == FieldType::sf_script) return read_script({});
  FieldValue value = zero_value(type);
  std::visit(
      [&]<class T>(T& one) {
        if constexpr (!List<T>) read_one(one, coding);
      },
      value);
  return value;
}

/// List or vector form of the elements of an MF field.
///
/// read_all  reads all elements of the vector form at once, if it can
template <class ReadElement, class ReadAll>
void FrameDecoder::read_multiple(size_t element_bytes, ReadElement read_one_element,
                                 ReadAll read_all) {
  if (u(1, "reserved") != 0) {
    warn("reserved_bits", "a list with the reserved bit set, which is taken as empty");
    return;
  }
  if (u(1, "isList") != 0) {
    while (u(1, "endFlag") == 0 && take(1, element_bytes)) read_one_element();
    return;
  }
  const uint32_t count = u(u(5, "nbBits"), "count");
  if (!take(count, element_bytes) || read_all(count)) return;
  for (uint32_t i = 0; i < count && ok(); ++i) read_one_element();
}

template <class ReadElement>
void FrameDecoder::read_multiple(size_t element_bytes, ReadElement read_one_element) {
  read_multiple(element_bytes, read_one_element, [](uint32_t) { return false; });
}

/// Elements that are numbers of one width, into memory that is asked for when they are known to be
/// there; false where they are not, or not such.
template <class T>
bool FrameDecoder::read_run(std::vector<T>& out, uint32_t count, const ElementCoding& coding) {
  const std::optional<unsigned> width = number_width<T>(coding);
  const uint64_t numbers = uint64_t{count} * kNumbersIn<T>;
  if (!width || !in_->has_run(numbers, *width)) return false;
  out.resize(count);
  constexpr uint32_t kPiece = uint32_t{1} << 16;  // elements between two calls of `passed`
  for (uint32_t begin = 0; begin < count; begin += kPiece) {
    const std::span<T> piece = std::span(out).subspan(begin, std::min(kPiece, count - begin));
    codec::BitReader::Run run = in_->run(piece.size() * kNumbersIn<T>, *width);
    if constexpr (kNumbersIn<T> != 0)
      for (T& element : piece) from_numbers(element, coding, [&] { return run.u(); });
    if (state_.options.passed && in_ == &frame_) state_.options.passed(in_->bit() / 8);
  }
  return true;
}

bool FrameDecoder::read_prediction_flag(const ElementCoding& coding) {
  if (u(1, "usePredictive") == 0) return false;
  if (coding.kind == Kind::plain)
    fail(Errc::malformed, "predictive coding of a field that is not quantized");
  return ok();
}

/// Elements of a list of nodes: a QuantizationParameter among them counts for those behind it.
void FrameDecoder::read_node_list(std::vector<NodeId>& out, const FieldDefinition& field,
                                  NodeId holder) {
  const bool drops =
      !state_.options.keep_coding_quantizers && is_free_list(state_.scene, holder, field);
  const Quantizer* const outer = quantizer_;
  std::optional<Quantizer> own;
  unsigned siblings_left = 0;  // of a local quantizer, itself included
  read_multiple(sizeof(NodeId), [&] {
    const NodeId node = read_node(field.data_type);
    if (!drops || !is_coding_quantizer(state_.scene, node)) out.push_back(node);
    if (is_quantizer(state_.scene, node)) {
      own = Quantizer::from_node(state_.scene, node);
      quantizer_ = &*own;
      siblings_left = own->is_local() ? 2 : 0;
    }
    if (siblings_left > 0 && --siblings_left == 0) quantizer_ = outer;
  });
  quantizer_ = outer;
}

void FrameDecoder::read_one(bool& value, const ElementCoding&) { value = u(1, "SFBool") != 0; }
void FrameDecoder::read_one(uint8_t& value, const ElementCoding&) {
  value = static_cast<uint8_t>(u(1, "SFBool"));
}

void FrameDecoder::read_one(int32_t& value, const ElementCoding& coding) {
  if (coding.kind != Kind::integer) {
    value = static_cast<int32_t>(u(32, "SFInt32"));
    return;
  }
  const int64_t wide = int64_t{u(coding.bits, "SFInt32")} + coding.offset;
  value = static_cast<int32_t>(wide);  // modulo 2^32 where a hostile bound asks for it
}

void FrameDecoder::read_one(float& value, const ElementCoding& coding) {
  value = read_float(coding, 0);
}

void FrameDecoder::read_one(double& value, const ElementCoding&) {
  const uint64_t high = u(32, "SFTime");
  const uint64_t low = u(32, "SFTime");
  value = std::bit_cast<double>(high << 32 | low);
}

void FrameDecoder::read_one(glm::vec2& value, const ElementCoding& coding) {
  value.x = read_float(coding, 0);
  value.y = read_float(coding, 1);
}

void FrameDecoder::read_one(glm::vec3& value, const ElementCoding& coding) {
  if (coding.kind == Kind::normal) {
    const auto normal = dequantize_normal(read_direction(true, 2, coding.bits), coding.bits);
    if (!normal.ok()) return fail(normal.error().code, normal.error().text);
    value = normal.value();
    return;
  }
  value.x = read_float(coding, 0);
  value.y = read_float(coding, 1);
  value.z = read_float(coding, 2);
}

void FrameDecoder::read_one(glm::vec4& value, const ElementCoding& coding) {
  for (int i = 0; i < 4; ++i) value[i] = read_float(coding, 0);
}

void FrameDecoder::read_one(nodes::Rotation& value, const ElementCoding& coding) {
  if (coding.kind == Kind::rotation) {
    const auto rotation = dequantize_rotation(read_direction(false, 3, coding.bits), coding.bits);
    if (!rotation.ok()) return fail(rotation.error().code, rotation.error().text);
    value = rotation.value();
    return;
  }
  value.x = read_float(coding, 0);
  value.y = read_float(coding, 0);
  value.z = read_float(coding, 0);
  value.angle = read_float(coding, 0);
}

/// A string's length and bytes; what the bytes mean is the definition's affair.
void FrameDecoder::read_one(std::string& value, const ElementCoding&) {
  const uint32_t length = u(u(5, "nbBits"), "length");
  read_bytes(value, length, "SFString");
}

void FrameDecoder::read_one(nodes::Url& value, const ElementCoding& coding) {
  if (u(1, "isOD") != 0) {
    value.object_descriptor = static_cast<int32_t>(u(10, "ODid"));
  } else {
    read_one(value.text, coding);
  }
}

void FrameDecoder::read_one(nodes::Image& value, const ElementCoding&) {
  value.width = u(12, "width");
  value.height = u(12, "height");
  value.components = u(2, "numComponents") + 1;
  const uint64_t pixels = uint64_t{value.width} * value.height;
  if (pixels > state_.limits.picture_pixels)
    return fail(Errc::limit_exceeded, "an image of more pixels than the limit picture_pixels, " +
                                          std::to_string(state_.limits.picture_pixels));
  read_bytes(value.samples, pixels * value.components, "pixel");
}

void FrameDecoder::read_one(nodes::CommandBuffer& value, const ElementCoding&) {
  const uint64_t bit = in_->bit();
  const uint32_t length = u(u(5, "nbBits"), "length");
  if (!ok() || length == 0) return;
  if (buffer_depth_ >= kMaxBufferDepth)
    return fail(Errc::limit_exceeded,
                "command buffers nested deeper than " + std::to_string(kMaxBufferDepth));
  auto bytes = std::make_shared<std::vector<uint8_t>>();
  read_bytes(*bytes, length, "buffer");
  auto commands = std::make_shared<BufferedCommands>();
  value.content = commands;
  const uint64_t begin = in_->bit() - uint64_t{length} * 8;
  if (!ok()) return;
  buffers_.push_back({std::move(commands), std::move(bytes), buffer_depth_ == 0 ? begin : bit,
                      path_, scope_, proto_, buffer_depth_ + 1});
}

void FrameDecoder::read_one(NodeId&, const ElementCoding&) {}

float FrameDecoder::read_float(const ElementCoding& coding, size_t component) {
  if (coding.kind == Kind::linear) {
    const uint32_t code = u(coding.bits, "SFFloat");
    return dequantize(code, coding.lo[component], coding.hi[component], coding.bits);
  }
  if (coding.efficient_floats) return read_efficient_float();
  return std::bit_cast<float>(u(32, "SFFloat"));
}

float FrameDecoder::read_efficient_float() {
  EfficientFloat parts;
  parts.mantissa_length = u(4, "mantissaLength");
  if (parts.mantissa_length == 0) return 0;
  parts.exponent_length = u(3, "exponentLength");
  parts.negative = u(1, "mantissaSign") != 0;
  parts.mantissa = u(parts.mantissa_length - 1, "mantissa");
  if (parts.exponent_length > 0) {
    parts.exponent_negative = u(1, "exponentSign") != 0;
    parts.exponent = u(parts.exponent_length - 1, "exponent");
  }
  return from_efficient_float(parts);
}

QuantizedDirection FrameDecoder::read_direction(bool has_sign, size_t components, unsigned bits) {
  QuantizedDirection direction;
  if (has_sign) direction.negative = u(1, "direction") != 0;
  direction.orientation = u(2, "orientation");
  if (direction.orientation > components)
    fail(Errc::malformed, "the orientation of a normal is 3 [expected 0 to 2]");
  for (size_t i = 0; i < components; ++i) direction.components[i] = u(bits, "component");
  return direction;
}

/// Bytes into a string or a byte vector, which stays empty where they are not there.
template <class Bytes>
void FrameDecoder::read_bytes(Bytes& out, uint64_t count, std::string_view name) {
  if (ok() && count > in_->bits_left() / 8)
    fail(Errc::truncated, "the data end inside " + std::string(name) + " (expected " +
                              std::to_string(count) + " bytes, " +
                              std::to_string(in_->bits_left() / 8) + " are left)");
  if (!take(0, 0) || count == 0 || !take(0, 1)) return;
  bytes_taken_ += count;  // at most the size of the input
  out.resize(count);
  in_->bytes({reinterpret_cast<uint8_t*>(out.data()), out.size()}, name);
}

}  // namespace afx::bifs

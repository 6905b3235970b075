// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/od_command.h"

#include <optional>
#include <string>
#include <utility>

#include "bifs/descriptor_reader.h"
#include "bifs/tagged_reader.h"

namespace afx::bifs {
namespace {

using codec::BitReader;

const char* name_of(uint8_t tag) {
  switch (tag) {
    case 1:
      return "ObjectDescriptorUpdate";
    case 2:
      return "ObjectDescriptorRemove";
    case 3:
      return "ES_DescriptorUpdate";
    case 4:
      return "ES_DescriptorRemove";
    case 7:
      return "ES_DescriptorRemoveRef";
    default:
      return "command";
  }
}

class OdReader {
 public:
  OdReader(std::span<const uint8_t> data, const Limits& limits, Diagnostics& diagnostics,
           const codec::Trace* trace)
      : data_(data), limits_(limits), diagnostics_(diagnostics), trace_(trace) {}

  Result<OdCommands> read();

 private:
  OdCommand command(BitReader& in);
  void body(uint8_t tag, BitReader& in, OdCommand& out);
  OdRemove remove(BitReader& in);
  EsUpdate es_update(BitReader& in, size_t end);
  EsRemove es_remove(BitReader& in, bool references);
  Descriptors descriptors(size_t begin, size_t end, const char* path);
  Descriptors shifted_descriptors(size_t begin, size_t end);
  void expect_zero(BitReader& in, unsigned bits);

  std::span<const uint8_t> data_;
  Limits limits_;
  Diagnostics& diagnostics_;
  const codec::Trace* trace_;
  std::optional<Error> error_;
};

Result<OdCommands> OdReader::read() {
  OdCommands commands;
  BitReader in(data_, trace_);
  while (in.ok() && !error_ && in.bits_left() > 0) {
    if (limits_.memory < sizeof(OdCommand)) {
      in.fail(Errc::limit_exceeded, "the commands take more memory than the limit allows");
      break;
    }
    limits_.memory -= sizeof(OdCommand);
    commands.push_back(command(in));
  }
  if (error_) return *error_;
  if (!in.ok()) return in.error();
  return commands;
}

OdCommand OdReader::command(BitReader& in) {
  OdCommand out;
  const auto [tag, name, length, length_bytes] = read_tagged_header(in, name_of, "", "access unit");
  if (!in.ok()) return out;
  out.length_bytes = length_bytes;
  const uint64_t end = in.bit() + length * 8;
  BitReader inner(data_.first(end / 8), trace_);
  inner.seek(in.bit());
  body(tag, inner, out);
  if (!inner.ok() && !error_) error_ = inner.error();
  in.seek(end);
  return out;
}

void OdReader::body(uint8_t tag, BitReader& in, OdCommand& out) {
  const BitReader::Scope scope(in, name_of(tag));
  const size_t begin = in.bit() / 8;
  const size_t end = begin + in.bits_left() / 8;
  switch (tag) {
    case 1:
      out.body = OdUpdate{descriptors(begin, end, "ObjectDescriptorUpdate")};
      return;
    case 2:
      out.body = remove(in);
      return;
    case 3:
      out.body = es_update(in, end);
      return;
    case 4:
    case 7:
      out.body = es_remove(in, tag == 7);
      return;
    default:
      out.body = UnknownOdCommand{tag,
                                  {data_.begin() + static_cast<ptrdiff_t>(begin),
                                   data_.begin() + static_cast<ptrdiff_t>(end)}};
      return;
  }
}

void OdReader::expect_zero(BitReader& in, unsigned bits) {
  const uint64_t at = in.bit();
  if (in.u(bits, "padding") != 0) {
    diagnostics_.warn("padding", Place::at_bit(at), "padding bits are not 0");
  }
}

OdRemove OdReader::remove(BitReader& in) {
  OdRemove remove;
  while (in.ok() && in.bits_left() >= 10) {
    remove.ids.push_back(static_cast<uint16_t>(in.u(10, "objectDescriptorId")));
  }
  if (in.bits_left() == 8) {  // the padding is shorter than a byte
    diagnostics_.warn("padding", Place::at_bit(in.bit()), "a whole byte stands behind the last ID");
  }
  expect_zero(in, static_cast<unsigned>(in.bits_left()));
  return remove;
}

EsUpdate OdReader::es_update(BitReader& in, size_t end) {
  EsUpdate update;
  update.od_id = static_cast<uint16_t>(in.u(10, "objectDescriptorId"));
  if (!in.ok()) return update;
  const size_t begin = in.bit() / 8;  // the byte in which the 10 bits end
  // Unaligned, the tag (3 or 15, so no bit of 6 and 7) fills these bits; aligned, they are 0 and
  // the next two bits too: only an unaligned stream of tag 3 begins with six zero bits, and then
  // has 11.
  const bool unaligned =
      end - begin > 1 && ((data_[begin] & 0x3F) != 0 || data_[begin + 1] >= 0xC0);
  if (!unaligned) expect_zero(in, 6);
  update.aligned = !unaligned && end - begin > 1;
  update.streams = unaligned ? shifted_descriptors(begin, end)
                             : descriptors(begin + 1, end, "ES_DescriptorUpdate");
  return update;
}

/// Descriptors that begin behind the two upper bits of byte `begin`: moved by two bits to the left,
/// which leaves 6 bits of padding in the last byte.
Descriptors OdReader::shifted_descriptors(size_t begin, size_t end) {
  std::vector<uint8_t> moved(data_.begin(), data_.begin() + static_cast<ptrdiff_t>(end));
  for (size_t i = begin; i + 1 < end; ++i) {
    moved[i] = static_cast<uint8_t>(data_[i] << 2 | data_[i + 1] >> 6);
  }
  if ((data_[end - 1] & 0x3F) != 0) {
    diagnostics_.warn("padding", Place::at_bit(end * 8 - 6), "padding bits are not 0");
  }
  const codec::Trace trace = [this](const codec::TraceElement& element) {
    codec::TraceElement back = element;
    back.bit += 2;
    (*trace_)(back);
  };
  DescriptorReadOptions options{limits_, trace_ != nullptr ? &trace : nullptr, begin,
                                "ES_DescriptorUpdate"};
  Diagnostics inner;
  auto read = read_descriptors(std::span(moved).first(end - 1), options, inner);
  for (const Warning& warning : inner.warnings()) {
    diagnostics_.warn(warning.code, Place::at_bit(warning.place.bit + 2), warning.text);
  }
  if (read.ok()) return std::move(read).value();
  error_ = std::move(read).error();
  error_->place.bit += 2;
  return {};
}

EsRemove OdReader::es_remove(BitReader& in, bool references) {
  EsRemove remove;
  remove.references = references;
  remove.od_id = static_cast<uint16_t>(in.u(10, "objectDescriptorId"));
  expect_zero(in, 6);
  while (in.ok() && in.bits_left() > 0) {
    remove.streams.push_back(static_cast<uint16_t>(in.u(16, references ? "ref_index" : "ES_ID")));
  }
  return remove;
}

Descriptors OdReader::descriptors(size_t begin, size_t end, const char* path) {
  DescriptorReadOptions options{limits_, trace_, begin, path};
  auto read = read_descriptors(data_.first(end), options, diagnostics_);
  if (read.ok()) return std::move(read).value();
  error_ = std::move(read).error();
  return {};
}

}  // namespace

Result<OdCommands> read_od_commands(std::span<const uint8_t> data, const Limits& limits,
                                    Diagnostics& diagnostics, const codec::Trace* trace) {
  return OdReader(data, limits, diagnostics, trace).read();
}

}  // namespace afx::bifs

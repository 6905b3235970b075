// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_box_reader.h"

#include <algorithm>

namespace afx::bifs {
namespace {

/// Whether there are usually several boxes of a type beside each other, so that a path counts them.
bool is_counted(FourCc type) {
  return type == fourcc("trak") || type == fourcc("traf") || type == fourcc("trun") ||
         type == fourcc("trex");
}

}  // namespace

Status Mp4Context::charge(uint64_t amount, const Mp4Part& part) {
  if (amount > memory_left) {
    return mp4_error(Errc::limit_exceeded, part, part.offset,
                     "what it describes takes more memory than the limit allows (" +
                         std::to_string(limits.memory) + " bytes for the whole file)");
  }
  memory_left -= amount;
  return {};
}

void Mp4Context::warn(const char* code, const Mp4Part& part, const std::string& text) {
  diagnostics.warn(code, Place::at_byte(part.offset), part.path + ": " + text);
}

Error mp4_error(Errc code, const Mp4Part& part, uint64_t offset, const std::string& text) {
  return {code, Place::at_byte(offset), part.path + ": " + text};
}

Mp4Fields::Mp4Fields(const Mp4Part& part, const Mp4Context& context)
    : part_(part), trace_(context.trace) {}

void Mp4Fields::fail(Errc code, const std::string& text) {
  if (ok()) error_ = mp4_error(code, part_, part_.offset + element_, text);
}

bool Mp4Fields::need(uint64_t count, const char* name) {
  if (!ok()) return false;
  element_ = at_;
  if (count <= left()) return true;
  fail(Errc::truncated, std::string("the box ends inside ") + name + " (expected " +
                            std::to_string(count) + " bytes, " + std::to_string(left()) +
                            " are left)");
  return false;
}

uint64_t Mp4Fields::u(unsigned bytes, const char* name) {
  if (!need(bytes, name)) return 0;
  uint64_t value = 0;
  for (unsigned i = 0; i < bytes; ++i) value = value << 8 | part_.bytes[at_ + i];
  if (trace_ != nullptr) {
    const std::string path = part_.path + "/" + name;
    (*trace_)({(part_.offset + at_) * 8, bytes * 8, path, value});
  }
  at_ += bytes;
  return value;
}

Mp4Fields::Version Mp4Fields::version(unsigned most) {
  const unsigned version = u8("version");
  const uint64_t at = element_;
  const auto flags = static_cast<uint32_t>(u(3, "flags"));
  if (version > most && ok()) {
    element_ = at;
    fail(Errc::unsupported, "version " + std::to_string(version) +
                                " is not known (expected at most " + std::to_string(most) + ")");
  }
  return {version, flags};
}

uint32_t Mp4Fields::count(unsigned element_bits, const char* name) {
  const uint32_t count = u32(name);
  if (ok() && uint64_t{count} * element_bits > left() * 8) {
    fail(Errc::truncated, std::string(name) + " is " + std::to_string(count) +
                              ", which is more than the " + std::to_string(left()) +
                              " bytes behind it hold");
    return 0;
  }
  return count;
}

std::span<const uint8_t> Mp4Fields::bytes(uint64_t count, const char* name) {
  if (!need(count, name)) return {};
  const auto part = part_.bytes.subspan(at_, count);
  at_ += count;
  return part;
}

std::optional<Mp4Part> Mp4Fields::box() {
  if (!ok() || left() == 0) return std::nullopt;
  const size_t begin = at_;
  uint64_t size = u32("size");
  const auto type = u32("type");
  if (size == 1) size = u(8, "largesize");
  if (!ok()) return std::nullopt;
  const uint64_t header = at_ - begin;
  element_ = begin;
  if (size < header) {
    fail(Errc::malformed, "the size of '" + to_string(type) + "' is " + std::to_string(size) +
                              " (expected at least its header of " + std::to_string(header) +
                              " bytes)");
    return std::nullopt;
  }
  if (size - header > left()) {
    fail(Errc::truncated, "'" + to_string(type) + "' ends behind the box it is in (expected " +
                              std::to_string(size - header) + " bytes, " + std::to_string(left()) +
                              " are left)");
    return std::nullopt;
  }
  Mp4Part part{type, part_.bytes.subspan(at_, size - header), offset(), part_.offset + begin,
               part_.path + "/" + to_string(type)};
  if (is_counted(type)) part.path += "[" + std::to_string(seen_[type]++) + "]";
  at_ = begin + size;
  return part;
}

Result<Mp4Box> keep_box(const Mp4Part& part, Mp4Context& context) {
  Status charged = context.charge(part.bytes.size() + sizeof(Mp4Box), part);
  if (!charged.ok()) return charged.error();
  return Mp4Box{part.type, {part.bytes.begin(), part.bytes.end()}};
}

Result<Mp4Children> Mp4Children::read(const Mp4Part& part, std::span<const FourCc> wanted,
                                      Mp4Context& context) {
  Mp4Children children;
  children.part_ = part;
  Mp4Fields fields(part, context);
  while (auto box = fields.box()) {
    if (std::find(wanted.begin(), wanted.end(), box->type) == wanted.end()) {
      Status charged = context.charge(sizeof(Mp4Part) + box->path.size(), *box);
      if (!charged.ok()) return charged.error();
      children.others_.push_back(*box);
    } else if (!children.found_.emplace(box->type, *box).second) {
      return mp4_error(Errc::malformed, part, box->begin,
                       "'" + to_string(box->type) + "' is there twice (expected once)");
    }
  }
  if (!fields.ok()) return fields.status().error();
  return children;
}

const Mp4Part* Mp4Children::find(FourCc type) const {
  const auto found = found_.find(type);
  return found != found_.end() ? &found->second : nullptr;
}

Result<const Mp4Part*> Mp4Children::need(FourCc type) const {
  const Mp4Part* part = find(type);
  if (part != nullptr) return part;
  return mp4_error(Errc::malformed, part_, part_.offset,
                   "there is no '" + to_string(type) + "' (expected one)");
}

}  // namespace afx::bifs

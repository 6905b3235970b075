// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/raw_bifs.h"

#include "bifs/mp4_builder.h"

#include <string>
#include <utility>

#include "codec/bit_writer.h"

namespace afx::bifs {
namespace {

using codec::BitReader;
using codec::BitWriter;

constexpr uint32_t kMagic = 0x42494653;  // "BIFS"

class RawReader {
 public:
  RawReader(std::span<const uint8_t> data, const Limits& limits, const codec::Trace* trace)
      : data_(data), in_(data, trace), memory_left_(limits.memory) {}

  Result<RawBifs> read() {
    RawBifs scene;
    if (in_.u(32, "magic") != kMagic) in_.fail(Errc::malformed, "does not begin with \"BIFS\"");
    const uint32_t version = in_.u(8, "version");
    if (version != 1) {
      in_.fail(Errc::unsupported, "the version is " + std::to_string(version) + " (expected 1)");
    }
    scene.object_type = static_cast<uint8_t>(in_.u(8, "objectTypeIndication"));
    scene.config = bytes(in_.u(16, "configSize"), "config");
    scene.timescale = in_.u(32, "timescale");
    if (scene.timescale == 0) in_.fail(Errc::malformed, "timescale is 0 (expected 1 or more)");
    while (in_.ok() && in_.bits_left() > 0) {
      charge(sizeof(RawBifsUnit));
      scene.units.push_back(unit());
    }
    if (!in_.ok()) return in_.error();
    return scene;
  }

 private:
  RawBifsUnit unit() {
    const BitReader::Scope scope(in_, "accessUnit");
    RawBifsUnit unit;
    unit.time = uint64_t{in_.u(32, "time")} << 32;
    unit.time |= in_.u(32, "time");
    if (unit.time < time_) {
      in_.fail(Errc::malformed, "accessUnit/time is " + std::to_string(unit.time) +
                                    " (expected at least the " + std::to_string(time_) +
                                    " of the one before)");
    }
    time_ = unit.time;
    const uint32_t flag = in_.u(8, "randomAccess");
    if (flag > 1) {
      in_.fail(Errc::malformed,
               "accessUnit/randomAccess is " + std::to_string(flag) + " (expected 0 or 1)");
    }
    unit.random_access = flag == 1;
    unit.bytes = bytes(in_.u(32, "size"), "bytes");
    return unit;
  }

  void charge(uint64_t amount) {
    if (amount > memory_left_) {
      in_.fail(Errc::limit_exceeded, "the scene takes more memory than the limit allows");
    } else {
      memory_left_ -= amount;
    }
  }

  std::vector<uint8_t> bytes(uint64_t count, const char* name) {
    if (in_.ok() && count > in_.bits_left() / 8) {
      in_.fail(Errc::truncated, std::string("the data end inside ") + name + " (expected " +
                                    std::to_string(count) + " bytes, " +
                                    std::to_string(in_.bits_left() / 8) + " are left)");
    }
    charge(count);
    if (!in_.ok()) return {};
    const auto part = data_.subspan(in_.bit() / 8, count);
    in_.seek(in_.bit() + count * 8);
    return {part.begin(), part.end()};
  }

  std::span<const uint8_t> data_;
  BitReader in_;
  uint64_t memory_left_;
  uint64_t time_ = 0;
};

Error bad(std::string text) { return {Errc::bad_argument, Place::none(), std::move(text)}; }

}  // namespace

Result<RawBifs> read_raw_bifs(std::span<const uint8_t> data, const Limits& limits,
                              const codec::Trace* trace) {
  return RawReader(data, limits, trace).read();
}

Result<std::vector<uint8_t>> write_raw_bifs(const RawBifs& scene) {
  if (scene.config.size() > 0xFFFF) return bad("the configuration has more than 65535 bytes");
  if (scene.timescale == 0) return bad("the timescale is 0 (expected 1 or more)");
  std::vector<uint8_t> bytes;
  const auto append = [&bytes](const std::vector<uint8_t>& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  BitWriter out(bytes);
  out.u(kMagic, 32);
  out.u(1, 8);
  out.u(scene.object_type, 8);
  out.u(static_cast<uint32_t>(scene.config.size()), 16);
  append(scene.config);
  out.u(scene.timescale, 32);
  uint64_t time = 0;
  for (const RawBifsUnit& unit : scene.units) {
    if (unit.time < time) return bad("the times of the access units go back");
    if (unit.bytes.size() > 0xFFFFFFFF) return bad("an access unit has 4 GB or more");
    time = unit.time;
    out.u(static_cast<uint32_t>(time >> 32), 32);
    out.u(static_cast<uint32_t>(time), 32);
    out.u(unit.random_access ? 1 : 0, 8);
    out.u(static_cast<uint32_t>(unit.bytes.size()), 32);
    append(unit.bytes);
  }
  return bytes;
}

Mp4Movie movie_of_raw_bifs(const RawBifs& scene) {
  constexpr uint64_t kHead = 4 + 1 + 1 + 2 + 4;  // before the first access unit, without config
  constexpr uint64_t kUnitHead = 8 + 1 + 4;
  Mp4Movie movie;
  movie.timescale = scene.timescale;
  Mp4Track track = make_scene_track(1, scene.object_type, scene.config, 0, 0);
  track.timescale = scene.timescale;
  uint64_t offset = kHead + scene.config.size();
  for (const RawBifsUnit& unit : scene.units) {
    Mp4Sample sample;
    sample.offset = offset + kUnitHead;
    sample.size = static_cast<uint32_t>(unit.bytes.size());
    sample.time = unit.time;
    sample.random_access = unit.random_access;
    track.samples.push_back(sample);
    offset += kUnitHead + unit.bytes.size();
  }
  movie.tracks.push_back(std::move(track));
  movie.initial_object = make_initial_object(1, 0);
  return movie;
}

}  // namespace afx::bifs

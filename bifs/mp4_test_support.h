// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bifs/mp4_reader.h"
#include "bifs/mp4_writer.h"

namespace afx::bifs::mp4_test {

using Bytes = std::vector<uint8_t>;
inline const std::string kMp4Folder = AFX_SOURCE_DIR "/conformance/suites/bifs-gpac/";

inline Bytes read_file(const std::string& name) {
  std::ifstream in(kMp4Folder + name, std::ios::binary);
  EXPECT_TRUE(in) << name;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline std::vector<std::string> vector_names() {
  std::vector<std::string> names;
  std::ifstream in(kMp4Folder + "manifest.json");
  const nlohmann::json manifest = nlohmann::json::parse(in);
  for (const auto& entry : manifest.at("vectors")) names.push_back(entry.at("name"));
  return names;
}

inline Result<Mp4Movie> read(const Bytes& bytes, const Limits& limits = {}) {
  Diagnostics diagnostics;
  return read_mp4(mp4_source(bytes), limits, diagnostics);
}

inline Bytes sample(const Bytes& bytes, const Mp4Track& track, size_t index) {
  auto read = read_sample(mp4_source(bytes), track, index, {});
  EXPECT_TRUE(read.ok()) << to_string(read.error());
  return read.ok() ? read.value() : Bytes{};
}

/// Writes again what was read from `bytes`.
inline Bytes rewrite(const Bytes& bytes, const Mp4Movie& movie) {
  const Mp4Source source = mp4_source(bytes);
  const Limits limits;
  Bytes out;
  const Status status = write_mp4(movie, samples_of(source, movie, limits),
                                  [&out](std::span<const uint8_t> part) -> Status {
                                    out.insert(out.end(), part.begin(), part.end());
                                    return {};
                                  });
  EXPECT_TRUE(status.ok()) << to_string(status.error());
  return out;
}

/// What a movie says, but for where the samples lie.
inline Mp4Movie without_offsets(Mp4Movie movie) {
  for (Mp4Track& track : movie.tracks) {
    for (Mp4Sample& one : track.samples) one.offset = 0;
  }
  return movie;
}

/// Big-endian bytes and boxes, for files made by hand.
inline void put(Bytes& out, uint64_t value, unsigned bytes) {
  for (unsigned i = bytes; i-- > 0;) out.push_back(static_cast<uint8_t>(value >> (8 * i)));
}
inline Bytes numbers(const std::vector<uint32_t>& values) {
  Bytes out;
  for (const uint32_t value : values) put(out, value, 4);
  return out;
}
inline Bytes join(const std::vector<Bytes>& parts) {
  Bytes out;
  for (const Bytes& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}
inline Bytes box(const char* type, const Bytes& payload) {
  Bytes out;
  put(out, payload.size() + 8, 4);
  out.insert(out.end(), type, type + 4);
  out.insert(out.end(), payload.begin(), payload.end());
  return out;
}

/// What the tables of a small track are made of, as the payloads of their boxes.
struct HandMade {
  Bytes stts = numbers({0, 1, 2, 10});    // two samples of 10 ticks
  Bytes stsc = numbers({0, 1, 1, 2, 1});  // two in a chunk
  Bytes stsz = numbers({0, 0, 2, 3, 4});  // of 3 and 4 bytes
  Bytes chunks = box("stco", numbers({0, 1, 40}));
  Bytes more;   // further boxes of stbl
  Bytes edits;  // a box
  Bytes mvex;   // a box
};

inline Bytes hand_made_moov(const HandMade& made) {
  const Bytes matrix = numbers({0x10000, 0, 0, 0, 0x10000, 0, 0, 0, 0x40000000});
  const Bytes mvhd = box("mvhd", join({numbers({0, 0, 0, 600, 12, 0x10000, 0x01000000, 0, 0}),
                                       matrix, Bytes(24), numbers({2})}));
  const Bytes tkhd =
      box("tkhd", join({numbers({1, 0, 0, 1, 0, 12, 0, 0, 0, 0}), matrix, numbers({0, 0})}));
  const Bytes es = {0x03, 0x15, 0, 0, 0, 0x04, 0x0D, 1, 0x0D, 0, 0, 0,
                    0,    0,    0, 0, 0, 0,    0,    0, 0x06, 1, 2};
  const Bytes esds = box("esds", join({numbers({0}), es}));
  const Bytes mp4s = box("mp4s", join({{0, 0, 0, 0, 0, 0, 0, 1}, esds}));
  const Bytes stbl =
      box("stbl", join({box("stsd", join({numbers({0, 1}), mp4s})), box("stts", made.stts),
                        box("stsc", made.stsc), box("stsz", made.stsz), made.chunks, made.more}));
  const Bytes dinf = box("dinf", box("dref", join({numbers({0, 1}), box("url ", numbers({1}))})));
  const Bytes minf = box("minf", join({box("nmhd", numbers({0})), dinf, stbl}));
  const Bytes mdia =
      box("mdia", join({box("mdhd", numbers({0, 0, 0, 1000, 20, 0x55C40000})),
                        box("hdlr", join({numbers({0, 0, fourcc("sdsm"), 0, 0, 0}), {0}})), minf}));
  return box("moov", join({mvhd, box("trak", join({tkhd, made.edits, mdia})), made.mvex}));
}

/// 'mdat' first, so that the sample data begin at 40: ftyp of 20 bytes, the header of mdat, 12 zero
/// bytes.
inline Bytes hand_made_file(const HandMade& made,
                            const Bytes& data = {'a', 'b', 'c', 'd', 'e', 'f', 'g'}) {
  return join({box("ftyp", join({{'m', 'p', '4', '2'}, numbers({1}), {'i', 's', 'o', 'm'}})),
               box("mdat", join({Bytes(12), data})), hand_made_moov(made)});
}

}  // namespace afx::bifs::mp4_test

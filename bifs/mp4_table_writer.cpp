// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_table_writer.h"

#include <algorithm>

#include "bifs/descriptor_writer.h"

namespace afx::bifs {
namespace {

using Scope = Mp4BoxWriter::Scope;
using Samples = std::vector<Mp4Sample>;

Status write_entries(const Mp4Track& track, Mp4BoxWriter& out) {
  const Scope stsd(out, fourcc("stsd"));
  out.version(0, 0);
  out.u32(static_cast<uint32_t>(track.entries.size()));
  for (const Mp4SampleEntry& entry : track.entries) {
    const Scope scope(out, entry.type);
    // The second half of these 8 bytes names the data reference: a written file has one.
    std::vector<uint8_t> head = entry.head;
    if (head.size() < 8) head.resize(8);
    head[6] = 0;
    head[7] = 1;
    out.bytes(head);
    if (entry.es) {
      Status status = write_descriptor_box(fourcc("esds"), *entry.es, out);
      if (!status.ok()) return status;
    }
    for (const Mp4Box& box : entry.boxes) out.box(box);
  }
  return {};
}

/// A table of runs: how many samples, and the number they share.
template <class Number>
void write_runs(FourCc type, uint8_t version, const Samples& samples, Number number,
                Mp4BoxWriter& out) {
  std::vector<std::pair<uint32_t, uint32_t>> runs;
  for (const Mp4Sample& sample : samples) {
    const uint32_t value = number(sample);
    if (runs.empty() || runs.back().second != value) runs.push_back({0, value});
    ++runs.back().first;
  }
  const Scope scope(out, type);
  out.version(version, 0);
  out.u32(static_cast<uint32_t>(runs.size()));
  for (const auto& [count, value] : runs) {
    out.u32(count);
    out.u32(value);
  }
}

void write_composition(const Samples& samples, Mp4BoxWriter& out) {
  const auto is_zero = [](const Mp4Sample& sample) { return sample.composition_offset == 0; };
  const auto is_negative = [](const Mp4Sample& sample) { return sample.composition_offset < 0; };
  if (std::all_of(samples.begin(), samples.end(), is_zero)) return;
  const bool negative = std::any_of(samples.begin(), samples.end(), is_negative);
  write_runs(
      fourcc("ctts"), negative ? 1 : 0, samples,
      [](const Mp4Sample& sample) { return static_cast<uint32_t>(sample.composition_offset); },
      out);
}

void write_sync(const Samples& samples, Mp4BoxWriter& out) {
  const auto is_sync = [](const Mp4Sample& sample) { return sample.random_access; };
  if (std::all_of(samples.begin(), samples.end(), is_sync)) return;
  const Scope scope(out, fourcc("stss"));
  out.version(0, 0);
  out.u32(static_cast<uint32_t>(std::count_if(samples.begin(), samples.end(), is_sync)));
  for (size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].random_access) out.u32(static_cast<uint32_t>(i + 1));
  }
}

void write_sizes(const Samples& samples, Mp4BoxWriter& out) {
  const Scope scope(out, fourcc("stsz"));
  const bool constant = !samples.empty() && samples[0].size != 0 &&
                        std::all_of(samples.begin(), samples.end(), [&](const Mp4Sample& sample) {
                          return sample.size == samples[0].size;
                        });
  out.version(0, 0);
  out.u32(constant ? samples[0].size : 0);
  out.u32(static_cast<uint32_t>(samples.size()));
  if (constant) return;
  for (const Mp4Sample& sample : samples) out.u32(sample.size);
}

void write_chunk_runs(const Samples& samples, const std::vector<Mp4Chunk>& chunks,
                      Mp4BoxWriter& out) {
  struct Run {
    size_t first, count;
    uint32_t entry;
  };
  std::vector<Run> runs;
  for (size_t i = 0; i < chunks.size(); ++i) {
    const uint32_t entry = samples[chunks[i].first].entry;
    if (runs.empty() || runs.back().count != chunks[i].count || runs.back().entry != entry) {
      runs.push_back({i, chunks[i].count, entry});
    }
  }
  const Scope scope(out, fourcc("stsc"));
  out.version(0, 0);
  out.u32(static_cast<uint32_t>(runs.size()));
  for (const Run& run : runs) {
    out.u32(static_cast<uint32_t>(run.first + 1));
    out.u32(static_cast<uint32_t>(run.count));
    out.u32(run.entry + 1);
  }
}

void write_chunk_offsets(const std::vector<Mp4Chunk>& chunks, uint64_t data, bool wide,
                         Mp4BoxWriter& out) {
  const Scope scope(out, wide ? fourcc("co64") : fourcc("stco"));
  out.version(0, 0);
  out.u32(static_cast<uint32_t>(chunks.size()));
  for (const Mp4Chunk& chunk : chunks) out.u(data + chunk.offset, wide ? 8 : 4);
}

}  // namespace

Status write_descriptor_box(FourCc type, const Descriptor& descriptor, Mp4BoxWriter& out) {
  const auto written = write_descriptors({descriptor});
  if (!written.ok()) {
    Error error = written.error();
    error.text = to_string(type) + ": " + error.text;
    return error;
  }
  const Scope scope(out, type);
  out.version(0, 0);
  out.bytes(written.value());
  return {};
}

Status write_sample_tables(const Mp4Track& track, const std::vector<Mp4Chunk>& chunks,
                           uint64_t data, bool wide, Mp4BoxWriter& out) {
  const Scope scope(out, fourcc("stbl"));
  Status status = write_entries(track, out);
  if (!status.ok()) return status;
  write_runs(
      fourcc("stts"), 0, track.samples, [](const Mp4Sample& sample) { return sample.duration; },
      out);
  write_composition(track.samples, out);
  write_sync(track.samples, out);
  write_chunk_runs(track.samples, chunks, out);
  write_sizes(track.samples, out);
  write_chunk_offsets(chunks, data, wide, out);
  for (const Mp4Box& box : track.table_boxes) out.box(box);
  return {};
}

}  // namespace afx::bifs

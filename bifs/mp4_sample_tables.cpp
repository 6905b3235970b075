// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_sample_tables.h"

#include <algorithm>

#include "bifs/mp4_sample_entry.h"

namespace afx::bifs {
namespace {

constexpr FourCc kTables[] = {fourcc("stsd"), fourcc("stts"), fourcc("ctts"),
                              fourcc("stss"), fourcc("stsz"), fourcc("stz2"),
                              fourcc("stsc"), fourcc("stco"), fourcc("co64")};

std::string counted(uint64_t count, const char* what) { return std::to_string(count) + " " + what; }

/// 'stsz', 'stz2': how many samples there are and how many bytes each has. A table takes bits for
/// each sample and a size for all is at least 1 byte of the file: the count is bounded by what is
/// there.
Status read_sizes(const Mp4Part& part, Mp4Context& context, std::vector<Mp4Sample>& samples) {
  Mp4Fields in(part, context);
  in.version(0);
  const bool compact = part.type == fourcc("stz2");
  uint32_t constant = 0;
  unsigned bits = 32;
  if (compact) {
    in.skip(3, "reserved");
    bits = in.u8("field_size");
    if (in.ok() && bits != 4 && bits != 8 && bits != 16) {
      in.fail(Errc::malformed, "field_size is " + std::to_string(bits) + " (expected 4, 8 or 16)");
    }
  } else {
    constant = in.u32("sample_size");
  }
  const uint32_t count = in.count(constant == 0 ? bits : 0, "sample_count");
  if (in.ok() && uint64_t{constant} * count > context.source.size) {
    in.fail(Errc::truncated, counted(count, "samples of ") + counted(constant,
                                                                     "bytes each are more "
                                                                     "than the file has"));
  }
  if (!in.ok()) return in.status();
  Status charged = context.charge(uint64_t{count} * sizeof(Mp4Sample), part);
  if (!charged.ok()) return charged;
  samples.resize(count);
  uint8_t pair = 0;
  for (uint32_t i = 0; i < count; ++i) {
    uint32_t size = constant;
    if (constant == 0 && bits == 4) {
      if (i % 2 == 0) pair = in.u8("entry_size");
      size = i % 2 == 0 ? pair >> 4 : pair & 0xF;
    } else if (constant == 0) {
      size = static_cast<uint32_t>(in.u(bits / 8, "entry_size"));
    }
    samples[i].size = size;
  }
  return in.status();
}

/// A run of a table is for more samples than there are: what is too much is left out.
uint64_t clip_run(uint64_t run, uint64_t left, const Mp4Part& part, Mp4Context& context) {
  if (run > left) {
    context.warn("sample_table", part,
                 "describes " + counted(run - left, "samples more than there are"));
  }
  return std::min(run, left);
}

Status too_few(const Mp4Part& part, uint64_t described, size_t samples) {
  return mp4_error(
      Errc::malformed, part, part.offset,
      "describes " + counted(described, "samples") + " (expected " + std::to_string(samples) + ")");
}

Status read_times(const Mp4Part& part, Mp4Context& context, std::vector<Mp4Sample>& samples) {
  Mp4Fields in(part, context);
  in.version(0);
  const uint32_t runs = in.count(64, "entry_count");
  uint64_t time = 0;  // at most 2^32 samples of less than 2^32 ticks
  size_t next = 0;
  for (uint32_t run = 0; run < runs && in.ok(); ++run) {
    const uint64_t many = clip_run(in.u32("sample_count"), samples.size() - next, part, context);
    const uint32_t delta = in.u32("sample_delta");
    for (const size_t end = next + many; next < end; ++next, time += delta) {
      samples[next].time = time;
      samples[next].duration = delta;
    }
  }
  if (in.ok() && next < samples.size()) return too_few(part, next, samples.size());
  return in.status();
}

Status read_composition(const Mp4Part& part, Mp4Context& context, std::vector<Mp4Sample>& samples) {
  Mp4Fields in(part, context);
  const bool is_signed = in.version(1).version == 1;
  const uint32_t runs = in.count(64, "entry_count");
  size_t next = 0;
  for (uint32_t run = 0; run < runs && in.ok(); ++run) {
    const uint64_t many = clip_run(in.u32("sample_count"), samples.size() - next, part, context);
    const uint32_t raw = in.u32("sample_offset");
    const int64_t offset = is_signed ? int64_t{static_cast<int32_t>(raw)} : int64_t{raw};
    for (const size_t end = next + many; next < end; ++next) {
      samples[next].composition_offset = offset;
    }
  }
  return in.status();  // samples not described have the offset 0
}

Status read_sync(const Mp4Part& part, Mp4Context& context, std::vector<Mp4Sample>& samples) {
  Mp4Fields in(part, context);
  in.version(0);
  for (Mp4Sample& sample : samples) sample.random_access = false;
  const uint32_t count = in.count(32, "entry_count");
  for (uint32_t i = 0; i < count && in.ok(); ++i) {
    const uint32_t number = in.u32("sample_number");
    if (number == 0 || number > samples.size()) {
      in.fail(Errc::malformed, "sample_number is " + std::to_string(number) + " (expected 1 to " +
                                   std::to_string(samples.size()) + ")");
    } else {
      samples[number - 1].random_access = true;
    }
  }
  return in.status();
}

/// 'stsc' with 'stco' or 'co64': the samples of chunk after chunk lie one behind the other.
class ChunkReader {
 public:
  ChunkReader(const Mp4Part& runs, const Mp4Part& chunks, Mp4Context& context, Mp4Track& track)
      : runs_part_(runs),
        chunks_part_(chunks),
        context_(context),
        track_(track),
        runs_(runs, context),
        chunks_(chunks, context),
        offset_bytes_(chunks.type == fourcc("co64") ? 8 : 4) {}

  Status read() {
    runs_.version(0);
    chunks_.version(0);
    runs_left_ = runs_.count(96, "entry_count");
    const uint32_t chunks = chunks_.count(offset_bytes_ * 8, "entry_count");
    next_run();
    for (uint32_t chunk = 1; chunk <= chunks && runs_.ok() && chunks_.ok(); ++chunk) {
      if (chunk == run_end_) next_run();
      Status status = runs_.ok() ? read_chunk() : Status();
      if (!status.ok()) return status;
    }
    if (!runs_.ok()) return runs_.status();
    if (!chunks_.ok()) return chunks_.status();
    if (next_ < track_.samples.size()) return too_few(runs_part_, next_, track_.samples.size());
    return {};
  }

 private:
  void next_run() {
    if (runs_left_ == 0) {  // no runs at all: no chunk holds anything
      run_end_ = 0;
      return;
    }
    const uint32_t first = run_end_ == 0 ? runs_.u32("first_chunk") : run_end_;
    if (run_end_ == 0 && first != 1) {
      runs_.fail(Errc::malformed, "first_chunk is " + std::to_string(first) + " (expected 1)");
    }
    samples_per_chunk_ = runs_.u32("samples_per_chunk");
    const uint32_t entry = runs_.u32("sample_description_index");
    if (runs_.ok() && (entry == 0 || entry > track_.entries.size())) {
      runs_.fail(Errc::malformed, "sample_description_index is " + std::to_string(entry) +
                                      " (expected 1 to " + std::to_string(track_.entries.size()) +
                                      ")");
    }
    entry_ = entry - 1;
    run_end_ = 0;
    if (--runs_left_ == 0) return;
    run_end_ = runs_.u32("first_chunk");
    if (run_end_ <= first) {
      runs_.fail(Errc::malformed, "first_chunk is " + std::to_string(run_end_) +
                                      " (expected more than the " + std::to_string(first) +
                                      " before it)");
    }
  }

  Status read_chunk() {
    uint64_t offset = chunks_.u(offset_bytes_, "chunk_offset");
    const uint64_t at = chunks_.offset() - offset_bytes_;
    const uint64_t many =
        clip_run(samples_per_chunk_, track_.samples.size() - next_, runs_part_, context_);
    for (const size_t end = next_ + many; next_ < end; ++next_) {
      Mp4Sample& sample = track_.samples[next_];
      sample.offset = offset;
      sample.entry = entry_;
      if (track_.entries[entry_].in_this_file) {
        Status status = check_sample_place(sample, chunks_part_, at, context_);
        if (!status.ok()) return status;
      }
      offset += sample.size;
    }
    return {};
  }

  const Mp4Part& runs_part_;
  const Mp4Part& chunks_part_;
  Mp4Context& context_;
  Mp4Track& track_;
  Mp4Fields runs_;
  Mp4Fields chunks_;
  unsigned offset_bytes_;
  uint32_t runs_left_ = 0;
  uint32_t run_end_ = 0;  // the first chunk of the next run; 0: there is none
  uint32_t samples_per_chunk_ = 0;
  uint32_t entry_ = 0;
  size_t next_ = 0;  // sample
};

Status read_chunks(const Mp4Children& tables, Mp4Context& context, Mp4Track& track) {
  const auto runs = tables.need(fourcc("stsc"));
  if (!runs.ok()) return runs.error();
  const Mp4Part* wide = tables.find(fourcc("co64"));
  const auto chunks = wide != nullptr ? Result<const Mp4Part*>(wide) : tables.need(fourcc("stco"));
  if (!chunks.ok()) return chunks.error();
  return ChunkReader(*runs.value(), *chunks.value(), context, track).read();
}

Status keep_tables(const Mp4Children& tables, Mp4Context& context, Mp4Track& track) {
  for (const Mp4Part& part : tables.others()) {
    if (part.type == fourcc("saio") || part.type == fourcc("saiz")) {
      context.warn("box_ignored", part, "points to places in the file and is not carried along");
      continue;
    }
    auto box = keep_box(part, context);
    if (!box.ok()) return box.error();
    track.table_boxes.push_back(std::move(box).value());
  }
  return {};
}

}  // namespace

Status check_sample_place(const Mp4Sample& sample, const Mp4Part& part, uint64_t at,
                          const Mp4Context& context) {
  const uint64_t size = context.source.size;
  if (sample.offset <= size && sample.size <= size - sample.offset) return {};
  return mp4_error(Errc::truncated, part, at,
                   "a sample of " + counted(sample.size, "bytes at ") +
                       std::to_string(sample.offset) + " ends behind the file of " +
                       counted(size, "bytes"));
}

Status read_sample_tables(const Mp4Part& stbl, const std::vector<bool>& self_contained,
                          Mp4Context& context, Mp4Track& track) {
  const auto children = Mp4Children::read(stbl, kTables, context);
  if (!children.ok()) return children.error();
  const Mp4Children& tables = children.value();
  const auto entries = tables.need(fourcc("stsd"));
  if (!entries.ok()) return entries.error();
  Status status = read_sample_entries(*entries.value(), self_contained, context, track);
  if (!status.ok()) return status;
  const Mp4Part* compact = tables.find(fourcc("stz2"));
  const auto sizes =
      compact != nullptr ? Result<const Mp4Part*>(compact) : tables.need(fourcc("stsz"));
  if (!sizes.ok()) return sizes.error();
  if (status = read_sizes(*sizes.value(), context, track.samples); !status.ok()) return status;
  const auto times = tables.need(fourcc("stts"));
  if (!times.ok()) return times.error();
  if (status = read_times(*times.value(), context, track.samples); !status.ok()) return status;
  const Mp4Part* composition = tables.find(fourcc("ctts"));
  if (composition != nullptr) status = read_composition(*composition, context, track.samples);
  if (!status.ok()) return status;
  const Mp4Part* sync = tables.find(fourcc("stss"));
  if (sync != nullptr) status = read_sync(*sync, context, track.samples);
  if (!status.ok()) return status;
  status = read_chunks(tables, context, track);
  return status.ok() ? keep_tables(tables, context, track) : status;
}

}  // namespace afx::bifs

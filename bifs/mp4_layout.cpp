// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/mp4_layout.h"

#include <queue>

namespace afx::bifs {
namespace {

/// The next sample of a track, with its time as seconds and a fraction of ticks / timescale.
struct Next {
  uint64_t seconds;
  uint64_t ticks;
  uint64_t timescale;
  size_t track;
  size_t sample;

  /// Whether it comes after another (so that the first one is on top of the queue).
  bool operator<(const Next& other) const {
    if (seconds != other.seconds) return seconds > other.seconds;
    const uint64_t a = ticks * other.timescale;  // both factors are below 2^32
    const uint64_t b = other.ticks * timescale;
    return a != b ? a > b : track > other.track;
  }
};

Next next_of(const Mp4Movie& movie, size_t track, size_t sample) {
  const Mp4Track& of = movie.tracks[track];
  const uint64_t time = of.samples[sample].time;
  return {time / of.timescale, time % of.timescale, of.timescale, track, sample};
}

}  // namespace

Mp4Layout lay_out(const Mp4Movie& movie) {
  Mp4Layout layout;
  std::priority_queue<Next> queue;
  for (size_t track = 0; track < movie.tracks.size(); ++track) {
    if (!movie.tracks[track].samples.empty()) queue.push(next_of(movie, track, 0));
  }
  while (!queue.empty()) {
    const Next next = queue.top();
    queue.pop();
    const std::vector<Mp4Sample>& samples = movie.tracks[next.track].samples;
    const bool joins = !layout.chunks.empty() && layout.chunks.back().track == next.track &&
                       samples[next.sample].entry == samples[layout.chunks.back().first].entry;
    if (joins) {
      ++layout.chunks.back().count;
    } else {
      layout.chunks.push_back({next.track, next.sample, 1, layout.bytes});
    }
    layout.bytes += samples[next.sample].size;
    if (next.sample + 1 < samples.size()) {
      queue.push(next_of(movie, next.track, next.sample + 1));
    }
  }
  return layout;
}

}  // namespace afx::bifs

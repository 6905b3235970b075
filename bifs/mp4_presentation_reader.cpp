// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-14 (clauses not checked); spec/bifs.md 15.
#include "bifs/mp4_presentation_reader.h"

#include <algorithm>
#include <utility>

#include "bifs/config.h"
#include "bifs/decoded_json.h"
#include "bifs/decoder.h"
#include "bifs/mp4_reader.h"

namespace afx::bifs {

namespace {

constexpr uint8_t kEsIdOfNone = 0;

/// The ES_Descriptor of a track as streams have it.
EsDescriptor stream_of_track(const Mp4Track& track) {
  EsDescriptor es;
  if (const EsDescriptor* found = track.entries.empty() ? nullptr : es_of(track.entries[0]))
    es = *found;
  es.es_id = static_cast<uint16_t>(track.id);
  std::erase_if(es.parts,
                [](const Descriptor& part) { return std::holds_alternative<SlConfig>(part.body); });
  SlConfig& sl = es.parts.emplace_back().body.emplace<SlConfig>();
  sl.predefined = 0;
  sl.fields.emplace().time_stamp_resolution = track.timescale;
  return es;
}

/// Puts in front of an error or warning which access unit it is about, and its place in the file.
class UnitPlaces {
 public:
  UnitPlaces(const Mp4Track& track, size_t index)
      : text_("track " + std::to_string(track.id) + ", access unit " + std::to_string(index) +
              ": "),
        bit_(track.samples[index].offset * 8) {}

  [[nodiscard]] Error in_file(Error error) const {
    error.text = text_ + error.text;
    if (error.place.kind == Place::Kind::bit) error.place.bit += bit_;
    return error;
  }
  void in_file(const Diagnostics& found, Diagnostics& out) const {
    for (const Warning& warning : found.warnings()) {
      Place place = warning.place;
      if (place.kind == Place::Kind::bit) place.bit += bit_;
      out.warn(warning.code, place, text_ + warning.text);
    }
  }

 private:
  std::string text_;
  uint64_t bit_;
};

Result<BifsConfig> config_of(const Mp4Track& track, Diagnostics& diagnostics) {
  const DecoderConfig* decoder =
      track.entries.empty() ? nullptr : decoder_config_of(track.entries[0]);
  const std::string name = "track " + std::to_string(track.id) + ": ";
  if (decoder == nullptr)
    return Error{Errc::malformed, Place::none(), name + "no decoder configuration (expected one)"};
  auto config = read_config(decoder_specific_info(*es_of(track.entries[0])), decoder->object_type,
                            diagnostics);
  if (!config.ok()) {
    config.error().text = name + "BIFSConfig: " + config.error().text;
    config.error().place = Place::none();  // it would count from the configuration
  }
  return config;
}

bool is_bifs(const Mp4Track& track) {
  const DecoderConfig* decoder =
      track.entries.empty() ? nullptr : decoder_config_of(track.entries[0]);
  return decoder != nullptr && decoder->stream_type == stream_type::kScene &&
         (decoder->object_type == object_type::kBifs ||
          decoder->object_type == object_type::kBifsV2);
}

/// One access unit's place in the order of the presentation.
struct Turn {
  uint64_t microseconds;
  bool descriptors;
  size_t sample;
};

class PresentationDecoder {
 public:
  PresentationDecoder(const Mp4Source& source, const Mp4Movie& movie,
                      const PresentationDecodeOptions& options, Diagnostics& diagnostics)
      : source_(source), movie_(movie), options_(options), diagnostics_(diagnostics) {}

  Result<nodes::Scene> decode(PresentationSink* sink) {
    sink_ = sink;
    Status done = begin();
    if (done.ok() && sink_ != nullptr) done = sink_->begin(initial());
    for (const Turn& turn : done.ok() ? turns() : std::vector<Turn>())
      if (done.ok()) done = turn.descriptors ? descriptors(turn.sample) : frame(turn.sample);
    if (done.ok() && sink_ != nullptr) done = sink_->end();
    if (!done.ok()) return done.error();
    return decoder_->take_scene();
  }

  Status decode_json(const nodes::TextSink& sink) {
    if (Status begun = begin(); !begun.ok()) return begun;
    nodes::TextOut out(sink);
    out.text() = "{\n\"config\": " + config_json(decoder_->config()) + ",\n\"accessUnits\": [";
    CommandJsonWriter writer;
    Status done;
    for (size_t i = 0; i < scene_->samples.size() && done.ok(); ++i) {
      out.text() += i == 0 ? "\n" : ",\n";
      done = json_unit(i, writer, out);
    }
    out.text() += "\n]\n}\n";
    const Status written = out.finish();
    return done.ok() ? written : done;
  }

 private:
  Status begin() {
    scene_ = scene_track(movie_);
    od_ = object_descriptor_track(movie_);
    if (scene_ == nullptr)
      return Error{Errc::malformed, Place::none(),
                   "there is no scene track (expected one of BIFS)"};
    for (const Mp4Track& track : movie_.tracks)
      if (&track != scene_ && is_bifs(track))
        diagnostics_.warn("other_scene", Place::none(),
                          "the scene stream of track " + std::to_string(track.id) +
                              " is left out; that of track " + std::to_string(scene_->id) +
                              " is the one decoded");
    const auto config = config_of(*scene_, diagnostics_);
    if (!config.ok()) return config.error();
    DecodeOptions how;
    how.keep_coding_quantizers = !options_.drop_coding_quantizers;
    if (source_.passed) how.passed = [this](size_t byte) { source_.passed(unit_begin_ + byte); };
    decoder_.emplace(config.value(), options_.limits, how);
    return {};
  }

  [[nodiscard]] InitialObjectDescriptor initial() const {
    InitialObjectDescriptor out;
    const auto* object = movie_.initial_object
                             ? std::get_if<InitialObjectDescriptor>(&movie_.initial_object->body)
                             : nullptr;
    if (object != nullptr) out = *object;
    out.in_file = false;
    Descriptors others = std::exchange(out.parts, {});
    for (const Mp4Track* track : {scene_, od_})
      if (track != nullptr)
        out.parts.emplace_back().body.emplace<EsDescriptor>(stream_of_track(*track));
    for (Descriptor& other : others)
      if (std::holds_alternative<UnknownDescriptor>(other.body))
        out.parts.push_back(std::move(other));
    return out;
  }

  [[nodiscard]] std::vector<Turn> turns() const {
    constexpr uint32_t kMicroseconds = 1000000;
    std::vector<Turn> turns;
    for (const Mp4Track* track : {scene_, od_}) {
      if (track == nullptr) continue;
      for (size_t i = 0; i < track->samples.size(); ++i) {
        const uint64_t time = presentation_time(movie_, *track, track->samples[i]);
        turns.push_back({rescale(time, track->timescale, kMicroseconds), track == od_, i});
      }
    }
    std::stable_sort(turns.begin(), turns.end(), [](const Turn& a, const Turn& b) {
      return std::pair(a.microseconds, a.descriptors) < std::pair(b.microseconds, b.descriptors);
    });
    return turns;
  }

  /// Decodes an access unit of the scene, with the places of its errors and warnings in the file.
  Result<CommandFrame> decode_unit(size_t index, const BifsDecoder::CommandSink& hear) {
    const UnitPlaces places(*scene_, index);
    const auto sample = view_sample(source_, *scene_, index, options_.limits);
    if (!sample.ok()) return sample.error();
    unit_begin_ = scene_->samples[index].offset;
    Diagnostics found;
    codec::Trace moved;
    if (options_.trace != nullptr)
      moved = [&](const codec::TraceElement& element) {
        const std::string path = std::to_string(index) + '/' + std::string(element.path);
        (*options_.trace)({element.bit, element.width, path, element.value});
      };
    auto frame = decoder_->decode(sample.value().bytes, found, hear,
                                  options_.trace != nullptr ? &moved : nullptr);
    places.in_file(found, diagnostics_);
    if (!frame.ok()) return places.in_file(std::move(frame).error());
    return frame;
  }

  Status frame(size_t index) {
    const Mp4Sample& sample = scene_->samples[index];
    Status told;
    if (sink_ != nullptr)
      told = sink_->begin_frame(presentation_time(movie_, *scene_, sample), sample.random_access);
    if (!told.ok()) return told;
    const auto frame = decode_unit(index, [&](const Command& command, const nodes::Scene& scene) {
      if (sink_ != nullptr && told.ok()) told = sink_->add(command, scene);
    });
    if (!frame.ok()) return frame.error();
    return told.ok() && sink_ != nullptr ? sink_->end_frame() : told;
  }

  Status descriptors(size_t index) {
    if (sink_ == nullptr) return {};
    const UnitPlaces places(*od_, index);
    const auto bytes = read_sample(source_, *od_, index, options_.limits);
    if (!bytes.ok()) return bytes.error();
    Diagnostics found;
    auto commands = read_od_commands(bytes.value(), options_.limits, found);
    places.in_file(found, diagnostics_);
    if (!commands.ok()) return places.in_file(std::move(commands).error());
    for (OdCommand& command : commands.value()) out_of_file(command);
    const Mp4Sample& sample = od_->samples[index];
    return sink_->object_descriptors(presentation_time(movie_, *od_, sample), sample.random_access,
                                     commands.value());
  }

  /// References to tracks become streams.
  void out_of_file(OdCommand& command) {
    if (auto* update = std::get_if<OdUpdate>(&command.body)) {
      for (Descriptor& descriptor : update->objects) {
        auto* object = std::get_if<ObjectDescriptor>(&descriptor.body);
        if (object == nullptr) continue;
        object->in_file = false;
        resolve(object->parts);
      }
    }
    if (auto* update = std::get_if<EsUpdate>(&command.body)) resolve(update->streams);
    auto* remove = std::get_if<EsRemove>(&command.body);
    if (remove == nullptr || !remove->references) return;
    remove->references = false;
    for (uint16_t& stream : remove->streams) {
      const Mp4Track* track = track_of(EsIdRef{stream});
      stream = track != nullptr ? static_cast<uint16_t>(track->id) : uint16_t{kEsIdOfNone};
    }
  }

  void resolve(Descriptors& parts) {
    for (Descriptor& part : parts) {
      const Mp4Track* track = nullptr;
      if (const auto* reference = std::get_if<EsIdRef>(&part.body)) track = track_of(*reference);
      if (const auto* inc = std::get_if<EsIdInc>(&part.body))
        track = find_track(movie_, inc->track_id);
      if (track == nullptr) continue;
      EsDescriptor es = stream_of_track(*track);
      es.source = MediaSource{options_.file_name + '#' + std::to_string(track->id), {}};
      part.body.emplace<EsDescriptor>(std::move(es));
    }
    std::erase_if(parts, [](const Descriptor& part) {
      return std::holds_alternative<EsIdRef>(part.body) ||
             std::holds_alternative<EsIdInc>(part.body);
    });
  }

  const Mp4Track* track_of(EsIdRef reference) {
    const Mp4Track* track = referenced_track(movie_, *od_, reference);
    if (track == nullptr)
      diagnostics_.warn("stream_missing", Place::none(),
                        "an object descriptor refers to stream " + std::to_string(reference.index) +
                            " of 'mpod', which is not there");
    return track;
  }

  Status json_unit(size_t index, CommandJsonWriter& writer, nodes::TextOut& out) {
    const Mp4Sample& sample = scene_->samples[index];
    out.text() += "{\"time\": " + std::to_string(presentation_time(movie_, *scene_, sample)) +
                  ", \"commands\": [";
    bool first = true;
    const auto frame = decode_unit(index, [&](const Command& command, const nodes::Scene& scene) {
      out.text() += first ? "\n" : ",\n";
      first = false;
      out.text() += writer.write(command, scene);
      out.piece();
    });
    if (!frame.ok()) return frame.error();
    out.text() += "\n], \"bitsUsed\": " + std::to_string(frame.value().bits_used) +
                  ", \"bytes\": " + std::to_string(sample.size) + '}';
    return {};
  }

  const Mp4Source& source_;
  const Mp4Movie& movie_;
  const PresentationDecodeOptions& options_;
  Diagnostics& diagnostics_;
  PresentationSink* sink_ = nullptr;
  const Mp4Track* scene_ = nullptr;
  const Mp4Track* od_ = nullptr;
  std::optional<BifsDecoder> decoder_;
  uint64_t unit_begin_ = 0;  ///< of the access unit at work in the file
};

}  // namespace

Result<nodes::Scene> decode_presentation(const Mp4Source& source, const Mp4Movie& movie,
                                         const PresentationDecodeOptions& options,
                                         PresentationSink* sink, Diagnostics& diagnostics) {
  return PresentationDecoder(source, movie, options, diagnostics).decode(sink);
}

Status decode_as_json(const Mp4Source& source, const Mp4Movie& movie,
                      const PresentationDecodeOptions& options, const nodes::TextSink& sink,
                      Diagnostics& diagnostics) {
  return PresentationDecoder(source, movie, options, diagnostics).decode_json(sink);
}

uint64_t presentation_time(const Mp4Movie& movie, const Mp4Track& track, const Mp4Sample& sample) {
  uint64_t delay = 0;
  for (const Mp4Edit& edit : track.edits) {
    if (edit.media_time >= 0) {
      const auto begin = static_cast<uint64_t>(edit.media_time);
      const uint64_t time = sample.time + delay;
      return time > begin ? time - begin : 0;
    }
    delay += rescale(edit.duration, movie.timescale, track.timescale);
  }
  return sample.time + delay;
}

}  // namespace afx::bifs

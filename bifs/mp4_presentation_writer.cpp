// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Source: ISO/IEC 14496-14 (clauses not checked); spec/bifs.md 15.
#include "bifs/mp4_presentation_writer.h"

#include <algorithm>
#include <utility>

#include "bifs/mp4_builder.h"
#include "bifs/scene_stream_encoder.h"

namespace afx::bifs {

namespace {

Error malformed(std::string text) { return {Errc::malformed, Place::none(), std::move(text)}; }

/// What a text says of a stream, beyond how it is coded, in the descriptor of its track.
void keep_stream_fields(const EsDescriptor& from, Mp4Track& track) {
  for (Mp4SampleEntry& entry : track.entries) {
    auto* es = entry.es ? std::get_if<EsDescriptor>(&entry.es->body) : nullptr;
    if (es == nullptr) continue;
    es->depends_on = from.depends_on;
    es->ocr_es_id = from.ocr_es_id;
    es->url = from.url;
    es->priority = from.priority;
    for (const Descriptor& part : from.parts)
      if (std::holds_alternative<UnknownDescriptor>(part.body) &&
          std::find(es->parts.begin(), es->parts.end(), part) == es->parts.end())
        es->parts.push_back(part);
  }
}

}  // namespace

class Mp4PresentationWriter::State {
 public:
  State(Mp4Sink sink, Mp4WriteOptions options)
      : sink_(std::move(sink)), options_(std::move(options)), scene_(options_.encoding) {}

  Status begin(const InitialObjectDescriptor& initial) {
    if (Status begun = scene_.begin(initial); !begun.ok()) return begun;
    if (Status only = check_streams(initial); !only.ok()) return only;
    initial_ = initial;
    const DisplaySize size = scene_.config().size.value_or(DisplaySize{});
    const EsDescriptor& es = scene_.stream();
    Mp4Track track = make_scene_track(es.es_id, scene_.config().version, decoder_specific_info(es),
                                      size.width, size.height);
    track.timescale = timestamp_resolution(&es);
    builder_.movie.timescale = track.timescale;
    keep_stream_fields(es, track);
    scene_track_ = builder_.add_track(std::move(track));
    if (const EsDescriptor* od = object_descriptor_stream(initial)) {
      Mp4Track descriptors = make_object_descriptor_track(od->es_id, {});
      descriptors.timescale = timestamp_resolution(od);
      keep_stream_fields(*od, descriptors);
      od_track_ = builder_.add_track(std::move(descriptors));
    }
    return {};
  }

  void begin_frame(uint64_t time, bool random_access) {
    time_ = time;
    random_access_ = random_access;
  }
  Status add(const Command& command, const nodes::Scene& before) {
    return scene_.add(command, before);
  }
  Status end_frame() {
    Result<std::vector<uint8_t>> bytes = scene_.end_frame();
    if (!bytes.ok()) return bytes.error();
    return add_sample(scene_track_, std::move(bytes).value(), time_, random_access_);
  }

  Status object_descriptors(uint64_t time, bool random_access, const OdCommands& commands) {
    if (!od_track_) return malformed("object descriptors, but no stream for them");
    OdCommands in_file = commands;
    for (OdCommand& command : in_file)
      if (Status done = into_file(command); !done.ok()) return done;
    Result<std::vector<uint8_t>> bytes = write_od_commands(in_file);
    if (!bytes.ok()) return bytes.error();
    return add_sample(*od_track_, std::move(bytes).value(), time, random_access);
  }

  Status end() {
    if (od_track_ && !media_ids_.empty())
      builder_.movie.tracks[*od_track_].references = {{fourcc("mpod"), media_ids_}};
    put_initial_object();
    return builder_.write(sink_);
  }

 private:
  /// Of one scene and one stream of object descriptors.
  static Status check_streams(const InitialObjectDescriptor& initial) {
    for (const Descriptor& part : initial.parts) {
      const auto* es = std::get_if<EsDescriptor>(&part.body);
      if (es == nullptr || es == scene_stream(initial) || es == object_descriptor_stream(initial))
        continue;
      return Error{Errc::unsupported, Place::none(),
                   "the stream " + std::to_string(es->es_id) +
                       " in the InitialObjectDescriptor (expected one scene stream and one of "
                       "object descriptors, others in ObjectDescriptors)"};
    }
    return {};
  }

  Status add_sample(size_t track, std::vector<uint8_t> bytes, uint64_t time, bool random_access) {
    delays_.resize(builder_.movie.tracks.size());
    const auto& samples = builder_.movie.tracks[track].samples;
    if (samples.empty() && time > 0) {  // the first sample of a track has the time 0
      builder_.delay_track(track, time);
      delays_[track] = time;
    }
    builder_.add_sample(track, std::move(bytes), time - delays_[track], random_access);
    return {};
  }

  /// Streams become references to tracks.
  Status into_file(OdCommand& command) {
    if (auto* update = std::get_if<OdUpdate>(&command.body)) {
      for (Descriptor& descriptor : update->objects) {
        auto* object = std::get_if<ObjectDescriptor>(&descriptor.body);
        if (object == nullptr) continue;
        object->in_file = true;
        if (Status done = refer(object->parts); !done.ok()) return done;
      }
    }
    if (auto* update = std::get_if<EsUpdate>(&command.body)) return refer(update->streams);
    if (auto* remove = std::get_if<EsRemove>(&command.body)) return refer(*remove);
    return {};
  }

  Status refer(Descriptors& parts) {
    for (Descriptor& part : parts) {
      const auto* es = std::get_if<EsDescriptor>(&part.body);
      if (es == nullptr) continue;
      if (es->url && !es->source) continue;  // elsewhere: it stays whole
      if (Status done = add_media(*es); !done.ok()) return done;
      part.body = EsIdRef{place_of(es->es_id)};
    }
    return {};
  }

  Status refer(EsRemove& remove) {
    if (remove.references) return {};
    for (uint16_t& stream : remove.streams) {
      const uint16_t place = place_of(stream);
      if (place == 0)
        return malformed("the stream " + std::to_string(stream) + " that is removed is not there");
      stream = place;
    }
    remove.references = true;
    return {};
  }

  /// Its place in 'mpod', from 1; 0: it has none.
  uint16_t place_of(uint16_t es_id) const {
    const auto at = std::find(media_ids_.begin(), media_ids_.end(), uint32_t{es_id});
    return at == media_ids_.end() ? 0 : static_cast<uint16_t>(at - media_ids_.begin() + 1);
  }

  Status add_media(const EsDescriptor& es) {
    const std::string stream = "the stream " + std::to_string(es.es_id);
    if (!es.source) return malformed(stream + " has no source (expected muxInfo with a fileName)");
    if (place_of(es.es_id) != 0) {
      if (*es.source == sources_[place_of(es.es_id) - 1U]) return {};
      return malformed(stream + " comes from two sources (expected another ES_ID)");
    }
    if (es.es_id == 0 || find_track(builder_.movie, es.es_id) != nullptr)
      return malformed(stream + " has an ES_ID that is 0 or taken (expected one of its own)");
    if (!options_.load_media)
      return Error{Errc::unsupported, Place::none(), stream + " comes from a file"};
    Result<Media> media = options_.load_media(*es.source);
    if (!media.ok()) return media.error();
    media.value().track.id = es.es_id;
    Mp4Track& track = media.value().track;
    for (Mp4Edit& edit : track.edits)
      edit.duration = rescale(edit.duration, track.timescale, builder_.movie.timescale);
    keep_stream_fields(es, track);
    builder_.add_media(std::move(media).value());
    media_ids_.push_back(es.es_id);
    sources_.push_back(*es.source);
    return {};
  }

  void put_initial_object() {
    InitialObjectDescriptor object = initial_;
    object.in_file = true;
    object.parts = {};
    object.parts.push_back({EsIdInc{builder_.movie.tracks[scene_track_].id}});
    if (od_track_) object.parts.push_back({EsIdInc{builder_.movie.tracks[*od_track_].id}});
    for (const Descriptor& part : initial_.parts)
      if (std::holds_alternative<UnknownDescriptor>(part.body)) object.parts.push_back(part);
    builder_.movie.initial_object.emplace().body = std::move(object);
  }

  Mp4Sink sink_;
  Mp4WriteOptions options_;
  SceneStreamEncoder scene_;
  InitialObjectDescriptor initial_;
  Mp4Builder builder_;
  size_t scene_track_ = 0;
  std::optional<size_t> od_track_;
  std::vector<uint64_t> delays_;  ///< by track: when it begins, in its ticks
  uint64_t time_ = 0;
  bool random_access_ = true;
  std::vector<uint32_t> media_ids_;   ///< in the order of 'mpod'
  std::vector<MediaSource> sources_;  ///< likewise
};

Mp4PresentationWriter::Mp4PresentationWriter(Mp4Sink sink, Mp4WriteOptions options)
    : state_(std::make_unique<State>(std::move(sink), std::move(options))) {}
Mp4PresentationWriter::~Mp4PresentationWriter() = default;

Status Mp4PresentationWriter::begin(const InitialObjectDescriptor& initial) {
  return state_->begin(initial);
}
Status Mp4PresentationWriter::begin_frame(uint64_t time, bool random_access) {
  state_->begin_frame(time, random_access);
  return {};
}
Status Mp4PresentationWriter::add(const Command& command, const nodes::Scene& before) {
  return state_->add(command, before);
}
Status Mp4PresentationWriter::end_frame() { return state_->end_frame(); }
Status Mp4PresentationWriter::object_descriptors(uint64_t time, bool random_access,
                                                 const OdCommands& commands) {
  return state_->object_descriptors(time, random_access, commands);
}
Status Mp4PresentationWriter::end() { return state_->end(); }

}  // namespace afx::bifs

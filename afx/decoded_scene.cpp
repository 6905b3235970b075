// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "afx/decoded_scene.h"

#include <utility>

#include "bifs/mp4_reader.h"

namespace afx {
namespace {

/// Notes which streams the object descriptors name.
class StreamKeeper final : public bifs::PresentationSink {
 public:
  StreamKeeper(const bifs::Mp4Source& source, const bifs::Mp4Movie& movie, const Limits& limits)
      : source_(source), movie_(movie), limits_(limits) {}

  DecodedScene found;

  Status begin(const bifs::InitialObjectDescriptor&) override { return {}; }
  Status begin_frame(uint64_t, bool) override { return ++found.frames, Status(); }
  Status add(const bifs::Command&, const nodes::Scene&) override {
    return ++found.commands, Status();
  }
  Status end_frame() override { return {}; }
  Status object_descriptors(uint64_t, bool, const bifs::OdCommands& commands) override {
    for (const bifs::OdCommand& command : commands)
      if (const auto* update = std::get_if<bifs::OdUpdate>(&command.body))
        for (const bifs::Descriptor& descriptor : update->objects)
          if (const auto* object = std::get_if<bifs::ObjectDescriptor>(&descriptor.body))
            keep(*object);
    return {};
  }
  Status end() override { return {}; }

 private:
  void keep(const bifs::ObjectDescriptor& object) {
    const auto* es = bifs::find_part<bifs::EsDescriptor>(object.parts);
    if (es == nullptr || !es->source) return;
    const size_t mark = es->source->file.rfind('#');  // decode_presentation wrote the track behind
    const auto id = static_cast<uint32_t>(std::stoul(es->source->file.substr(mark + 1)));
    const bifs::Mp4Track* const track = bifs::find_track(movie_, id);
    if (track == nullptr) return;
    found.streams[object.id] = {*track, [this_source = source_, track, limits = limits_](size_t i) {
                                  return bifs::read_sample(this_source, *track, i, limits);
                                }};
  }

  const bifs::Mp4Source& source_;
  const bifs::Mp4Movie& movie_;
  Limits limits_;
};

}  // namespace

Result<DecodedScene> decode_scene(const bifs::Mp4Source& source, const bifs::Mp4Movie& movie,
                                  const bifs::PresentationDecodeOptions& options,
                                  Diagnostics& diagnostics) {
  StreamKeeper keeper(source, movie, options.limits);
  auto scene = bifs::decode_presentation(source, movie, options, &keeper, diagnostics);
  if (!scene.ok()) return std::move(scene).error();
  keeper.found.scene = std::move(scene).value();
  return std::move(keeper.found);
}

}  // namespace afx

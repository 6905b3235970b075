// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/presentation.h"

#include "bifs/apply.h"

namespace afx::bifs {

namespace {

constexpr uint32_t kDefaultResolution = 1000;

const EsDescriptor* stream_of_type(const InitialObjectDescriptor& initial, uint8_t stream_type) {
  for (const Descriptor& part : initial.parts) {
    const auto* es = std::get_if<EsDescriptor>(&part.body);
    const auto* config = es != nullptr ? find_part<DecoderConfig>(es->parts) : nullptr;
    if (config != nullptr && config->stream_type == stream_type) return es;
  }
  return nullptr;
}

Status play_frame(const std::vector<Command>& commands, nodes::Scene& scene, PresentationSink& sink,
                  Diagnostics& diagnostics) {
  for (const Command& command : commands) {
    Status told = sink.add(command, scene);
    if (!told.ok()) return told;
    const Status applied = apply_command(scene, command);
    if (!applied.ok())
      diagnostics.warn(
          "not_applied", Place::none(),
          std::string(command_name(command)) + ": " + applied.error().text + "; it is kept");
  }
  return {};
}

}  // namespace

Status play(Presentation& presentation, PresentationSink& sink, Diagnostics& diagnostics) {
  Status told = sink.begin(presentation.initial);
  for (const AccessUnit& unit : presentation.units) {
    if (!told.ok()) return told;
    if (const auto* descriptors = std::get_if<OdCommands>(&unit.commands)) {
      told = sink.object_descriptors(unit.time, unit.random_access, *descriptors);
      continue;
    }
    told = sink.begin_frame(unit.time, unit.random_access);
    if (told.ok())
      told = play_frame(*std::get_if<std::vector<Command>>(&unit.commands), presentation.scene,
                        sink, diagnostics);
    if (told.ok()) told = sink.end_frame();
  }
  return told.ok() ? sink.end() : told;
}

const EsDescriptor* scene_stream(const InitialObjectDescriptor& initial) {
  return stream_of_type(initial, stream_type::kScene);
}

const EsDescriptor* object_descriptor_stream(const InitialObjectDescriptor& initial) {
  return stream_of_type(initial, stream_type::kObjectDescriptor);
}

uint32_t timestamp_resolution(const EsDescriptor* es) {
  const auto* sl = es != nullptr ? find_part<SlConfig>(es->parts) : nullptr;
  if (sl == nullptr || !sl->fields || sl->fields->time_stamp_resolution == 0)
    return kDefaultResolution;
  return sl->fields->time_stamp_resolution;
}

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A presentation as a whole: its object descriptors, its scene and the commands that change them in
// time. Text (BT, XMT-A) is read into a Presentation; whoever writes one, in whatever form, is a
// PresentationSink, and is told it piece by piece by play() or by the decoder of a file.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "bifs/command.h"
#include "bifs/descriptor.h"
#include "bifs/od_command.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "nodes/scene.h"

namespace afx::bifs {

/// One access unit of the scene stream or of the stream of object descriptors.
struct AccessUnit {
  uint64_t time = 0;          ///< ticks of the stream's timestamp resolution
  bool random_access = true;  ///< decoding can begin here
  std::variant<std::vector<Command>, OdCommands> commands;
};

/// What a text says, nothing of it carried out: `scene` holds every node that comes in a command,
/// with the values that it has there, and has no roots.
struct Presentation {
  /// In the form of streams (in_file false), with an EsDescriptor for each stream. Of the scene
  /// stream the DecoderSpecificInfo, where it is there, is a BIFS configuration: its widths are the
  /// least that are wanted. Without EsDescriptors there is one stream, of the scene, with ES_ID 1.
  InitialObjectDescriptor initial;
  nodes::Scene scene;
  std::vector<AccessUnit> units;  ///< in the order of time
};

/// Takes a presentation piece by piece. The first error ends the telling and is handed on.
class PresentationSink {
 public:
  PresentationSink() = default;
  PresentationSink(const PresentationSink&) = delete;
  PresentationSink& operator=(const PresentationSink&) = delete;
  virtual ~PresentationSink() = default;

  /// Comes first, once.
  virtual Status begin(const InitialObjectDescriptor& initial) = 0;
  /// An access unit of the scene stream: begin_frame, add for each command, end_frame.
  virtual Status begin_frame(uint64_t time, bool random_access) = 0;
  /// `before`: the scene that the command is about to change; good during the call.
  virtual Status add(const Command& command, const nodes::Scene& before) = 0;
  virtual Status end_frame() = 0;
  /// An access unit of the stream of object descriptors, in the form of streams: whole
  /// EsDescriptors, with a MediaSource where the access units of a stream are elsewhere.
  virtual Status object_descriptors(uint64_t time, bool random_access,
                                    const OdCommands& commands) = 0;
  /// Comes last.
  virtual Status end() = 0;
};

/// Tells a presentation to a sink, in the order of its units, and carries the commands out: the
/// scene is then as it is at the end. A command that cannot be carried out (apply_command) is told
/// all the same, with a warning (not_applied).
Status play(Presentation& presentation, PresentationSink& sink, Diagnostics& diagnostics);

/// The EsDescriptor of the scene stream, or of the stream of object descriptors; nullptr where
/// there is none.
const EsDescriptor* scene_stream(const InitialObjectDescriptor& initial);
const EsDescriptor* object_descriptor_stream(const InitialObjectDescriptor& initial);

/// Ticks a second of a stream's times: the time stamp resolution of its SlConfig, 1000 where
/// nothing is said.
uint32_t timestamp_resolution(const EsDescriptor* es);

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The fields of descriptors by the names that they have in text, BT and XMT-A alike: one
// description, over which reading and writing are passes. A pass has the members
//
//     number(name, value, bits, unsaid)    an unsigned number of so many bits
//     flag(name, value, unsaid)            true or false
//     optional_number(name, value, bits)   std::optional of a number
//     optional_text(name, value)           std::optional<std::string>
//
// A writer may leave out what has the value `unsaid`; a reader has it there already.
// Source: ISO/IEC 14496-1 (clauses not checked) for the fields; the names as the peer has them.
#pragma once

#include "bifs/descriptor.h"

namespace afx::bifs {

template <class Object, class Pass>
void object_descriptor_fields(Object& object, Pass& pass) {
  pass.number("objectDescriptorID", object.id, 10, 0xFFFF);
  pass.optional_text("URLstring", object.url);
}

template <class Initial, class Pass>
void initial_object_fields(Initial& initial, Pass& pass) {
  object_descriptor_fields(initial, pass);
  pass.flag("includeInlineProfileLevelFlag", initial.inline_profiles, false);
}

/// In XMT-A these stand in an element of their own, Profiles.
template <class Initial, class Pass>
void profile_fields(Initial& initial, Pass& pass) {
  pass.number("ODProfileLevelIndication", initial.od_profile, 8, 0xFF);
  pass.number("sceneProfileLevelIndication", initial.scene_profile, 8, 0xFF);
  pass.number("audioProfileLevelIndication", initial.audio_profile, 8, 0xFF);
  pass.number("visualProfileLevelIndication", initial.visual_profile, 8, 0xFF);
  pass.number("graphicsProfileLevelIndication", initial.graphics_profile, 8, 0xFF);
}

template <class Es, class Pass>
void es_descriptor_fields(Es& es, Pass& pass) {
  pass.number("ES_ID", es.es_id, 16, 0xFFFFFFFF);
  pass.optional_number("dependsOn_ES_ID", es.depends_on, 16);
  pass.optional_number("OCR_ES_ID", es.ocr_es_id, 16);
  pass.number("streamPriority", es.priority, 5, 0);
  pass.optional_text("URLstring", es.url);
}

template <class Config, class Pass>
void decoder_config_fields(Config& config, Pass& pass) {
  pass.number("objectTypeIndication", config.object_type, 8, 0);
  pass.number("streamType", config.stream_type, 6, 0xFF);
  pass.flag("upStream", config.up_stream, false);
  pass.number("bufferSizeDB", config.buffer_bytes, 24, 0);
  pass.number("maxBitrate", config.max_bitrate, 32, 0);
  pass.number("avgBitrate", config.avg_bitrate, 32, 0);
}

template <class Fields, class Pass>
void sl_config_fields(Fields& sl, Pass& pass) {
  pass.flag("useAccessUnitStartFlag", sl.access_unit_start, false);
  pass.flag("useAccessUnitEndFlag", sl.access_unit_end, false);
  pass.flag("useRandomAccessPointFlag", sl.random_access_point, false);
  pass.flag("hasRandomAccessUnitsOnlyFlag", sl.random_access_units_only, false);
  pass.flag("usePaddingFlag", sl.padding, false);
  pass.flag("useTimeStampsFlag", sl.time_stamps, true);
  pass.flag("useIdleFlag", sl.idle, false);
  pass.flag("durationFlag", sl.has_duration, false);
  pass.number("timeStampResolution", sl.time_stamp_resolution, 32, 0);
  pass.number("OCRResolution", sl.ocr_resolution, 32, 0);
  pass.number("timeStampLength", sl.time_stamp_bits, 8, 0);
  pass.number("OCRLength", sl.ocr_bits, 8, 0);
  pass.number("AU_Length", sl.au_length_bits, 8, 0);
  pass.number("instantBitrateLength", sl.instant_bitrate_bits, 8, 0);
  pass.number("degradationPriorityLength", sl.degradation_priority_bits, 4, 0);
  pass.number("AU_seqNumLength", sl.au_sequence_bits, 5, 0);
  pass.number("packetSeqNumLength", sl.packet_sequence_bits, 5, 0);
  pass.number("timeScale", sl.time_scale, 32, 0);
  pass.number("accessUnitDuration", sl.access_unit_duration, 16, 0);
  pass.number("compositionUnitDuration", sl.composition_unit_duration, 16, 0);
  pass.number("startDecodingTimeStamp", sl.start_decoding_time, 64, 0);
  pass.number("startCompositionTimeStamp", sl.start_composition_time, 64, 0);
}

/// The configuration of a scene stream. In XMT-A pixelMetric and the size stand in elements of
/// their own.
template <class Config, class Pass>
void bifs_config_widths(Config& config, Pass& pass) {
  pass.flag("use3DMeshCoding", config.use_3d_mesh_coding, false);
  pass.flag("usePredictiveMFField", config.use_predictive_field, false);
  pass.number("nodeIDbits", config.node_id_bits, 5, 0);
  pass.number("routeIDbits", config.route_id_bits, 5, 0);
  pass.number("protoIDbits", config.proto_id_bits, 5, 0);
}

}  // namespace afx::bifs

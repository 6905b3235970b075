// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Commands of the object descriptor stream: which objects appear and go, and when. ISO/IEC 14496-1
// (clauses not checked), in MP4 files as ISO/IEC 14496-14 stores them. An access unit is a sequence
// of commands, each a tag, a length and a payload as descriptors have them.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "bifs/descriptor.h"
#include "codec/bit_reader.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx::bifs {

/// ObjectDescriptorUpdate (tag 1): these objects are there from now on, or changed.
struct OdUpdate {
  Descriptors objects;  ///< ObjectDescriptors
  bool operator==(const OdUpdate&) const = default;
};

/// ObjectDescriptorRemove (tag 2).
struct OdRemove {
  std::vector<uint16_t> ids;  ///< ObjectDescriptorIDs, 0..1023
  bool operator==(const OdRemove&) const = default;
};

/// ES_DescriptorUpdate (tag 3): streams added to an object.
struct EsUpdate {
  uint16_t od_id = 0;    ///< 0..1023
  bool aligned = false;  ///< 6 zero bits behind od_id. Sources differ: GPAC has none, so they are
                         ///< read either way and written without
  Descriptors streams;   ///< ES_Descriptors, in MP4 files EsIdRefs
  bool operator==(const EsUpdate&) const = default;
};

/// ES_DescriptorRemove (tag 4; in MP4 files tag 7, which names streams as EsIdRef does).
struct EsRemove {
  uint16_t od_id = 0;      ///< 0..1023
  bool references = true;  ///< tag 7: `streams` are places in 'mpod', from 1; otherwise ES_IDs
  std::vector<uint16_t> streams;
  bool operator==(const EsRemove&) const = default;
};

/// Any other command (such as IPMP updates): kept and written back.
struct UnknownOdCommand {
  uint8_t tag = 0;
  std::vector<uint8_t> payload;
  bool operator==(const UnknownOdCommand&) const = default;
};

struct OdCommand {
  std::variant<UnknownOdCommand, OdUpdate, OdRemove, EsUpdate, EsRemove> body;
  uint8_t length_bytes = 0;  ///< as Descriptor::length_bytes
  bool operator==(const OdCommand&) const = default;
};
using OdCommands = std::vector<OdCommand>;

/// Reads one access unit of an object descriptor stream. Places count from the start of `data`.
/// Written again it gives the same bytes, unless there was a warning.
///
/// Errors    those of read_descriptors, of commands likewise
/// Warnings  those of read_descriptors; padding: bits behind the last ID that are not zero bits up
///           to the byte
Result<OdCommands> read_od_commands(std::span<const uint8_t> data, const Limits& limits,
                                    Diagnostics& diagnostics, const codec::Trace* trace = nullptr);

/// Writes one access unit.
/// Errors  bad_argument: those of write_descriptors; an ID of more than 1023; an UnknownOdCommand
///         with the tag of a known one
Result<std::vector<uint8_t>> write_od_commands(const OdCommands& commands);

}  // namespace afx::bifs

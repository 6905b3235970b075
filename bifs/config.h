// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "codec/diagnostics.h"
#include "codec/error.h"

namespace afx::bifs {

/// Object type indications of scene streams.
inline constexpr uint8_t kOtiBifs = 1;          ///< BIFSConfig
inline constexpr uint8_t kOtiBifsV2 = 2;        ///< BIFSv2Config
inline constexpr uint8_t kOtiBifsExtended = 4;  ///< BIFSConfigEx

/// Size of the scene's display in pixels.
struct DisplaySize {
  uint16_t width = 0;
  uint16_t height = 0;
  bool operator==(const DisplaySize&) const = default;
};

/// The decoder-specific information of a scene stream: what its access units need to be read.
struct BifsConfig {
  uint8_t version = 1;              ///< the form: 1 or 2, which is also the object type indication
  bool use_3d_mesh_coding = false;  ///< version 2: IndexedFaceSet is coded as a 3D mesh
  bool use_predictive_field = false;  ///< version 2: MFFields may be coded predictively
  uint8_t node_id_bits = 1;           ///< 0..31
  uint8_t route_id_bits = 0;          ///< 0..31
  uint8_t proto_id_bits = 0;          ///< 0..31; version 1 has none
  bool pixel_metric = true;           ///< coordinates are pixels, not metres
  std::optional<DisplaySize> size;
  bool operator==(const BifsConfig&) const = default;
};

/// Reads a decoder configuration.
///
/// oti     the object type indication of the stream: kOtiBifs or kOtiBifsV2. Where the bytes do not
///         fit the form it names but fit the other, that one is read, with a warning
///         (config_form): files with the wrong indication exist.
/// Errors  truncated; unsupported (an animation stream; the extended configuration; another oti)
/// Source  ISO/IEC 14496-11, BIFSConfig and BIFSv2Config (clauses not checked); spec/bifs.md 2
Result<BifsConfig> read_config(std::span<const uint8_t> data, uint8_t oti,
                               Diagnostics& diagnostics);

/// Writes a configuration in the form that `version` names. Errors: bad_argument (a width above
/// 31, another version, a version 1 with PROTO bits or one of the version 2 tools).
Result<std::vector<uint8_t>> write_config(const BifsConfig& config);

}  // namespace afx::bifs

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <cstdint>

#include "bifs/encoder.h"
#include "bifs/presentation.h"
#include "codec/error.h"

namespace afx::bifs {

/// What may be chosen when a presentation that was read from text is encoded.
struct EncodingChoices {
  /// GPAC's choices, so that a text gives the bits that its MP4Box makes of it:
  /// - PROTO IDs count from 1 in each scope, and are cut to the width of the last one;
  /// - images and lists of script texts are written even if they were not given;
  /// - bounds of SFInt32 PROTO fields are written as the bits of floats;
  /// - node insertions at positions above 255 lose the higher bits (a warning says so);
  /// - no coding of numbers but the ones that the text asks for.
  ///
  /// The text must be read like_gpac too (nodes::SceneReadOptions), for strings and ROUTE IDs.
  /// Without it PROTO IDs are unique in the file, and insertions at such positions are coded as
  /// insertions of values, which have 16 bits.
  bool like_gpac = false;
  /// Code the names of nodes, ROUTEs, PROTOs and their fields too (USENAMES; MP4Box -def).
  enum class Names : uint8_t {
    automatic,  ///< where names would be lost, that is, are not the ones that IDs stand for (N<k>);
                ///< like_gpac: never
    always,
    never
  };
  Names names = Names::automatic;
  /// Code quantized lists predictively where that is shorter (EncodeOptions::predictive). Not like
  /// GPAC.
  bool predictive = false;
};

/// Makes a presentation ready for encoding: gives it an EsDescriptor for the scene stream, and one
/// for object descriptors if there are any; puts the configuration into the former, with the widths
/// that the IDs of the scene need or, where the text asks for more, those; settles what `choices`
/// say.
///
/// Errors    malformed: the configuration of the text cannot be read; limit_exceeded: IDs beyond 31
///           bits
/// Warnings  position_cut
Status set_up_encoding(Presentation& presentation, const EncodingChoices& choices,
                       Diagnostics& diagnostics);

/// The options of the encoder that go with choices.
EncodeOptions encode_options(const EncodingChoices& choices);

}  // namespace afx::bifs

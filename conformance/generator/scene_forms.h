// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// A presentation in the forms that it can have, and back. What carries the commands of a
// presentation out says so; warnings are of no interest here.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bifs/encoding_setup.h"
#include "bifs/presentation.h"

namespace afx::conformance {

/// What a presentation tells (told_commands.h); it is played.
std::string told(bifs::Presentation& presentation);

/// A raw scene, after set_up_encoding; the presentation is played.
Result<std::vector<uint8_t>> encode(bifs::Presentation& presentation,
                                    const bifs::EncodingChoices& choices);
/// The same as an MP4 file.
Result<std::vector<uint8_t>> encode_mp4(bifs::Presentation& presentation,
                                        const bifs::EncodingChoices& choices);
/// Decodes a raw scene or an MP4 file into a sink.
Status decode(const std::vector<uint8_t>& bytes, bool raw, bifs::PresentationSink& sink);
/// The same as the answer of the form `commands`; null where it does not decode.
nlohmann::json decoded_document(const std::vector<uint8_t>& bytes, bool raw);
/// A raw scene, decoded and encoded.
Result<std::vector<uint8_t>> encode_again(const std::vector<uint8_t>& bytes,
                                          const bifs::EncodingChoices& choices);

/// XMT-A or BT; the presentation is played.
Result<std::string> write_text(bifs::Presentation& presentation, bool xml);
Result<bifs::Presentation> read_text(const std::string& text, bool xml);

}  // namespace afx::conformance

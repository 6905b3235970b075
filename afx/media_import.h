// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Elementary streams from the files that a scene is made of.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "afx/file.h"
#include "bifs/media.h"
#include "codec/diagnostics.h"
#include "codec/error.h"
#include "codec/limits.h"

namespace afx {

/// The first byte of the configuration of an AFX stream: how it is coded.
inline constexpr uint8_t kOctreeImageCode = 6, kSc3dmcCode = 12;

/// How long a frame of an OctreeImage stream is shown, in milliseconds: the stream does not say it.
inline constexpr uint32_t kFrameMilliseconds = 40;

/// The access units of a file. Its content tells what it is:
///
///   PNG, JPEG, JPEG 2000 (JP2)    one sample, the whole file
///   OctreeImage stream (.afx)     a sample for each frame, in milliseconds: the header and that
///                                 frame, so that each is a whole stream
///   "scene.mp4#20"                track 20 of an MP4 file, with its sample entries, times and
///                                 edits
///   SC3DMC                        told by the ending .s3d or by the format "SC3DMC"; one sample,
///   the
///                                 whole file, which is not looked at
///
/// Files are named relative to `folder` (empty: the working folder), and are mapped as long as what
/// is returned lives.
/// Errors  io: cannot be opened, is no regular file; unsupported: of no such kind; malformed,
///         truncated: its header, its frames or the MP4 file are broken; bad_argument: there is no
///         such track; limit_exceeded: a picture of more than 65535 pixels a side, a sample of 4
///         GB, the limits. All with the path
/// Warnings  those of decode_octree_stream and read_mp4, with the path
Result<bifs::Media> import_media(const bifs::MediaSource& source, const std::string& folder,
                                 const Limits& limits, Diagnostics& diagnostics);

/// A stream of one sample, the whole file, which lasts for ever.
/// Errors  limit_exceeded: 4 GB or more. Reading the sample: limit_exceeded: limits.memory
Result<bifs::Media> one_sample_media(bifs::Mp4Track track, MappedFile file, const Limits& limits);

/// The object code of an AFX stream (kOctreeImageCode, ...); none for other streams and without a
/// configuration.
std::optional<uint8_t> afx_object_code(const bifs::Media& media);

/// The object type of a stream of still pictures (bifs::object_type::kJpeg, kPng, kJpeg2000); none
/// for other streams.
std::optional<uint8_t> still_picture_type(const bifs::Media& media);

}  // namespace afx

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// Scenes from files of any kind that holds one: text, XMT-A, MP4, raw BIFS.
#pragma once

#include <memory>

#include "afx/scene_files.h"
#include "bifs/mp4_presentation_reader.h"
#include "bifs/presentation.h"
#include "tools/input.h"

namespace afx::tools {

/// An opened MP4 file or raw BIFS stream.
struct CodedScene {
  bifs::Mp4Movie movie;
  bifs::Mp4Source source;  ///< the bytes of the input, which must outlive this
};

/// Errors: those of read_mp4 and read_raw_bifs, with the file.
Result<CodedScene> open_coded_scene(const Input& input, const Limits& limits,
                                    Diagnostics& diagnostics, const codec::Trace* trace = nullptr);

/// Reads a text scene with its descriptors and commands; like_gpac: BT as MP4Box reads it. Errors:
/// those of read_bt and read_xmt, with the file.
Result<bifs::Presentation> read_presentation(const Input& input, const Limits& limits,
                                             Diagnostics& diagnostics, bool like_gpac = false);

/// A scene and what its urls lead to. Can be moved; `input` must outlive it.
struct LoadedScene {
  nodes::Scene scene;
  std::string folder;
  std::unique_ptr<CodedScene> coded;  ///< of an MP4 file: holds the streams' bytes
  ObjectStreams streams;

  [[nodiscard]] UrlBase base() const { return UrlBase(folder, &streams); }
};

/// Reads the scene of an input as it is at the end, all commands carried out. Errors and warnings:
/// those of the readers.
Result<LoadedScene> read_scene(const Input& input, const Limits& limits, Diagnostics& diagnostics);

/// The same as plain text would hold it: what streams bring is in the nodes, pictures have their
/// names. Errors also: those of unpack_scene.
Result<nodes::Scene> read_plain_scene(const Input& input, const Limits& limits,
                                      Diagnostics& diagnostics);

/// Warns of what a scene has and models of it have not (left_out): Shapes and Inlines.
void warn_of_left_out(const nodes::Scene& scene, Diagnostics& diagnostics);

}  // namespace afx::tools

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include <string>

#include "nodes/scene.h"
#include "nodes/text_out.h"

namespace afx::nodes {

struct SceneWriteOptions {
  bool vrml_header = false;  ///< begin with the line `#VRML V2.0 utf8` (.wrl); BT has no header
};

/// Writes a scene as text that read_scene_text reads back to an equal scene. Floats have the
/// shortest decimal form that reads back exactly, a NaN that is not the usual one is nan(0xBITS). A
/// node that stands in several places but has no DEF name, or one that text cannot hold, gets a
/// name `_N1`, ...; ROUTEs of nodes that stand nowhere are left out. The same scene gives the same
/// text.
std::string write_scene_text(const Scene& scene, const SceneWriteOptions& options = {});
/// The same piece by piece. Errors: those of the sink.
Status write_scene_text_to(const TextSink& sink, const Scene& scene,
                           const SceneWriteOptions& options = {});

/// One value as scene text has it, nodes as "..." or NULL. For messages and dumps.
std::string value_text(const FieldValue& value);

}  // namespace afx::nodes

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#pragma once

#include "bifs/presentation.h"
#include "conformance/generator/choices.h"

namespace afx::conformance {

/// The names of nodes, ROUTEs, PROTOs and their fields.
enum class SceneNames {
  own,  ///< any; also none
  made  ///< those that a decoder makes for a stream without names
};

/// A legal presentation of one scene stream: a scene, mostly small, and commands that change it.
/// Every node, field type and command occurs. It is complete but for the descriptors and the
/// configuration, which bifs::set_up_encoding adds. All draws 0: an empty Group.
///
/// The same draws give the same presentation but for the names, whatever `names` are.
bifs::Presentation random_scene(Choices& choices, SceneNames names);

}  // namespace afx::conformance

// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The viewer's keys: one table, which the window and the help are made from.
#pragma once

#include <cstdint>
#include <span>

namespace afx::tools {

/// A key: the small letter or sign that it has on the user's keyboard, or one of these.
enum Key : int {
  kKeyNone = 0,
  kKeyEscape = 256,
  kKeyTab,
  kKeyLeft,
  kKeyRight,
  kKeyUp,
  kKeyDown,
  kKeyPageUp,
  kKeyPageDown,
  kKeyF1,
  kKeyF11,
  kKeyF12
};

struct Modifiers {
  bool shift = false;
  bool control = false;
};

enum class Action : uint8_t {
  none,
  // As long as the key is held:
  turn_left,
  turn_right,
  turn_up,
  turn_down,
  fly_ahead,
  fly_back,
  fly_left,
  fly_right,
  fly_up,
  fly_down,
  zoom_in,
  zoom_out,
  // Once:
  quit,
  help,
  reset,
  fit,
  projection,
  splats,
  coarser,
  finer,
  samples,
  backend,
  background,
  boxes,
  cameras,
  next_camera,
  previous_camera,
  next_viewpoint,
  previous_viewpoint,
  viewpoint,  ///< the key is its number
  screenshot,
  window_picture,
  status,
  fullscreen
};

/// Whether it goes on while the key is held.
constexpr bool is_held(Action action) {
  return action >= Action::turn_left && action <= Action::zoom_out;
}

/// What a key does.
struct KeyRow {
  Action action;
  int key;     ///< a Key or a character
  bool shift;  ///< with the shift key. Held actions, and signs, take no notice of it
};
[[nodiscard]] std::span<const KeyRow> key_rows();

/// The action of a key; none where it has none.
[[nodiscard]] Action action_of(int key, const Modifiers& modifiers);

/// A line of the help.
struct HelpRow {
  const char* what;  ///< keys or gesture; nullptr: `does` is a heading
  const char* does;
};
[[nodiscard]] std::span<const HelpRow> help_rows();

}  // namespace afx::tools

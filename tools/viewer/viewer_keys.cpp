// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/viewer_keys.h"

namespace afx::tools {
namespace {

/// A key with its help. Rows without an action are gestures or headings; rows without a text belong
/// to the row above.
struct Row {
  KeyRow key;
  HelpRow help;
};

constexpr KeyRow kNoKey{Action::none, kKeyNone, false};
constexpr HelpRow kNoHelp{nullptr, nullptr};

constexpr Row kRows[] = {
    {kNoKey, {nullptr, "Moving"}},
    {kNoKey, {"drag", "turn around the model"}},
    {kNoKey, {"right drag, Shift + drag", "shift the picture"}},
    {kNoKey, {"scroll, two fingers", "zoom to what is under the cursor"}},
    {kNoKey, {"Ctrl + drag", "look around from where you are"}},
    {kNoKey, {"double click", "turn around this point from now on"}},
    {{Action::turn_left, kKeyLeft, false}, {"arrow keys", "turn around the model"}},
    {{Action::turn_right, kKeyRight, false}, kNoHelp},
    {{Action::turn_up, kKeyUp, false}, kNoHelp},
    {{Action::turn_down, kKeyDown, false}, kNoHelp},
    {{Action::fly_ahead, 'w', false}, {"w  s  a  d", "fly ahead, back, left, right"}},
    {{Action::fly_back, 's', false}, kNoHelp},
    {{Action::fly_left, 'a', false}, kNoHelp},
    {{Action::fly_right, 'd', false}, kNoHelp},
    {{Action::fly_up, 'e', false}, {"e  c", "fly up, down (Shift: all faster)"}},
    {{Action::fly_down, 'c', false}, kNoHelp},
    {{Action::zoom_in, '+', false}, {"+  -", "zoom"}},
    {{Action::zoom_in, '=', false}, kNoHelp},
    {{Action::zoom_out, '-', false}, kNoHelp},
    {kNoKey, {nullptr, "Places to look from"}},
    {{Action::reset, 'r', false}, {"r", "back to the beginning"}},
    {{Action::fit, 'f', false}, {"f", "fit the model into the window"}},
    {{Action::next_viewpoint, kKeyPageDown, false},
     {"PageUp  PageDown", "viewpoints of the scene"}},
    {{Action::previous_viewpoint, kKeyPageUp, false}, kNoHelp},
    {{Action::viewpoint, '1', false}, {"1 to 9", "viewpoint of that number"}},
    {{Action::viewpoint, '2', false}, kNoHelp},
    {{Action::viewpoint, '3', false}, kNoHelp},
    {{Action::viewpoint, '4', false}, kNoHelp},
    {{Action::viewpoint, '5', false}, kNoHelp},
    {{Action::viewpoint, '6', false}, kNoHelp},
    {{Action::viewpoint, '7', false}, kNoHelp},
    {{Action::viewpoint, '8', false}, kNoHelp},
    {{Action::viewpoint, '9', false}, kNoHelp},
    {{Action::next_camera, 'n', false}, {"n  Shift + n", "next, previous reference camera"}},
    {{Action::previous_camera, 'n', true}, kNoHelp},
    {{Action::projection, 'o', false}, {"o", "perspective or parallel projection"}},
    {kNoKey, {nullptr, "Drawing"}},
    {{Action::splats, 'k', false}, {"k", "kind of splats: smooth, flat, points"}},
    {{Action::coarser, 'l', false}, {"l  Shift + l", "octree one level coarser, finer"}},
    {{Action::finer, 'l', true}, kNoHelp},
    {{Action::samples, 'm', false}, {"m", "samples in a pixel when still: 1 to 4"}},
    {{Action::backend, 'g', false}, {"g", "software or OpenGL"}},
    {{Action::background, 'y', false}, {"y", "background"}},
    {{Action::boxes, 'b', false}, {"b", "boxes around the models"}},
    {{Action::cameras, 'i', false}, {"i", "cameras of the reference images"}},
    {kNoKey, {nullptr, "Window"}},
    {{Action::screenshot, 'p', false}, {"p", "save the picture (PNG, numbered)"}},
    {{Action::window_picture, kKeyF12, false}, {"F12", "save all of the window"}},
    {{Action::status, kKeyTab, false}, {"Tab", "hide or show the status"}},
    {{Action::fullscreen, kKeyF11, false}, {"F11", "full screen"}},
    {kNoKey, {"drop a file", "show it instead"}},
    {{Action::help, 'h', false}, {"h", "hide or show this help"}},
    {{Action::help, kKeyF1, false}, kNoHelp},
    {{Action::quit, 'q', false}, {"q  Esc", "quit"}},
    {{Action::quit, kKeyEscape, false}, kNoHelp},
};

template <class Part, Part Row::*kPart, class Wanted>
struct Column {
  static constexpr size_t count() {
    size_t n = 0;
    for (const Row& row : kRows) n += Wanted()(row.*kPart) ? 1 : 0;
    return n;
  }
  Part rows[count()];
  constexpr Column() : rows{} {
    size_t n = 0;
    for (const Row& row : kRows)
      if (Wanted()(row.*kPart)) rows[n++] = row.*kPart;
  }
};

struct HasAction {
  constexpr bool operator()(const KeyRow& row) const { return row.action != Action::none; }
};
struct HasText {
  constexpr bool operator()(const HelpRow& row) const { return row.does != nullptr; }
};

constexpr Column<KeyRow, &Row::key, HasAction> kKeys;
constexpr Column<HelpRow, &Row::help, HasText> kHelp;

bool is_letter(int key) { return key >= 'a' && key <= 'z'; }

}  // namespace

std::span<const KeyRow> key_rows() { return kKeys.rows; }
std::span<const HelpRow> help_rows() { return kHelp.rows; }

Action action_of(int key, const Modifiers& modifiers) {
  if (modifiers.control) return Action::none;  // another program's habits
  for (const KeyRow& row : kKeys.rows) {
    if (row.key != key) continue;
    if (is_held(row.action) || !is_letter(key) || row.shift == modifiers.shift) return row.action;
  }
  return Action::none;
}

}  // namespace afx::tools

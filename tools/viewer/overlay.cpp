// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/overlay.h"

#include <imgui.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#include <unistd.h>

#include <algorithm>
#include <span>

#include "tools/viewer/viewer_keys.h"

namespace afx::tools {
namespace {

constexpr float kTextHeight = 15;
constexpr ImGuiWindowFlags kPlain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_AlwaysAutoResize;
const ImVec4 kHeading(1, 0.80F, 0.40F, 1);
const ImVec4 kKeys(0.65F, 0.85F, 1, 1);
const ImVec4 kError(1, 0.55F, 0.50F, 1);

/// A font that is easy to read, if the machine has it; the built-in one otherwise.
void add_font(float scale) {
  static const ImWchar kRanges[] = {0x20, 0x24F, 0x370, 0x52F, 0x2000, 0x206F, 0x20A0, 0x20CF, 0};
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  for (const char* path : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                           "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                           "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf"}) {
    if (access(path, R_OK) != 0) continue;
    if (fonts.AddFontFromFileTTF(path, kTextHeight * scale, nullptr, kRanges) != nullptr) return;
  }
  ImFontConfig config;
  config.SizePixels = 13 * std::max(1.0F, static_cast<float>(static_cast<int>(scale + 0.5F)));
  fonts.AddFontDefault(&config);
}

void set_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 6;
  style.WindowBorderSize = 0;
  style.WindowPadding = {10, 8};
  style.ItemSpacing = {8, 3};
  style.Colors[ImGuiCol_WindowBg] = {0.05F, 0.06F, 0.07F, 1};
  style.ScaleAllSizes(scale);
}

/// A small window at a place, its corner `pivot` there.
void begin(const char* name, const ImVec2& at, const ImVec2& pivot, float opacity) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowBgAlpha(opacity);
  ImGui::Begin(name, nullptr, kPlain);
}

/// Some lines, broken where they are longer than `width`; below 0: nowhere.
void lines(const std::string& text, float width) {
  ImGui::PushTextWrapPos(width);
  ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
  ImGui::PopTextWrapPos();
}

/// One half of the help: a column of keys, one of what they do.
class HelpColumn {
 public:
  explicit HelpColumn(std::span<const HelpRow> rows) : rows_(rows) {
    for (const HelpRow& row : rows_) {
      if (row.what == nullptr) continue;
      keys_ = std::max(keys_, ImGui::CalcTextSize(row.what).x);
      texts_ = std::max(texts_, ImGui::CalcTextSize(row.does).x);
    }
    keys_ += ImGui::GetTextLineHeight();
  }
  [[nodiscard]] float width() const { return keys_ + texts_; }
  /// Returns where it ends.
  float draw(ImVec2 at) const {
    for (const HelpRow& row : rows_) {
      const bool heading = row.what == nullptr;
      if (heading && &row != rows_.data()) at.y += ImGui::GetTextLineHeight() * 0.6F;
      ImGui::SetCursorPos(at);
      ImGui::TextColored(heading ? kHeading : kKeys, "%s", heading ? row.does : row.what);
      ImGui::SetCursorPos({at.x + keys_, at.y});
      if (!heading) ImGui::TextUnformatted(row.does);
      at.y += ImGui::GetTextLineHeightWithSpacing();
    }
    return at.y;
  }

 private:
  std::span<const HelpRow> rows_;
  float keys_ = 0, texts_ = 0;
};

/// Where the second half of the help begins: with the heading next after the middle.
size_t half_of(std::span<const HelpRow> rows) {
  size_t half = rows.size() / 2;
  while (half < rows.size() && rows[half].what != nullptr) ++half;
  return half;
}

}  // namespace

Overlay::Overlay(double scale) : scale_(static_cast<float>(std::clamp(scale, 1.0, 4.0))) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // it writes no files
  ImGui_ImplOpenGL3_Init("#version 330 core");
  add_font(scale_);
  set_style(scale_);
}

Overlay::~Overlay() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Overlay::draw_status(const OverlayText& text) const {
  if (text.status.empty()) return;
  const float edge = 10 * scale_;
  begin("status", {edge, edge}, {0, 0}, 0.55F);
  lines(text.status, -1);
  ImGui::End();
}

void Overlay::draw_waiting(const OverlayText& text, const glm::vec2& window) const {
  if (text.waiting.empty()) return;
  begin("waiting", {window.x / 2, window.y / 2}, {0.5F, 0.5F}, 0.55F);
  ImGui::TextUnformatted(text.waiting.c_str());
  ImGui::End();
}

void Overlay::draw_bottom(const OverlayText& text, const glm::vec2& window) const {
  const float edge = 10 * scale_;
  const float width = window.x - 6 * edge;
  float y = window.y - edge;
  if (!text.error.empty()) {
    begin("error", {edge, y}, {0, 1}, 0.85F);
    ImGui::PushStyleColor(ImGuiCol_Text, kError);
    lines(text.error, width);
    ImGui::PopStyleColor();
    y -= ImGui::GetWindowHeight() + edge / 2;
    ImGui::End();
  }
  if (text.message.empty()) return;
  begin("message", {edge, y}, {0, 1}, 0.7F);
  lines(text.message, width);
  ImGui::End();
}

void Overlay::draw_help(const glm::vec2& window) const {
  begin("help", {window.x / 2, window.y / 2}, {0.5F, 0.5F}, 0.9F);
  const auto rows = help_rows();
  const HelpColumn left(rows.first(half_of(rows))), right(rows.subspan(half_of(rows)));
  const ImVec2 from = ImGui::GetCursorPos();
  const float gap = 2 * ImGui::GetTextLineHeight();
  const float end = std::max(left.draw(from), right.draw({from.x + left.width() + gap, from.y}));
  ImGui::SetCursorPos({from.x + left.width() + gap + right.width(), end});
  ImGui::End();
}

void Overlay::draw(const OverlayText& text, const glm::ivec2& window) {
  const glm::vec2 size(window);
  ImGui::GetIO().DisplaySize = {size.x, size.y};
  ImGui_ImplOpenGL3_NewFrame();
  // New windows are measured in their first frame and seen in the second.
  for (int frame = 0; frame < 2; ++frame) {
    ImGui::NewFrame();
    draw_status(text);
    draw_waiting(text, size);
    draw_bottom(text, size);
    if (text.help) draw_help(size);
    ImGui::Render();
  }
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace afx::tools

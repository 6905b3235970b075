// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "tools/viewer/viewer_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

namespace afx::tools {
namespace {

using testing::HasSubstr;

std::shared_ptr<ViewerModel> cube() {
  auto model = std::make_shared<ViewerModel>();
  for (unsigned k = 0; k < 8; ++k)
    model->outline.emplace_back((k & 1U) - 0.5, (k >> 1U & 1U) - 0.5, (k >> 2U) - 0.5);
  model->levels = 5;
  return model;
}

class ViewerStateTest : public testing::Test {
 protected:
  void SetUp() override {
    state.set_size({800, 600});
    state.show(model);
  }
  Action press(int key, bool shift = false) {
    const Action action = state.key_down(key, {.shift = shift});
    state.key_up(key);
    return action;
  }
  void drag(Button button, Modifiers modifiers, glm::dvec2 from, glm::dvec2 to) {
    state.button_down(button, modifiers, from);
    state.move(to);
    state.button_up(button);
  }

  std::shared_ptr<ViewerModel> model = cube();
  ViewerState state{Drawn{}};
};

TEST(ViewerKeys, NoKeyHasTwoMeaningsAndAllActionsHaveAKey) {
  std::set<std::pair<int, bool>> keys;
  std::set<Action> actions;
  for (const KeyRow& row : key_rows()) {
    EXPECT_TRUE(keys.insert({row.key, row.shift}).second) << row.key;
    EXPECT_TRUE(!row.shift || (row.key >= 'a' && row.key <= 'z')) << row.key;
    actions.insert(row.action);
  }
  EXPECT_EQ(actions.size(), static_cast<size_t>(Action::fullscreen));  // without none
}

TEST(ViewerKeys, TheHelpNamesEveryLetter) {
  std::string all;
  for (const HelpRow& row : help_rows())
    if (row.what != nullptr) all += std::string(" ") + row.what + " ";
  for (const KeyRow& row : key_rows()) {
    if (row.key < 'a' || row.key > 'z') continue;
    EXPECT_THAT(all, HasSubstr(std::string(" ") + static_cast<char>(row.key) + " "));
  }
}

TEST(ViewerKeys, ControlBelongsToOthersAndShiftChoosesTheOtherWay) {
  EXPECT_EQ(action_of('l', {}), Action::coarser);
  EXPECT_EQ(action_of('l', {.shift = true}), Action::finer);
  EXPECT_EQ(action_of('w', {.shift = true}), Action::fly_ahead);
  EXPECT_EQ(action_of('+', {.shift = true}), Action::zoom_in);
  EXPECT_EQ(action_of('l', {.control = true}), Action::none);
  EXPECT_EQ(action_of('j', {}), Action::none);
}

TEST_F(ViewerStateTest, StartsWithTheModelFittedAndResetGoesBackThere) {
  EXPECT_LT(glm::length(state.camera().target), 0.2);
  const glm::dvec3 eye = eye_of(state.camera());
  drag(Button::left, {}, {100, 100}, {240, 150});
  EXPECT_GT(glm::length(eye_of(state.camera()) - eye), 0.1);
  press('o');
  press('r');
  EXPECT_EQ(eye_of(state.camera()), eye);
  EXPECT_EQ(state.camera().projection, render::Projection::perspective);
}

TEST_F(ViewerStateTest, DragsTurnShiftAndLookByButtonAndKey) {
  const OrbitCamera start = state.camera();
  drag(Button::left, {}, {100, 100}, {140, 100});
  EXPECT_EQ(state.camera().target, start.target);
  EXPECT_LT(state.camera().azimuth, start.azimuth);
  press('r');
  for (const bool shift : {false, true}) {
    drag(shift ? Button::left : Button::right, {.shift = shift}, {100, 100}, {140, 100});
    EXPECT_EQ(state.camera().azimuth, start.azimuth);
    EXPECT_NEAR(glm::length(state.camera().target - start.target), 40 * unit_per_pixel(start, 600),
                1e-12);
    press('r');
  }
  drag(Button::left, {.control = true}, {100, 100}, {140, 100});
  EXPECT_LT(glm::length(eye_of(state.camera()) - eye_of(start)), 1e-12);
  EXPECT_GT(state.camera().azimuth, start.azimuth);
  state.move({300, 300});  // no button
  EXPECT_LT(glm::length(eye_of(state.camera()) - eye_of(start)), 1e-12);
}

TEST_F(ViewerStateTest, ScrollingIsSmoothAndEndsAtTheWholeFactor) {
  const double start = state.camera().distance;
  state.scroll(1, {400, 300});
  EXPECT_TRUE(state.is_moving());
  double last = start;
  int steps = 0;
  for (; state.is_moving() && steps < 200; ++steps) {
    state.advance(0.01);
    EXPECT_LT(state.camera().distance, last);
    last = state.camera().distance;
  }
  EXPECT_GT(steps, 5);
  EXPECT_LT(steps, 60);
  EXPECT_NEAR(last, start * std::exp(-0.15), 1e-9);
  state.scroll(-1, {400, 300});
  for (int i = 0; i < 100; ++i) state.advance(0.01);
  EXPECT_NEAR(state.camera().distance, start, 1e-9);
}

TEST_F(ViewerStateTest, ScrollingZoomsToWhatIsUnderTheCursor) {
  const double near = state.camera().distance * 0.9;
  state.set_distances([near](const glm::dvec2&) { return near; });
  const glm::dvec3 point = point_under(state.camera(), {600, 200}, {800, 600}, near);
  state.scroll(4, {600, 200});
  for (int i = 0; i < 200; ++i) state.advance(0.01);
  const glm::dvec3 after =
      point_under(state.camera(), {600, 200}, {800, 600}, near * std::exp(-0.6));
  EXPECT_LT(glm::length(after - point), 1e-9);
}

TEST_F(ViewerStateTest, HeldKeysMoveAsLongAsTheyAreHeldWhateverTheFrameRate) {
  const OrbitCamera start = state.camera();
  EXPECT_EQ(state.key_down('w', {}), Action::none);
  for (int i = 0; i < 10; ++i) state.advance(0.05);
  const double flown = glm::length(eye_of(state.camera()) - eye_of(start));
  EXPECT_NEAR(flown, 0.8 * 0.5 * start.distance, 1e-9);
  state.key_up('w');
  EXPECT_FALSE(state.is_moving());
  state.advance(1);
  EXPECT_NEAR(glm::length(eye_of(state.camera()) - eye_of(start)), flown, 1e-9);
  state.key_down('d', {});
  state.release_all();
  EXPECT_FALSE(state.is_moving());
}

TEST_F(ViewerStateTest, LevelsGoFromTheFinestToTheRoot) {
  press('l');
  EXPECT_EQ(state.drawn().level, 4U);
  EXPECT_EQ(state.take_message(), "octree level 4 of 5");
  EXPECT_EQ(state.take_message(), "");
  for (int i = 0; i < 9; ++i) press('l');
  EXPECT_EQ(state.drawn().level, 0U);
  for (int i = 0; i < 9; ++i) press('l', true);
  EXPECT_EQ(state.drawn().level, 5U);
  model->levels = 0;
  press('l');
  EXPECT_EQ(state.take_message(), "the model has no octree");
}

TEST_F(ViewerStateTest, KeysChangeTheDrawing) {
  const Drawn start = state.drawn();
  press('k');
  EXPECT_EQ(state.drawn().splats, render::SplatKind::flat);
  press('k');
  EXPECT_EQ(state.take_message(), "points");
  press('k');
  EXPECT_EQ(state.drawn(), start);
  press('m');
  EXPECT_EQ(state.drawn().samples, 4U);
  press('b');
  press('i');
  EXPECT_TRUE(state.drawn().boxes && state.drawn().cameras);
  EXPECT_EQ(state.take_message(), "the model has no reference images");
  press('g');
  EXPECT_EQ(state.drawn().backend, Backend::gl);
  state.refuse_backend("no");
  EXPECT_EQ(state.drawn().backend, Backend::software);
  for (int i = 0; i < 4; ++i) press('y');
  EXPECT_EQ(state.drawn().background, start.background);
  EXPECT_TRUE(state.drawn().backdrop);
}

TEST_F(ViewerStateTest, EscapeLeavesTheHelpFirst) {
  press('h');
  EXPECT_TRUE(state.help());
  EXPECT_EQ(press(kKeyEscape), Action::none);
  EXPECT_FALSE(state.help());
  EXPECT_EQ(press(kKeyEscape), Action::quit);
  EXPECT_EQ(press('q'), Action::quit);
  EXPECT_EQ(press('p'), Action::screenshot);
}

TEST_F(ViewerStateTest, ViewpointsAreGoneToInTurnAndByNumber) {
  press('1');
  EXPECT_EQ(state.take_message(), "the scene has no viewpoints");
  model->viewpoints.resize(2);
  model->viewpoints[0].position = {0, 0, 4};
  model->viewpoints[1].position = {0, 1, 5};
  model->viewpoints[1].description = "higher";
  press(kKeyPageDown);
  EXPECT_LT(glm::length(eye_of(state.camera()) - glm::dvec3(0, 0, 4)), 1e-9);
  press(kKeyPageDown);
  EXPECT_LT(glm::length(eye_of(state.camera()) - glm::dvec3(0, 1, 5)), 1e-9);
  EXPECT_EQ(state.take_message(), "viewpoint 2 of 2: higher");
  EXPECT_DOUBLE_EQ(state.camera().field_of_view, 0.785398);
  press(kKeyPageDown);
  EXPECT_LT(glm::length(eye_of(state.camera()) - glm::dvec3(0, 0, 4)), 1e-9);
  press(kKeyPageUp);
  EXPECT_LT(glm::length(eye_of(state.camera()) - glm::dvec3(0, 1, 5)), 1e-9);
  press('3');
  EXPECT_THAT(state.take_message(), HasSubstr("no viewpoint 3 (expected 1 to 2)"));
  model->first_viewpoint = 1;
  press('r');
  EXPECT_LT(glm::length(eye_of(state.camera()) - glm::dvec3(0, 0, 4)), 1e-9);
}

TEST_F(ViewerStateTest, ReferenceCamerasAreLookedThroughAsTheyAre) {
  ReferenceCamera from_right;
  from_right.position = {3, 0, 0};
  from_right.right = {0, 0, -1};
  from_right.ahead = {-1, 0, 0};
  from_right.orthographic = true;
  from_right.half_view = {0.5, 0.75};
  model->cameras = {from_right, ReferenceCamera{.position = {0, 0, 9}, .half_view = {0.4, 0.2}}};
  press('n');
  EXPECT_EQ(state.reference(), 0U);
  const render::Camera parallel = state.camera_for_drawing();
  EXPECT_EQ(parallel.projection, render::Projection::orthographic);
  EXPECT_NEAR(parallel.view_height, 1.5, 1e-9);
  EXPECT_LT(glm::length(parallel.orientation * glm::dvec3(0, 0, -1) - from_right.ahead), 1e-9);
  EXPECT_LT(glm::length(parallel.orientation * glm::dvec3(1, 0, 0) - from_right.right), 1e-9);
  press('n');
  const render::Camera wide = state.camera_for_drawing();  // 0.4 wide: 0.3 high in 4 : 3
  EXPECT_NEAR(wide.field_of_view, 2 * std::atan(0.3), 1e-9);
  EXPECT_LT(glm::length(wide.position - glm::dvec3(0, 0, 9)), 1e-9);
  press('n', true);
  EXPECT_EQ(state.reference(), 0U);
  drag(Button::left, {}, {0, 0}, {9, 9});
  EXPECT_FALSE(state.reference().has_value());
}

TEST_F(ViewerStateTest, ADoubleClickMakesThePointTheCentre) {
  state.set_distances(
      [](const glm::dvec2& at) { return at.x < 400 ? std::optional<double>(2.5) : std::nullopt; });
  const OrbitCamera start = state.camera();
  const glm::dvec3 point = point_under(start, {300, 200}, {800, 600}, 2.5);
  state.double_click({500, 200});
  EXPECT_EQ(state.camera().target, start.target);
  state.double_click({300, 200});
  EXPECT_LT(glm::length(state.camera().target - point), 1e-9);
  press('r');
  press('o');
  const render::Camera drawn = state.camera_for_drawing();
  const glm::dvec3 ahead = drawn.orientation * glm::dvec3(0, 0, -1);
  state.double_click({300, 200});
  EXPECT_NEAR(glm::dot(state.camera().target - drawn.position, ahead), 2.5, 1e-9);
}

TEST(ViewerStateWithoutModel, TakesAllEvents) {
  ViewerState state{Drawn{}};
  state.set_size({800, 600});
  for (const KeyRow& row : key_rows()) {
    state.key_down(row.key, {.shift = row.shift});
    state.advance(0.1);
    state.key_up(row.key);
  }
  state.button_down(Button::left, {}, {1, 1});
  state.move({50, 50});
  state.double_click({50, 50});
  state.scroll(1, {50, 50});
  EXPECT_FALSE(state.is_moving());
}

}  // namespace
}  // namespace afx::tools

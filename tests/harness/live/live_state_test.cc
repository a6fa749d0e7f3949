#include "harness/live/live_state.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::shared_ptr<const Scene> SceneOf(const std::string& name) {
  const std::string file =
      std::string(RTB_TEST_SOURCE_DIR) + "/scenes/" + name + ".yaml";
  auto scene = LoadScene(file);
  RTB_CHECK(scene.has_value());
  return std::make_shared<const Scene>(std::move(*scene));
}

LiveState Make(const std::string& scene = "whitted") {
  LiveView view;
  view.scene = scene;
  view.encoders = {"quadrant", "quadrant"};
  LiveState state(view, {{"half", "quadrant", "tiv"},
                         {"cornell", "moving", "whitted"},
                         {"embree"}});
  state.Resize({120, 40});
  state.Adopt(SceneOf(scene));
  return state;
}

void Press(LiveState* state, char32_t key, bool shift = false,
           bool ctrl = false) {
  state->Handle(KeyEvent{.key = key, .shift = shift, .ctrl = ctrl}, 0);
}

TEST(LiveState, EncodersGoAround) {
  LiveState state = Make();
  Press(&state, U'n');
  EXPECT_EQ(state.view().encoders[0], "tiv");
  Press(&state, U'n');
  EXPECT_EQ(state.view().encoders[0], "half");
  Press(&state, U'n', true);
  Press(&state, U'n', true);
  EXPECT_EQ(state.view().encoders[0], "quadrant");
}

TEST(LiveState, SplitScreenHasTwoEncodersAndADivider) {
  LiveState state = Make();
  Press(&state, U'v');
  EXPECT_TRUE(state.view().split);
  EXPECT_EQ(state.view().encoders,
            (std::array<std::string, 2>{"quadrant", "tiv"}));
  // 86 columns beside the panel.
  EXPECT_EQ(state.view().divider, 43);
  Press(&state, U'[');
  EXPECT_LT(state.view().divider, 43);
  Press(&state, kKeyTab);
  Press(&state, U'n');
  EXPECT_EQ(state.view().encoders[0], "tiv");
  EXPECT_EQ(state.view().encoders[1], "tiv");
  state.Resize({1, 1});
  EXPECT_FALSE(state.view().split);
  state.Resize({120, 40});
  EXPECT_TRUE(state.view().split);
}

TEST(LiveState, TheMouseDragsTheDividerAndTheView) {
  LiveState state = Make();
  Press(&state, U'v');
  state.Handle(MouseEvent{MouseAction::kPress, 0, 43, 10}, 0);
  state.Handle(MouseEvent{MouseAction::kDrag, 0, 20, 10}, 0);
  EXPECT_EQ(state.view().divider, 21);  // (20 + 1/2) / 86, rounded up.
  EXPECT_FALSE(state.view().camera.has_value());
  state.Handle(MouseEvent{MouseAction::kRelease, 0, 20, 10}, 0);
  state.Handle(MouseEvent{MouseAction::kPress, 0, 60, 10}, 0);
  state.Handle(MouseEvent{MouseAction::kDrag, 0, 70, 10}, 0);
  state.Step(0, 0);
  EXPECT_TRUE(state.view().camera.has_value());
}

TEST(LiveState, KeysMoveTheCamera) {
  LiveState state = Make();
  state.Step(0, 0.1);
  EXPECT_FALSE(state.view().camera.has_value());
  Press(&state, U'w');
  EXPECT_TRUE(state.moving(0.05));
  state.Step(0.05, 0.05);
  const auto scene = SceneOf("whitted");
  ASSERT_TRUE(state.view().camera.has_value());
  EXPECT_GT((state.view().camera->position - scene->camera.position)
                .dot(CameraAt(*scene, 0).forward),
            0);
  Press(&state, U'r');
  EXPECT_FALSE(state.view().camera.has_value());
}

// 0.35 rad/s: in 10 s the camera goes 3.5 rad, in swings of 0.4 rad.
TEST(LiveState, AnOrbitTurnsBackWhereItsReachEnds) {
  LiveState state = Make();
  state.modes().orbit = true;
  state.modes().orbit_reach = 0.2;
  const CameraFrame start = CameraAt(*SceneOf("whitted"), 0);
  double leftmost = 0, rightmost = 0;
  for (int i = 0; i < 100; ++i) {
    state.Step(0, 0.1);
    const V3d forward = state.view().camera->forward;
    const double angle =
        std::atan2(forward.dot(start.right), forward.dot(start.forward));
    leftmost = std::min(leftmost, angle);
    rightmost = std::max(rightmost, angle);
  }
  // It turns back after the step that passes the end, 0.035 rad long.
  EXPECT_NEAR(leftmost, -0.2, 0.04);
  EXPECT_NEAR(rightmost, 0.2, 0.04);
}

TEST(LiveState, ScenesThatForbidItDoNotMove) {
  LiveState state = Make();
  auto still = std::make_shared<Scene>(*SceneOf("cornell"));
  still->camera.user_control = false;
  state.Adopt(still);
  Press(&state, U'w');
  state.Step(0.05, 0.05);
  EXPECT_FALSE(state.view().camera.has_value());
  EXPECT_THAT(state.log().back(), HasSubstr("does not move"));
}

TEST(LiveState, MovementPlaysPausesAndSteps) {
  LiveState state = Make("moving");
  state.Step(0, 0.5);
  EXPECT_DOUBLE_EQ(state.view().time, 0.5);
  Press(&state, U'p');
  state.Step(0, 0.5);
  EXPECT_DOUBLE_EQ(state.view().time, 0.5);
  EXPECT_FALSE(state.moving(0));
  Press(&state, U'.');
  EXPECT_DOUBLE_EQ(state.view().time, 0.5 + 1.0 / 24);
}

TEST(LiveState, ScenePickerChooses) {
  LiveState state = Make();
  Press(&state, U'l');
  EXPECT_TRUE(state.modes().picker);
  Press(&state, kKeyDown);
  Press(&state, U'w');  // Does not move the camera now.
  Press(&state, kKeyEnter);
  EXPECT_FALSE(state.modes().picker);
  EXPECT_EQ(state.view().scene, "moving");
  state.RejectScene();
  EXPECT_EQ(state.view().scene, "whitted");
}

TEST(LiveState, SettingsHaveEnds) {
  LiveState state = Make();
  for (int i = 0; i < 20; ++i) Press(&state, U'+');
  EXPECT_EQ(state.view().spp, 256);
  for (int i = 0; i < 20; ++i) Press(&state, U'-');
  EXPECT_EQ(state.view().spp, 1);
  for (int i = 0; i < 1000; ++i) Press(&state, U'0');
  EXPECT_EQ(state.view().exposure, 64);
}

TEST(LiveState, ColorsNeverExceedTheTerminals) {
  LiveState state = Make();
  state.set_terminal_depth(ColorDepth::k256);
  std::vector<ColorDepth> seen;
  for (int i = 0; i < 4; ++i) {
    seen.push_back(state.view().depth);
    Press(&state, U'k');
  }
  EXPECT_THAT(seen, ElementsAre(ColorDepth::k256, ColorDepth::k16,
                                ColorDepth::kMono, ColorDepth::k256));
}

TEST(LiveState, ActionsAreHandedOnOnce) {
  LiveState state = Make();
  Press(&state, U'x');
  Press(&state, U'r', true);
  Press(&state, U'c', false, true);
  EXPECT_THAT(state.TakeActions(),
              ElementsAre(LiveCommand::kScreenshot, LiveCommand::kRecord,
                          LiveCommand::kQuit));
  EXPECT_TRUE(state.TakeActions().empty());
}

TEST(LiveState, TheLogShowsNoEscapeSequences) {
  LiveState state = Make();
  state.Log("scene \x1b[2J");
  EXPECT_EQ(state.log().back().find('\x1b'), std::string::npos);
  for (int i = 0; i < 1000; ++i) state.Log("line");
  EXPECT_LE(state.log().size(), 50u);
}

}  // namespace
}  // namespace rtb

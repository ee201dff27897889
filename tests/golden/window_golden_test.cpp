// SPDX-License-Identifier: MIT
// Golden windows: page, bar and panels as the screen draws them off-screen, by the golden rule, each proved
// able to fail.
#include "app/cli/lesson_lookup.h"
#include "app/cli/or_fail.h"
#include "app/window/screen/screen.h"
#include "render/image/compare.h"
#include "tests/golden/approval.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

namespace polhode::golden {
namespace {

/// What is done to a session, and where the pointer rests; then frames are drawn until all has settled.
struct Asked {
  Size size{1280, 800};
  std::size_t step = 0;
  double scale = 1;
  float x = -1, y = -1;
  std::vector<std::function<void(LessonSession&)>> changes{};
};

struct Row {
  std::string name;
  Asked asked;
};

void open(LessonSession& session, Panel panel) { session.panel = panel; }

/// The panel of methods shows times, which no two runs share: that is looked at under Xvfb.
const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = {
      {"window-plain", {.step = 0}},
      {"window-outline", {.step = 0, .changes = {[](LessonSession& c) { open(c, Panel::outline); }}}},
      {"window-body", {.step = 0, .changes = {[](LessonSession& c) { open(c, Panel::body); }}}},
      {"window-answer-dark", {.step = 1, .changes = {[](LessonSession& c) {
                                           c.preferences.theme = Theme::dark;
                                           open(c, Panel::question);
                                           c.answer(*c.questions().front(), "1");
                                           c.show_hint(*c.questions().front());
                                         }}}},
      {"window-note", {.step = 0, .x = 160, .y = 155}},
      {"window-narrow-large",
       {.size = {1400, 1000}, .step = 0, .scale = 1.5, .changes = {[](LessonSession& c) {
                                                         open(c, Panel::show);
                                                       }}}},
  };
  return kRows;
}

std::shared_ptr<const LoadedLesson> lesson() {
  static const auto kLesson = std::make_shared<const LoadedLesson>(
      or_fail(load_lesson((test::source_dir() / "tests/data/golden/page.md").string())));
  return kLesson;
}

Image picture(const Asked& asked) {
  auto screen = Screen::create(context(), renderer().fonts());
  if (!screen) throw std::runtime_error(screen.error());
  LessonSession session(lesson());
  session.preferences.reduced_motion = true;
  session.go_to({0, asked.step});
  for (const auto& change : asked.changes) change(session);
  constexpr int kSettled = 4;
  for (int i = 0; i < kSettled; ++i) {
    ImGui::GetIO().MousePos = {asked.x - (i == 0 ? 1 : 0), asked.y};  // what lies still is told nothing
    const Status drawn =
        (*screen)->draw(session, {.size = asked.size, .scale = asked.scale, .seconds = 0.02});
    if (!drawn) throw std::runtime_error(drawn.error());
  }
  return (*screen)->read();
}

struct Mutation {
  const char* what;
  std::function<void(Asked&)> change;
  std::function<bool(const Asked&)> can_show = [](const Asked&) { return true; };
};

const std::vector<Mutation>& mutations() {
  static const std::vector<Mutation> kMutations = {
      {"the other step", [](Asked& a) { a.step = 1 - a.step, a.changes.clear(); }},
      {"a frame later",
       [](Asked& a) { a.changes.push_back([](LessonSession& c) { c.scrub_to(c.t_s() + 0.04); }); }},
      {"another panel",
       [](Asked& a) { a.changes.push_back([](LessonSession& c) { open(c, Panel::settings); }); }},
      {"the other theme",
       [](Asked& a) {
         a.changes.push_back([](LessonSession& c) {
           c.preferences.theme = c.preferences.theme == Theme::paper ? Theme::dark : Theme::paper;
         });
       }},
      {"larger text",
       [](Asked& a) { a.changes.push_back([](LessonSession& c) { c.change_text_scale(1); }); }},
      {"a camera turned by half a degree",
       [](Asked& a) {
         a.changes.push_back([](LessonSession& c) {
           CameraSpec camera = c.model()->scene.camera;
           camera.azimuth_rad += 0.5 * static_cast<double>(EIGEN_PI) / 180;
           c.set_camera(camera);
         });
       }},
      {"the pointer elsewhere", [](Asked& a) { a.x = a.y = -1; }, [](const Asked& a) { return a.x >= 0; }},
      {"another speed",
       [](Asked& a) { a.changes.push_back([](LessonSession& c) { c.set_speed(1.0 / 16); }); }},
  };
  return kMutations;
}

class GoldenWindow : public testing::TestWithParam<Row> {};

TEST_P(GoldenWindow, IsAsApproved) { expect_as_approved(GetParam().name, picture(GetParam().asked)); }

TEST_P(GoldenWindow, RefusesEveryMutation) {
  const Image approved = picture(GetParam().asked);
  for (const Mutation& mutation : mutations()) {
    if (!mutation.can_show(GetParam().asked)) continue;
    Asked asked = GetParam().asked;
    mutation.change(asked);
    EXPECT_FALSE(compare_images(approved, picture(asked)).equal()) << mutation.what;
  }
}

TEST_P(GoldenWindow, RepeatsToTheByte) {
  EXPECT_EQ(picture(GetParam().asked).rgba, picture(GetParam().asked).rgba);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenWindow, testing::ValuesIn(rows()), [](const auto& row) {
  std::string name = row.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace

std::vector<std::string> window_names() {
  std::vector<std::string> names;
  for (const Row& row : rows()) names.push_back(row.name);
  return names;
}

}  // namespace polhode::golden

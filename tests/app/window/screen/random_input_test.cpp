// SPDX-License-Identifier: MIT
// Whatever keyboard and mouse do in whatever order: the session stays one that could be reached by hand, what
// can be undone is undone, and the state files say what is so. Seeds are fixed. A few short sequences by
// default; POLHODE_RANDOM_INPUT=1000x200 makes a night of it, and 1000x200+400 goes on with it at the 401st.
#include "app/session/answers/progress.h"
#include "app/session/command.h"
#include "app/session/saved/saved_progress.h"
#include "tests/app/window/screen_harness.h"
#include "tests/base/files/folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>

namespace polhode {
namespace {

struct Amount {
  int sequences = 5, events = 40, done = 0;
};

Amount amount() {
  Amount wanted;
  if (const char* text = std::getenv("POLHODE_RANDOM_INPUT"))
    std::sscanf(text, "%dx%d+%d", &wanted.sequences, &wanted.events, &wanted.done);
  return wanted;
}

class Hand {
 public:
  explicit Hand(unsigned seed) : random_(seed) {}
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 random_;
};

std::vector<std::string> all_keys() {
  std::vector<std::string> keys;
  for (const CommandFacts& facts : all_commands()) {
    if (facts.command == Command::quit) continue;
    std::string_view rest = facts.keys;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(", "), rest.size());
      keys.emplace_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 2, rest.size()));
    }
  }
  for (const char* typed : {"A", "D", "1", "2", "3", "9", "Enter", "*", "W", "Backspace", "(", "/"})
    keys.emplace_back(typed);
  return keys;
}

class RandomInput : public ScreenTest {
 protected:
  void show(int count = 1) {
    for (int i = 0; i < count; ++i) {
      ImGuiIO& io = ImGui::GetIO();
      io.MousePos = {x, y};
      io.MouseDown[0] = down;
      const Status drawn = screen->draw(*played, {.size = size, .scale = 1, .seconds = 0.04});
      ASSERT_TRUE(drawn) << drawn.error() << told;
      io.MouseWheel = 0;
    }
  }

  void point(Hand& hand) {
    x = static_cast<float>(hand.below(size.width));
    y = static_cast<float>(hand.below(size.height));
  }

  void act(Hand& hand) {
    static const std::vector<std::string> kKeys = all_keys();
    switch (hand.below(8)) {
      case 0:
        point(hand);
        told += fmt::format(" click {:.0f},{:.0f};", x, y);
        show(2);
        down = true;
        show(2);
        down = false;
        show(2);
        break;
      case 1:
        point(hand);
        told += fmt::format(" drag {:.0f},{:.0f}", x, y);
        show(2);
        down = true;
        show(2);
        for (int i = 0; i < 3; ++i) {
          point(hand);
          told += fmt::format(" to {:.0f},{:.0f}", x, y);
          show();
        }
        down = false;
        told += ';';
        show(2);
        break;
      case 2:
        point(hand);
        ImGui::GetIO().MouseWheel = hand.below(2) == 0 ? 1.0F : -1.0F;
        told += fmt::format(" wheel {:.0f},{:.0f};", x, y);
        show();
        break;
      case 3:
        size = {640 + hand.below(700), 480 + hand.below(400)};
        told += fmt::format(" {}x{};", size.width, size.height);
        show();
        break;
      default: {
        const std::string& key = kKeys[static_cast<std::size_t>(hand.below(static_cast<int>(kKeys.size())))];
        told += ' ' + key + ';';
        const bool typing = ImGui::GetIO().WantTextInput;
        const bool is_done = hand.below(5) == 0 ? screen->press_from_afar(*played, key, false)
                                                : screen->press(*played, key, hand.below(9) == 0);
        if (typing && !is_done && key.size() == 1)
          ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(key[0]));
        show(1 + hand.below(3));
      }
    }
    screen->requests().quit = false;
    screen->requests().open_lesson.clear();
  }

  void expect_sound() {
    const LessonSession& now = *played;
    const auto& stages = now.lesson().stages;
    ASSERT_LT(now.place().stage, stages.size()) << told;
    ASSERT_LT(now.place().step, now.stage().steps.size()) << told;
    EXPECT_TRUE(now.visited().contains(now.stage().id)) << told;
    EXPECT_TRUE(std::isfinite(now.t_s())) << told;
    EXPECT_TRUE(now.speed() >= kSlowest && now.speed() <= kFastest) << told;
    EXPECT_TRUE(now.preferences.text_scale >= kLeastTextScale && now.preferences.text_scale <= kMostTextScale)
        << told;
    EXPECT_EQ(now.has_scene(), now.model() != nullptr) << told;
    EXPECT_TRUE(!now.is_black() || now.is_presenting()) << told;
    EXPECT_TRUE(!now.has_speaker() || now.is_presenting()) << told;
    EXPECT_TRUE(!now.is_frozen() || now.has_speaker()) << told;
    EXPECT_TRUE(!now.is_pointing() || now.is_presenting()) << told;
    EXPECT_FALSE(now.chosen_stages().empty()) << told;
    EXPECT_TRUE(now.counterexample() == nullptr || now.is_aside()) << told;
    EXPECT_LE(std::abs(now.t_s()), now.model() ? now.model()->reach_s : 0) << told;
    const std::vector<PlacedAsk> asked = questions_of(now.lesson());
    for (const auto& [name, record] : now.answers()) {
      EXPECT_NE(std::ranges::find(asked, name, &PlacedAsk::name), asked.end()) << told;
      EXPECT_LE(record.right, record.tries) << name << told;
    }
  }

  /// What is shown is what the edits say: another session that is given them shows the same.
  void expect_edits_are_shown() {
    if (!played->has_scene() || played->is_following()) return;
    LessonSession other(played->loaded_pointer());
    other.go_to(played->place());
    ASSERT_TRUE(other.set_edits(played->edits())) << told;
    other.light(played->lit());
    EXPECT_EQ(other.model()->scene, played->model()->scene) << told;
  }

  /// What is undone comes to an end, and made again it is what it was.
  void expect_undo_to_end() {
    played->leave_counterexample();
    const SceneEdits made = played->edits();
    int undone = 0;
    while (played->can_undo() && undone <= 100) {
      EXPECT_TRUE(played->undo()) << told;
      ++undone;
    }
    EXPECT_FALSE(played->can_undo()) << told;
    EXPECT_FALSE(played->undo()) << told;
    expect_edits_are_shown();
    for (; undone > 0; --undone) EXPECT_TRUE(played->redo()) << told;
    SceneEdits again = played->edits();
    again.camera = made.camera;  // one that was turned by hand stays
    EXPECT_EQ(again, made) << told;
    expect_edits_are_shown();
  }

  void expect_kept(const std::filesystem::path& folder) {
    LessonSession next(played->loaded_pointer());
    const SavedProgress progress(next, folder);
    EXPECT_EQ(progress.notice(), "") << told;
    EXPECT_EQ(next.place(), played->place()) << told;
    EXPECT_EQ(next.visited(), played->visited()) << told;
    EXPECT_EQ(next.preferences, played->preferences) << told;
    EXPECT_EQ(next.left_out(), played->left_out()) << told;
    ASSERT_EQ(next.answers().size(), played->answers().size()) << told;
    for (const auto& [name, record] : played->answers()) {
      const AnswerRecord& kept = next.answers().at(name);
      EXPECT_EQ(kept.tries, record.tries) << name << told;
      EXPECT_EQ(kept.hints, record.hints) << name << told;
      EXPECT_EQ(kept.right > 0, record.right > 0) << name << told;
      EXPECT_EQ(kept.last, record.last) << name << told;
    }
    EXPECT_FALSE(next.is_presenting() || next.has_speaker() || next.is_black()) << "before who comes next";
  }

  std::unique_ptr<LessonSession> played;
  Size size{800, 600};
  std::string told;  ///< what was done
};

TEST_F(RandomInput, LeavesASoundSession) {
  const Amount wanted = amount();
  for (int sequence = wanted.done; sequence < wanted.sequences; ++sequence) {
    const test::Folder state, saved;
    const char* id = test::kLessons[static_cast<std::size_t>(sequence) % std::size(test::kLessons)];
    Hand hand(static_cast<unsigned>(1000 + sequence));
    played = std::make_unique<LessonSession>(test::loaded_lesson(id));
    SavedProgress progress(*played, state.path());
    const auto stage = static_cast<std::size_t>(hand.below(static_cast<int>(played->lesson().stages.size())));
    played->go_to({stage, 0});
    screen->set_folder(saved.path().string());
    told = fmt::format("\nsequence {} of {}, stage {}:", sequence, id, stage + 1);
    size = {800, 600};
    down = false;
    show(3);
    for (int event = 0; event < wanted.events; ++event) {
      act(hand);
      expect_sound();
      ASSERT_EQ(progress.keep(*played), "") << told;
      if (HasFailure()) return;
    }
    expect_edits_are_shown();
    ASSERT_EQ(progress.keep_at_last(*played), "") << told;
    expect_kept(state.path());
    expect_undo_to_end();
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace polhode

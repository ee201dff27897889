// SPDX-License-Identifier: MIT
// Every key that `?` tells of, pressed for real, with each panel open, before an audience and in the
// speaker's window: it does its work, and none of another's. The window runs in the test's own process, so
// that what was done is read from the session instead of from pixels; a second thread is the hand.
#include "app/session/command.h"
#include "app/window/window.h"
#include "tests/app/session/example_lesson.h"
#include "tests/window/window_test.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <utility>

namespace polhode::window_test {
namespace {

/// Whatever a key may change, as text, by name.
using Seen = std::map<std::string, std::string>;
using Names = std::set<std::string>;

/// As xdotool calls them.
std::string key_of_hand(std::string name) {
  static const std::map<std::string, std::string> kNames = {
      {"PageDown", "Next"}, {"PageUp", "Prior"}, {"Space", "space"},    {"Enter", "Return"},
      {">", "greater"},     {"<", "less"},       {"]", "bracketright"}, {"[", "bracketleft"},
      {"}", "braceright"},  {"{", "braceleft"},  {"?", "question"},     {"+", "plus"},
      {"=", "equal"},       {"-", "minus"},      {".", "period"}};
  std::string before;
  for (const auto& [ours, of_hand] : {std::pair("Ctrl+", "ctrl+"), std::pair("Shift+", "shift+")})
    if (name.starts_with(ours)) {
      before = of_hand;
      name = name.substr(std::string(ours).size());
    }
  if (const auto found = kNames.find(name); found != kNames.end()) return before + found->second;
  if (name.size() == 1) name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  return before + name;
}

std::vector<std::string> keys_in(std::string_view list) {
  std::vector<std::string> keys;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(", "), list.size());
    keys.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 2, list.size()));
  }
  return keys;
}

/// What is open, and how it was opened.
struct Situation {
  std::string name;
  std::vector<std::string> opened_by;
  Panel panel = Panel::none;
  bool presents = false, in_speakers_window = false;
};

std::ostream& operator<<(std::ostream& out, const Situation& situation) { return out << situation.name; }

const std::vector<Situation> kSituations = {{"page", {}},
                                            {"outline", {"o"}, Panel::outline},
                                            {"body", {"b"}, Panel::body},
                                            {"method", {"m"}, Panel::method},
                                            {"show", {"s"}, Panel::show},
                                            {"question", {"q"}, Panel::question},
                                            {"save", {"e"}, Panel::save},
                                            {"settings", {"F2"}, Panel::settings},
                                            {"help", {"question"}, Panel::help},
                                            {"presenting", {"p"}, Panel::none, true},
                                            {"outline_presented", {"p", "o"}, Panel::outline, true},
                                            {"speaker", {"n"}, Panel::none, true, true}};

/// What moves in a panel that a key has opened. Beside questions the page has these.
bool is_of_panel(const Situation& situation, const std::string& key) {
  static const Names kKeys = {"Left", "Right",     "Up",     "Down",     "Space", "Enter",
                              "Tab",  "Shift+Tab", "PageUp", "PageDown", "Home",  "End"};
  const bool has_keys =
      situation.panel != Panel::none && situation.panel != Panel::question && !situation.in_speakers_window;
  const bool is_of_clicker = situation.presents && (key == "PageUp" || key == "PageDown");
  return has_keys && kKeys.contains(key) && !is_of_clicker;
}

/// What changes when a command has done its work, and what may change with it.
struct Work {
  Names does, may{};
  std::vector<std::string> before{};  ///< keys that give it something to do
};

const Names kWithPlace = {"t", "playing", "views", "ghost", "camera", "following", "numbers", "lit", "text"};

Work work_of(Command command, const Situation& situation) {
  using C = Command;
  const Names size_too = {"size", "text", "focus", "panel", "lit"};
  switch (command) {
    case C::next_step:
    case C::previous_step:
    case C::next_stage:
    case C::previous_stage:
    case C::first_stage:
    case C::last_stage:
      return {{"place"}, kWithPlace};
    case C::play_pause:
      return {{"playing"}, {"t", "text"}};
    case C::frame_forward:
    case C::frame_back:
    case C::reset_time:
    case C::start_of_time:
    case C::next_flip:
    case C::previous_flip:
      return {{"t"}, {"text"}};
    case C::faster:
    case C::slower:
      return {{"speed"}};
    case C::next_view:
      return {{"views"}, {"text"}};
    case C::turn_left:
    case C::turn_right:
    case C::turn_up:
    case C::turn_down:
    case C::nearer:
    case C::farther:
      return {{"camera"}};
    case C::follow:
      return {{"following"}, {"camera"}};
    case C::ghost:
      return {{"ghost"}, {"text"}};
    case C::larger_number:
    case C::smaller_number:
    case C::larger_second_number:
    case C::smaller_second_number:
    case C::reset_scene:
    case C::undo:
      return {{"numbers"}, {"t", "text", "playing", "camera"}};
    case C::next_symbol:
    case C::previous_symbol:
      return {{"lit"}, {"text"}};
    case C::explain:
      return {{"text"}, {}, {"Tab"}};
    case C::scroll_down:
      return {{"text"}, {}, {"k", "k", "k", "k"}};
    case C::scroll_up:
      return {{"text"}, {}, {"j", "j"}};
    case C::copy_step:
      return {{"copied"}};
    case C::read_aloud:
      return {{"spoken"}};
    case C::outline:
    case C::body:
    case C::method:
    case C::show:
    case C::question:
    case C::save:
    case C::settings:
    case C::help:
      return {{"panel"}, {"focus", "typing"}};
    case C::leave:
      if (situation.panel != Panel::none) return {{"panel"}, {"focus"}};
      if (situation.presents) return {{"presenting"}, {"speaker", "size", "text"}};
      return {{"lit"}, {"text"}, {"Tab"}};
    case C::switch_focus:
      return situation.panel == Panel::none ? Work{} : Work{{"focus"}, {"typing"}};
    case C::larger_text:
    case C::smaller_text:
      return {{"text size"}, {"text"}};
    case C::normal_text:
      return {{"text size"}, {"text"}, {"plus"}};
    case C::theme:
      return {{"theme"}, {"text"}};
    case C::full_screen:
      return {{"size"}, {"text"}};
    case C::present:
      return {{"presenting"}, {"speaker", "panel", "size", "text", "focus"}};
    case C::notes:
      if (!situation.presents) return {{"presenting", "speaker"}, {"panel", "size", "text", "focus"}};
      return {{"speaker"}, size_too};
    case C::black:
      return situation.presents ? Work{{"black"}, {"text"}} : Work{};
    case C::point:
      return situation.presents ? Work{{"spot"}} : Work{};
    case C::freeze:
      return situation.in_speakers_window ? Work{{"frozen"}} : Work{};
    case C::save_page:
      return {{"saved"}};
    case C::quit:
      break;
  }
  return {};
}

class Keys : public testing::TestWithParam<Situation> {
 protected:
  void SetUp() override {
    if (const std::string why = Display::why_not(); !why.empty()) GTEST_SKIP() << why;
    // Room for both windows, where there are two.
    display_ = std::make_unique<Display>(Size{GetParam().in_speakers_window ? 2600 : 1300, 820});
    std::ofstream(folder_ / "spd-say")
        << "#!/bin/sh\ncase \"$*\" in *--cancel*) ;; *) echo >> spoken;; esac\n";
    std::filesystem::permissions(folder_ / "spd-say", std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.path().string() + ':' + std::getenv("PATH")).c_str(), 1);
    setenv("DISPLAY", display_->name().c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_.path());
  }
  void TearDown() override {
    if (!before_.empty()) std::filesystem::current_path(before_);
  }

  /// On the window's thread, behind each frame.
  void look(const LessonSession& now) {
    const std::lock_guard guard(mutex_);
    ++frames_;
    if (wish_) std::exchange(wish_, nullptr)();
    Size size;
    GLFWwindow* window = glfwGetCurrentContext();
    glfwGetFramebufferSize(window, &size.width, &size.height);
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    const CameraSpec camera = now.camera();
    std::string numbers;
    for (const Variation& number : now.variations()) numbers += fmt::format("{} ", number.value);
    const char* copied = glfwGetClipboardString(window);
    seen_ = {
        {"place", fmt::format("{}.{}", now.place().stage, now.place().step)},
        {"panel", fmt::format("{}", static_cast<int>(now.panel))},
        {"t", fmt::format("{}", now.t_s())},
        {"playing", fmt::format("{}", now.is_playing())},
        {"speed", fmt::format("{}", now.speed())},
        {"text size", fmt::format("{}", now.preferences.text_scale)},
        {"theme", fmt::format("{}", static_cast<int>(now.preferences.theme))},
        {"presenting", fmt::format("{}", now.is_presenting())},
        {"speaker", fmt::format("{}", now.has_speaker())},
        {"black", fmt::format("{}", now.is_black())},
        {"frozen", fmt::format("{}", now.is_frozen())},
        {"spot", fmt::format("{}", now.is_pointing())},
        {"following", fmt::format("{}", now.is_following())},
        {"camera", fmt::format("{} {} {}", camera.azimuth_rad, camera.elevation_rad, camera.zoom)},
        {"numbers", numbers},
        {"views", now.model() ? fmt::format("{}", now.model()->scene.views.size() * 10 +
                                                      static_cast<std::size_t>(
                                                          now.model()->scene.views.front() == View::body))
                              : ""},
        {"ghost", now.model() ? fmt::format("{}", now.model()->scene.motion.ghost) : ""},
        {"lit", now.lit()},
        {"answers", fmt::format("{}", now.answers().size())},
        {"focus", imgui.NavWindow ? imgui.NavWindow->RootWindow->Name : ""},
        {"typing", fmt::format("{}", imgui.IO.WantTextInput)},
        {"size", fmt::format("{}x{}", size.width, size.height)},
        {"copied", copied ? copied : ""}};
  }

  int frames() {
    const std::lock_guard guard(mutex_);
    return frames_;
  }

  /// Waits until what was done is drawn, and nothing more is, or, where something moves, for a while.
  /// Whatever is done makes some frames; on a machine that is busy with other tests they are late.
  void settle() {
    using Clock = std::chrono::steady_clock;
    constexpr int kLeast = 4, kMany = 16;
    const int first = frames();
    const auto begin = Clock::now();
    ASSERT_TRUE(eventually([&] { return frames() >= first + kLeast; }));
    const auto quiet = std::chrono::milliseconds(60) + (Clock::now() - begin);
    int drawn = frames();
    auto since = Clock::now();
    while (drawn < first + kMany && Clock::now() - since < quiet) {
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
      if (const int now = frames(); now != drawn) {
        drawn = now;
        since = Clock::now();
      }
    }
  }

  Seen seen() {
    Seen now;
    {
      const std::lock_guard guard(mutex_);
      now = seen_;
    }
    std::error_code unknown;
    int saved = 0;
    for (const std::string& name : names_in(folder_.path())) saved += name.ends_with(".png") ? 1 : 0;
    now["saved"] = fmt::format("{}", saved);
    now["spoken"] = fmt::format("{}", std::filesystem::file_size(folder_ / "spoken", unknown));
    const Image picture = display_->picture();
    std::size_t text = 0;
    for (int y = 60; y < 700; ++y)
      for (int x = 30; x < 600; ++x)
        for (int i = 0; i < 3; ++i) text = text * 31 + picture.pixel(x, y)[i];
    now["text"] = fmt::format("{}", text);
    return now;
  }

  void press(const std::vector<std::string>& keys) {
    if (keys.empty()) return;
    std::vector<std::string> words = {"key", "--delay", "1"};
    words.insert(words.end(), keys.begin(), keys.end());
    display_->act(words);
    settle();
  }

  /// Which run() waits for.
  void quit() const { display_->act({"key", "ctrl+q"}); }

  /// Has it done behind a frame, and waits for it.
  void have_done(std::function<void()> wish) {
    {
      const std::lock_guard guard(mutex_);
      wish_ = std::move(wish);
    }
    bool is_open = true;
    while (is_open) {
      display_->act({"mousemove", "3", "3", "mousemove", "1", "1"});  // so that a frame is drawn
      settle();
      const std::lock_guard guard(mutex_);
      is_open = static_cast<bool>(wish_);
    }
    display_->act({"mousemove", "2", "2"});
    settle();
  }

  Place base_place() const { return GetParam().panel == Panel::question ? Place{1, 2} : Place{1, 1}; }

  /// In the middle of the lesson and of the time, with something changed by hand.
  void begin_anew() {
    const Situation& situation = GetParam();
    have_done([this] {
      session_.set_presenting(false);
      session_.panel = Panel::none;
      session_.go_to({0, 0});  // no symbol has the focus any more
      session_.forget_answer(*blocks_of<Ask>(session_.lesson().stages[1].steps[2]).front());
      session_.preferences = {};
      session_.preferences.reduced_motion = true;
      session_.set_speed(1);
    });
    have_done([this] {
      session_.go_to(base_place());
      session_.set_playing(false);
      session_.reset_edits();
      session_.begin_change();
      ASSERT_TRUE(session_.vary(0, 0.05));
      session_.scrub_to(22);
      glfwSetClipboardString(glfwGetCurrentContext(), "");
    });
    focus(" — stage ");
    press(situation.opened_by);
    if (situation.in_speakers_window) focus("speaker");
    const std::string panel = fmt::format("{}", static_cast<int>(situation.panel));
    ASSERT_TRUE(eventually([&] {
      const Seen now = seen();
      return now.at("panel") == panel && now.at("presenting") == fmt::format("{}", situation.presents);
    }));
  }

  std::optional<unsigned> window_called(const std::string& words) const {
    for (const unsigned window : display_->windows_of(getpid()))
      if (display_->title_of(window).find(words) != std::string::npos) return window;
    return std::nullopt;
  }

  void focus(const std::string& title) {
    ASSERT_TRUE(eventually([&] { return window_called(title).has_value(); })) << title;
    display_->act(
        {"windowfocus", std::to_string(*window_called(title)), "mousemove", "1", "1", "mousemove", "2", "2"});
    settle();
  }

  void expect_works(const CommandFacts& facts, const std::string& key) {
    const Situation& situation = GetParam();
    Work work = work_of(facts.command, situation);
    if (is_of_panel(situation, key)) work = {{}, {"focus", "typing"}};
    // Beside the question its letters answer it; before an audience B is a black screen.
    if (situation.panel == Panel::question && key == "B") work = {{"answers"}, {"text"}};
    if (situation.presents && situation.panel == Panel::none && key == "B") work = {{"black"}, {"text"}};
    if (situation.presents && key == "B") work = {{"black"}, {"text"}};
    press(work.before);
    const Seen before = seen();
    press({key_of_hand(key)});
    Seen after = seen();
    for (int i = 0; i < 100 && std::ranges::any_of(
                                   work.does, [&](auto& name) { return before.at(name) == after.at(name); });
         ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      after = seen();
    }
    Names changed;
    for (const auto& [name, value] : after)
      if (before.at(name) != value) changed.insert(name);
    for (const std::string& name : work.does)
      EXPECT_TRUE(changed.contains(name)) << key << " (" << facts.does << ") has to change " << name;
    for (const std::string& name : changed)
      EXPECT_TRUE(work.does.contains(name) || work.may.contains(name))
          << key << " (" << facts.does << ") changes " << name << ": " << before.at(name) << " -> "
          << after.at(name);
    ++pressed_;
    if (!changed.empty() || !work.before.empty()) begin_anew();
  }

  /// The window, until the hand has closed it.
  void run(const std::function<void()>& hand) {
    WindowOptions options;
    options.keep = [this](const LessonSession& now) {
      look(now);
      return std::string();
    };
    std::thread other([&] {
      try {
        if (eventually([&] { return frames() > 0 && window_called(" — stage ").has_value(); })) hand();
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
      if (const auto window = window_called(" — stage ")) display_->ask_to_close(*window);
    });
    const Result<WindowEnd> end = run_window(session_, fonts_, options);
    other.join();
    ASSERT_TRUE(end) << end.error();
    EXPECT_EQ(end->kind, WindowEnd::Kind::closed);
  }

  const Fonts fonts_ = Fonts::open().value();
  LessonSession session_{test::loaded_text(text_of(test::source_dir() / "tests/data/window/keys.md"))};
  int pressed_ = 0;

 private:
  ScratchFolder folder_;
  std::filesystem::path before_;
  std::unique_ptr<Display> display_;
  std::mutex mutex_;
  int frames_ = 0;
  Seen seen_;
  std::function<void()> wish_;
};

TEST_P(Keys, EachDoesItsWorkAndNoOther) {
  run([this] {
    begin_anew();
    for (const CommandFacts& facts : all_commands())
      for (const std::string& key : keys_in(facts.keys))
        if (facts.command != Command::quit) expect_works(facts, key);
    EXPECT_GT(pressed_, 60);
    quit();
  });
}

INSTANTIATE_TEST_SUITE_P(With, Keys, testing::ValuesIn(kSituations),
                         [](const auto& situation) { return situation.param.name; });

}  // namespace
}  // namespace polhode::window_test

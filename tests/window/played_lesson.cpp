// SPDX-License-Identifier: MIT
#include "tests/window/played_lesson.h"

#include "tests/support/paths.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace polhode::window_test {

namespace {

/// What POLHODE_FRAME_LOG tells: a line "t cpu_ms moving full" for each picture.
struct FrameLog {
  int frames = 0;
  bool at_rest = false;  ///< the last one was of full quality, with nothing moving
};

FrameLog frame_log(const std::filesystem::path& path) {
  const std::string text = text_of(path);
  const std::size_t end = text.rfind('\n');  // what follows is half written
  if (end == std::string::npos) return {};
  const std::size_t begin = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  std::istringstream line(text.substr(begin == std::string::npos ? 0 : begin + 1, end));
  double t_s = 0, cpu_ms = 0;
  int moving = 1, full = 0;
  line >> t_s >> cpu_ms >> moving >> full;
  return {static_cast<int>(std::count(text.begin(), text.end(), '\n')), full == 1 && moving == 0};
}

std::vector<std::string> move_words(Point point) {
  return {"mousemove", std::to_string(point.x), std::to_string(point.y)};
}

template <class... More>
std::vector<std::string> joined(std::vector<std::string> words, const More&... more) {
  (words.insert(words.end(), more.begin(), more.end()), ...);
  return words;
}

using Words = std::vector<std::string>;

}  // namespace

TitlePlace place_in(const std::string& title) {
  const std::size_t begin = title.rfind(" — stage ");
  if (begin == std::string::npos) return {};
  TitlePlace place{.stage_title = title.substr(0, begin)};
  int read = 0;
  std::sscanf(title.c_str() + begin, " — stage %d of %d, step %d of %d — polhode%n", &place.stage,
              &place.stages, &place.step, &place.steps, &read);
  return begin + static_cast<std::size_t>(read) == title.size() ? place : TitlePlace{};
}

Start start_of_play(const Display& display, const Home& home, const std::vector<std::string>& arguments,
                    const Environment& environment) {
  Environment all = {{"DISPLAY", display.name()},
                     {"WAYLAND_DISPLAY", std::nullopt},
                     {"HOME", home.folder.path().string()},
                     {"XDG_STATE_HOME", (home.folder / "state").string()},
                     {"XDG_PICTURES_DIR", std::nullopt},
                     {"XDG_RUNTIME_DIR", std::nullopt},  // the desktop's wishes are not the test's
                     {"DBUS_SESSION_BUS_ADDRESS", std::nullopt},
                     {"POLHODE_LESSONS", test::source_dir() / "lessons"},
                     {"POLHODE_FRAME_LOG", (home.folder / "frames").string()}};
  for (const auto& [name, value] : environment) all[name] = value;
  return {joined(Words{test::program(), "play"}, arguments), all, home.folder.path(), home.folder / "out",
          home.folder / "err"};
}

PlayedLesson::PlayedLesson(const Display& display, const Home& home, const Words& arguments,
                           const Environment& environment)
    : display_(display),
      err_(home.folder / "err"),
      frame_log_(home.folder / "frames"),
      process_((std::filesystem::remove(home.folder / "frames"),
                start_of_play(display, home, arguments, environment))) {
  const bool shown = eventually([&] {
    if (process_.code()) throw std::runtime_error("polhode play has ended: " + said());
    window_ = display.window_of(process_.id()).value_or(0);
    return window_ != 0 && place().stage != 0;
  });
  if (!shown) throw std::runtime_error("polhode play shows no window: " + said());
  display_.act({"windowfocus", std::to_string(window_), "mousemove", "1", "1"});  // where nothing is
  picture_at_rest();
}

void PlayedLesson::press(const Words& keys) {
  if (!keys.empty()) display_.act(joined({"key", "--delay", "1"}, keys));
}

void PlayedLesson::type(const std::string& text) { display_.act({"type", "--delay", "1", "--", text}); }

void PlayedLesson::move_to(Point point) { display_.act(move_words(point)); }

void PlayedLesson::click(Point point) {
  display_.act(joined(move_words(point), Words{"mousedown", "1", "mouseup", "1"}));
}

void PlayedLesson::turn_wheel(Point point, int notches) {
  const std::string button = notches > 0 ? "4" : "5";
  display_.act(
      joined(move_words(point), Words{"click", "--repeat", std::to_string(std::abs(notches)), button}));
}

void PlayedLesson::drag(const std::vector<Point>& points) {
  Words words = joined(move_words(points.front()), Words{"mousedown", "1"});
  for (const Point& point : points) words = joined(words, move_words(point));
  display_.act(joined(words, Words{"mouseup", "1"}));
}

bool PlayedLesson::comes_to(int stage, int step) const {
  return eventually([&] {
    const TitlePlace now = place();
    return now.stage == stage && now.step == step;
  });
}

bool PlayedLesson::comes_to_stage(int stage) const {
  return eventually([&] { return place().stage == stage; });
}

Image PlayedLesson::picture_at_rest() const {
  constexpr auto kQuiet = std::chrono::milliseconds(250);
  int seen = 0;
  auto since = std::chrono::steady_clock::now();
  const bool rests = eventually([&] {
    const FrameLog log = frame_log(frame_log_);
    const auto now = std::chrono::steady_clock::now();
    if (log.frames != seen || !log.at_rest) since = now;
    seen = log.frames;
    return log.at_rest && now - since > kQuiet;
  });
  if (!rests) throw std::runtime_error("the picture does not come to rest");
  return picture();
}

bool PlayedLesson::changes_from(const Image& before, std::chrono::milliseconds patience) const {
  return eventually([&] { return picture().rgba != before.rgba; }, patience);
}

int PlayedLesson::frames() const { return frame_log(frame_log_).frames; }

double changed_part(const Image& a, const Image& b, Point from, Point to) {
  int changed = 0;
  for (int y = from.y; y < to.y; ++y)
    for (int x = from.x; x < to.x; ++x) {
      const std::uint8_t *p = a.pixel(x, y), *q = b.pixel(x, y);
      changed +=
          std::max({std::abs(p[0] - q[0]), std::abs(p[1] - q[1]), std::abs(p[2] - q[2])}) > kGoldenLevels;
    }
  return double(changed) / ((to.x - from.x) * (to.y - from.y));
}

}  // namespace polhode::window_test

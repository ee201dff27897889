// SPDX-License-Identifier: MIT
// The live page of the whole lecture, from its first figure to its last, in a real browser: by keys, by
// pointer, on a telephone, and each picture beside the one that is drawn here. Skipped where ./web was not
// run. It takes minutes.
#include "app/web/live_figure.h"
#include "render/image/compare.h"
#include "render/image/png.h"
#include "tests/app/publish/browser.h"
#include "tests/app/publish/live/alike.h"
#include "tests/app/publish/live/web_folder.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>

namespace polhode {
namespace {

using testing::IsEmpty;
using Json = nlohmann::json;
namespace fs = std::filesystem;

// Not large: software draws.
constexpr Size kWindow{560, 640}, kPhone{360, 740};
constexpr const char* kLesson = "euler-equations";

class LiveLecture : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_web_program()) GTEST_SKIP() << "the program for pages is not built: ./web";
    browser_ = Browser::start(kWindow.width, kWindow.height, Browser::Graphics::webgl);
    if (!browser_) GTEST_SKIP() << "no Chromium is installed";
  }

  static fs::path lesson() { return test::source_dir() / "lessons" / (std::string(kLesson) + ".md"); }
  /// Written once for all tests.
  static fs::path page() {
    static const ScratchFolder kFolder;
    const fs::path file = kFolder / "lecture.html";
    if (fs::exists(file)) return file;
    RunOptions options;
    options.environment["POLHODE_WEB"] = web_folder().string();
    // A busy machine takes longer than the two minutes that a program has in tests.
    options.wrapper = {"env", "--ignore-signal=ALRM"};
    const ProgramRun run =
        polhode({"export", lesson().string(), "--live", "--reader", file.string()}, options);
    EXPECT_EQ(run.code, 0) << run.err;
    return file;
  }

  Json value_of(const std::string& expression) { return browser_->value_of(expression); }
  bool is(const std::string& expression) { return value_of("Boolean(" + expression + ")") == true; }
  /// Within a minute: a busy machine draws slowly.
  bool comes(const std::string& expression) {
    constexpr int kTries = 12;  // of five seconds each
    for (int i = 0; i < kTries; ++i)
      if (browser_->wait_for("Boolean(" + expression + ")", true) == true) return true;
    return false;
  }
  void open_page() {
    browser_->open(page());
    value_of(
        "window.F = [...document.querySelectorAll('figure[data-stage]')], window.P = () => "
        "polhodeLive.View.present.program, window.PRESS = F.map(f => f.querySelector('.live-press')), 0");
    count_ = value_of("F.length");
    ASSERT_GT(count_, 200);
  }
  static std::string figure(int i) { return fmt::format("F[{}]", i); }
  std::string name(int i) {
    return value_of(fmt::format("F[{0}].dataset.stage + '/' + F[{0}].dataset.step", i)).get<std::string>();
  }
  /// As by a script; one that is not in view is not drawn.
  void press_first() {
    brought_to_the_middle("PRESS[0]");
    value_of("PRESS[0].click(), 0");
    ASSERT_TRUE(is_alive(0)) << why(0);
    value_of("P().call('set_playing', 0), 0");
  }
  bool is_alive(int i) {
    return comes(
        fmt::format("F[{0}].classList.contains('is-live') && polhodeLive.View.present.words?.alt && "
                    "P().state()?.stage_id === F[{0}].dataset.stage && P().state().step === "
                    "Number(F[{0}].dataset.step)",
                    i));
  }
  std::string why(int i) { return value_of(figure(i) + ".querySelector('.live-why').textContent"); }
  /// The middle of an element that stands in the middle of the window: x, y, width and height.
  std::array<double, 4> brought_to_the_middle(const std::string& element) {
    return value_of(
        "(async () => { const e = " + element +
        "; for (let k = 0; k < 2; ++k) { e.scrollIntoView({ block: 'center', behavior: 'instant' }); await "
        "new Promise(done => setTimeout(done, 30)); } const b = e.getBoundingClientRect(); return [b.left + "
        "b.width / 2, b.top + b.height / 2, b.width, b.height]; })()");
  }
  /// The ways a figure is turned, and what it starts from: what a hand changes.
  Json held() { return value_of("(s => [s.camera, s.omega0])(P().state())"); }
  /// Not of a diagram, which is flat.
  bool can_be_turned() { return value_of("P().state().in_space") == true; }
  std::string button(int i, const std::string& words) {
    return fmt::format("[...F[{}].querySelectorAll('.live-panel button')].find(b => b.textContent === '{}')",
                       i, words);
  }

  std::unique_ptr<Browser> browser_;
  int count_ = 0;
};

TEST_F(LiveLecture, EachFigureComesAliveByKeysAndLetsThemGo) {
  open_page();
  for (int i = 0; i < count_; ++i) {
    SCOPED_TRACE(name(i));
    // From the button of the figure before.
    constexpr int kMostTabs = 200;
    const std::string at_it = fmt::format("document.activeElement === PRESS[{}]", i);
    for (int tabs = 0; tabs < kMostTabs && !is(at_it); ++tabs) browser_->press("Tab");
    ASSERT_TRUE(is(at_it)) << "Tab does not come to it";
    browser_->press("Enter");
    ASSERT_TRUE(is_alive(i)) << why(i);
    const Json playing = value_of("P().state().playing");
    browser_->press(" ");
    EXPECT_NE(value_of("P().state().playing"), playing) << "Space plays and pauses";
    value_of("P().call('set_playing', 0), 0");
    const Json before = held();
    browser_->press("ArrowRight");
    EXPECT_EQ(held() != before, can_be_turned()) << "an arrow turns it";
    constexpr int kMostWithin = 60;
    const std::string within = figure(i) + ".contains(document.activeElement)";
    for (int tabs = 0; tabs < kMostWithin && is(within); ++tabs) browser_->press("Tab");
    EXPECT_FALSE(is(within)) << "Tab gets out";
    value_of("polhodeLive.View.present.box.focus({ preventScroll: true }), 0");
    browser_->press("Escape");
    EXPECT_TRUE(is("!document.querySelector('canvas') && " + at_it)) << "Escape gives the picture back";
  }
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

TEST_F(LiveLecture, EachFigureComesAliveByPointer) {
  open_page();
  for (int i = 0; i < count_; ++i) {
    SCOPED_TRACE(name(i));
    const auto press = brought_to_the_middle(fmt::format("PRESS[{}]", i));
    browser_->click(press[0], press[1]);
    ASSERT_TRUE(is_alive(i)) << why(i);
    value_of("P().call('set_playing', 0), 0");
    const auto canvas = brought_to_the_middle("polhodeLive.View.present.canvas");
    const Json before = held();
    // Above, where no plot is.
    const Vec2 from(canvas[0] - 0.3 * canvas[2], canvas[1] - 0.35 * canvas[3]);
    browser_->drag(from, from + Vec2(60, -20));
    EXPECT_EQ(held() != before, can_be_turned()) << "a drag moves it";
    const auto close = brought_to_the_middle(button(i, "Picture"));
    browser_->click(close[0], close[1]);
    EXPECT_EQ(browser_->wait_for("document.querySelectorAll('canvas').length", 0), 0);
  }
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

TEST_F(LiveLecture, EachFigureComesAliveUnderFingersOnATelephone) {
  browser_->become_phone(kPhone.width, kPhone.height);
  open_page();
  for (int i = 0; i < count_; ++i) {
    SCOPED_TRACE(name(i));
    const auto press = brought_to_the_middle(fmt::format("PRESS[{}]", i));
    browser_->tap(press[0], press[1]);
    ASSERT_TRUE(is_alive(i)) << why(i);
    EXPECT_LE(value_of("document.documentElement.scrollWidth").get<int>(), kPhone.width);
    value_of("P().call('set_playing', 0), 0");
    const auto canvas = brought_to_the_middle("polhodeLive.View.present.canvas");
    const Json before = held();
    browser_->swipe(canvas[0] - 0.3 * canvas[2], canvas[0] - 0.1 * canvas[2], canvas[1] - 0.35 * canvas[3]);
    EXPECT_EQ(held() != before, can_be_turned()) << "a finger moves it";
    const Json zoom = value_of("P().state().camera.zoom");
    browser_->spread(Vec2(canvas[0], canvas[1]), 140, 80);
    EXPECT_EQ(value_of("P().state().camera.zoom") != zoom, can_be_turned()) << "two fingers make it smaller";
    const auto close = brought_to_the_middle(button(i, "Picture"));
    browser_->tap(close[0], close[1]);
    EXPECT_EQ(browser_->wait_for("document.querySelectorAll('canvas').length", 0), 0);
  }
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

// As large as the pictures of the page, which are packed with loss and so no measure.
TEST_F(LiveLecture, EachFigureIsDrawnAsHere) {
  open_page();
  press_first();
  LiveFigure native;
  native.begin_call();
  ASSERT_TRUE(native.open_lesson(text_of(lesson()), "lecture.md"));
  auto context = open_context(ContextKind::any);
  ASSERT_TRUE(context);
  ASSERT_TRUE(native.attach(std::move(context).value()));
  for (int i = 0; i < count_; ++i) {
    SCOPED_TRACE(name(i));
    const Json drawn = value_of(fmt::format(
        "(() => {{ const f = F[{}], img = f.querySelector('img'), p = P(), c = "
        "polhodeLive.View.present.canvas; p.call('show_stage', f.dataset.stage, Number(f.dataset.step)); "
        "p.call('reset'); c.width = Number(img.getAttribute('width')); c.height = p.call('height_for', "
        "c.width); const done = p.call('draw', c.width, c.height, 0, 1); return [f.dataset.stage, "
        "Number(f.dataset.step), done ? c.toDataURL() : p.message()]; }})()",
        i));
    const std::string png = Browser::data_in(drawn[2]);
    const auto got = decode_png({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
    ASSERT_TRUE(got) << drawn[2].get<std::string>().substr(0, 200);
    native.begin_call();
    ASSERT_TRUE(native.show(drawn[0].get<std::string>(), drawn[1].get<std::size_t>()));
    ASSERT_TRUE(native.reset());
    ASSERT_TRUE(native.draw(got->image.size, LiveFigure::Picture::figure, 1));
    const auto wanted = native.read();
    ASSERT_TRUE(wanted);
    EXPECT_GE(ssim(*wanted, got->image), 0.98);
    EXPECT_GE(overlap(*wanted, got->image), 0.99);
  }
}

// npm's axe-core, one script, which is no part of Debian.
TEST_F(LiveLecture, AxeFindsNothing) {
  const char* axe = std::getenv("POLHODE_AXE");
  if (!axe || !*axe) GTEST_SKIP() << "POLHODE_AXE does not name axe.min.js of npm's axe-core";
  for (const char* theme : {"light", "dark"}) {
    browser_->prefer(theme);
    open_page();
    press_first();
    value_of(
        "document.querySelectorAll('.live-panel details').forEach(d => { "
        "d.open = true; }), 0");
    value_of(text_of(axe) + "\n;0");
    EXPECT_THAT(value_of("axe.run(document, { resultTypes: ['violations'] }).then(r => r.violations.map(v => "
                         "v.id + ': ' + v.nodes.slice(0, 5).map(n => n.html.slice(0, 200)).join(' | ')))"),
                IsEmpty())
        << theme;
  }
}

}  // namespace
}  // namespace polhode

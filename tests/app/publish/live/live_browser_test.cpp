// SPDX-License-Identifier: MIT
// Pages whose figures move, in a real browser with WebGL2 drawn by its own software. Skipped where ./web was
// not run.
#include "app/session/camera_moves.h"
#include "app/session/scene_edits.h"
#include "tests/app/publish/browser.h"
#include "tests/app/publish/live/web_folder.h"
#include "tests/app/publish/text_edition/example_edition.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace polhode {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kView = "polhodeLive.View.present";

class LiveInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_web_program()) GTEST_SKIP() << "the program for pages is not built: ./web";
    browser_ = Browser::start(1280, 800, Browser::Graphics::webgl);
    if (!browser_) GTEST_SKIP() << "no Chromium is installed";
  }

  /// Written once for all tests.
  static fs::path page(const std::string& name, const std::vector<std::string>& what,
                       const std::string& lesson = kEditionLesson) {
    static const ScratchFolder kFolder;
    const fs::path file = kFolder / (name + ".html");
    if (fs::exists(file)) return file;
    write_text(kFolder / "edition.md", lesson);
    RunOptions options;
    options.folder = kFolder.path();
    options.environment["POLHODE_WEB"] = web_folder().string();
    std::vector<std::string> words = {"export"};
    words.insert(words.end(), what.begin(), what.end());
    words.push_back(file.string());
    const ProgramRun run = polhode(words, options);
    EXPECT_EQ(run.code, 0) << run.err;
    return file;
  }
  static fs::path reader_page() { return page("reader", {"./edition.md", "--live", "--reader"}); }
  static fs::path sandbox_page() { return page("sandbox", {"--sandbox"}); }
  static fs::path deck_page() {
    return page("deck", {"./edition.md", "--live", "--size", "960x540", "--deck"});
  }

  Json value_of(const std::string& expression) { return browser_->value_of(expression); }
  Json state() { return value_of(std::string(kView) + ".program.state()"); }
  void call(const std::string& words) {
    value_of(std::string(kView) + ".program.call(" + words + "), " + kView + ".touch(), 0");
  }
  /// Waits until the picture is there.
  void wait_for_picture() {
    constexpr int kTries = 10;  // of five seconds each: a busy machine compiles shaders slowly
    const char* const there = "Boolean(polhodeLive.View.present?.words?.alt)";
    for (int i = 1; i < kTries && browser_->wait_for(there, true) != true; ++i) continue;
    ASSERT_EQ(value_of(there), true) << value_of(
        "document.body.innerText.match(/stays a picture[^.]*/)?.[0] ?? 'no word of why'");
  }
  void press_first() {
    value_of("document.querySelector('.live-press').click(), 0");
    wait_for_picture();
    call("'set_playing', 0");
  }
  /// px of the page, of a place of the picture.
  Vec2 on_page(double x, double y) {
    const Json box = value_of(
        "(() => { const c = document.querySelector('canvas'), b = c.getBoundingClientRect(); return [b.left, "
        "b.top, "
        "b.width / c.width, b.height / c.height]; })()");
    return {box[0].get<double>() + x * box[2].get<double>(), box[1].get<double>() + y * box[3].get<double>()};
  }
  void bring_into_view() {
    value_of("document.querySelector('canvas').scrollIntoView({ block: 'center', behavior: 'instant' }), 0");
  }

  std::unique_ptr<Browser> browser_;
};

TEST_F(LiveInBrowser, SpeaksTheLanguageOfItsLesson) {
  std::string lesson = kEditionLesson;
  lesson.replace(lesson.find("\"en\""), 4, "\"de\"");
  browser_->open(page("german", {"./edition.md", "--live", "--reader"}, lesson));
  EXPECT_EQ(value_of("document.querySelector('.live-press').ariaLabel"),
            "Live: Abbildung abspielen, drehen, neu beginnen");
  press_first();
  EXPECT_THAT(value_of("document.querySelector('.live-panel').innerText").get<std::string>(),
              AllOf(HasSubstr("Link kopieren"), HasSubstr("Neu beginnen"), Not(HasSubstr("undefined"))));
  EXPECT_THAT(value_of("document.querySelector('.live-time .live-value').innerText").get<std::string>(),
              testing::MatchesRegex("[0-9]+(,[0-9]+)? s"));
}

TEST_F(LiveInBrowser, AFigureIsAPictureUntilItIsPressed) {
  browser_->open(reader_page());
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 0);
  EXPECT_EQ(value_of("document.querySelectorAll('.live-press').length"), 2);
  press_first();
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 1);
  EXPECT_EQ(value_of("getComputedStyle(document.querySelector('figure img')).display"), "none");
  EXPECT_THAT(value_of("document.querySelector('canvas').getAttribute('aria-label')").get<std::string>(),
              HasSubstr("the energy ellipsoid"));
  // One canvas for all.
  value_of("document.querySelectorAll('.live-press')[1].click(), 0");
  EXPECT_EQ(browser_->wait_for("document.querySelectorAll('figure.is-live').length === 1 && "
                               "document.querySelectorAll('figure')[1].classList.contains('is-live')",
                               true),
            true);
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 1);
  EXPECT_NE(value_of("getComputedStyle(document.querySelector('figure img')).display"), "none");
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

// The motion after a drag is that which `polhode trace` has from the same start.
TEST_F(LiveInBrowser, ADragOfOmegaStartsThatVeryMotion) {
  browser_->open(reader_page());
  press_first();
  bring_into_view();
  call("'set_time', 0");
  value_of(std::string(kView) +
           ".program.call('draw', document.querySelector('canvas').width, "
           "document.querySelector('canvas').height, 0, 1)");
  const Json before = state();
  ASSERT_EQ(before["tips"].size(), 1U);
  const Vec2 tip = on_page(before["tips"][0]["x"], before["tips"][0]["y"]);
  browser_->drag(tip, tip + Vec2(35, 25));
  const Json dragged = state();
  ASSERT_NE(dragged["omega0"], before["omega0"]);
  EXPECT_EQ(dragged["t"], 0);
  call("'set_time', 7.25");
  const Json after = state();
  const auto list = [](const Json& numbers) {
    return fmt::format("{}", fmt::join(numbers.get<std::vector<double>>(), ","));
  };
  const ProgramRun run = polhode({"trace", "--inertia", list(after["moments"]), "--omega",
                                  list(after["omega0"]), "--times", "7.25", "--columns", "w1,w2,w3"});
  ASSERT_EQ(run.code, 0) << run.err;
  std::istringstream rows(run.out.substr(run.out.find('\n') + 1));
  double scale = 0;
  for (const double w : after["omega0"]) scale = std::hypot(scale, w);
  for (int i = 0; i < 3; ++i) {
    double wanted = NAN;
    char comma = 0;
    rows >> wanted >> comma;
    // C ≤ 4 of tests/physics over some five turns: 4 (1 + |ω| t) 2^-52 ≈ 2e-14, well within what is promised.
    EXPECT_NEAR(after["omega"][static_cast<std::size_t>(i)].get<double>(), wanted, 1e-12 * scale) << i;
  }
}

TEST_F(LiveInBrowser, ADragBesideItTurnsTheCameraAsTheWindowDoes) {
  browser_->open(reader_page());
  press_first();
  bring_into_view();
  const Json before = state();
  const double height = value_of("document.querySelector('canvas').getBoundingClientRect().height");
  const double width = value_of("document.querySelector('canvas').getBoundingClientRect().width");
  const Vec2 from = on_page(0, 0) + Vec2(0.06 * width, 0.9 * height), by(90, -40);
  browser_->drag(from, from + by);
  const Json after = state();
  CameraSpec camera;
  camera.azimuth_rad = before["camera"]["azimuth"];
  camera.elevation_rad = before["camera"]["elevation"];
  const CameraSpec wanted = orbited(camera, by.x(), by.y(), height);
  // Each of the moves of a drag is rounded to what a lesson can state, 1e-4 degrees.
  const double rounded = Browser::kMovesOfADrag * 1e-4 * 3.14159265 / 180;
  EXPECT_NEAR(
      std::remainder(after["camera"]["azimuth"].get<double>() - wanted.azimuth_rad, 2 * 3.141592653589793), 0,
      rounded);
  EXPECT_NEAR(after["camera"]["elevation"].get<double>(), wanted.elevation_rad, rounded);
  EXPECT_EQ(after["omega0"], before["omega0"]);
}

// What a caption says is the lesson's motion, not of another; but where it stood, at the end of a page,
// nothing moves.
TEST_F(LiveInBrowser, AFigureStaysUnderTheHandWhenItsCaptionGoes) {
  std::string lesson = kEditionLesson;
  const std::size_t begin = lesson.find("caption = '"), end = lesson.find('\n', begin);
  lesson.replace(
      begin, end - begin,
      "caption = 'It turns about an axis that turns too, and this is said in two lines of words that stand "
      "below the picture'");
  browser_->open(page("caption", {"./edition.md", "--live", "--reader"}, lesson));
  press_first();
  value_of("scrollTo({ top: document.body.scrollHeight, behavior: 'instant' }), 0");
  const std::string top = "document.querySelector('canvas').getBoundingClientRect().top";
  const std::string caption = "getComputedStyle(document.querySelector('figcaption')).visibility";
  EXPECT_EQ(value_of(caption), "visible");
  const Json before = value_of(top);
  call("'set_omega', 0.5, 1, 2");
  EXPECT_EQ(browser_->wait_for(caption, "hidden"), "hidden");
  EXPECT_EQ(value_of(top), before);
}

TEST_F(LiveInBrowser, KeysTurnPlayAndClose) {
  browser_->open(reader_page());
  press_first();
  value_of("document.querySelector('.live-view').focus(), 0");
  const Json before = state();
  browser_->press("ArrowRight");
  EXPECT_NE(state()["camera"]["azimuth"], before["camera"]["azimuth"]);
  browser_->press(" ");
  EXPECT_EQ(state()["playing"], true);
  browser_->press(" ");
  EXPECT_EQ(state()["playing"], false);
  browser_->press("Escape");
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 0);
  EXPECT_NE(value_of("getComputedStyle(document.querySelector('figure img')).display"), "none");
}

// What cannot be turned is not offered to be, and no key changes it unseen.
TEST_F(LiveInBrowser, ADiagramIsFlat) {
  std::string lesson = kEditionLesson;
  const std::string shown = R"(["energy-ellipsoid", "omega"])";
  lesson.replace(lesson.find(shown), shown.size(), R"(["tensor-bars"])");
  browser_->open(page("diagram", {"./edition.md", "--live", "--reader"}, lesson));
  press_first();
  ASSERT_EQ(state()["in_space"], false);
  const std::string turns =
      "[...document.querySelectorAll('.live-panel button')].filter(b => "
      "/Turn|Nearer|Farther/.test(b.ariaLabel)).length";
  EXPECT_EQ(value_of(turns), 0);
  EXPECT_EQ(value_of("document.querySelector('.live-view').ariaLabel"), "Live figure. Space plays.");
  value_of("document.querySelector('.live-view').focus(), 0");
  browser_->press("ArrowRight");
  EXPECT_EQ(state()["changed"], false);
  browser_->press(" ");
  EXPECT_EQ(state()["playing"], true);
  value_of("document.querySelectorAll('.live-press')[1].click(), 0");
  EXPECT_EQ(browser_->wait_for("document.querySelectorAll('figure')[1].classList.contains('is-live')", true),
            true);
  EXPECT_EQ(value_of(turns), 6);
  EXPECT_THAT(value_of("document.querySelector('.live-view').ariaLabel").get<std::string>(),
              HasSubstr("Arrow keys turn it"));
}

TEST_F(LiveInBrowser, ALinkIsAScenario) {
  const fs::path page = reader_page();
  browser_->open(page, "#moves/step.1?t=1.375&omega=0.5,-1.25,2&I=1,2,2.5");
  wait_for_picture();
  const Json opened = state();
  EXPECT_EQ(opened["t"], 1.375);
  EXPECT_EQ(opened["omega0"], Json({0.5, -1.25, 2}));
  EXPECT_EQ(opened["moments"], Json({1, 2, 2.5}));
  EXPECT_EQ(opened["playing"], false);
  call("'set_time', 2.0625");
  EXPECT_EQ(browser_->wait_for(
                "location.hash.includes('t=2.0625') && location.hash.includes('omega=0.5,-1.25,2')", true),
            true);
  // What cannot be is said, and the rest is there.
  browser_->open(page, "#moves/step.1?t=1&I=1,1,9");
  wait_for_picture();
  EXPECT_EQ(state()["t"], 1);
  EXPECT_THAT(value_of("document.querySelector('.live-note').textContent").get<std::string>(),
              Not(IsEmpty()));
}

TEST_F(LiveInBrowser, WithoutWebGL2ThePictureStaysAndThePageSaysWhy) {
  browser_->open(reader_page());
  value_of("HTMLCanvasElement.prototype.getContext = () => null, 0");
  value_of("document.querySelector('.live-press').click(), 0");
  EXPECT_EQ(browser_->wait_for(
                "/stays a picture: .*WebGL2/.test(document.querySelector('.live-why').textContent)", true),
            true);
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 0);
  EXPECT_NE(value_of("getComputedStyle(document.querySelector('figure img')).display"), "none");
}

TEST_F(LiveInBrowser, AContextThatIsLostGivesThePictureBackAndCanBePressedAgain) {
  browser_->open(reader_page());
  press_first();
  value_of(
      "document.querySelector('canvas').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()"
      ", 0");
  EXPECT_EQ(browser_->wait_for(
                "/taken the graphics away/.test(document.querySelector('.live-why').textContent)", true),
            true);
  EXPECT_NE(value_of("getComputedStyle(document.querySelector('figure img')).display"), "none");
  value_of("polhodeLive.View.present.words = null, document.querySelector('.live-press').click(), 0");
  wait_for_picture();
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 1);
}

TEST_F(LiveInBrowser, WithoutScriptThereArePicturesAndAWord) {
  const fs::path reader = reader_page();
  browser_->forbid_scripts();
  browser_->open(reader);
  EXPECT_EQ(value_of("document.querySelectorAll('figure img').length"), 2);
  EXPECT_EQ(value_of("document.querySelectorAll('canvas, .live-press').length"), 0);
  EXPECT_THAT(value_of("document.body.innerText").get<std::string>(),
              HasSubstr("The figures are pictures here"));
  browser_->open(sandbox_page());
  EXPECT_EQ(value_of("document.querySelector('figure img').naturalWidth > 0"), true);
  EXPECT_THAT(value_of("document.body.innerText").get<std::string>(), HasSubstr("This is a picture"));
}

// The figure takes the slide's place; what is done in it is not done to the deck.
TEST_F(LiveInBrowser, ASlideIsPlayedWhereItStands) {
  const std::string place = "document.getElementById('place').textContent";
  browser_->open(deck_page());
  EXPECT_EQ(browser_->wait_for(place, "1 / 3"), "1 / 3");
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 0);
  press_first();
  const Json box = value_of(
      "(() => { const c = document.querySelector('canvas'), b = c.getBoundingClientRect(); return [c.width / "
      "c.height, b.width / b.height, b.bottom <= "
      "document.querySelector('.live-panel').getBoundingClientRect().top, "
      "document.querySelector('.live-panel').getBoundingClientRect().bottom <= "
      "document.getElementById('bar').getBoundingClientRect().top + 1]; })()");
  EXPECT_NEAR(box[0].get<double>() / box[1].get<double>(), 1, 0.01);
  EXPECT_EQ(box[2], true) << "the figure lies above what can be done";
  EXPECT_EQ(box[3], true) << "and that above the bar";
  const Json before = state();
  browser_->press("ArrowRight");
  EXPECT_NE(state()["camera"]["azimuth"], before["camera"]["azimuth"]);
  browser_->press(" ");
  EXPECT_EQ(state()["playing"], true);
  browser_->press(" ");
  ASSERT_EQ(state()["tips"].size(), 1U);
  const Json still = state();
  const Vec2 tip = on_page(still["tips"][0]["x"], still["tips"][0]["y"]);
  browser_->drag(tip, tip + Vec2(20, 15));
  EXPECT_NE(state()["omega0"], still["omega0"]);
  EXPECT_EQ(value_of(place), "1 / 3") << "neither keys nor hand went on";
  browser_->press("PageDown");
  EXPECT_EQ(browser_->wait_for(place, "2 / 3"), "2 / 3");
  browser_->press("PageUp");
  EXPECT_EQ(browser_->wait_for(place, "1 / 3"), "1 / 3");
  EXPECT_EQ(value_of("document.querySelector('canvas').checkVisibility()"), true) << "it is where it was";
  value_of("document.querySelector('.live-view').focus(), 0");
  browser_->press("Escape");
  EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 0);
  EXPECT_EQ(value_of("document.querySelector('.slide.current img').checkVisibility()"), true);
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

TEST_F(LiveInBrowser, ALinkToASlideIsAScenario) {
  browser_->open(deck_page(), "#02-asked-step1?t=1.5&omega=0.5,-1.25,2");
  wait_for_picture();
  EXPECT_EQ(state()["stage_id"], "asked");
  EXPECT_EQ(state()["t"], 1.5);
  EXPECT_EQ(state()["omega0"], Json({0.5, -1.25, 2}));
  EXPECT_EQ(value_of("document.querySelector('.slide.current').id"), "02-asked-step1");
  EXPECT_EQ(value_of("location.hash.startsWith('#02-asked-step1?t=1.5')"), true);
}

TEST_F(LiveInBrowser, ASlideThatCannotBePlayedStaysAndSaysWhy) {
  browser_->open(deck_page());
  EXPECT_EQ(browser_->wait_for("document.getElementById('place').textContent", "1 / 3"), "1 / 3");
  value_of("HTMLCanvasElement.prototype.getContext = () => null, 0");
  value_of("document.querySelector('.live-press').click(), 0");
  EXPECT_EQ(browser_->wait_for(
                "/stays a picture: .*WebGL2/.test(document.querySelector('.live-why').textContent)", true),
            true);
  EXPECT_EQ(value_of("document.querySelector('.live-why').checkVisibility()"), true);
  EXPECT_EQ(value_of("document.querySelector('.slide.current img').checkVisibility()"), true);
  browser_->forbid_scripts();
  browser_->open(deck_page());
  EXPECT_THAT(value_of("document.body.innerText").get<std::string>(),
              HasSubstr("The figures are pictures here"));
}

// All pages have the program in one file beside them, which a page may run, though it may not read it.
TEST_F(LiveInBrowser, PagesOfASiteShareTheProgram) {
  const fs::path site = page("site", {"./edition.md", "--live", "--with", "html", "--site"});
  for (const char* name : {"edition.html", "edition-slides.html"}) {
    browser_->open(site / name);
    press_first();
    EXPECT_EQ(value_of("document.querySelectorAll('canvas').length"), 1) << name;
  }
  browser_->open(site / "sandbox.html");
  wait_for_picture();
  EXPECT_THAT(browser_->complaints(), IsEmpty());
  const ScratchFolder alone;
  fs::copy(site / "edition.html", alone / "edition.html");
  browser_->open(alone / "edition.html");
  value_of("document.querySelector('.live-press').click(), 0");
  EXPECT_EQ(browser_->wait_for("/stays a picture: .*does not lie beside this page/.test("
                               "document.querySelector('.live-why').textContent)",
                               true),
            true);
}

TEST_F(LiveInBrowser, TheSandboxThrowsComputesAndIsShared) {
  const fs::path page = sandbox_page();
  browser_->open(page);
  wait_for_picture();
  EXPECT_EQ(browser_->wait_for(std::string(kView) + ".program.state().t > 0.7", true), true) << "it plays";
  EXPECT_EQ(browser_->wait_for("document.querySelectorAll('.trade tbody tr').length", 6), 6);
  // Explicit Euler does not come as far as is compared, and is not called right.
  EXPECT_EQ(value_of("[...document.querySelectorAll('.trade tbody tr')].filter(r => "
                     "r.cells[2].textContent === '0°').map(r => r.cells[0].textContent)"),
            Json({"exact"}));
  EXPECT_EQ(value_of("[...document.querySelectorAll('.trade tbody tr')].filter(r => "
                     "r.cells[2].textContent === 'breaks down').map(r => r.cells[1].textContent)"),
            Json({"–"}));
  value_of("document.querySelector('input[value=book]').click(), 0");
  EXPECT_EQ(state()["body"], "book");
  call("'set_playing', 0");
  // A coarse method: the error is told, and the exact body is beside it.
  value_of(
      "(() => { const s = document.querySelector('#throw\\\\.method input'); s.value = 0; "
      "s.dispatchEvent(new "
      "Event('input')); })()");
  EXPECT_EQ(state()["method"]["name"], "explicit-euler");
  call("'set_time', 3");
  EXPECT_GT(state()["error"]["attitude"], 0.01);
  EXPECT_EQ(browser_->wait_for("document.querySelectorAll('.trade tbody tr').length", 6), 6);
  for (const int width : {320, 360, 800, 1280}) {
    browser_->resize(width, 740);
    EXPECT_LE(value_of("document.documentElement.scrollWidth").get<int>(), width);
  }
  ASSERT_EQ(browser_->wait_for(
                "location.hash.includes('method=explicit-euler') && location.hash.includes('t=3')", true),
            true);
  const Json shared = state();
  const std::string link = value_of("location.hash");
  browser_->open(page, link);
  wait_for_picture();
  const Json opened = state();
  for (const char* name : {"body", "omega0", "moments", "t"}) EXPECT_EQ(opened[name], shared[name]) << name;
  EXPECT_EQ(opened["method"]["step"], shared["method"]["step"]);
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

// Who has taken ω by the hand shares the body as it lies then, too: beside the invariable plane L stays down,
// and the attitude follows from it; one that is stated goes with the link.
TEST_F(LiveInBrowser, ALinkAfterADragOpensThatAttitude) {
  const fs::path page = sandbox_page();
  browser_->open(page);
  wait_for_picture();
  call("'set_playing', 0");
  call("'set_time', 0");
  bring_into_view();
  ASSERT_GE(state()["tips"].size(), 1U);
  const Json before = state();
  const Vec2 tip = on_page(before["tips"][0]["x"], before["tips"][0]["y"]);
  browser_->drag(tip, tip + Vec2(40, 30));
  const Json dragged = state();
  ASSERT_NE(dragged["omega0"], before["omega0"]);
  ASSERT_TRUE(dragged["attitude0"].is_null()) << "L stays down";
  ASSERT_EQ(browser_->wait_for("location.hash.includes('omega=')", true), true);
  const std::string link = value_of("location.hash");
  const auto expect_opened = [&](const std::string& hash, const Json& quaternion) {
    browser_->open(page, hash);
    wait_for_picture();
    const Json opened = state();
    EXPECT_EQ(opened["omega0"], dragged["omega0"]);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(opened["quaternion"][i].get<double>(), quaternion[i].get<double>(), 1e-12) << i;
  };
  expect_opened(link, dragged["quaternion"]);
  expect_opened(link + "&q=0.8,0.6,0,0", Json({0.8, 0.6, 0, 0}));
}

// npm's axe-core, one script, which is no part of Debian.
TEST_F(LiveInBrowser, AxeFindsNothing) {
  const char* axe = std::getenv("POLHODE_AXE");
  if (!axe || !*axe) GTEST_SKIP() << "POLHODE_AXE does not name axe.min.js of npm's axe-core";
  const std::string script = text_of(axe);
  const auto violations = [&] {
    value_of(script + "\n;0");
    return value_of(
        "axe.run(document, { resultTypes: ['violations'] }).then(r => r.violations.map(v => v.id + ': ' + "
        "v.nodes.map(n => n.html.slice(0, 200)).join(' | ')))");
  };
  browser_->open(reader_page());
  press_first();
  value_of("document.querySelectorAll('.live-panel details').forEach(d => { d.open = true; }), 0");
  EXPECT_THAT(violations(), IsEmpty());
  browser_->open(deck_page());
  press_first();
  value_of("document.querySelectorAll('.live-panel details').forEach(d => { d.open = true; }), 0");
  EXPECT_THAT(violations(), IsEmpty());
  for (const char* theme : {"light", "dark"}) {
    browser_->prefer(theme);
    browser_->open(sandbox_page());
    wait_for_picture();
    EXPECT_EQ(browser_->wait_for("document.querySelectorAll('.trade tbody tr').length", 6), 6);
    EXPECT_THAT(violations(), IsEmpty()) << theme;
  }
}

}  // namespace
}  // namespace polhode

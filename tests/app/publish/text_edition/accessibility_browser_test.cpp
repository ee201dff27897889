// SPDX-License-Identifier: MIT
// Pages to read, the index of a site and slides for people who do not see well, or have no mouse: by the
// rules of WCAG 2.2 A and AA as axe-core holds pages to them, by colours measured one by one, and by real
// keys. axe-core is a package of npm; ./check puts it into build/npm where there is an npm.
#include "tests/app/publish/browser.h"
#include "tests/app/publish/firefox.h"
#include "tests/app/publish/text_edition/example_edition.h"
#include "tests/support/paths.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polhode {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/// Empty: it is not there.
std::string axe_core() {
  const fs::path file = test::source_dir() / "build/npm/node_modules/axe-core/axe.min.js";
  return fs::exists(file) ? text_of(file) : "";
}

/// Signs are text too: axe leaves those that are no letters undecided unless it is told so.
constexpr const char* kRunAxe = R"js((async () => {
  axe.configure({checks: [{id: "color-contrast", options: {ignoreUnicode: false, ignoreLength: true, ignorePseudo: false,
    boldValue: 700, boldTextPt: 14, largeTextPt: 18, pseudoSizeThreshold: 0.25, shadowOutlineEmMax: 0.2,
    textStrokeEmMin: 0.03, contrastRatio: {normal: {expected: 4.5}, large: {expected: 3}}}}]});
  const found = await axe.run(document, {resultTypes: ["violations", "incomplete"], runOnly: {type: "tag",
    values: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22a", "wcag22aa"]}});
  const told = (rule) => [rule.id, rule.nodes.length, rule.nodes[0].html.slice(0, 200)];
  const contrasts = found.incomplete.filter((rule) => rule.id === "color-contrast").length;
  return {contrasts, passes: found.passes.length, violations: found.violations.map(told),
    undecided: found.incomplete.filter((rule) => rule.id !== "color-contrast").map(told)};
})())js";

/// What axe cannot decide of contrasts, where letters overlap, scroll away or are struck out: for each text
/// its colour and that of the nearest ground. Nothing on the page lies over something else, and none is
/// translucent.
constexpr const char* kContrasts = R"js((() => {
  const rgb = (css) => { const v = css.match(/[\d.]+/g).map(Number); return v.length < 4 ? [...v, 1] : v; };
  const light = ([r, g, b]) => {
    const part = (c) => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    return 0.2126 * part(r) + 0.7152 * part(g) + 0.0722 * part(b);
  };
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const low = [];
  let count = 0, least = 21;
  for (let text; (text = texts.nextNode());) {
    const of = text.parentElement;
    if (!text.data.trim() || of.closest("script, style, annotation, option")) continue;
    const style = getComputedStyle(of);
    if (style.display === "none" || style.visibility !== "visible") continue;
    let ground = null, plain = true;
    for (let at = of; at; at = at.parentElement) {
      const around = getComputedStyle(at), own = rgb(around.backgroundColor);
      if (around.opacity !== "1" || around.filter !== "none" || around.mixBlendMode !== "normal") plain = false;
      if (!ground && own[3] > 0) { ground = own; plain &&= own[3] === 1; }
    }
    const ink = rgb(style.color), a = light(ink), b = ground ? light(ground) : a;
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05), px = parseFloat(style.fontSize);
    const needed = px >= 24 || (px >= 18.66 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
    ++count;
    least = Math.min(least, contrast);
    if (!plain || ink[3] !== 1 || contrast < needed) low.push([of.outerHTML.slice(0, 100), contrast]);
  }
  return {count, least, low};
})())js";

struct Mode {
  const char* scheme;
  int width;  ///< 320 px are 400 % of 1280
};
constexpr std::array<Mode, 4> kModes = {{{"light", 1280}, {"dark", 1280}, {"light", 320}, {"dark", 320}}};

/// @param is_plain whether all colours of the page lie on plain ground
void expect_accessible(Browser& browser, const fs::path& page, const std::string& axe, bool is_plain = true) {
  for (const Mode& mode : kModes) {
    SCOPED_TRACE(fmt::format("{} {} {}", page.filename().string(), mode.scheme, mode.width));
    browser.resize(mode.width, 900);
    browser.prefer(mode.scheme);
    browser.open(page);
    EXPECT_LE(browser.value_of("document.documentElement.scrollWidth").get<int>(), mode.width);
    if (is_plain) {
      EXPECT_EQ(browser.value_of(kContrasts)["low"], Json::array());
    }
    if (axe.empty()) continue;
    browser.value_of(axe + "; true");
    const Json found = browser.value_of(kRunAxe);
    EXPECT_GE(found["passes"].get<int>(), 10);
    EXPECT_EQ(found["violations"], Json::array());
    EXPECT_EQ(found["undecided"], Json::array());
    EXPECT_TRUE(is_plain || found["contrasts"] == 0);
  }
}

/// Elements of formulas that have not as many parts as they need.
constexpr const char* kWrongCounts = R"js(
  [...document.querySelectorAll("mfrac, mroot, msub, msup, munder, mover, msubsup, munderover")]
    .filter((part) => part.children.length !== (/subsup|underover/.test(part.localName) ? 3 : 2)).length)js";

/// Screen readers say of each formula what the lesson says of it.
template <class AnyBrowser>
void expect_spoken(AnyBrowser& browser, const fs::path& page) {
  browser.open(page);
  browser.value_of("document.querySelectorAll('details').forEach((part) => { part.open = true; })");
  const auto words =
      browser.value_of("[...document.getElementsByTagName('math')].map((m) => m.getAttribute('alttext'))")
          .template get<std::vector<std::string>>();
  EXPECT_GT(words.size(), 100u);
  EXPECT_EQ(browser.names_of_formulas(), words) << page;
  EXPECT_EQ(browser.value_of(kWrongCounts), 0);
  EXPECT_THAT(browser.complaints(), testing::IsEmpty());
}

fs::path made(const fs::path& lesson, const char* option, const fs::path& file) {
  const ProgramRun run = polhode({"export", lesson.string(), option, file.string(), "--quality", "draft"});
  EXPECT_EQ(run.code, 0) << run.err;
  return file;
}

class AccessibleInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    browser_ = Browser::start(1280, 900);
    if (!browser_) GTEST_SKIP() << "no Chromium is installed";
    write_text(folder_ / "edition.md", kEditionLesson);
  }
  /// Called last: what has been measured without it stands.
  void say_if_without(const std::string& axe) {
    if (axe.empty() && !HasFailure())
      GTEST_SKIP() << "axe-core is not installed: colours alone were measured";
  }

  ScratchFolder folder_;
  std::unique_ptr<Browser> browser_;
};

TEST_F(AccessibleInBrowser, PagesToReadAndTheirIndexAndSlides) {
  const std::string axe = axe_core();
  const fs::path lesson = folder_ / "edition.md";
  expect_accessible(*browser_, made(lesson, "--reader", folder_ / "page.html"), axe);
  expect_accessible(*browser_, made(lesson, "--site", folder_ / "site") / "index.html", axe);
  expect_accessible(*browser_, made(lesson, "--deck", folder_ / "deck.html"), axe, false);
  say_if_without(axe);
}

// ---- Keys

/// Each thing that the keyboard comes to, a group of radio buttons once.
constexpr const char* kStops = R"js((() => {
  const groups = new Set();
  return [...document.querySelectorAll("a[href], button, input, select, summary, [tabindex='0']")].filter((part) => {
    if (!part.checkVisibility() || part.disabled) return false;
    if (part.type !== "radio") return true;
    return !groups.has(part.name) && groups.add(part.name);
  }).length;
})())js";

/// Which stop it is; null: none. What has the focus has a frame, and is in sight once the page has scrolled.
constexpr const char* kStop = R"js((async () => {
  const part = document.activeElement;
  if (!part || part === document.body || part === document.documentElement) return null;
  window.stops ||= new Map();
  const key = part.type === "radio" ? part.name : part;
  if (!window.stops.has(key)) window.stops.set(key, window.stops.size);
  let place = part.getBoundingClientRect();
  const is_in_sight = () => place.bottom > 0 && place.top < innerHeight && place.height > 0;
  for (let i = 0; i < 1000 && !is_in_sight(); ++i) {  // a busy machine scrolls slowly
    await new Promise((go_on) => setTimeout(go_on, 20));
    place = part.getBoundingClientRect();
  }
  const style = getComputedStyle(part);
  const seen = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2 && is_in_sight();
  return {stop: window.stops.get(key), seen, html: part.outerHTML.slice(0, 120)};
})())js";

template <class AnyBrowser>
void expect_keyboard(AnyBrowser& browser, const fs::path& page) {
  browser.open(page);
  const int wanted = browser.value_of(kStops).template get<int>();
  ASSERT_GT(wanted, 5);
  int count = 0, looked_at = 0;
  for (;; ++count) {
    browser.press("Tab");
    const Json at = browser.value_of(kStop);
    if (at.is_null() || at["stop"] < count) break;  // behind the last: the browser itself, or the first again
    EXPECT_EQ(at["stop"], count) << at["html"];
    EXPECT_EQ(at["seen"], true) << at["html"];
    ASSERT_LE(count, wanted) << at["html"];
    if (count % 16 != 1) continue;
    ++looked_at;
    const std::string with = browser.screenshot();
    browser.value_of("window.held = document.activeElement, held.blur()");
    bool is_framed = false;  // once a busy machine has painted the page again
    for (int i = 0; i < 20 && !is_framed; ++i) is_framed = browser.screenshot() != with;
    EXPECT_TRUE(is_framed) << at["html"];
    browser.value_of("held.focus({preventScroll: true})");
  }
  EXPECT_EQ(count, wanted);
  EXPECT_GE(looked_at, 1);
  browser.press("Shift+Tab");  // and back, from wherever that is
  EXPECT_FALSE(browser.value_of(kStop).is_null());
}

TEST_F(AccessibleInBrowser, TheKeyboardComesEverywhereInChromium) {
  browser_->resize(1280, 900);
  expect_keyboard(*browser_, made(folder_ / "edition.md", "--reader", folder_ / "page.html"));
  browser_->resize(320, 740);
  expect_keyboard(*browser_, folder_ / "page.html");
}

TEST_F(AccessibleInBrowser, TheKeyboardComesEverywhereInFirefox) {
  const auto firefox = Firefox::start(1280, 900);
  if (!firefox) GTEST_SKIP() << "no Firefox is installed";
  expect_keyboard(*firefox, made(folder_ / "edition.md", "--reader", folder_ / "page.html"));
  firefox->resize(320, 740);
  expect_keyboard(*firefox, folder_ / "page.html");
}

// ---- Whole lessons

class EveryLesson : public AccessibleInBrowser, public testing::WithParamInterface<const char*> {
 protected:
  fs::path page() const {
    const fs::path lesson = test::source_dir() / "lessons" / (std::string(GetParam()) + ".md");
    return made(lesson, "--reader", folder_ / "page.html");
  }
};

TEST_P(EveryLesson, IsAccessibleAndSpoken) {
  const std::string axe = axe_core();
  const fs::path page = this->page();
  expect_accessible(*browser_, page, axe);
  expect_spoken(*browser_, page);
  if (const auto firefox = Firefox::start(1280, 900)) expect_spoken(*firefox, page);
  say_if_without(axe);
}

TEST_P(EveryLesson, IsReachedByTheKeyboard) {
  const fs::path page = this->page();
  browser_->resize(1280, 900);
  expect_keyboard(*browser_, page);
  if (const auto firefox = Firefox::start(1280, 900)) expect_keyboard(*firefox, page);
}

INSTANTIATE_TEST_SUITE_P(Lessons, EveryLesson,
                         testing::Values("symmetric-top", "heavy-top", "numerical-lab", "intermediate-axis",
                                         "intermediate-axis.de", "euler-equations"),
                         [](const auto& lesson) {
                           std::string name = lesson.param;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace polhode

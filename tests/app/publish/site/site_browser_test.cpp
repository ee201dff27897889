// SPDX-License-Identifier: MIT
// The index of a site in a real browser: how it fits, and what its search finds.
#include "tests/app/publish/browser.h"
#include "tests/app/publish/text_edition/example_edition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using testing::IsEmpty;
using Json = nlohmann::json;

class SiteInBrowser : public testing::Test {
 protected:
  void SetUp() override {
    browser_ = Browser::start(360, 740);
    if (!browser_) GTEST_SKIP() << "no Chromium is installed";
    write_text(folder_ / "edition.md", kEditionLesson);
    const ProgramRun run =
        polhode({"export", (folder_ / "edition.md").string(), "--site", (folder_ / "site").string()});
    ASSERT_EQ(run.code, 0) << run.err;
    browser_->open(folder_ / "site" / "index.html");
  }
  Json value_of(const std::string& expression) { return browser_->value_of(expression); }
  /// Where the entries lead that are seen when this is typed.
  Json found(const std::string& typed) {
    return value_of(
        "(() => { const field = document.getElementById('sought'); field.value = " + Json(typed).dump() +
        "; field.dispatchEvent(new Event('input')); return [...document.querySelectorAll("
        "'#all a')].filter((a) => a.checkVisibility()).map((a) => a.getAttribute('href')); })()");
  }
  ScratchFolder folder_;
  std::unique_ptr<Browser> browser_;
};

TEST_F(SiteInBrowser, FitsAndComplainsOfNothing) {
  for (const int width : {320, 360, 768, 1280, 3840}) {
    browser_->resize(width, 740);
    EXPECT_LE(value_of("document.documentElement.scrollWidth").get<int>(), width);
  }
  EXPECT_EQ(value_of("[...document.images].every(image => image.complete && image.naturalWidth > 0)"), true);
  EXPECT_THAT(browser_->complaints(), IsEmpty());
}

// 29 November 2026: only a mouse could scroll what is wider than a phone.
TEST_F(SiteInBrowser, TheKeyboardScrollsWhatIsWider) {
  value_of(
      "(() => { const long = document.createElement('span'), inside = document.createElement('span'); "
      "long.className = 'long'; inside.textContent = 'x'; inside.style.display = 'inline-block'; "
      "inside.style.width = '900px'; long.append(inside); document.querySelector('main').append(long); "
      "return true; })()");
  found("");
  EXPECT_EQ(value_of("document.querySelector('main > .long:last-child').tabIndex"), 0);
  EXPECT_EQ(value_of("document.querySelector('main > .long:last-child').getAttribute('role')"), "group");
}

TEST_F(SiteInBrowser, FindsHeadingsAndEquations) {
  EXPECT_EQ(found("d over d t ANGULAR"), Json::array());
  EXPECT_EQ(found("Equation (5)"), Json::array({"edition.html#moves/law"}));
  EXPECT_EQ(found("first STEP"), Json::array({"edition.html#moves/step.1"}));
  EXPECT_EQ(value_of("document.getElementById('found').innerText"), "1 place");
  EXPECT_EQ(found("no such words"), Json::array());
  EXPECT_EQ(value_of("document.getElementById('found').innerText"), "Nothing found.");
  EXPECT_EQ(value_of("getComputedStyle(document.getElementById('lessons')).display"), "none");
  found("");
  EXPECT_NE(value_of("getComputedStyle(document.getElementById('lessons')).display"), "none");
}

TEST_F(SiteInBrowser, FindsEquationsAsTheyAreTyped) {
  for (const char* typed : {"dL/dt", "dl/dt = n", "dL/dt=N", "=N"})
    EXPECT_EQ(found(typed), Json::array({"edition.html#moves/law"})) << typed;
  EXPECT_EQ(found("dN/dt"), Json::array());
}

TEST_F(SiteInBrowser, EnterGoesToTheFirstThatIsFound) {
  found("questions");
  value_of("document.getElementById('sought').focus()");
  value_of("document.getElementById('search').requestSubmit()");
  EXPECT_EQ(value_of("document.activeElement.getAttribute('href')"), "edition.html#asked");
}

}  // namespace
}  // namespace polhode

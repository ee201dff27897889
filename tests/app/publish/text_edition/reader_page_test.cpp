// SPDX-License-Identifier: MIT
// The text edition, as `polhode export --reader` writes it.
#include "app/narration/speech_text.h"
#include "app/narration/verdict_row.h"
#include "app/publish/html_text.h"
#include "app/publish/text_edition/lesson_html.h"
#include "lessons/reader/checks/lesson_check.h"
#include "tests/app/publish/example_deck.h"
#include "tests/app/publish/text_edition/example_edition.h"
#include "tests/support/paths.h"
#include "tests/support/xml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <regex>
#include <set>
#include <utility>

namespace polhode {
namespace {

using test::all_named;
using test::for_each_node;
using test::XmlNode;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
namespace fs = std::filesystem;

/// What the program makes of the lesson above, or of another text.
class Edition {
 public:
  explicit Edition(const std::string& lesson = kEditionLesson, const std::vector<std::string>& more = {}) {
    write_text(folder_ / "edition.md", lesson);
    std::vector<std::string> words = {"export", (folder_ / "edition.md").string(), "--reader",
                                      (folder_ / "page.html").string()};
    words.insert(words.end(), more.begin(), more.end());
    run = polhode(words);
    EXPECT_EQ(run.code, 0) << run.err;
    html = text_of(folder_ / "page.html");
    EXPECT_NO_THROW(root = test::read_xml(html));
  }

  ProgramRun run;
  std::string html;
  XmlNode root;

 private:
  ScratchFolder folder_;
};

const Edition& edition() {
  static const Edition kEdition;
  return kEdition;
}

/// With one blank where there are several, and none at the ends; apostrophes as they are typed.
std::string one_line(std::string_view set) {
  const std::string text = std::regex_replace(std::string(set), std::regex("\u2019"), "'");
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_nbsp = std::string_view(text).substr(i).starts_with("\u00A0");
    if (is_nbsp) ++i;
    if (!is_nbsp && text[i] != ' ' && text[i] != '\n')
      line += text[i];
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

/// What a page says: texts, and formulas in their words.
void add_words(const XmlNode& node, std::string& words) {
  static const std::set<std::string> kBlocks = {"p",  "li", "td",         "th",     "div",
                                                "h1", "h2", "h3",         "tr",     "ol",
                                                "ul", "br", "figcaption", "option", "summary"};
  if (node.name == "script" || node.name == "style") return;
  if (node.name == "math") {
    words += node.attribute("alttext");
    return;
  }
  words += node.text;
  for (const XmlNode& child : node.children) add_words(child, words);
  if (kBlocks.contains(node.name)) words += '\n';
}

std::string words_of(const XmlNode& root) {
  std::string words;
  add_words(root, words);
  return one_line(words);
}

const XmlNode* with_id(const XmlNode& root, const std::string& id) {
  const XmlNode* found = nullptr;
  for_each_node(root, [&](const XmlNode& node) {
    if (node.attribute("id") != id) return;
    EXPECT_EQ(found, nullptr) << "twice: " << id;
    found = &node;
  });
  EXPECT_NE(found, nullptr) << id;
  return found;
}

/// Says what of the lesson a page does not say.
class LostWords {
 public:
  LostWords(const Lesson& lesson, const XmlNode& root) : speech_(lesson), page_(words_of(root)) {
    for (const Stage& stage : lesson.stages) {
      expect(stage.title_text);
      for (const Step& step : stage.steps) {
        expect(step.title);
        for (const Block& block : step.blocks) std::visit([&](const auto& b) { look_at(b, step); }, block);
      }
    }
    for (const Reference& reference : lesson.references)
      if (reference.is_cited) expect(reference.text);
  }

  const std::vector<std::string>& lost() const { return lost_; }
  std::size_t looked_for() const { return looked_for_; }

 private:
  void expect(const std::string& text) {
    const std::string wanted = one_line(text);
    if (wanted.empty()) return;
    ++looked_for_;
    if (page_.find(wanted) == std::string::npos) lost_.push_back(wanted);
  }
  void expect(const std::vector<TextSpan>& spans) {
    std::string text;
    for (const TextSpan& span : spans) {
      const bool is_number = span.kind == TextSpan::Kind::math && span.text.starts_with("\\eqref");
      text += span.kind == TextSpan::Kind::text ? span.text
              : is_number                       ? ""
                                                : speech_.words_in_line(span.math, text);
      if (is_number) {  // the words of a reference are its number, as those before and behind are
        expect(text);
        text.clear();
      }
      if (span.break_after) text += ' ';
    }
    expect(text);
  }
  void expect(const RichText& text) {
    for (const TextBlock& block : text) {
      expect(block.spans);
      for (const auto& row : block.table.rows)
        for (const TextTable::Cell& cell : row) expect(cell);
    }
  }

  void look_at(const Prose& prose, const Step&) { expect(prose.text); }
  void look_at(const Callout& callout, const Step&) {
    expect(callout.title);
    expect(callout.text);
  }
  void look_at(const Footnote& note, const Step&) { expect(note.text); }
  void look_at(const Equation& equation, const Step&) {
    expect(speech_.words(equation.math));
    if (!equation.tag.empty()) expect('(' + equation.tag + ')');
  }
  void look_at(const Claim& claim, const Step& step) {
    expect(verdict_row(claim, step.scene.get(), nullptr, Language::en).word);
  }
  void look_at(const Ask& ask, const Step&) {
    expect(ask.prompt_text);
    for (const auto* texts : {&ask.choice_texts, &ask.replies, &ask.hint_texts})
      for (const RichText& text : *texts) expect(text);
    expect(ask.because);
  }

  SpeechText speech_;
  std::string page_;
  std::vector<std::string> lost_;
  std::size_t looked_for_ = 0;
};

TEST(Reader, IsOneWellFormedPageThatNeedsNothing) {
  EXPECT_THAT(edition().run.err, HasSubstr("3 steps in "));
  const XmlNode& root = edition().root;
  EXPECT_EQ(root.attribute("lang"), "en");
  EXPECT_EQ(words_of(*all_named(root, "title").front()), "An <edition> & more");
  EXPECT_THAT(edition().html, HasSubstr("default-src 'none'; img-src data:; style-src 'sha256-"));
  EXPECT_THAT(edition().html, Not(HasSubstr("{{")));
  EXPECT_THAT(edition().html, testing::EndsWith("</html>\n"));
  for_each_node(root, [](const XmlNode& node) {
    EXPECT_EQ(node.attributes.count("style"), 0u);
    const std::string source = node.attribute("src");
    if (node.name == "img") {
      EXPECT_THAT(source, testing::StartsWith("data:image/webp;base64,"));
    } else {
      EXPECT_EQ(source, "");
    }
    for (const auto& [key, value] : node.attributes) EXPECT_THAT(key, Not(testing::StartsWith("on")));
  });
}

/// Paper is light, whatever the screen is.
TEST(Reader, FiguresForDarkScreensStandBesideTheOthers) {
  const Edition both(kEditionLesson, {"--theme", "both"});
  const auto pictures = all_named(both.root, "picture"), images = all_named(both.root, "img");
  ASSERT_EQ(pictures.size(), images.size());
  ASSERT_EQ(images.size(), all_named(edition().root, "img").size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    const XmlNode& source = *all_named(*pictures[i], "source").at(0);
    EXPECT_EQ(source.attribute("media"), "screen and (prefers-color-scheme: dark)");
    EXPECT_THAT(source.attribute("srcset"), testing::StartsWith("data:image/webp;base64,"));
    EXPECT_NE(source.attribute("srcset"), images[i]->attribute("src"));
    EXPECT_EQ(images[i]->attribute("src"), all_named(edition().root, "img")[i]->attribute("src"));
  }
}

TEST(Reader, ItsPolicyIsThatOfItsStyleAndScript) {
  const XmlNode& root = edition().root;
  for (const char* name : {"style", "script"})
    EXPECT_THAT(edition().html, HasSubstr(std::string(name) + "-src " +
                                          policy_hash(all_named(root, name).front()->children.front().text)));
}

TEST(Reader, SaysEveryWordOfTheLesson) {
  const auto lesson = check_lesson(kEditionLesson, "edition.md");
  ASSERT_TRUE(lesson.lesson);
  const LostWords words(*lesson.lesson, edition().root);
  EXPECT_THAT(words.lost(), IsEmpty());
  EXPECT_GT(words.looked_for(), 30u);
  EXPECT_THAT(words_of(edition().root), HasSubstr("A. B. What you will be able to do read it"));
}

TEST(Reader, SaysEveryWordOfTheLecture) {
  const ScratchFolder folder;
  const fs::path page = folder / "page.html";
  const std::string path = (test::source_dir() / "lessons/euler-equations.md").string();
  ASSERT_EQ(polhode({"export", path, "--reader", page.string(), "--quality", "draft"}).code, 0);
  const std::string html = text_of(page);
  constexpr std::size_t kLargest = 10'000'000;  // what is sent by mail
  EXPECT_LT(html.size(), kLargest);
  const auto lesson = check_lesson(text_of(path), path);
  ASSERT_TRUE(lesson.lesson);
  const XmlNode root = test::read_xml(html);
  const LostWords words(*lesson.lesson, root);
  EXPECT_THAT(words.lost(), IsEmpty());
  EXPECT_GT(words.looked_for(), 1000u);
  std::set<std::string> ids;
  for_each_node(root, [&](const XmlNode& node) {
    const std::string id = node.attribute("id");
    EXPECT_TRUE(id.empty() || ids.insert(id).second) << "twice: " << id;
  });
  for_each_node(root, [&](const XmlNode& node) {
    const std::string link = node.attribute("href");
    EXPECT_TRUE(!link.starts_with('#') || ids.contains(link.substr(1))) << link << " leads nowhere";
    for (const char* name : {"for", "aria-labelledby"}) {
      const std::string id = node.attribute(name);
      EXPECT_TRUE(id.empty() || ids.contains(id)) << id;
    }
  });
}

TEST(Reader, ListsAndTablesAreThat) {
  const XmlNode& root = edition().root;
  const XmlNode& step = *with_id(root, "moves/step.1");
  const auto lists = all_named(step, "ul");
  ASSERT_FALSE(lists.empty());
  EXPECT_EQ(words_of(*lists[0]), "one two inside twice three");
  const auto inside = all_named(*lists[0], "ol");
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_EQ(all_named(*inside[0], "li").at(1)->attribute("value"), "2");
  const XmlNode& table = *all_named(step, "table").at(0);
  EXPECT_EQ(table.attribute("aria-label"), "body, period");
  EXPECT_EQ(all_named(table, "th").at(1)->attribute("scope"), "col");
  EXPECT_EQ(all_named(table, "th").at(2)->attribute("scope"), "row") << "a row is named by its first cell";
  EXPECT_TRUE(all_named(table, "td").at(0)->has_class("right"));
}

TEST(Reader, LinksLeadToPlacesOfThePageOrToTheWeb) {
  const auto links = all_named(*with_id(edition().root, "moves/step.1"), "a");
  std::vector<std::string> addresses;
  for (const XmlNode* link : links) addresses.push_back(link->attribute("href"));
  EXPECT_THAT(addresses, ElementsAre("https://example.org/?a=1&b=2", "#asked", "#cite:LL", "#moves/note.1",
                                     "#moves/law"));
  EXPECT_THAT(words_of(edition().root), HasSubstr("there, elsewhere and [LL, §36]¹."));
  EXPECT_THAT(edition().html, HasSubstr("by <a href=\"#moves/law\">(5)</a>."));
}

TEST(Reader, AFigureHasItsWordsAndItsNumbers) {
  const auto figures = all_named(edition().root, "figure");
  ASSERT_EQ(figures.size(), 2u) << "a step that goes on with a scene has none of its own";
  const XmlNode& image = *all_named(*figures[0], "img").at(0);
  EXPECT_THAT(image.attribute("alt"), HasSubstr("the energy ellipsoid"));
  EXPECT_EQ(image.attribute("width"), "960");
  EXPECT_EQ(words_of(*all_named(*figures[0], "figcaption").at(0)), "It turns at 3.01 rad/s");
  EXPECT_THAT(image.attribute("alt"), Not(HasSubstr("It turns at"))) << "a caption is read once";
  EXPECT_THAT(words_of(edition().root), HasSubstr("it turns at 3.01 rad/s."));
  EXPECT_EQ(words_of(*all_named(*figures[1], "figcaption").at(0)), "It keeps to 2.00 rad/s");
}

// 28 November 2026: how ω lies to L was told of figures whose question asks just that.
TEST(Reader, AQuestionComesBehindItsFigureWhichDoesNotAnswerIt) {
  const XmlNode& step = *with_id(edition().root, "asked/step.1");
  std::vector<std::string> parts;
  for (const XmlNode& child : step.children)
    if (!child.name.empty()) parts.push_back(child.name);
  EXPECT_THAT(parts, ElementsAre("figure", "div"));
  EXPECT_THAT(all_named(step, "img").at(0)->attribute("alt"),
              testing::AllOf(HasSubstr("the angular velocity ω"), Not(HasSubstr("turns at"))));
}

// 28 November 2026: an answer was "omega = [0.0, 3.0, 4.0]", as in a lesson's file, in German with points.
TEST(Reader, AStateThatAnswersIsPrintedAsOnPages) {
  const Edition page(
      std::string(kEditionLesson) +
      "\n# Steer {steer}\n```ask aim\ntype = \"state\"\nprompt = \"Make it turn.\"\ngoals = [{ of = "
      "\"norm(omega)\", say = \"length of ω\", is = 5, within = 1, unit = \"rad/s\" }]\nchange = "
      "[\"omega\"]\nsolution = { omega = [0, 3, 4.5] }\n```\n```scene\nomega = [0, 1, 0]\n```\n");
  EXPECT_THAT(
      words_of(*with_id(page.root, "steer/ask.aim")),
      HasSubstr("For example vector omega equals open parenthesis 0, 3, 4.5 close parenthesis rad/s"));
}

TEST(Reader, ADerivationSaysWhatIsGivenAndWhatIsAsked) {
  const Edition page(std::string(kEditionLesson) + R"(
# Derive {derive}
```ask way
type   = "derive"
prompt = "Bring the law to the body."
start  = "dL/dt = N"
goal   = "d*L/dt + omega x L = N"
modulo = "motion"
facts  = ["dA/dt = d*A/dt + omega x A"]
worked = [{ line = "d*L/dt + omega x L = N", point = "Which rate?", teach = "Use the theorem." }]
```
)");
  std::vector<std::string> items;
  for (const XmlNode* item : all_named(*with_id(page.root, "derive/ask.way.prompt"), "li"))
    items.push_back(words_of(*item));
  EXPECT_THAT(
      items,
      ElementsAre("From d vector L over d t equals vector N",
                  "to d star vector L over d t plus vector omega cross vector L equals vector N",
                  "by d vector A over d t equals d star vector A over d t plus vector omega cross vector A"));
}

// 28 November 2026: "Answer in rad/s" stood above "Your answer, in radians per second".
TEST(Reader, AUnitIsAskedForOnce) {
  const XmlNode& count = *with_id(edition().root, "asked/ask.count");
  EXPECT_EQ(words_of(*all_named(count, "label").at(0)), "Your answer");
  EXPECT_EQ(all_named(count, "input").at(0)->attribute("aria-describedby"), "asked/ask.count.prompt");
}

TEST(Reader, AGoalIsAFormulaWhereItHasNoWords) {
  const Edition page(
      std::string(kEditionLesson) +
      "\n# Steer {steer}\n```ask aim\ntype = \"state\"\nprompt = \"Make it turn.\"\ngoals = [{ of = "
      "\"norm(omega)\", is = 5, within = 1, unit = \"rad/s\" }]\nchange = "
      "[\"omega\"]\nsolution = { omega = [0, 3, 4.5] }\n```\n```scene\nomega = [0, 1, 0]\n```\n");
  EXPECT_THAT(words_of(*with_id(page.root, "steer/ask.aim")),
              HasSubstr("magnitude of vector omega: (5 ± 1) rad/s"));
}

TEST(Reader, MomentsSayWhatHasChanged) {
  std::string lesson = kEditionLesson;
  lesson.replace(lesson.find("type    = \"choice\""), 18, "type    = \"predict\"\nplays   = [0, 1.5]");
  const Edition page(lesson);
  std::vector<std::string> alts;
  for_each_node(page.root, [&](const XmlNode& node) {
    if (node.has_class("moments"))
      for (const XmlNode* image : all_named(node, "img")) alts.push_back(image->attribute("alt"));
  });
  ASSERT_EQ(alts.size(), 4u);
  EXPECT_THAT(alts[0], testing::EndsWith("kilogram square metres."));
  EXPECT_EQ(
      alts[1],
      "The same at t = 0.5 seconds. Axis 1 of the body points 57 degrees away from where it pointed at t = "
      "0 seconds.");
}

TEST(Reader, APrerequisiteThatIsALessonIsItsTitle) {
  std::string lesson = kEditionLesson;
  lesson.replace(lesson.find("[references]"), 12, "prerequisites = [\"tiny\", \"sums\"]\n[references]");
  const ScratchFolder folder;
  write_text(folder / "edition.md", lesson);
  RunOptions options;
  options.environment["POLHODE_LESSONS"] = fs::path(test_lesson("tiny.md")).parent_path().string();
  const ProgramRun run = polhode(
      {"export", (folder / "edition.md").string(), "--reader", (folder / "page.html").string()}, options);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(text_of(folder / "page.html"), HasSubstr("<li>A tiny lesson</li>\n<li>sums</li>"));
}

TEST(Reader, MarksAndUnitsStayBesideTheirFormulas) {
  std::string lesson = kEditionLesson;
  const std::string first = "First **words**";
  lesson.replace(lesson.find(first), first.size(),
                 "Alone $a$ here, ($b$), $c$&nbsp;kg and [$d$](#asked), **$e$**. $f$$g$ "
                 "($a + b + c + d + e + f + g + h + i + j + k$)");
  const Edition page(lesson);
  std::vector<std::string> words;
  for_each_node(page.root, [&](const XmlNode& node) {
    if (node.name != "span" || node.attribute("class") != "word") return;
    std::string word;
    add_words(node, word);
    words.push_back(word);
  });
  ASSERT_GE(words.size(), 4u);
  words.resize(4);
  EXPECT_THAT(words, ElementsAre("(b),", "c\u00A0kg", "fg", "3.01 rad/s."));
}

TEST(Reader, LinesEndNeitherInAUnitNorBeforeTheNumberOfAnAxis) {
  std::string lesson = kEditionLesson;
  const std::string first = "First **words**";
  lesson.replace(
      lesson.find(first), first.size(),
      "Euler's axis 3, axes 1 and 12; in 1996 some 20 bodies, 2 % of them, of $a$ kg m², $b$ each, at 3 m");
  const Edition page(lesson);
  std::string words;
  add_words(page.root, words);
  EXPECT_THAT(words,
              HasSubstr("Euler\u2019s axis\u00A03, axes\u00A01 and\u00A012; in 1996 some\u00A020 bodies, "
                        "2\u00A0% of them, of a\u00A0kg\u00A0m², b each, at\u00A03\u00A0m"));
}

TEST(Reader, TheTexToCopyHasItsNumbers) {
  std::set<std::string> tex;
  for (const XmlNode* note : all_named(edition().root, "annotation")) tex.insert(note->children.front().text);
  for (const XmlNode* math : all_named(edition().root, "math")) tex.insert(math->attribute("data-tex"));
  EXPECT_TRUE(tex.contains("{3.01}" + unit_tex("rad/s"))) << testing::PrintToString(tex);
  for (const std::string& one : tex) {
    EXPECT_THAT(one, Not(HasSubstr("\\live")));
    EXPECT_THAT(one, Not(HasSubstr("\\term")));
  }
}

// 29 November 2026: of the numbers of tables the rest of a longer text was left, "{0}ift_T}".
TEST(Reader, TheTexToCopyIsTexInEveryLesson) {
  const Fonts fonts = Fonts::open().value();
  std::size_t formulas = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(test::source_dir() / "lessons")) {
    if (entry.path().extension() != ".md" || entry.path().stem() == "FORMAT" ||
        entry.path().stem() == "README")
      continue;
    const auto reading = read_lesson(text_of(entry.path()), entry.path().string());
    ASSERT_TRUE(reading.lesson) << entry.path();
    const Lesson& lesson = *reading.lesson;
    const SpeechText speech(lesson);
    const TextNumbers numbers{PageNumbers(lesson, fonts)};
    const LessonHtml html(lesson, speech, numbers, {});
    const auto check = [&](const TextSpan& span) {
      if (span.kind != TextSpan::Kind::math) return;
      const std::string page = html.formula(span.math, span.text);
      std::smatch found;
      static const std::regex kTex("data-tex=\"([^\"]*)\"|<annotation[^>]*>([^<]*)</annotation>");
      if (!std::regex_search(page, found, kTex)) return;
      std::string tex = found[1].matched ? found[1] : found[2];
      for (const auto& [sign, plain] :
           {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
        tex = std::regex_replace(tex, std::regex(sign), plain);
      EXPECT_TRUE(parse_math(tex, lesson.macros).ok()) << entry.path().stem() << ": " << tex;
      ++formulas;
    };
    for (const Stage& stage : lesson.stages)
      for (const Step& step : stage.steps)
        for (const Block& block : step.blocks) {
          if (const auto* prose = std::get_if<Prose>(&block)) for_each_span(prose->text, check);
          if (const auto* callout = std::get_if<Callout>(&block)) for_each_span(callout->text, check);
          if (const auto* note = std::get_if<Footnote>(&block)) for_each_span(note->text, check);
        }
  }
  EXPECT_GT(formulas, 1000u);
}

TEST(Reader, AVerdictStandsInWords) {
  std::vector<std::string> verdicts;
  for_each_node(edition().root, [&](const XmlNode& node) {
    if (node.has_class("verdict")) verdicts.push_back(words_of(node));
  });
  ASSERT_EQ(verdicts.size(), 1u);
  // The line is a claim beside the formula: the verdict is about that.
  EXPECT_EQ(verdicts[0], "Stated: d vector L over d t equals vector N law.")
      << "a chip ends with a stop that is heard";
}

TEST(Reader, QuestionsHaveWhatTheyAreJudgedBy) {
  const XmlNode& root = edition().root;
  const XmlNode& pick = *with_id(root, "asked/ask.pick");
  EXPECT_EQ(pick.attribute("data-answer"), "2");
  EXPECT_EQ(all_named(pick, "input").size(), 2u);
  EXPECT_THAT(words_of(pick), HasSubstr("Answer B. Two vector omega. It is <two>."));
  const XmlNode& rank = *with_id(root, "asked/ask.rank");
  EXPECT_EQ(rank.attribute("data-answer"), "1 3 2");
  std::vector<std::string> order;
  for (const XmlNode* item : all_named(*all_named(rank, "ol").at(0), "li")) order.push_back(words_of(*item));
  EXPECT_THAT(order, ElementsAre("A. small", "C. middle", "B. large"));
  const XmlNode& count = *with_id(root, "asked/ask.count");
  EXPECT_EQ(count.attribute("data-unit"), "rad/s");
  EXPECT_NEAR(std::stod(count.attribute("data-value")), 2.0, 1e-12);
  const XmlNode& write = *with_id(root, "asked/ask.write");
  EXPECT_EQ(write.attribute("data-type"), "open");
  EXPECT_TRUE(all_named(write, "button").empty());
  EXPECT_TRUE(all_named(write, "code").empty()) << "how it is typed, where nothing can be";
  EXPECT_FALSE(all_named(write, "math").empty());
}

TEST(Reader, EveryControlHasAName) {
  std::set<std::string> named;
  for (const XmlNode* label : all_named(edition().root, "label")) named.insert(label->attribute("for"));
  for (const char* control : {"input", "select"})
    for (const XmlNode* node : all_named(edition().root, control))
      EXPECT_TRUE(named.contains(node->attribute("id"))) << node->attribute("id");
}

TEST(Reader, RepeatsToTheByte) { EXPECT_TRUE(Edition().html == edition().html); }

TEST(Reader, APartOfALessonLeadsNowhereElse) {
  const Edition part(kEditionLesson, {"--stage", "moves"});
  EXPECT_THAT(part.run.err, HasSubstr("2 steps in "));
  EXPECT_THAT(part.html, Not(HasSubstr("#asked")));
  EXPECT_THAT(words_of(part.root), HasSubstr("there, elsewhere and"));
}

TEST(Reader, NothingOfALessonBecomesMarkup) {
  std::string lesson = kEditionLesson;
  const std::string bad = R"(\</p>\<script>alert(1)\</script>\<img src=x onerror=alert(1)>\"'\]\]>)";
  const auto put = [&](const std::string& at, const std::string& what) {
    const std::size_t found = lesson.find(at);
    ASSERT_NE(found, std::string::npos) << at;
    lesson.replace(found, at.size(), what);
  };
  put("An <edition> & more", "</title></style><script>alert(1)</script>");
  put("Landau & Lifshitz", "<svg onload=alert(1)>");
  put("First **words**", bad);
  put("It **stops**", bad);
  put("[there](#asked)", "[there](javascript:alert)");
  put("Which is it?", "Which \\\\<script>?");
  const ScratchFolder folder;
  write_text(folder / "hostile.md", lesson);
  const ProgramRun run =
      polhode({"export", (folder / "hostile.md").string(), "--reader", (folder / "a.html").string()});
  if (run.code != 0) {  // the reader refuses the address, as it should
    EXPECT_THAT(run.err, HasSubstr("javascript"));
    put("[there](javascript:alert)", "there");
  }
  const Edition hostile(lesson);
  EXPECT_EQ(all_named(hostile.root, "script").size(), 1u);
  EXPECT_EQ(all_named(hostile.root, "svg").size(), 0u);
  EXPECT_EQ(all_named(hostile.root, "img").size(), all_named(edition().root, "img").size());
  EXPECT_THAT(words_of(hostile.root), HasSubstr("<script>alert(1)</script><img src=x onerror=alert(1)>"));
}

TEST(Reader, SaysWhatCannotBe) {
  const ScratchFolder folder;
  const auto expect = [&](std::vector<std::string> more, const fs::path& file, int code, const char* text) {
    std::vector<std::string> words = {"export", test_lesson("tiny.md"), "--reader", file.string()};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = polhode(words);
    EXPECT_EQ(run.code, code);
    EXPECT_THAT(run.err, HasSubstr(text));
  };
  expect({}, folder / "page.odt", 2, "has to end in .html");
  expect({"--deck", (folder / "d.html").string()}, folder / "page.html", 2,
         "--deck does not go with --reader");
  expect({"--size", "640x480"}, folder / "page.html", 2, "--size does not go with --reader");
  expect({"--skip-existing"}, folder / "page.html", 2, "--skip-existing does not go with --reader");
  expect({"--theme", "both", "--live"}, folder / "page.html", 2, "does not go with --live");
  expect({"--stage", "rollin"}, folder / "page.html", 2, "did you mean");
  EXPECT_THAT(names_in(folder.path()), IsEmpty());
  fs::create_directory(folder / "page.html");
  expect({}, folder / "page.html", 1, "is a folder");
  EXPECT_THAT(names_in(folder / "page.html"), IsEmpty());
}

TEST(Reader, AStopLeavesTheOldFile) {
  const ScratchFolder folder;
  const fs::path page = folder / "page.html";
  write_text(page, "old");
  RunOptions options;
  options.while_running = [](pid_t program) { ::kill(program, SIGINT); };
  const std::string path = (test::source_dir() / "lessons/euler-equations.md").string();
  const ProgramRun run = polhode({"export", path, "--reader", page.string()}, options);
  EXPECT_NE(run.code, 0);
  EXPECT_EQ(text_of(page), "old");
  EXPECT_THAT(names_in(folder.path()), ElementsAre("page.html"));
}

}  // namespace
}  // namespace polhode

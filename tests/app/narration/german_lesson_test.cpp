// SPDX-License-Identifier: MIT
// The lesson that is in German, from its first to its last page: no English is left on it.
#include "app/narration/alt_text.h"
#include "app/narration/short_answers.h"
#include "app/narration/speech_text.h"
#include "app/narration/transcript.h"
#include "app/narration/verdict_row.h"
#include "app/page/plot_words.h"
#include "lessons/reader/checks/lesson_check.h"
#include "render/drawing/plots/meter_plots.h"
#include "render/figure/make_figure.h"
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace polhode {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// In lower case, without formulas and what is filled in.
std::set<std::string> words_in(const std::string& text) {
  const std::string plain = std::regex_replace(text, std::regex(R"(\$[^$]*\$|\\[a-z]+)"), " ");
  std::set<std::string> words;
  std::string word;
  for (const char c : plain + ' ') {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) || byte >= 0x80) {
      word += static_cast<char>(std::tolower(byte));
    } else if (!word.empty()) {
      words.insert(std::exchange(word, {}));
    }
  }
  return words;
}

/// Those of the program's own words in English that are none in German ("fast" is "almost" there), and common
/// ones.
std::set<std::string> english_words() {
  std::set<std::string> english = {
      "the",   "and",   "of",     "is",     "are",   "with",  "at",     "for",    "from",   "by",
      "to",    "not",   "that",   "this",   "these", "it",    "its",    "which",  "when",   "while",
      "where", "about", "after",  "before", "body",  "axis",  "axes",   "moment", "energy", "torque",
      "spin",  "spins", "turn",   "turns",  "flip",  "error", "wait",   "motion", "proved", "true",
      "false", "given", "figure", "stage",  "step",  "steps", "length", "answer", "right",  "choice",
      "both",  "same",  "small",  "large",  "grows"};
  std::set<std::string> german = {"hat", "ring", "a",  "an",     "t",     "s",        "l",
                                  "h",   "so",   "in", "tensor", "const", "relative", "fast"};
  const std::regex phrase(R"re(\{"((?:[^"\\]|\\.)*)",\s*"((?:[^"\\]|\\.)*)"\})re");
  for (const auto& entry : std::filesystem::directory_iterator(test::source_dir() / "base" / "words")) {
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), phrase), end; found != end; ++found) {
      for (const std::string& word : words_in((*found)[1])) english.insert(word);
      for (const std::string& word : words_in((*found)[2])) german.insert(word);
    }
  }
  EXPECT_GT(english.size(), 300u) << "the catalogue was read";
  for (const std::string& word : german) english.erase(word);
  return english;
}

class GermanLesson : public testing::Test {
 protected:
  static const Lesson& lesson() {
    static const LessonReading reading = [] {
      const std::filesystem::path path = test::source_dir() / "lessons" / "intermediate-axis.de.md";
      return check_lesson(read_file(path), path.string());
    }();
    EXPECT_TRUE(reading.lesson) << to_string(reading.diagnostics.at(0));
    return *reading.lesson;
  }

  static void expect_german(const std::string& text, const std::string& where) {
    static const std::set<std::string> kEnglish = english_words();
    for (const std::string& word : words_in(text))
      EXPECT_FALSE(kEnglish.contains(word)) << word << ": " << where << ": " << text;
    // Of numbers: 0.5 is English.
    EXPECT_FALSE(std::regex_search(text, std::regex(R"([0-9]\.[0-9])"))) << where << ": " << text;
  }
};

TEST_F(GermanLesson, IsReadAloudInGerman) {
  std::istringstream lines(transcript_of(lesson(), {}));
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    if (line.starts_with("["))
      break;
    else
      expect_german(line, "transcript");  // sources are cited as they are
  EXPECT_GT(count, 1000);
}

TEST_F(GermanLesson, HasVerdictsAndAnswersInGerman) {
  const SpeechText speech(lesson());
  for (const Stage& stage : lesson().stages) {
    expect_german(short_answers(lesson(), stage), stage.id);
    for (const Step& step : stage.steps) {
      for (const Claim* claim : blocks_of<Claim>(step)) {
        const VerdictRow row = verdict_row(*claim, step.scene.get(), nullptr, lesson().about.language);
        expect_german(row.word + ' ' + row.note + ' ' + row.example + ' ' + std::string(row.claimed_is),
                      stage.id);
      }
      for (const Ask* ask : blocks_of<Ask>(step)) {
        if (!ask->expression && !ask->task) expect_german(speech.words_of_answer(*ask), ask->id);
        for (const RichText& reply : ask->replies) expect_german(speech.words(reply), ask->id);
        for (const RichText& hint : ask->hint_texts) expect_german(speech.words(hint), ask->id);
        expect_german(speech.words(ask->because), ask->id);
      }
    }
  }
}

TEST_F(GermanLesson, HasFiguresInGerman) {
  const SpeechText speech(lesson());
  const Scene* before = nullptr;
  int count = 0;
  for (const Stage& stage : lesson().stages)
    for (const Step& step : stage.steps) {
      if (!step.scene || step.scene.get() == before) continue;
      before = step.scene.get();
      ++count;
      const SceneModel model = make_model(*step.scene, ModelFor::page);
      const double t_s = still_time_s(*step.scene);
      expect_german(alt_text(model, speech.words_of_scenes(step, *step.scene), t_s), stage.id);
      expect_german(speech.words_of_plots(*step.scene), stage.id);
      expect_german(words_of_plots(model, t_s, speech, false), stage.id);
      expect_german(moment_in_words(model, {}, 0.0, t_s, t_s), stage.id);
      for (const Pane& pane : make_figure(model, t_s, 1.5).panes) {
        expect_german(pane.title, stage.id);
        for (const Label& label : pane.list.labels) expect_german(label.text, stage.id);
      }
      for (const TimePlot& plot : meter_plots(model, t_s)) {
        expect_german(plot.title, stage.id);
        for (const TimeSeries& series : plot.series) expect_german(series.label, stage.id);
        EXPECT_EQ(plot.language, Language::de);
      }
    }
  EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "app/narration/transcript.h"

#include "app/narration/speech_text.h"
#include "base/utf8.h"
#include "base/words/speech_words.h"
#include "lessons/reader/markdown/footnotes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polhode {

namespace {

std::size_t columns_of(std::string_view utf8) { return static_cast<std::size_t>(count_characters(utf8)); }

std::string underlined(const std::string& heading, char line) {
  return heading + '\n' + std::string(columns_of(heading), line) + '\n';
}

class Transcript {
 public:
  explicit Transcript(const Lesson& lesson) : speech_(lesson) { text_ = underlined(lesson.title, '='); }

  void add(const Stage& stage, std::size_t number) {
    text_ += '\n' + underlined(fmt::format("{}. {}", number, speech_.words(stage.title_text)), '-');
    for (const Step& step : stage.steps) {
      if (!step.title.empty()) text_ += '\n' + underlined(speech_.words(step.title), '~');
      scene_ = step.scene.get();
      for (const Block& block : step.blocks) std::visit([this](const auto& b) { add(b); }, block);
      const std::vector<FigureWords> figure = speech_.words_of_figure(step);
      if (!figure.empty() && figure != figure_) {
        figure_ = figure;
        for (const auto& [opening, caption] : figure) add_paragraph(caption, opening);
      }
      const std::string plots = step.scene ? speech_.words_of_plots(*step.scene) : "";
      if (!plots.empty() && plots != plots_) add_paragraph(plots, speech_.opening(words::kPlotted));
      plots_ = plots;
      const std::string marks = speech_.words_of_marks(step);
      if (!marks.empty() && marks != marks_) add_paragraph(marks, speech_.opening(words::kDrawn));
      marks_ = marks;
    }
  }

  /// What the lesson cites, wherever: a reader finds it at the end.
  void add_references(const std::vector<Reference>& references) {
    std::string cited;
    for (const Reference& reference : references)
      if (reference.is_cited) cited += wrapped(reference.text, fmt::format("[{}] ", reference.key));
    if (!cited.empty()) text_ += '\n' + underlined(speech_.opening(words::kReferences), '-') + '\n' + cited;
  }

  std::string take() { return std::move(text_); }

 private:
  void add(const Prose& prose) {
    bool in_list = false;
    for (const TextBlock& block : prose.text) {
      if (block.is_table()) {
        add_table(block.table);
        in_list = false;
        continue;
      }
      // Items of a list stand close.
      if (!(in_list && !block.marker.empty())) text_ += '\n';
      in_list = !block.marker.empty();
      const std::string blanks(2 * static_cast<std::size_t>(std::max(0, block.indent)), ' ');
      text_ += wrapped(speech_.words(block), in_list ? blanks + block.marker + ' ' : blanks);
    }
  }

  void add_table(const TextTable& table) {
    text_ += '\n';
    std::string first;
    for (const std::string& row : speech_.words_of_rows(table)) {
      text_ += wrapped(row, first);
      first = "  ";
    }
  }

  void add(const Equation& equation) { add_paragraph(speech_.words(equation), "    "); }
  void add(const Callout& callout) { add_paragraph(speech_.words(callout), "  > "); }
  void add(const Footnote& note) {
    text_ += '\n' + wrapped(speech_.words(note.text), raised_number(note.number) + ' ');
  }
  void add(const Claim& claim) { text_ += wrapped(speech_.words(claim, scene_), "      "); }

  void add(const Ask& ask) {
    add_paragraph(speech_.words(ask.prompt_text), speech_.opening(words::kQuestion));
    for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
      text_ += wrapped(speech_.words(ask.choice_texts[i]), fmt::format("  {}. ", letter_of_choice(i)));
  }

  void add_paragraph(const std::string& words, const std::string& first) {
    text_ += '\n' + wrapped(words, first);
  }

  SpeechText speech_;
  std::string text_;
  std::vector<FigureWords> figure_;  ///< of the last one: steps inherit captions
  std::string plots_, marks_;        ///< likewise
  const Scene* scene_ = nullptr;     ///< of the step
};

}  // namespace

std::string wrapped(std::string_view words, const std::string& first) {
  const std::string indent(columns_of(first), ' ');
  std::string text, line = first;
  bool is_empty = true;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of(" \n"), words.size());
    const std::string_view word = words.substr(0, end);
    words.remove_prefix(std::min(end + 1, words.size()));
    if (word.empty()) continue;
    if (!is_empty && columns_of(line) + 1 + columns_of(word) > kTranscriptColumns) {
      text += line + '\n';
      line = indent;
      is_empty = true;
    }
    if (!is_empty) line += ' ';
    line += word;
    is_empty = false;
  }
  return is_empty ? text : text + line + '\n';
}

std::string transcript_of(const Lesson& lesson, const std::vector<std::string>& stages) {
  Transcript transcript(lesson);
  for (std::size_t i = 0; i < lesson.stages.size(); ++i) {
    const Stage& stage = lesson.stages[i];
    if (stages.empty() || std::find(stages.begin(), stages.end(), stage.id) != stages.end())
      transcript.add(stage, i + 1);
  }
  transcript.add_references(lesson.references);
  return transcript.take();
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "app/narration/step_transcript.h"

#include "base/words/speech_words.h"
#include "lessons/reader/markdown/footnotes.h"

#include <fmt/format.h>

namespace polhode {

namespace {

using Kind = StepNote::Kind;

class Notes {
 public:
  explicit Notes(const SpeechText& speech) : speech_(speech) {}

  void add(const Prose& prose) {
    for (const TextBlock& block : prose.text) {
      const bool item = !block.marker.empty();
      if (block.is_table()) {
        const std::vector<std::string> rows = speech_.words_of_rows(block.table);
        for (const std::string& row : rows) add(&row == rows.data() ? Kind::text : Kind::item, row);
        continue;
      }
      std::vector<NoteLink> links;
      const std::string words = speech_.words(block, &links);
      add(item ? Kind::item : Kind::text, item ? block.marker + ' ' : "", words, std::move(links));
    }
  }
  void add(const Equation& equation) { add(Kind::equation, speech_.words(equation)); }
  void add(const Callout& callout) {
    std::vector<NoteLink> links;
    const std::string words = speech_.words(callout, &links);
    add(callout.kind == Callout::Kind::notes ? Kind::to_say : Kind::callout, "", words, std::move(links));
  }
  void add(const Claim& claim) { add(Kind::text, speech_.words(claim, scene_)); }
  void add(const Footnote& note) {
    std::vector<NoteLink> links;
    const std::string words = speech_.words(note.text, &links);
    add(Kind::note, raised_number(note.number) + ' ', words, std::move(links));
  }
  void add(const Ask& ask) {
    add(Kind::question, speech_.opening(words::kQuestion) + speech_.words(ask.prompt_text));
    for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
      add(Kind::item, fmt::format("{}. {}", letter_of_choice(i), speech_.words(ask.choice_texts[i])));
  }
  void add(const FigureWords& figure) { add(Kind::figure, figure.opening + figure.caption); }
  void add_title(std::string words) { add(Kind::text, std::move(words)); }
  void add_plots(const std::string& words) { add(Kind::figure, speech_.opening(words::kPlotted) + words); }

  /// Of the claims that are added from now on; null: there is none.
  void set_scene(const Scene* scene) { scene_ = scene; }

  std::vector<StepNote> take() { return std::move(notes_); }

 private:
  void add(Kind kind, std::string text) {
    if (!text.empty()) notes_.push_back({kind, std::move(text)});
  }
  /// The links are those of the words.
  void add(Kind kind, const std::string& before, const std::string& words, std::vector<NoteLink> links) {
    for (NoteLink& link : links) {
      link.begin += before.size();
      link.end += before.size();
    }
    if (!words.empty() || !before.empty()) notes_.push_back({kind, before + words, std::move(links)});
  }

  const SpeechText& speech_;
  const Scene* scene_ = nullptr;
  std::vector<StepNote> notes_;
};

}  // namespace

std::vector<StepNote> notes_of(const SpeechText& speech, const Stage& stage, int first, int last) {
  Notes notes(speech);
  const auto begin = static_cast<std::size_t>(first - 1), end = static_cast<std::size_t>(last);
  for (std::size_t i = begin; i < end; ++i) {
    const Step& step = stage.steps[i];
    notes.set_scene(step.scene.get());
    for (const Callout& note : step.notes) notes.add(note);
    notes.add_title(speech.words(step.title));
    for (const Block& block : step.blocks) std::visit([&](const auto& b) { notes.add(b); }, block);
    if (i == 0 || step.captions != stage.steps[i - 1].captions)
      for (const FigureWords& figure : speech.words_of_figure(step)) notes.add(figure);
    const auto plots_of = [&](const Step& one) { return one.scene ? speech.words_of_plots(*one.scene) : ""; };
    const std::string plots = plots_of(step);
    if (!plots.empty() && (i == 0 || plots != plots_of(stage.steps[i - 1]))) notes.add_plots(plots);
  }
  return notes.take();
}

}  // namespace polhode

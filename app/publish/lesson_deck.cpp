// SPDX-License-Identifier: MIT
#include "app/publish/lesson_deck.h"

#include "app/narration/step_transcript.h"
#include "app/page/text/recalled_equations.h"
#include "base/ascii.h"
#include "base/words/page_words.h"
#include "render/image/png_summary.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace polhode {

namespace {

Result<std::string> description_in(const std::filesystem::path& file) {
  const Result<PngSummary> png = summarize_png_file(file);
  if (!png) return failure("cannot use " + file.string() + ": " + png.error());
  for (const auto& [keyword, value] : png->metadata.text)
    if (keyword == "Description") return value;
  return std::string();
}

/// Its title, or its number, where a slide is a step of several; of a page, which steps it has.
std::string part_of(const SpeechText& speech, const PlannedPicture& picture, const ExportOptions& options,
                    Language language) {
  const std::size_t steps = picture.stage->steps.size();
  if (options.each == Each::page && picture.first_step < picture.step &&
      static_cast<std::size_t>(picture.step - picture.first_step) + 1 < steps)
    return words::kStepsOf.with(
        language, {std::to_string(picture.first_step), std::to_string(picture.step), std::to_string(steps)});
  if (options.each == Each::page && picture.first_step == picture.step && steps > 1)
    return words::kStepOf.with(language, {std::to_string(picture.step), std::to_string(steps)});
  if (options.each == Each::step && picture.stage->steps.size() > 1) {
    const Step& step = picture.stage->steps[static_cast<std::size_t>(picture.step - 1)];
    return step.title.empty()
               ? words::kStepOf.with(language, {std::to_string(picture.step), std::to_string(steps)})
               : speech.words(step.title);
  }
  if (!picture.equation || options.each == Each::step) return {};
  return words::kEquationPart.with(
      language, {picture.equation->tag.empty() ? picture.equation->id : "(" + picture.equation->tag + ")"});
}

struct Steps {
  int first, last;
};

/// Whose words go with picture `i`.
Steps steps_said(const ExportPlan& plan, std::size_t i) {
  const PlannedPicture& picture = plan.pictures[i];
  const bool is_first = i == 0 || plan.pictures[i - 1].stage != picture.stage;
  const bool is_last = i + 1 == plan.pictures.size() || plan.pictures[i + 1].stage != picture.stage;
  const int before = is_first ? 0 : plan.pictures[i - 1].step;
  return {std::min(before + 1, picture.step),
          is_last ? static_cast<int>(picture.stage->steps.size()) : picture.step};
}

/// The slide that shows a step: the first of its stage that has come so far. Nothing where there is none.
std::string slide_with(const ExportPlan& plan, const StepPlace& place) {
  for (const PlannedPicture& picture : plan.pictures)
    if (static_cast<std::size_t>(picture.number) == place.stage + 1 &&
        static_cast<std::size_t>(picture.step) > place.step)
      return '#' + std::filesystem::path(picture.file).stem().string();
  return "";
}

/// Links of the lesson as links of the deck; what leads to no slide and to no address is none.
void lead_to_slides(const Lesson& lesson, const ExportPlan& plan, std::vector<StepNote>& notes) {
  for (StepNote& note : notes) {
    for (NoteLink& link : note.links) {
      const auto place = target_of(lesson, link.to);
      if (place)
        link.to = slide_with(plan, *place);
      else if (!link.to.starts_with("http") && !link.to.starts_with("mailto:"))
        link.to.clear();
    }
    std::erase_if(note.links, [](const NoteLink& link) { return link.to.empty(); });
  }
}

/// What stands at the foot of a slide of one step.
void add_recalled(const Lesson& lesson, const SpeechText& speech, const PlannedPicture& picture,
                  std::vector<StepNote>& notes) {
  const Equation* recalled =
      recalled_on_slide({.lesson = lesson, .stage = *picture.stage, .step = picture.step, .size = {}});
  if (recalled != nullptr)
    notes.push_back({StepNote::Kind::equation, capitalized(words::kFromBefore.in(lesson.about.language)) +
                                                   ' ' + speech.words(*recalled)});
}

/// What the lesson cites, behind its last words.
void add_references(const Lesson& lesson, std::vector<StepNote>& notes) {
  for (const Reference& reference : lesson.references)
    if (reference.is_cited)
      notes.push_back({StepNote::Kind::note, fmt::format("[{}] {}", reference.key, reference.text)});
}

}  // namespace

Result<Deck> deck_of(const Lesson& lesson, const ExportOptions& options, const ExportPlan& plan,
                     const std::filesystem::path& folder) {
  const SpeechText speech(lesson);
  Deck deck;
  deck.title = lesson.title;
  deck.author = fmt::format("{}", fmt::join(lesson.about.authors, ", "));
  deck.language = lesson.about.language;
  deck.theme = options.theme;
  deck.dpi = options.dpi;
  for (std::size_t i = 0; i < plan.pictures.size(); ++i) {
    const PlannedPicture& picture = plan.pictures[i];
    DeckSlide slide;
    slide.png = folder / picture.file;
    slide.stage = picture.number;
    slide.title = speech.words(picture.stage->title_text);
    slide.part = part_of(speech, picture, options, lesson.about.language);
    Result<std::string> alt = description_in(slide.png);
    if (!alt) return failure(alt.error());
    slide.alt = std::move(*alt);
    if (picture.stage->steps[static_cast<std::size_t>(picture.step - 1)].scene)
      slide.live = live_attributes(*picture.stage, picture.step);
    const Steps said = steps_said(plan, i);
    slide.notes = notes_of(speech, *picture.stage, said.first, said.last);
    if (options.what == What::page && options.profile == Profile::slides && options.each == Each::step)
      add_recalled(lesson, speech, picture, slide.notes);
    lead_to_slides(lesson, plan, slide.notes);
    if (i + 1 == plan.pictures.size()) add_references(lesson, slide.notes);
    deck.slides.push_back(std::move(slide));
  }
  return deck;
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "lessons/reader/stage_builder.h"

#include "base/spelling.h"
#include "lessons/reader/markdown/callouts.h"
#include "lessons/reader/markdown/heading.h"
#include "lessons/reader/questions/ask_block.h"
#include "lessons/reader/questions/state_keys.h"
#include "lessons/reader/reader.h"
#include "lessons/reader/scene/plot_keys.h"
#include "lessons/reader/scene/varied_scene.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

/// What the opening of a ```claim may end with.
constexpr std::string_view kInOtherWords = "in-other-words";

std::vector<std::string> names_of(const std::map<std::string, int>& lines) {
  std::vector<std::string> names;
  for (const auto& [name, line] : lines) names.push_back(name);
  return names;
}

}  // namespace

bool StageBuilder::add(const MarkdownBlock& block) {
  if (is_closed() && (block.kind != MarkdownBlock::Kind::heading || block.level != 1)) return true;
  ++parts_;
  const bool names_step =
      block.kind == MarkdownBlock::Kind::heading && block.level == 2 && !block.underlined && !stages_.empty();
  if (names_step) return add_title(block);
  if (block.kind == MarkdownBlock::Kind::heading) return start_stage(block);
  if (stages_.empty()) {
    if (!said_text_before_stage_) {
      report_.error({block.first_line, 1}, "text before the first stage", "begin it with # Title {stage-id}");
    }
    said_text_before_stage_ = true;
    return true;
  }
  if (block.kind == MarkdownBlock::Kind::rule) return start_step(block.first_line);
  step_is_empty_ = false;
  if (block.kind == MarkdownBlock::Kind::fence) add_fence(block);
  if (block.kind == MarkdownBlock::Kind::quote) add_quote(block);
  if (block.kind == MarkdownBlock::Kind::prose) add_prose(block);
  if (parts_ <= kMaxParts) return true;
  report_.error({block.first_line, 1}, "a lesson has at most " + std::to_string(kMaxParts) + " parts");
  return false;
}

std::vector<Stage> StageBuilder::take() {
  finish_stage();
  return std::move(stages_);
}

bool StageBuilder::start_stage(const MarkdownBlock& block) {
  if (block.underlined || block.level != 1) {
    report_.error({block.first_line, 1},
                  block.underlined ? "text above a line of - or = is a heading in Markdown"
                                   : "headings of level " + std::to_string(block.level) + " are not read",
                  block.underlined
                      ? "put an empty line above ---"
                      : "a stage starts with # Title {stage-id}, a step may start with ## Title");
    return true;
  }
  finish_stage();
  if (static_cast<int>(stages_.size()) == kMaxStages) {
    report_.error({block.first_line, 1}, "a lesson has at most " + std::to_string(kMaxStages) + " stages");
    return false;
  }
  Stage stage;
  stage.place = {block.first_line, 1};
  Heading heading = read_heading(block.first_line, texts_);
  stage.id = heading.id;
  stage.title = heading.title;
  stage.title_text = std::move(heading.title_text);
  if (!stage.id.empty()) {
    const auto [taken, is_new] = stage_lines_.emplace(stage.id, block.first_line);
    if (!is_new) {
      report_.error(heading.id_place, "stage " + in_quotes(stage.id) + " is there already, on line " +
                                          std::to_string(taken->second));
    }
  }
  stage.steps.emplace_back();
  stages_.push_back(std::move(stage));
  texts_.notes().start_stage();
  scene_ = front_.scene;
  shown_ = {scene_};
  varied_.reset();
  has_scene_ = step_has_scene_ = false;
  step_is_empty_ = true;
  step().place = stages_.back().place;
  return true;
}

bool StageBuilder::start_step(int line) {
  finish_step();
  if (static_cast<int>(stages_.back().steps.size()) == kMaxStepsPerStage) {
    report_.error({line, 1}, "a stage has at most " + std::to_string(kMaxStepsPerStage) + " steps");
    return false;
  }
  stages_.back().steps.emplace_back();
  step_has_scene_ = false;
  step_is_empty_ = true;
  step().place = {line, 1};
  return true;
}

/// Directly below the stage's heading or a rule it names the step that they begin; elsewhere it begins one.
bool StageBuilder::add_title(const MarkdownBlock& heading) {
  const bool begins = !step_is_empty_ || !step().title.empty();
  if (begins && !start_step(heading.first_line)) return false;
  step().title = read_step_title(heading.first_line, texts_);
  return true;
}

void StageBuilder::finish_step() {
  if (step_is_empty_) {
    const bool only_one = stages_.back().steps.size() == 1;
    report_.error(step().place, only_one ? "this stage is empty" : "this step is empty",
                  only_one ? "write its text below the heading" : "leave out one ---");
  }
  read_tables();
  add_footnotes();
  if (!has_scene_) return;
  if (!step_has_scene_) {
    const Step& before = *std::prev(stages_.back().steps.end(), 2);
    step().scene = before.scene;
    step().captions = before.captions;
    step().labels = before.labels;
    step().varied = before.varied;
    return;
  }
  if ((shown_.size() > 1 || varied_) && ++steps_with_several_ > kMaxStepsWithSeveral) {
    if (steps_with_several_ == kMaxStepsWithSeveral + 1)
      report_.error(step().place, "a lesson has at most " + std::to_string(kMaxStepsWithSeveral) +
                                      " steps that begin \"scenes\" or \"vary\"");
    shown_ = {scene_};
    varied_.reset();
  }
  Scene scene = varied_ ? varied_->strip().value() : finished(shown_, front_.bodies);
  if (!varied_) scene.vary.clear();  // what cannot be, and was reported
  for (std::size_t i = 0; i <= scene.beside.size(); ++i)
    step().captions.push_back(varied_ ? scene_.caption : shown_[i].caption);
  for (const LessonScene& shown : varied_ ? std::span<const LessonScene>(&scene_, 1) : shown_)
    for (const auto& [key, text] : shown.labels) step().labels.push_back(text);
  for (const Scene* shown : shown_scenes(scene)) parts_ += parts_of(shown->meters);
  step().scene = std::make_shared<const Scene>(std::move(scene));
  step().varied = varied_;
  step().same = scene_.same;
  step().from = scene_.from;
  check_shown();
}

/// Of what a scene shows all is to be seen; where not, its author may not know.
void StageBuilder::take_footnote(const PlacedText& id, LocatedText text) {
  const auto same =
      std::find_if(notes_.begin(), notes_.end(), [&](const Note& note) { return note.id.text == id.text; });
  if (!is_id(id.text))
    report_.error(id.place, "bad id " + in_quotes(id.text), std::string(kIdRule));
  else if (same != notes_.end())
    report_.error(id.place, "footnote " + in_quotes(id.text) + " is there already, on line " +
                                std::to_string(same->id.place.line));
  else if (notes_.size() == kMaxFootnotes)
    report_.error(id.place, "a step has at most " + std::to_string(kMaxFootnotes) + " footnotes");
  else
    notes_.push_back({id, std::move(text)});
}

/// The footnotes of the step, in the order of their marks.
void StageBuilder::add_footnotes() {
  std::vector<std::string> known;
  for (const Note& note : notes_) known.push_back(note.id.text);
  std::set<std::string> marked;
  for (const FootnoteMarks::Mark& mark : texts_.notes().finish_step()) {
    marked.insert(mark.id);
    const auto note =
        std::find_if(notes_.begin(), notes_.end(), [&](const Note& one) { return one.id.text == mark.id; });
    if (note == notes_.end()) {
      report_.error(source_.place_of(mark.offset), "this step has no footnote " + in_quotes(mark.id),
                    known.empty() ? "write [^" + mark.id + "]: and its text below an empty line"
                                  : suggestion(mark.id, known));
      continue;
    }
    ++parts_;
    if (trimmed_lines(note->text.text()).empty()) report_.error(note->id.place, "this footnote is empty");
    step().blocks.push_back(Footnote{mark.number, texts_.note(note->text), note->id.place});
  }
  for (const Note& note : notes_)
    if (!marked.contains(note.id.text))
      report_.error(note.id.place, "nothing in this step refers to footnote " + in_quotes(note.id.text),
                    "write [^" + note.id.text + "] where it belongs");
  notes_.clear();
}

void StageBuilder::finish_stage() {
  if (stages_.empty() || is_closed()) return;
  finish_step();
  for (Step& one : stages_.back().steps) place_state_questions(one, report_);
  stages_.back().steps.shrink_to_fit();  // complete scenes are large
  check_claims();
  check_highlights();
  equation_lines_.clear();
  above_.reset();
  ask_lines_.clear();
  terms_.clear();
}

void StageBuilder::check_claims() {
  for (const PlacedText& name : claimed_) {
    if (equation_lines_.contains(name.text)) continue;
    std::string hint = suggestion(name.text, names_of(equation_lines_));
    if (hint.empty()) hint = "the stage has no ```math fence";
    report_.error(name.place, "no equation " + in_quotes(name.text) + " in this stage", std::move(hint));
  }
  claimed_.clear();
}

void StageBuilder::check_highlights() {
  for (const PlacedText& name : highlighted_) {
    if (terms_.contains(name.text) || overlay_from(name.text)) continue;
    std::vector<std::string> known(terms_.begin(), terms_.end());
    known.insert(known.end(), overlay_names().begin(), overlay_names().end());
    report_.error(name.place,
                  "nothing to highlight: no \\term and no overlay is called " + in_quotes(name.text),
                  suggestion(name.text, known));
  }
  highlighted_.clear();
}

void StageBuilder::add_prose(const MarkdownBlock& block) {
  const SourcePlace place{block.first_line, 1};
  LocatedText text, note;
  PlacedText id;
  bool in_note = false;  // a footnote ends with its paragraph
  const auto end_note = [&] {
    if (in_note) take_footnote(id, std::exchange(note, {}));
    in_note = false;
  };
  for (int number = block.first_line; number <= block.last_line; ++number) {
    const std::string_view line = source_.line(number);
    const auto opening = footnote_opening(line);
    if (opening || is_blank(line)) end_note();
    if (opening) {
      in_note = true;
      id = {std::string(opening->id), source_.place_of(opening->id)};
      note.append(opening->text, source_.offset_of(opening->text));
      continue;
    }
    LocatedText& into = in_note ? note : text;
    if (in_note || number > block.first_line) into.append("\n", source_.begin_of(number) - 1);
    into.append(line, source_.offset_of(line));
  }
  end_note();
  const std::string_view markdown = trimmed_lines(text.text());
  if (markdown.empty()) return;
  step().blocks.push_back(Prose{std::string(markdown), texts_.passage(text), place});
}

void StageBuilder::add_quote(const MarkdownBlock& block) {
  for (Callout& callout : read_callouts(block.first_line, block.last_line, texts_)) {
    ++parts_;
    if (callout.kind == Callout::Kind::notes)
      step().notes.push_back(std::move(callout));
    else
      step().blocks.push_back(std::move(callout));
  }
}

/// What a fence opens with: so many words, its kind among them, without "given" and what is.
struct StageBuilder::FenceKind {
  std::string_view name;
  std::size_t least, most;
  std::string_view last;  ///< what the last is where there are the most; empty: anything
  bool takes_given;
  std::string_view usage;
  void (StageBuilder::*add)(const Fence&);
};

const std::array<StageBuilder::FenceKind, 5> StageBuilder::kFenceKinds{{
    {"math", 2, 3, "", true,
     "```math ID, or ```math ID KIND [given ASSUMPTION…] where the formula is to be proved",
     &StageBuilder::add_math},
    {"claim", 3, 4, kInOtherWords, true, "```claim EQUATION KIND [given ASSUMPTION…] [in-other-words]",
     &StageBuilder::add_claim},
    {"scene", 1, 1, "", false, "```scene", &StageBuilder::add_scene},
    {"table", 1, 1, "", false, "```table", &StageBuilder::add_table},
    {"ask", 2, 2, "", false, "```ask ID", &StageBuilder::add_ask},
}};

void StageBuilder::add_fence(const MarkdownBlock& block) {
  Fence fence;
  fence.place = {block.first_line, 1};
  fence.first_line = block.first_line + 1;
  fence.last_line = block.closed ? block.last_line - 1 : block.last_line;
  if (!block.closed) {
    report_.error(fence.place, "this fence is never closed", "end it with a line ```");
    return;
  }
  const std::string_view opening = source_.line(block.first_line);
  fence.words = read_words(opening, opening.find_first_not_of(" `~"), block.first_line);
  const std::string name = fence.words.empty() ? "" : fence.words[0].text;
  const auto kind = std::find_if(kFenceKinds.begin(), kFenceKinds.end(),
                                 [&name](const FenceKind& known) { return known.name == name; });
  if (kind == kFenceKinds.end()) {
    std::vector<std::string> names;
    for (const FenceKind& known : kFenceKinds) names.emplace_back(known.name);
    report_.error(fence.place,
                  name.empty() ? "this fence does not say what it holds" : "unknown fence " + in_quotes(name),
                  suggestion(name, names));
    return;
  }
  if (kind->takes_given && fence.words.size() > 4 && fence.words[3].text == "given") {
    const auto end = fence.words.end() - (fence.words.back().text == kInOtherWords ? 1 : 0);
    fence.given.assign(fence.words.begin() + 4, end);
    fence.words.erase(fence.words.begin() + 3, end);
  }
  const std::size_t count = fence.words.size();
  const bool ends_otherwise =
      !kind->last.empty() && count == kind->most && fence.words.back().text != kind->last;
  if (count < kind->least || count > kind->most || ends_otherwise) {
    report_.error(count > kind->most ? fence.words[kind->most].place
                  : ends_otherwise   ? fence.words.back().place
                                     : fence.place,
                  "this fence opens with " + std::string(kind->usage));
    return;
  }
  (this->*kind->add)(fence);
}

bool StageBuilder::take_id(const Fence& fence, std::map<std::string, int>& taken, std::string_view what) {
  const PlacedText& id = fence.words[1];
  if (!is_id(id.text)) {
    report_.error(id.place, "bad id " + in_quotes(id.text), std::string(kIdRule));
    return false;
  }
  const auto [first, is_new] = taken.emplace(id.text, fence.place.line);
  if (is_new) return true;
  report_.error(id.place, std::string(what) + ' ' + in_quotes(id.text) + " is there already, on line " +
                              std::to_string(first->second));
  return false;
}

void StageBuilder::add_ask(const Fence& fence) {
  take_id(fence, ask_lines_, "question");
  const int list_line = first_line_of_list(source_, fence.first_line, fence.last_line);
  const auto table = parse_toml(source_.lines(fence.first_line, list_line - 1), fence.first_line, report_);
  std::optional<ChoiceList> list;
  if (list_line <= fence.last_line) list = read_choice_list(list_line, fence.last_line, report_);
  if (!table) return;
  if (auto ask = read_ask(*table, fence.words[1].text, fence.place, front_, texts_, list ? &*list : nullptr,
                          stages_.back().id)) {
    step().blocks.push_back(std::move(*ask));
  }
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "lessons/reader/stage_builder.h"

#include "base/spelling.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/reader/claim_lines.h"
#include "lessons/reader/markdown/callouts.h"
#include "lessons/reader/markdown/heading.h"
#include "lessons/reader/questions/ask_block.h"
#include "lessons/reader/questions/state_keys.h"
#include "lessons/reader/reader.h"
#include "lessons/reader/scene/motion_table.h"
#include "lessons/reader/scene/plot_keys.h"
#include "lessons/reader/scene/varied_scene.h"
#include "render/scene/model/scene_needs.h"
#include "render/typeset/math/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
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

/// What holds of ω at an instant says nothing of rates. False, and a report, if a claim speaks of them.
bool check_given(const Claim& claim, Report& report) {
  if (!claim.given.sets_spin()) return true;
  const auto has_rates = [](const Expression& side) {
    return std::any_of(side.nodes.begin(), side.nodes.end(), is_rate);
  };
  for (const ClaimLine& line : claim.lines) {
    const bool concludes =
        line.conclusion && (has_rates(line.conclusion->left) || has_rates(line.conclusion->right));
    if (!has_rates(line.equality.left) && !has_rates(line.equality.right) && !concludes) continue;
    report.error(line.place, "what is given of ω holds at an instant, and says nothing of rates");
    return false;
  }
  return true;
}

/// What is claimed where something is small holds to an order and is printed so; what is not, is not. False,
/// and a report, where a line says otherwise.
bool check_order(const Claim& claim, Report& report) {
  const bool has_small = !claim.given.small.empty();
  const bool is_printed = claim.origin != Claim::Origin::beside;
  const std::string sign = is_printed ? "\\approx" : "~=";
  for (const ClaimLine& line : claim.lines) {
    const auto refuse = [&](std::string message, std::string hint) {
      report.error(line.place, std::move(message), std::move(hint));
      return false;
    };
    const bool is_approximate = line.relation == Relation::approximate;
    if (is_approximate && claim.kind == ClaimKind::measured && !line.within)
      return refuse("an approximation is measured within a tolerance that is said",
                    "write a claim: left ~= right within 0.01");
    if (!has_small && is_approximate && claim.kind != ClaimKind::measured)
      return refuse(
          "an approximation is proved to an order in what is small, and nothing is small here",
          "write near = { small = [\"w1\"], order = 1 } into [assume], and given near behind the kind");
    if (!has_small) continue;
    if (line.conclusion)
      return refuse("what follows from what is not proved to an order", "claim what holds near there itself");
    if (is_order(line.relation))
      return refuse("an inequality is not proved to an order", "leave out what is small");
    if (!is_approximate)
      return refuse("write " + sign + ": with what is given it holds to " +
                        std::string(name_of_order(claim.given.small.order)) + " order only",
                    "what holds exactly is a claim of its own, without what is small");
    if (claim.kind != ClaimKind::measured &&
        (line.equality.left.uses(Operation::norm) || line.equality.right.uses(Operation::norm)))
      return refuse("a length is a root, and has no series where it may be 0", "square both sides");
  }
  return true;
}

/// How the lines are printed where they are not the formula itself.
void print_lines(Claim& claim, const Vocabulary& vocabulary) {
  if (claim.origin == Claim::Origin::formula) return;
  for (ClaimLine& line : claim.lines) line.tex = tex_of(line, claim.kind, &vocabulary);
}

/// Of different units nothing is added, and no sides are compared, but where that is what is false of a line.
/// False, and a report, if a line does.
bool check_units(const Claim& claim, const std::map<int, Dimension>& constants, Report& report) {
  if (claim.kind == ClaimKind::is_false) return true;
  for (const ClaimLine& line : claim.lines) {
    for (const Equality* equality : {&line.equality, line.conclusion ? &*line.conclusion : nullptr}) {
      if (equality == nullptr) continue;
      const DimensionReading left = dimension_of(equality->left, constants),
                             right = dimension_of(equality->right, constants);
      const auto& fault = left.fault ? left.fault : right.fault;
      const bool differ = left.dimension && right.dimension && *left.dimension != *right.dimension;
      if (fault) report.error(line.place, fault->message);
      if (!fault && differ)
        report.error(line.place, "units disagree: the sides are " + to_string(*left.dimension) + " and " +
                                     to_string(*right.dimension));
      if (fault || differ) return false;
    }
  }
  return true;
}

/// Whether a formula is a quantity alone, with which one below may go on: no relation, no words.
bool states_nothing(const MathNode& node) {
  using Kind = MathNode::Kind;
  const bool is_word = node.kind == Kind::text && node.atom != MathClass::large;
  if (node.atom == MathClass::relation || is_word || node.kind == Kind::arrow || node.kind == Kind::cancel)
    return false;
  return std::all_of(node.children.begin(), node.children.end(), states_nothing);
}

/// "3", "3.2", "3a", "3'", "A": words beside an equation would say something of it.
bool is_tag(std::string_view tag) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_mark = [](char c) { return c == '\'' || c == '*'; };
  auto at = std::find_if_not(tag.begin(), tag.end(), is_digit);
  if (at != tag.end() && is_letter(*at)) ++at;
  return !tag.empty() && std::all_of(at, tag.end(), is_mark);
}

}  // namespace

// A fence with the words of its opening line.
struct StageBuilder::Fence {
  std::vector<PlacedText>
      words;  // the first is the kind; without those of `given` and what stands behind them
  std::vector<PlacedText> given;  // names of assumptions
  SourcePlace place;
  int first_line;  // of the content
  int last_line;
};

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
  for (const LessonScene& shown : varied_ ? std::vector<LessonScene>{scene_} : shown_)
    for (const auto& [key, text] : shown.labels) step().labels.push_back(text);
  for (const Scene* shown : shown_scenes(scene)) parts_ += parts_of(shown->meters);
  step().scene = std::make_shared<const Scene>(std::move(scene));
  step().varied = varied_;
  step().same = scene_.same;
  step().from = scene_.from;
  check_shown();
}

/// Of what a scene shows all is to be seen; where not, its author may not know.
void StageBuilder::check_shown() {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const Scene& scene = i == 0 ? *step().scene : step().scene->beside[i - 1];
    for (const PlacedText& name : shown_[i].shown)
      if (const std::string unseen = what_is_unseen(*overlay_from(name.text), scene); !unseen.empty())
        report_.warning(name.place, "in the scene of line " + std::to_string(scene_line_) + ' ' +
                                        in_quotes(name.text) + ' ' + unseen);
  }
}

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

void StageBuilder::add_math(const Fence& fence) {
  take_id(fence, equation_lines_, "equation");
  const std::string_view tex = source_.lines(fence.first_line, fence.last_line);
  if (trimmed_lines(tex).empty()) {
    report_.error(fence.place, "this equation is empty");
    return;
  }
  Equation equation{fence.words[1].text, std::string(tex), "", {}, source_.offset_of(tex), fence.place};
  if (auto math = texts_.formula(LocatedText(source_, tex))) equation.math = std::move(*math);
  equation.tag = equation.math.tag;
  take_tag(equation);
  terms_.insert(equation.math.terms.begin(), equation.math.terms.end());
  auto claim = fence.words.size() > 2 ? claim_printed_in(equation, fence) : std::nullopt;
  above_.reset();
  if (claim && claim->origin == Claim::Origin::formula && claim->kind != ClaimKind::non_sequitur)
    above_ = {equation.math, claim->kind, claim->given.names};
  else if (fence.words.size() == 2 && equation.math.root && states_nothing(*equation.math.root))
    above_ = {equation.math, {}};
  step().blocks.push_back(std::move(equation));
  if (!claim) return;
  parts_ += static_cast<int>(claim->lines.size());
  step().blocks.push_back(std::move(*claim));
}

/// What a fence ```math ID KIND claims: the formula, as it is printed. What cannot be read is an error where
/// it stands.
std::optional<Claim> StageBuilder::claim_printed_in(const Equation& equation, const Fence& fence) {
  const auto kind = kind_from(fence.words[2]);
  if (!kind || !equation.math.root) return std::nullopt;
  const auto place_of = [&](SourceSpan span) { return source_.place_of(equation.offset + span.begin); };
  const auto refuse = [&](const UnreadableEquation& fault) {
    report_.error(place_of(fault.place), "this formula cannot be proved as printed: " + fault.reason,
                  fault.hint.empty()
                      ? "or leave out the kind here, and say in a ```claim fence what is proved"
                      : fault.hint);
    return std::nullopt;
  };
  const auto whole = [](std::string reason, std::string hint = {}) {
    return UnreadableEquation{{0, 0}, std::move(reason), std::move(hint)};
  };
  if (kind == ClaimKind::is_false && !equation.math.live.empty())
    return refuse(whole("a live number is what it is on this motion, and false in general"));
  Claim claim{.equation = equation.id, .kind = *kind, .lines = {}, .place = fence.place};
  if (!take_given(fence, claim)) return std::nullopt;
  const bool goes_on =
      above_ && (!above_->kind || (above_->kind == kind && above_->given == claim.given.names));
  const auto read = read_equation(equation.math, front_.notation, goes_on ? &above_->math : nullptr);
  if (!read) return refuse(read.error());
  if (read->has_condition && !claim.given.empty())
    return refuse(whole("a condition in the formula does not go with what is given", "put it into [assume]"));
  auto lines = claim_lines_of(*read, *kind, place_of);
  if (!lines) return refuse(lines.error());
  claim.lines = std::move(*lines);
  claim.origin = read->is_part ? Claim::Origin::part : Claim::Origin::formula;
  if (!check_given(claim, report_) || !check_order(claim, report_) ||
      !check_units(claim, front_.dimensions, report_))
    return std::nullopt;
  print_lines(claim, front_.notation.vocabulary);
  return claim;
}

/// The assumptions that a fence names; false if there is something wrong with them.
bool StageBuilder::take_given(const Fence& fence, Claim& claim) {
  if (fence.given.size() > kMaxGiven) {
    report_.error(fence.given[kMaxGiven].place,
                  "a claim puts together at most " + std::to_string(kMaxGiven) + " assumptions");
    return false;
  }
  auto given = given_by(fence.given, front_.assumptions, report_);
  if (!given) return false;
  claim.given = std::move(*given);
  if (claim.kind == ClaimKind::free && (claim.given.sets_torque() || claim.given.small.has_torque())) {
    report_.error(fence.given.front().place, "this gives a torque, and the kind free says that there is none",
                  "the kind is motion");
    return false;
  }
  return true;
}

std::optional<ClaimKind> StageBuilder::kind_from(const PlacedText& word) {
  const auto kind = claim_kind_from(word.text);
  if (!kind)
    report_.error(word.place, "unknown kind of claim " + in_quotes(word.text),
                  suggestion(word.text, claim_kind_names()));
  return kind;
}

/// Several tags of one equation are joined by commas. An equation that is printed once more keeps its number.
void StageBuilder::take_tag(const Equation& equation) {
  std::size_t begin = 0;
  for (const std::size_t at : equation.math.tag_offsets) {
    const std::size_t end = std::min(equation.tag.find(", ", begin), equation.tag.size());
    const std::string tag = equation.tag.substr(begin, end - begin);
    begin = std::min(end + 2, equation.tag.size());
    const SourcePlace place = source_.place_of(equation.offset + at);
    if (!is_tag(tag))
      report_.error(place, "a tag is a number, or a letter, and not " + in_quotes(tag),
                    "for example 3, 3a or 3'; write words into the text");
    const auto [first, is_new] = tags_.try_emplace(tag, Tagged{place.line, equation.tex});
    if (!is_new && first->second.tex != equation.tex)
      report_.warning(
          place, "another equation has tag (" + tag + "), on line " + std::to_string(first->second.line));
  }
}

void StageBuilder::add_claim(const Fence& fence) {
  claimed_.push_back(fence.words[1]);
  const auto kind = kind_from(fence.words[2]);
  if (!kind) return;
  if (trimmed_lines(source_.lines(fence.first_line, fence.last_line)).empty()) {
    report_.error(fence.place, "this claim is empty", "write left = right on each line");
    return;
  }
  Claim claim{.equation = fence.words[1].text, .kind = *kind, .lines = {}, .place = fence.place};
  claim.in_other_words = fence.words.size() > 3;
  const Vocabulary& vocabulary = front_.notation.vocabulary;
  claim.lines = read_claim_lines(source_, fence.first_line, fence.last_line, *kind, report_, &vocabulary);
  parts_ += static_cast<int>(claim.lines.size());
  if (!take_given(fence, claim) || !check_given(claim, report_) || !check_order(claim, report_) ||
      !check_units(claim, front_.dimensions, report_))
    return;
  print_lines(claim, vocabulary);
  step().blocks.push_back(std::move(claim));
}

void StageBuilder::add_scene(const Fence& fence) {
  if (step_has_scene_) {
    report_.error(fence.place, "this step has a scene already", "start a new step with --- first");
    return;
  }
  has_scene_ = step_has_scene_ = true;
  scene_line_ = fence.place.line;
  const auto table = parse_toml(source_.lines(fence.first_line, fence.last_line), fence.first_line, report_);
  if (!table) return;
  scene_.same.clear();
  scene_.from.clear();
  std::vector<PlacedText> names =
      read_scene_keys(*table, front_.bodies, front_.words(), scene_, texts_, fence.place);
  std::move(names.begin(), names.end(), std::back_inserter(highlighted_));
  std::vector<LessonScene> shown = side_by_side(scene_, front_.bodies, front_.words(), texts_, highlighted_);
  for (std::size_t i = 0; i < std::min(shown.size(), shown_.size()); ++i)  // steps share what stays
    if (shown[i].scene.caption == shown_[i].scene.caption) shown[i].caption = shown_[i].caption;
  warn_of_hidden_caption(*table, shown);
  shown_ = std::move(shown);
  vary_scene();
}

/// The caption that scenes side by side have in common stands below those without one of their own.
void StageBuilder::warn_of_hidden_caption(const TomlTable& table, const std::vector<LessonScene>& shown) {
  const TomlEntry* entry = table.find("caption");
  if (entry == nullptr || !scene_.scenes || scene_.scene.caption.empty()) return;
  const auto is_own = [&](const LessonScene& one) { return one.scene.caption != scene_.scene.caption; };
  if (std::all_of(shown.begin(), shown.end(), is_own))
    report_.warning(entry->place, "this caption is not shown: each of the scenes has one of its own",
                    "leave it out, or those of the scenes");
}

/// What `vary` asks for, where the scene has such numbers and all can be as far as their ranges go.
void StageBuilder::vary_scene() {
  varied_.reset();
  std::vector<Variation>& numbers = scene_.scene.vary;
  if (numbers.empty() || scene_.fault_said) return;
  const std::vector<SourcePlace>& places = scene_.vary_places;
  if (scene_.scenes) {
    report_.error(places.front(), "a scene is varied, or has others beside it, not both",
                  "write scenes = [] or vary = {}");
    return;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Variation& number = numbers[i];
    const auto value = number_of(scene_, front_.bodies, number.number);
    if (!value) {
      report_.error(places[i], in_quotes(number.number) + " cannot be varied: " + value.error().message,
                    value.error().hint);
      return;
    }
    number.value = *value;
    if (number.from <= number.value && number.value <= number.to) continue;
    report_.error(places[i], fmt::format("{} is {:.7g} in this scene, beyond its range from {:.7g} to {:.7g}",
                                         in_quotes(number.number), number.value, number.from, number.to));
    return;
  }
  auto varied = std::make_shared<const VariedScene>(scene_, front_.bodies);
  if (check_ends(*varied)) varied_ = std::move(varied);
}

/// False, and a report, if a scene cannot be at a corner of the ranges.
bool StageBuilder::check_ends(const VariedScene& varied) {
  const std::vector<Variation>& numbers = scene_.scene.vary;
  for (unsigned corner = 0; corner < 1U << numbers.size(); ++corner) {
    std::vector<double> values;
    std::string named;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      values.push_back((corner >> i & 1U) != 0 ? numbers[i].to : numbers[i].from);
      named += fmt::format("{}{} = {:.7g}", i > 0 ? ", " : "", numbers[i].number, values.back());
    }
    const auto scene = varied.at(values);
    if (scene) continue;
    report_.error(scene_.vary_places.front(),
                  fmt::format("at {} there is no such scene: {}", named, scene.error()),
                  "make the range smaller");
    return false;
  }
  if (const auto strip = varied.strip(); !strip) {
    report_.error(scene_.vary_places.front(), strip.error(), "make the range smaller");
    return false;
  }
  return true;
}

void StageBuilder::add_table(const Fence& fence) {
  const std::string_view text = source_.lines(fence.first_line, fence.last_line);
  auto keys = parse_toml(text, fence.first_line, report_);
  if (!keys) return;
  tables_.push_back({std::move(*keys), step().blocks.size()});
  step().blocks.push_back(Prose{std::string(text), {}, fence.place});
}

void StageBuilder::read_tables() {
  for (const WaitingTable& waiting : tables_) {
    auto& table = std::get<Prose>(step().blocks[waiting.block]);
    if (!has_scene_) {
      report_.error(table.place, "the numbers of a table need a scene, which its rows change",
                    "add a ```scene fence to this step or above it");
      continue;
    }
    table.text =
        read_motion_table(waiting.keys, table.place, shown_.front(), front_.bodies, front_.words(), texts_);
    for (const TextBlock& block : table.text)
      parts_ += static_cast<int>(block.table.rows.size() * block.table.columns.size());
  }
  tables_.clear();
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

// SPDX-License-Identifier: MIT
#include "app/page/text/page_text.h"

#include "app/narration/short_answers.h"
#include "app/page/text/page_numbers.h"
#include "app/page/text/page_verdicts.h"
#include "app/page/text/recalled_equations.h"
#include "app/page/text/symbol_glossary.h"
#include "base/words/page_words.h"
#include "base/words/verdict_words.h"
#include "lessons/reader/checks/lint_budget.h"
#include "render/scene/model/scene_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace polhode {

namespace {

constexpr double kHeaderSize = 0.62;        // em of prose
constexpr double kSmallestOfSlides = 0.62;  // likewise: 1.3 % of the height is its x-height
constexpr double kAboveStep = 1.5;          // em: what is seen above a step that is read from its beginning
constexpr double kHeaderToTitle = 0.9;
constexpr double kLeastOfAll = 0.3;  // smaller type nobody reads; of what is normal for the page
constexpr double kSmaller = 0.94;
constexpr double kTallestBefore = 2.6;         // em: of what a slide recalls in a line
constexpr std::size_t kMostRecalled = 6;       // equations of earlier steps on a page
constexpr std::size_t kMostOfPagesBefore = 3;  // the same where those steps have pages of their own

using Pieces = std::vector<ColumnPiece>;
using PieceRefs = std::vector<const ColumnPiece*>;

void add(PieceRefs& refs, const Pieces& pieces) {
  for (const ColumnPiece& piece : pieces) refs.push_back(&piece);
}

bool has_equation(const Step& step, const std::string& id) {
  const auto equations = blocks_of<Equation>(step);
  return std::any_of(equations.begin(), equations.end(),
                     [&](const Equation* equation) { return equation->id == id; });
}

/// What the scenes of a step highlight.
std::vector<std::string> marked_by(const Step& step) {
  std::vector<std::string> marked;
  if (!step.scene) return marked;
  for (const Scene* scene : shown_scenes(*step.scene))
    marked.insert(marked.end(), scene->highlight.begin(), scene->highlight.end());
  return marked;
}

/// What of the earlier steps a page shows: all steps from `whole_from`, and equations of those before.
struct Selection {
  std::size_t whole_from = 0;
  std::vector<Recalled> recalled{};  ///< in their order
  std::size_t left_out = 0;          ///< so many that could have been recalled are not
  /// The less, the more is shown.
  std::size_t rank() const { return whole_from + left_out; }
};

/// px, of the type of badges, names and footnotes: on a slide it is not set smaller where the rest is, for it
/// would not be read from the back row.
double least_small_type(const PageRequest& request, double em) {
  if (request.profile == Profile::slides) return kSmallestOfSlides * em;
  return least_type_px(request);
}

/// What the text of a page is made of at every size of type.
struct TextParts {
  std::vector<MathSymbol> symbols;
  Verdicts verdicts;
  PageNumbers numbers;
  /// Absent where all steps stand, or one alone: on a slide, in a window, which tells what is pointed at.
  std::optional<SymbolGlossary> glossary;
};

TextParts parts_of(const PageRequest& request, const Fonts& fonts) {
  TextParts parts{
      symbols_of(request.lesson, request.theme), verdicts_of(request), numbers_of(request, fonts), {}};
  if (request.profile == Profile::page && !request.scrolls)
    parts.glossary.emplace(request.lesson, parts.symbols);
  return parts;
}

/// The text at one size; each step is set when it is first asked for.
class ScaledText {
 public:
  ScaledText(const PageRequest& request, const TextParts& parts, double width, double em, double scale,
             const Fonts& fonts)
      : request_(request),
        parts_(parts),
        fonts_(fonts),
        width_(width),
        em_(em),
        scale_(scale),
        column_(width, scale * em, request.theme, request.profile, parts.symbols, parts.numbers, fonts,
                least_small_type(request, em), request.lesson.about.language),
        last_(static_cast<std::size_t>(request.step - 1)),
        heading_{header(), title()},
        footnote_rule_(column_.footnote_rule()) {
    footnote_rule_.of = &request_.stage.steps;
  }

  double scale() const { return scale_; }

  /// A slide: the step's own text, and in a line at the foot of the column what it goes on from. Nothing if
  /// that is higher than `height`. Fails if a text cannot be set.
  Result<std::optional<FittedText>> slide(double height, bool has_to_recall = false) {
    const Selection own{last_};
    const PieceRefs refs = pieces(own);
    const double own_height = height_of(refs);
    const ColumnPiece foot = from_before(height - own_height);
    if (!status_) return failure(status_.error());
    const double room = foot.height > 0.0 ? std::floor(height - foot.height - foot.gap) : height;
    const bool is_asked_for = !present().from.empty() && recalled_on_slide(request_) != nullptr;
    if (own_height > room || (has_to_recall && is_asked_for && foot.height == 0.0))
      return std::optional<FittedText>();
    FittedText text{stack(refs), scale_, formula_scale(own), equations_in(own), request_.step, {0, 0}};
    if (foot.height > 0.0) {
      text.recalled = recalled_on_slide(request_);
      ColumnPiece placed = foot;
      placed.sheet = {};
      append(placed.sheet, foot.sheet, {0, std::floor(height - foot.height)});
      text.stack.pieces.push_back(std::move(placed));
    }
    return std::optional(std::move(text));
  }

  /// The most that fits; nothing if the step alone does not. Fails if a text that was tried cannot be set.
  Result<std::optional<Selection>> most(double height) {
    const std::optional<Selection> shown = most_that_fits(height);
    if (!status_) return failure(status_.error());
    return shown;
  }

  /// All steps, for a page that scrolls in a place of this height.
  Result<FittedText> scrolled(double height) {
    const Selection all{0};
    const PieceRefs refs = pieces(all);
    if (!status_) return failure(status_.error());
    FittedText text{stack(refs), scale_, formula_scale(all), equations_in(all), 1, {0, 0}};
    text.overflow = std::max(0.0, std::ceil(text.stack.height - height));
    if (!request_.derivation.lines.empty()) text.hidden = text.overflow;  // the line that is being typed
    if (last_ == 0) return text;
    std::size_t before = heading_.size();
    for (std::size_t i = 0; i < last_; ++i) before += whole(i, 0).text.size();
    const std::size_t after = before + whole(last_, 0).text.size();
    const auto height_to = [&](std::size_t count) {
      return height_of(PieceRefs(refs.begin(), refs.begin() + static_cast<std::ptrdiff_t>(count)));
    };
    if (after == before) return text;
    text.new_from = height_to(before + 1) - refs[before]->height;
    text.new_to = height_to(after);
    if (request_.derivation.lines.empty())
      text.hidden = std::clamp(std::floor(text.new_from - kAboveStep * em_), 0.0, text.overflow);
    return text;
  }

  Stack stacked(const Selection& shown) { return stack(pieces(shown)); }

  /// A text that leaves much of the column's height free stands in the middle of it, below the header: as the
  /// first lines of a chapter do, and not over an empty half.
  void sink_if_short(const Selection& shown, double height) {
    constexpr double kShort = 0.68;  // of the height: it would end above 0.63 of that of the page
    const double own = height_of(pieces(shown));
    if (own < kShort * height) heading_.front().gap += std::round(0.5 * (height - own));
  }

  /// Where in the stack each step begins that stands there whole.
  std::vector<double> step_tops(const Selection& shown) {
    const PieceRefs refs = pieces(shown);
    std::vector<double> tops;
    for (std::size_t i = shown.whole_from; i <= last_; ++i) {
      const auto first = std::find_if(refs.begin(), refs.end(), [&](const ColumnPiece* piece) {
        return piece->step == static_cast<int>(i) + 1;
      });
      if (first == refs.end()) continue;
      tops.push_back(height_of(PieceRefs(refs.begin(), first + 1)) - (*first)->height);
    }
    return tops;
  }

  /// As of heights_of_pages.
  Result<std::vector<double>> heights_back(double height) {
    std::vector<double> heights;
    for (std::size_t from = last_ + 1; from > 0 && (heights.empty() || heights.back() <= height); --from)
      heights.push_back(height_of(pieces({from - 1})));
    if (!status_) return failure(status_.error());
    return heights;
  }

  double formula_scale(const Selection& shown) {
    double least = 1.0;
    for (const ColumnPiece* piece : pieces(shown)) least = std::min(least, piece->formula_scale);
    return least;
  }

  std::vector<const Equation*> equations_in(const Selection& shown) const {
    std::vector<const Equation*> all;
    for (const Recalled& recalled : shown.recalled) all.push_back(recalled.equation);
    for (std::size_t i = shown.whole_from; i <= last_; ++i)
      for (const Equation* equation : blocks_of<Equation>(request_.stage.steps[i])) all.push_back(equation);
    return all;
  }

 private:
  std::optional<Selection> most_that_fits(double height) {
    if (request_.before) {
      const std::size_t first = last_ - request_.before->size();
      if (height_of(pieces({first})) > height) return std::nullopt;
      return recalling(first, height);
    }
    const std::size_t whole_from =
        first_that_fits(last_ + 1, height, [&](std::size_t i) { return pieces({i}); });
    if (whole_from > last_) return std::nullopt;
    // Rather fewer equations of earlier steps than an answer without its question.
    const bool answers = last_ > 0 && whole_from < last_ && !blocks_of<Ask>(before_present()).empty();
    const std::size_t latest = answers ? last_ - 1 : last_;
    for (std::size_t from = whole_from; from <= latest; ++from) {
      Selection shown = recalling(from, height);
      if (shown.left_out == 0 || shown.recalled.size() == kMostRecalled || from == latest) return shown;
    }
    return std::nullopt;
  }

  /// Above step `whole_from` the equations that there is room for, of many the heaviest and among these the
  /// latest: more than some are read by nobody.
  Selection recalling(std::size_t whole_from, double height) {
    Selection shown{whole_from};
    const std::vector<Recalled> all = recallable(request_, whole_from);
    std::vector<Recalled> wanted = all;
    std::stable_sort(wanted.begin(), wanted.end(), [](const Recalled& a, const Recalled& b) {
      return std::pair(a.weight, a.step) > std::pair(b.weight, b.step);
    });
    const auto in_their_order = [&all](std::vector<Recalled> chosen) {
      std::vector<Recalled> ordered;
      for (const Recalled& one : all)
        if (std::any_of(chosen.begin(), chosen.end(),
                        [&](const Recalled& other) { return other.equation == one.equation; }))
          ordered.push_back(one);
      return ordered;
    };
    const std::size_t most = request_.before ? kMostOfPagesBefore : kMostRecalled;
    for (const Recalled& next : wanted) {
      if (shown.recalled.size() == most) break;
      Selection more = shown;
      more.recalled.push_back(next);
      more.recalled = in_their_order(std::move(more.recalled));
      if (height_of(pieces(more)) > height) break;
      shown = std::move(more);
    }
    shown.left_out = all.size() - shown.recalled.size();
    return shown;
  }

  /// The smallest index below `end` from which on `pieces_from` fits; steps are tried from
  /// the newest back.
  template <class PiecesFrom>
  std::size_t first_that_fits(std::size_t end, double height, const PiecesFrom& pieces_from) {
    while (end > 0 && height_of(pieces_from(end - 1)) <= height) --end;
    return end;
  }

  PieceRefs pieces(const Selection& shown) {
    PieceRefs all;
    add(all, heading_);
    const Recalled* above = nullptr;
    for (const Recalled& recalled : shown.recalled) {
      all.push_back(&earlier(recalled, above));
      above = &recalled;
    }
    const std::size_t from = shown.whole_from;
    for (std::size_t i = from; i <= last_; ++i) add(all, whole(i, from).text);
    // At the foot symbols in words, footnotes, what is cited, and answers.
    const std::size_t body = all.size();
    if (const ColumnPiece* words = symbols_in_words(all, from)) all.push_back(words);
    for (std::size_t i = from; i <= last_; ++i) add(all, whole(i, from).notes);
    add_references(all);
    const std::string answers = answers_at_foot(request_, static_cast<int>(from) + 1);
    if (!answers.empty()) all.push_back(&small_lines(answers));
    if (all.size() > body) all.insert(all.begin() + static_cast<std::ptrdiff_t>(body), &footnote_rule_);
    return all;
  }

  bool is_slide() const { return request_.profile == Profile::slides; }
  /// What is read without anybody to ask, and nothing to point at.
  bool is_for_readers() const { return !is_slide() && !request_.scrolls; }

  /// In a line, which the step's own text makes room for; or, if none holds it, below its words, where that
  /// much is left.
  ColumnPiece from_before(double left) {
    const Equation* equation = recalled_on_slide(request_);
    if (equation == nullptr) return {};
    ColumnPiece line = noted(column_.from_before(*equation, false));
    line.of = equation;
    if (line.width <= width_ && line.height <= kTallestBefore * scale_ * em_) return line;
    ColumnPiece lines = noted(column_.from_before(*equation, true));
    lines.of = equation;
    return lines.width <= width_ && lines.height + lines.gap <= left ? lines : ColumnPiece();
  }

  /// Nothing stands in the place of a text that cannot be set.
  ColumnPiece noted(Result<ColumnPiece> piece) {
    if (piece) return std::move(piece).value();
    if (status_) status_ = failure(piece.error());
    return {};
  }

  const Step& present() const { return request_.stage.steps[last_]; }
  const Step& before_present() const { return request_.stage.steps[last_ - 1]; }
  /// Whether the present step's title stands as that of a slide, in the place of the stage's.
  bool has_own_title() const { return is_slide() && !present().title.empty(); }

  ColumnPiece title() {
    const bool is_own = has_own_title();
    ColumnPiece piece = noted(column_.title(is_own ? present().title : request_.stage.title_text));
    piece.of = is_own ? static_cast<const void*>(&present().title) : &request_.stage;
    return piece;
  }

  /// Lesson, stage, step: small, above the title; without the lesson's title where that is too long. Above
  /// the title of a step the stage has its own.
  ColumnPiece header() const {
    // It keeps its size where other type is set smaller, but not the size of a reader's larger type.
    const double em = em_ * std::max(scale_, 1.0 / std::max(1.0, request_.text_scale));
    TextStyle quiet;
    quiet.size = std::max(kHeaderSize * em, least_type_px(request_));
    quiet.color = colors_of(request_.theme).quiet;
    quiet.sans = true;
    const PageRequest::Count stage = request_.counted_as.value_or(
        PageRequest::Count{static_cast<std::size_t>(request_.number), request_.lesson.stages.size()});
    const std::string number = std::to_string(stage.number), count = std::to_string(stage.count);
    std::string place = words::kStageOf.with(language(), {number, count});
    if (!is_slide() && request_.stage.steps.size() > 1)
      place += "  ·  " + words::kCountOf.with(
                             language(), {steps_in_words(), std::to_string(request_.stage.steps.size())});
    const std::string whose = has_own_title() ? in_a_line(request_.stage.title_text) : request_.lesson.title;
    const std::string brief = words::kCountOf.with(language(), {number, count});
    DisplayList line = set_line(whose + "  ·  " + place, quiet, fonts_);
    if (line.width > width_ && has_own_title()) line = set_line(whose + "  ·  " + brief, quiet, fonts_);
    if (line.width > width_) line = set_line(place, quiet, fonts_);
    ColumnPiece piece;
    piece.of = &request_.lesson;
    piece.height = std::round(quiet.size);
    piece.gap = kHeaderToTitle * em;
    piece.sheet.texts.push_back({.list = std::move(line), .at = {0, std::round(0.8 * quiet.size)}});
    return piece;
  }

  Language language() const { return request_.lesson.about.language; }

  std::string steps_in_words() const {
    const std::size_t before = request_.before ? request_.before->size() : 0;
    const std::string last = std::to_string(request_.step);
    if (before == 0) return words::kStepNumber.with(language(), {last});
    return words::kStepsFromTo.with(language(),
                                    {std::to_string(request_.step - static_cast<int>(before)), last});
  }

  /// What a step adds.
  struct Whole {
    Pieces text, notes;
  };
  const Whole& whole(std::size_t i, std::size_t whole_from) {
    const int before = notes_before(i, whole_from);
    const auto [made, is_new] = whole_.try_emplace({i, before});
    if (is_new) made->second = made_whole(i, column_.with_notes_after(before));
    return made->second;
  }

  /// Of those of the stage, so many footnotes are not on the page: on it they count from 1. A slide keeps the
  /// numbers that the speaker's notes have.
  int notes_before(std::size_t i, std::size_t whole_from) const {
    const auto notes = [&](std::size_t of) { return blocks_of<Footnote>(request_.stage.steps[of]).size(); };
    if (is_slide() || notes(i) == 0) return 0;
    std::size_t count = 0;
    for (std::size_t before = 0; before < whole_from; ++before) count += notes(before);
    return static_cast<int>(count);
  }

  /// Symbols of the lesson's own that stand in these pieces and were explained before step `whole_from`;
  /// null: none.
  const ColumnPiece* symbols_in_words(const PieceRefs& pieces, std::size_t whole_from) {
    if (!parts_.glossary) return nullptr;
    std::vector<std::string> names;
    for (const ColumnPiece* piece : pieces)
      for (const PlacedType& text : piece->sheet.texts)
        names.insert(names.end(), text.list.names.begin(), text.list.names.end());
    const std::string line =
        parts_.glossary->explained(names, {static_cast<std::size_t>(request_.number - 1), whole_from});
    return line.empty() ? nullptr : &small_lines(line);
  }

  /// Words at the foot.
  const ColumnPiece& small_lines(const std::string& line) {
    const auto [made, is_new] = in_words_.try_emplace(line);
    if (is_new) {
      made->second = column_.small_words(line);
      made->second.of = &in_words_;
      tell_cost_of(made->second);
    }
    return made->second;
  }

  /// What the pieces of a page to read cite.
  void add_references(PieceRefs& pieces) {
    if (!request_.before) return;
    std::set<std::string_view> cited;
    for (const ColumnPiece* piece : pieces)
      for (const PlacedType& text : piece->sheet.texts)
        for (const std::string& name : text.list.names)
          if (name.starts_with(kCiteLink)) cited.insert(std::string_view(name).substr(kCiteLink.size()));
    for (const Reference& reference : request_.lesson.references) {
      if (!cited.contains(reference.key)) continue;
      const auto [made, is_new] = references_.try_emplace(&reference);
      if (is_new) {
        made->second = noted(column_.reference(reference));
        made->second.of = &reference;
        tell_cost_of(made->second);
      }
      pieces.push_back(&made->second);
    }
  }

  Whole made_whole(std::size_t i, const TextColumn& column) {
    const Step& step = request_.stage.steps[i];
    const int number = static_cast<int>(i) + 1;
    const bool is_present = i == last_ || figured(request_, number);
    const Equation* first = focus_of(request_.stage, step);
    const auto focus_on = [&](const Equation& equation) {
      if (!is_in_focus(request_.stage, step, equation)) return Focus::none;
      return is_present                                            ? Focus::now
             : std::holds_alternative<FadingIn>(request_.entrance) ? Focus::before
                                                                   : Focus::none;
    };
    const std::vector<std::string> marked = is_present ? marked_by(step) : std::vector<std::string>();
    Whole made;
    const auto take = [&](Result<ColumnPiece> set, const Block& block) {
      ColumnPiece piece = noted(std::move(set));
      piece.of = &block;
      tell_cost_of(piece);
      piece.is_main = first && std::get_if<Equation>(&block) == first;
      piece.is_new = is_present;
      piece.step = number;
      (std::holds_alternative<Footnote>(block) ? made.notes : made.text).push_back(std::move(piece));
    };
    if (!step.title.empty() && !is_slide()) {
      made.text.push_back(noted(column_.step_title(step.title)));
      made.text.back().of = &step.title;
      made.text.back().is_new = is_present;
      made.text.back().step = number;
      tell_cost_of(made.text.back());
    }
    for (const Block& block : step.blocks) {
      if (const auto* equation = std::get_if<Equation>(&block))
        take(
            column.equation(*equation, focus_on(*equation), marked, verdicts_on(*equation, step, is_present)),
            block);
      if (const auto* claim = std::get_if<Claim>(&block); claim && !has_equation(step, claim->equation))
        take(verdict(*claim, step, is_present), block);
      if (const auto* prose = std::get_if<Prose>(&block)) take(column.prose(prose->text), block);
      if (const auto* callout = std::get_if<Callout>(&block))
        take(
            column.callout(*callout, std::string(label_of(request_.lesson, callout->kind)), is_for_readers()),
            block);
      if (const auto* ask = std::get_if<Ask>(&block)) {
        take(column.question(*ask), block);
        if (ask == request_.derivation.ask && is_present) add_derivation(made.text);
      }
      if (const auto* note = std::get_if<Footnote>(&block)) take(column.footnote(*note), block);
    }
    return made;
  }

  void add_derivation(Pieces& pieces) {
    for (const ShownDerivedLine& line : request_.derivation.lines) {
      const auto formula = parse_math(line.tex, request_.lesson.macros, language());
      if (!formula) continue;  // it was set before it came here
      pieces.push_back(noted(column_.derived_line(*formula, line.word, line.certainty)));
      pieces.back().is_new = true;
      tell_cost_of(pieces.back());
    }
  }

  Pieces verdicts_on(const Equation& equation, const Step& step, bool is_present) const {
    Pieces pieces;
    for (const Block& block : step.blocks)
      if (const auto* claim = std::get_if<Claim>(&block);
          claim && claim->equation == equation.id &&
          !(is_slide() && is_beside(*claim, parts_.verdicts.at(claim))))
        pieces.push_back(verdict(*claim, step, is_present));
    return pieces;
  }

  /// Numbers of both sides are for a window, where they follow the motion: neither from the back row nor on
  /// paper do they tell what the badge does not. A slide has no room either for what is claimed beside a
  /// formula; that it is not the formula itself the slide says. On a page to read a counterexample stands if
  /// it has room on the line of its badge: the figure shows it as well.
  ColumnPiece verdict(const Claim& claim, const Step& step, bool is_present) const {
    const Scene* scene = scene_on_page(step);
    // Numbers of other quantities than the formula's would be taken for those of its sides.
    const bool is_print = is_slide() || request_.before;
    const bool has_numbers =
        !is_print && is_present && scene && !claim.in_other_words && can_be_shown(claim, *scene);
    VerdictRow row = parts_.verdicts.at(&claim);
    if (is_print && claim.kind == ClaimKind::measured && row.certainty == Certainty::stated) row.note.clear();
    if (is_slide() && !row.claimed.empty()) {
      const Phrase how = claim.origin == Claim::Origin::part ? words::kInPart : words::kInOtherWords;
      row.note = std::string(how.in(language())) + (row.note.empty() ? std::string() : ", " + row.note);
      row.claimed.clear();
    }
    ColumnPiece piece = column_.verdict(row, has_numbers);
    if (!request_.before || row.example.empty()) return piece;
    row.example.clear();
    ColumnPiece brief = column_.verdict(row, has_numbers);
    return brief.height < piece.height ? brief : piece;
  }

  /// Of the present step that of the page, which a hand may have changed; where it is only tried, and of
  /// others, the step's own.
  const Scene* scene_on_page(const Step& step) const {
    return request_.model && &step == &present() ? &request_.model->scene : step.scene.get();
  }

  void tell_cost_of(const ColumnPiece& piece) const {
    std::size_t glyphs = 0;
    for (const PlacedType& text : piece.sheet.texts) glyphs += text.list.glyphs.size();
    spend(request_.effort, kGlyphEvaluations * static_cast<std::int64_t>(glyphs));
  }

  /// The first of its step on the page has the step's title; what is given is not said twice in a row.
  const ColumnPiece& earlier(const Recalled& recalled, const Recalled* above) {
    const Step& step = *recalled.of;
    EarlierLabel label = label_of_earlier(parts_.verdicts, *recalled.equation, step, language());
    if (above && above->of == recalled.of) label.title.clear();
    if (above && !label.note.empty()) {
      const EarlierLabel last = label_of_earlier(parts_.verdicts, *above->equation, *above->of, language());
      if (last.note == label.note) label.note = words::kUnderTheSameConditions.in(language());
    }
    const auto [made, is_new] = earlier_.try_emplace({recalled.equation, label.title + label.note});
    if (!is_new) return made->second;
    ColumnPiece piece = noted(column_.earlier_equation(*recalled.equation, label));
    piece.of = block_of(step, *recalled.equation);
    piece.is_main = recalled.equation == focus_of(request_.stage, step);
    tell_cost_of(piece);
    return made->second = std::move(piece);
  }

  static const Block* block_of(const Step& step, const Equation& equation) {
    const auto found = std::find_if(step.blocks.begin(), step.blocks.end(), [&](const Block& block) {
      return std::get_if<Equation>(&block) == &equation;
    });
    return &*found;
  }

  const PageRequest& request_;
  const TextParts& parts_;
  const Fonts& fonts_;
  double width_, em_, scale_;
  TextColumn column_;
  Status status_ = success();  ///< of the first text that could not be set
  std::size_t last_;           ///< index of the step
  Pieces heading_;             ///< header and title
  ColumnPiece footnote_rule_;
  std::map<std::pair<std::size_t, int>, Whole> whole_;  ///< by step and what its footnotes count from
  std::map<std::pair<const Equation*, std::string>, ColumnPiece> earlier_;  ///< by what is said of them
  std::map<std::string, ColumnPiece> in_words_;
  std::map<const Reference*, ColumnPiece> references_;
};

Failure<std::string> too_much(const PageRequest& request) {
  return failure(
      fmt::format("stage \"{}\": step {} has more text than a page holds", request.stage.id, request.step));
}

}  // namespace

Result<FittedText> fit_text(const PageRequest& request, double width, double height, double em,
                            const Fonts& fonts) {
  const TextParts parts = parts_of(request, fonts);
  const auto text_at = [&](double scale) { return ScaledText(request, parts, width, em, scale, fonts); };
  const auto fitted = [&request, height](ScaledText& text, const Selection& shown) {
    if (request.before && stands_side_by_side(request.size)) text.sink_if_short(shown, height);
    return FittedText{text.stacked(shown),
                      text.scale(),
                      text.formula_scale(shown),
                      text.equations_in(shown),
                      static_cast<int>(shown.whole_from) + 1,
                      {0, 0},
                      0,
                      0,
                      0,
                      0,
                      request.before ? text.step_tops(shown) : std::vector<double>()};
  };
  if (request.scrolls) return text_at(1.0).scrolled(height);
  std::optional<FittedText> best;
  std::size_t best_rank = 0;
  for (const double scale : std::array{1.0, 0.93, kLeastScale}) {
    ScaledText text = text_at(scale);
    const auto most = text.most(height);
    if (!most) return failure(most.error());
    const auto& shown = *most;
    if (!shown || (best && shown->rank() >= best_rank)) continue;
    best_rank = shown->rank();
    best = fitted(text, *shown);
    if (best_rank == 0 || request.before) break;
  }
  if (best) return std::move(*best);
  const double least = kLeastOfAll / std::max(1.0, request.text_scale);
  for (double scale = kSmaller * kLeastScale; scale > least; scale *= kSmaller) {
    ScaledText text = text_at(scale);
    const auto shown = text.most(height);
    if (!shown) return failure(shown.error());
    if (*shown) return fitted(text, **shown);
  }
  return too_much(request);
}

Result<std::vector<double>> heights_of_pages(const PageRequest& request, double width, double height,
                                             double em, const Fonts& fonts) {
  const TextParts parts = parts_of(request, fonts);
  return ScaledText(request, parts, width, em, 1.0, fonts).heights_back(height);
}

std::string answers_at_foot(const PageRequest& request, int first) {
  if (!request.before) return {};
  const std::vector<Stage>& stages = request.lesson.stages;
  std::string lines;
  const auto add = [&](const Stage& stage, std::size_t number) {
    if (const std::string answers = short_answers(request.lesson, stage); !answers.empty())
      lines += (lines.empty() ? "" : ". ") +
               words::kAnswersToStage.with(request.lesson.about.language, {std::to_string(number), answers});
  };
  const auto number = static_cast<std::size_t>(request.number);
  if (first == 1 && number > 1) add(stages[number - 2], number - 1);
  if (number == stages.size() && request.step == std::ssize(request.stage.steps)) add(request.stage, number);
  return lines;
}

void scroll_to(FittedText& text, double hidden) {
  const double wanted = std::clamp(std::round(hidden), 0.0, text.overflow);
  text.corner.y() += text.hidden - wanted;
  text.hidden = wanted;
}

Result<bool> fits_slide(const PageRequest& request, double width, double height, double em,
                        double least_formula, bool has_to_recall, const Fonts& fonts) {
  const TextParts parts = parts_of(request, fonts);
  ScaledText text(request, parts, width, em, request.slide_type->scale, fonts);
  const auto made = text.slide(height, has_to_recall);
  if (!made) return failure(made.error());
  return made->has_value() && (*made)->formula_scale >= least_formula;
}

Result<FittedText> fit_slide(const PageRequest& request, double scale, double width, double height, double em,
                             const Fonts& fonts) {
  const TextParts parts = parts_of(request, fonts);
  for (; scale > kLeastOfAll; scale *= kSmaller) {
    ScaledText text(request, parts, width, em, scale, fonts);
    auto made = text.slide(height);
    if (!made) return failure(made.error());
    if (*made) return **std::move(made);
  }
  return too_much(request);
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "app/page/text/text_column.h"

#include "base/ascii.h"
#include "base/words/page_words.h"
#include "lessons/reader/markdown/footnotes.h"
#include "lessons/reader/questions/state_keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace polhode {

namespace {

// Relative to the em of prose.
constexpr double kTitleSize = 1.62;
constexpr double kSlideTitleSize = 1.3;
constexpr double kDisplaySize = 1.34;
constexpr double kEarlierSize = 1.0;
constexpr double kCalloutSize = 0.94;
constexpr double kLabelSize = 0.62;
constexpr double kFootnoteSize = 0.74;
constexpr double kFootnoteRule = 4.1;  ///< length of the line above footnotes
constexpr double kTagSize = 1.0;
constexpr double kVerdictSize = 0.66;
constexpr double kVerdictLine = 1.35;  ///< of its size
constexpr double kChipHeight = 1.55;   ///< likewise
constexpr float kChipTint = 0.12F;     ///< of the ink, on the paper
constexpr double kClaimedSize = 0.7;   ///< of what is claimed beside the formula
constexpr double kClaimedGap = 0.3;    ///< above each of its rows, of its size
constexpr double kVerdictGap = 0.3, kSlideVerdictGap = 0.36;
constexpr double kWidestTag = 0.4;  ///< of the column
constexpr double kStepTitleGap = 1.15;
constexpr double kStepTitleCloser = 0.34;  ///< to its own text than that to what is above
constexpr double kParagraphGap =
    0.87;  // to the eye as wide as `between` below: those are lines without tails
constexpr double kDisplayGap = 0.78;
constexpr double kLineTop = 0.74;     ///< of a line without tall letters, above its baseline
constexpr double kLineBottom = 0.24;  ///< and below it
constexpr double kLabelIndent = 4.1;
constexpr double kLabelGap = 0.45, kBarGap = 0.55;  ///< before the bar of what has a name, and behind it
constexpr double kFormulaClearance = 0.5;           ///< between formulas with fractions, one below the other
constexpr double kEarlierGap = 0.62;                ///< between equations of earlier steps
constexpr double kLabelRoom = 0.36;                 ///< of the column, for what they are
constexpr double kLeastBeside = 5.0;                ///< of that room
constexpr double kLeastScaleBeside = 0.85;
constexpr double kEarlierLabelSize = 0.7;
constexpr double kBesideGap = 0.6;
constexpr double kBetweenLines = 0.35;  ///< of their size: what is free between two of them
constexpr double kBarIndent = 0.6;
constexpr double kBeforeSize = 0.86;
constexpr double kLeastBefore = 0.72;    ///< of its size: what is too wide for the column
constexpr double kBeforeLeading = 1.45;  ///< of the words, where the formula stands below them
constexpr double kPanelPad = 0.5;

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Result<DisplayList> or_why_not(Result<DisplayList, std::vector<TypeError>> set) {
  if (!set) return failure("this text cannot be set: " + set.error().front().message);
  return std::move(set).value();
}

/// Boxes behind the glyphs of the terms of these names.
void mark(const DisplayList& list, const Vec2& at, const std::vector<std::string>& names, double em,
          const Color& color, const Fonts& fonts, Sheet& sheet) {
  for (std::size_t i = 0; i < list.names.size(); ++i) {
    if (std::find(names.begin(), names.end(), list.names[i]) == names.end()) continue;
    DisplayList term;
    const auto is_of_term = [&](const auto& part) { return part.naming.term == static_cast<int>(i); };
    std::copy_if(list.glyphs.begin(), list.glyphs.end(), std::back_inserter(term.glyphs), is_of_term);
    std::copy_if(list.rules.begin(), list.rules.end(), std::back_inserter(term.rules), is_of_term);
    const TypeBox box = ink_box(term, fonts);
    if (box.empty()) continue;
    const double pad = 0.16 * em;
    sheet.shapes.push_back(Area{
        rectangle(at.x() + box.x0 - pad, at.y() + box.y0 - pad, at.x() + box.x1 + pad, at.y() + box.y1 + pad),
        color});
  }
}

/// The parts of a formula between which it can be broken: each but the first begins with a relation, plus or
/// minus that stands in no bracket.
std::vector<std::string> terms_of(std::string_view tex) {
  std::vector<std::string> terms(1);
  int depth = 0;
  bool after_operand = false;
  for (std::size_t i = 0; i < tex.size();) {
    std::size_t length = 1;
    if (tex[i] == '\\') {
      while (i + length < tex.size() && std::isalpha(static_cast<unsigned char>(tex[i + length])) != 0)
        ++length;
      length = std::max<std::size_t>(length, 2);
    }
    const std::string_view token = tex.substr(i, length);
    depth += token == "{" || token == "(" || token == "["   ? 1
             : token == "}" || token == ")" || token == "]" ? -1
                                                            : 0;
    static constexpr std::array<std::string_view, 8> kSigns = {"=",    "+",    "-",        "\\le",
                                                               "\\ge", "\\ne", "\\approx", "\\Rightarrow"};
    const bool is_sign = std::find(kSigns.begin(), kSigns.end(), token) != kSigns.end();
    if (is_sign && depth == 0 && after_operand) terms.emplace_back();
    if (token != " ") after_operand = !is_sign;
    terms.back() += token;
    i += length;
  }
  // A formula between dollars does not end with a blank.
  for (std::string& term : terms) term.erase(term.find_last_not_of(' ') + 1);
  return terms;
}

/// An equation lower by so much in a place that is higher by so much.
ColumnPiece lowered(ColumnPiece piece, double by, double more) {
  ColumnPiece placed{.sheet = {},
                     .height = piece.height + more,
                     .gap = piece.gap,
                     .formula_scale = piece.formula_scale,
                     .formula = piece.formula};
  add(placed, std::move(piece), {0, by});
  return placed;
}

}  // namespace

TextStyle TextColumn::style(double size, Color color, double width) const {
  TextStyle style;
  style.size = size;
  style.color = color;
  style.width = width;
  style.between = 0.38;
  style.link_color = colors().question;
  style.symbols = &symbols_;
  return style;
}

std::vector<MathSymbol> TextColumn::symbols_in(const Color& color) const {
  std::vector<MathSymbol> symbols = symbols_;
  for (MathSymbol& symbol : symbols) symbol.color = color;
  return symbols;
}

Result<DisplayList> TextColumn::set(const RichText& text, const TextStyle& style) const {
  RichText shown = numbers_.put_into(text);
  if (notes_before_ > 0)
    for_each_span(shown, [&](TextSpan& span) {
      for (int number = notes_before_ + 1; number <= notes_before_ + static_cast<int>(kMaxFootnotes);
           ++number)
        if (span.text == raised_number(number)) {
          span.text = mark_of_note(number);
          break;
        }
    });
  return or_why_not(set_text(shown, style, fonts_));
}

std::string TextColumn::mark_of_note(int number) const { return raised_number(number - notes_before_); }

TextColumn TextColumn::with_notes_after(int before) const {
  TextColumn column = *this;
  column.notes_before_ = before;
  return column;
}

void TextColumn::take_rooms(DisplayList& list, const Vec2& at, ColumnPiece& piece) const {
  for (LiveRoom room : numbers_.take_rooms(list)) {
    room.at += at;
    piece.numbers.push_back({&numbers_.lesson().numbers[static_cast<std::size_t>(room.id)], room});
  }
}

Result<ColumnPiece> TextColumn::piece_of(Result<DisplayList> list, double em, double gap) const {
  if (!list) return failure(list.error());
  ColumnPiece piece;
  const double top = std::round(std::max(list->ascent, kLineTop * em));
  piece.height = top + std::round(std::max(list->depth, kLineBottom * em));
  piece.gap = gap;
  take_rooms(*list, {0, top}, piece);
  piece.sheet.texts.push_back({.list = std::move(list).value(), .at = {0, top}});
  return piece;
}

Result<ColumnPiece> TextColumn::title(const RichText& title) const {
  const double em = (profile_ == Profile::slides ? kSlideTitleSize : kTitleSize) * size_;
  TextStyle bold = style(em, colors().ink, width_);
  bold.bold = true;
  bold.leading = 1.2;
  return piece_of(set(title, bold), em, 0.55 * em);
}

Result<ColumnPiece> TextColumn::step_title(const RichText& title) const {
  TextStyle bold = style(size_, colors().ink, width_);
  bold.bold = true;
  bold.leading = 1.2;
  Result<ColumnPiece> piece = piece_of(set(title, bold), size_, kStepTitleGap * size_);
  if (piece) piece->height -= std::round(kStepTitleCloser * size_);
  return piece;
}

Result<ColumnPiece> TextColumn::prose(const RichText& text) const {
  return piece_of(set(text, style(size_, colors().ink, width_)), size_, kParagraphGap * size_);
}

/// As large as it can be within `room`: a little smaller on one line before it is broken, then smaller.
Result<TextColumn::Formula> TextColumn::formula(const Equation& equation, double size, double room) const {
  MathStyle style{.size = size,
                  .display = true,
                  .color = colors().ink,
                  .strike = colors().accent,
                  .line_width = room,
                  .symbols = &symbols_};
  const Math math = numbers_.put_into(equation.math);
  Result<DisplayList> list = or_why_not(set_math(math, style, fonts_));
  // "= 0" alone on a second line would read as a formula of its own.
  constexpr double kLeastUnbroken = 0.88;
  MathStyle whole = style;
  whole.line_width = 0;
  if (const auto unbroken = or_why_not(set_math(math, whole, fonts_));
      unbroken && unbroken->width > room && unbroken->width * kLeastUnbroken <= room) {
    style = whole;
    list = unbroken;
  }
  constexpr int kMostTries = 8;  // a smaller formula may be broken elsewhere
  for (int i = 0; i < kMostTries && list && list->width > room; ++i) {
    style.size *= 0.999 * room / list->width;
    list = or_why_not(set_math(math, style, fonts_));
  }
  if (!list) return failure(list.error());
  return Formula{std::move(list).value(), style.size / size};
}

Result<ColumnPiece> TextColumn::numbered(const Equation& equation, double size,
                                         const std::vector<std::string>& marked, double left) const {
  DisplayList tag;
  if (!equation.tag.empty()) {
    TextStyle quiet = style(kTagSize * size_, colors().quiet, 0);
    tag = set_line("(" + equation.tag + ")", quiet, fonts_);
    if (tag.width > kWidestTag * width_) {
      quiet.size *= kWidestTag * width_ / tag.width;
      tag = set_line("(" + equation.tag + ")", quiet, fonts_);
    }
  }
  const double beside = equation.tag.empty() ? 0.0 : tag.width + size_;
  Result<Formula> set = formula(equation, size, width_ - left - beside);
  if (!set) return failure(set.error());
  auto [list, formula_scale] = std::move(set).value();
  // In the middle, unless it would run into its number.
  const double x = std::round(std::min(0.5 * (left + width_ - list.width), width_ - beside - list.width));
  const double top = std::round(std::max(list.ascent, kLineTop * size));
  ColumnPiece piece;
  piece.height = top + std::round(std::max(list.depth, kLineBottom * size));
  piece.gap = kDisplayGap * size_;
  piece.formula_scale = formula_scale;
  const Vec2 at(std::max(0.0, x), top);
  mark(list, at, marked, size, colors().marked, fonts_, piece.sheet);
  take_rooms(list, at, piece);
  if (!equation.tag.empty())
    piece.sheet.texts.push_back({.list = tag, .at = {std::round(width_ - tag.width), top}});
  piece.formula = piece.sheet.texts.size();
  piece.sheet.texts.push_back({.list = std::move(list), .at = at});
  return piece;
}

Color TextColumn::color_of(Certainty certainty) const {
  switch (certainty) {
    case Certainty::proved:
      return colors().meant;
    case Certainty::stated:
      return colors().quiet;
    case Certainty::refuted:
    case Certainty::open:
      return colors().accent;
  }
  return colors().quiet;
}

/// A word on a rounded ground, behind a tick if it is proved, a cross if it is wrong.
ColumnPiece TextColumn::chip(const std::string& word, Certainty certainty) const {
  const double em = small_size(kVerdictSize);
  const Color ink = color_of(certainty);
  TextStyle bold = style(em, ink, 0);
  bold.sans = bold.bold = true;
  DisplayList list = set_line(word, bold, fonts_);
  const double height = std::round(kChipHeight * em), pad = std::round(0.7 * em), y = 0.5 * height;
  const bool has_mark = certainty == Certainty::proved || certainty == Certainty::refuted;
  const double mark_width = has_mark ? std::round(1.0 * em) : 0.0;
  const double width = std::round(list.width + mark_width + 2.0 * pad);
  const double above = profile_ == Profile::slides ? kSlideVerdictGap : kVerdictGap;
  ColumnPiece piece{.sheet = {}, .height = height, .gap = above * size_};
  piece.sheet.shapes.push_back(Stroke{
      .points = {{y, y}, {width - y, y}}, .width = height, .color = between(colors().paper, ink, kChipTint)});
  const auto drawn = [&](std::vector<Vec2> points) {
    for (Vec2& point : points) point = Vec2(pad, y) + em * point;
    piece.sheet.shapes.push_back(Stroke{.points = std::move(points), .width = 0.14 * em, .color = ink});
  };
  if (certainty == Certainty::proved) drawn({{0.0, 0.02}, {0.22, 0.26}, {0.64, -0.3}});
  if (certainty == Certainty::refuted) {
    drawn({{0.05, -0.26}, {0.57, 0.26}});
    drawn({{0.05, 0.26}, {0.57, -0.26}});
  }
  piece.sheet.texts.push_back({.list = std::move(list), .at = {pad + mark_width, std::round(y + 0.36 * em)}});
  piece.width = width;
  return piece;
}

ColumnPiece TextColumn::verdict(const VerdictRow& row, bool is_live) const {
  const double em = small_size(kVerdictSize), gap = std::round(0.6 * em);
  TextStyle quiet =
      style(em,
            row.certainty == Certainty::proved || row.certainty == Certainty::stated ? colors().quiet
                                                                                     : colors().ink,
            width_);
  quiet.sans = true;
  quiet.leading = 1.3;
  quiet.symbols = nullptr;  // the slots outlive them
  ColumnPiece piece = chip(row.word, row.certainty);
  const double line = std::round(kVerdictLine * em);
  double baseline = piece.sheet.texts.front().at.y(), end = piece.width;
  // Nobody reads the numbers of an example from the back row.
  const bool has_example = !row.example.empty() && profile_ == Profile::page;
  const std::string words = has_example ? row.note + (row.note.empty() ? "" : ", ") + row.example : row.note;
  if (!words.empty()) {
    const std::vector<MathSymbol> symbols = symbols_in(quiet.color);
    TextStyle named = quiet;
    named.symbols = &symbols;
    DisplayList note = set_line(words, named, fonts_);
    Vec2 at(end + gap, baseline);
    if (at.x() + note.width > width_) {  // below, in as many lines as it takes
      note = set_lines(words, named, fonts_);
      at = {0, piece.height + std::round(0.3 * em + std::max(note.ascent, kLineTop * em))};
      piece.height = at.y() + std::round(std::max(note.depth, kLineBottom * em));
      end = width_;
    } else {
      end = at.x() + note.width;
    }
    piece.sheet.texts.push_back({.list = std::move(note), .at = at});
  }
  if (!row.claimed.empty()) {  // the verdict is about that, and stands below it
    TextStyle claimed = quiet;
    claimed.size = small_size(kClaimedSize);
    ColumnPiece both{.sheet = {}, .width = piece.width, .gap = piece.gap};
    add_claimed(row, claimed, both);
    const double top = both.height + std::round(kClaimedGap * em);
    append(both.sheet, std::move(piece.sheet), {0, top});
    both.height = top + piece.height;
    baseline += top;
    piece = std::move(both);
  }
  const std::vector<std::string> rows =
      is_live ? widest_live_rows(*row.claim, language_) : std::vector<std::string>();
  if (rows.empty()) return piece;

  double room = 0;
  for (const std::string& text : rows) room = std::max(room, set_line(text, quiet, fonts_).width);
  const bool is_beside = row.claimed.empty() && end + gap + room <= width_;
  if (!is_beside) {
    baseline = piece.height + std::round(0.9 * em);
    piece.height += line;
  }
  piece.height += line * static_cast<double>(rows.size() - 1);
  if (room > width_) quiet.size *= width_ / room;
  piece.live.push_back({row.claim, {width_, baseline}, std::min(room, width_), line, quiet});
  return piece;
}

/// "Proved: …": one formula beside the other, as many in a row as there is room for.
void TextColumn::add_claimed(const VerdictRow& verdict, const TextStyle& style, ColumnPiece& piece) const {
  const std::vector<std::string>& claimed = verdict.claimed;
  const double gap = std::round(kClaimedGap * style.size);
  std::string row = capitalized(verdict.claimed_is) + ": ";
  const auto end_row = [&] {
    TextStyle fitting = style;
    DisplayList list = set_line(row, fitting, fonts_);
    if (list.width > width_) {
      fitting.size *= width_ / list.width;
      list = set_line(row, fitting, fonts_);
    }
    const double baseline = std::ceil(piece.height + gap + list.ascent);
    piece.height = std::ceil(baseline + list.depth);
    piece.sheet.texts.push_back({.list = std::move(list), .at = {0, baseline}});
    row.clear();
  };
  const auto fits = [&](const std::string& more) {
    return set_line(row + more, style, fonts_).width <= width_;
  };
  for (std::size_t i = 0; i < claimed.size(); ++i) {
    const std::string end = i + 1 < claimed.size() ? ",  " : "";
    const std::string formula = '$' + claimed[i] + '$' + end;
    if (i > 0 && !fits(formula)) end_row();
    if (fits(formula)) {
      row += formula;
      continue;
    }
    // Over several rows, each as long as it can be, broken as a display is: before a relation or a sign.
    std::string part;
    for (const std::string& term : terms_of(claimed[i])) {
      if (!part.empty() && !fits('$' + part + term + '$')) {
        row += '$' + part + '$';
        end_row();
        part = "\\quad{}";
      }
      part += term;
    }
    row += '$' + part + '$' + end;
  }
  if (!claimed.empty()) end_row();
}

Result<ColumnPiece> TextColumn::equation(const Equation& equation, Focus focus,
                                         const std::vector<std::string>& marked,
                                         const std::vector<ColumnPiece>& verdicts) const {
  Result<ColumnPiece> set = numbered(equation, kDisplaySize * size_, marked);
  if (!set) return set;
  ColumnPiece plain = std::move(set).value();
  for (const ColumnPiece& verdict : verdicts) {
    const double top = plain.height + std::round(verdict.gap);
    add(plain, verdict, {0, top});
    plain.height = top + verdict.height;
  }
  if (focus == Focus::none) return plain;
  const double pad = std::round(kPanelPad * size_), bar = std::round(std::max(2.0, 0.17 * size_));
  const double left = -std::round(0.7 * size_), right = width_ + pad;
  ColumnPiece piece{.sheet = {},
                    .height = plain.height + 2.0 * pad,
                    .gap = 0.9 * plain.gap,
                    .formula_scale = plain.formula_scale,
                    .formula = plain.formula};
  if (focus == Focus::now)
    piece.sheet.shapes = {Area{rectangle(left, 0, right, piece.height), colors().panel},
                          Area{rectangle(left, 0, left + bar, piece.height), colors().accent}};
  piece.panel = piece.sheet.shapes.size();
  add(piece, std::move(plain), {0, pad});
  return piece;
}

DisplayList TextColumn::small_lines(const std::string& text, const Color& color, double room) const {
  TextStyle small = style(small_size(kEarlierLabelSize), color, room);
  small.sans = true;
  small.leading = kVerdictLine;
  const std::vector<MathSymbol> symbols = symbols_in(color);
  small.symbols = &symbols;
  return set_lines(text, small, fonts_);
}

DisplayList TextColumn::balanced_title(const std::string& title, double room) const {
  constexpr double kNarrower = 0.94, kLeast = 0.5;
  DisplayList lines = small_lines(title, colors().ink, room);
  const double height = lines.ascent + lines.depth;
  for (double narrow = kNarrower; narrow > kLeast; narrow *= kNarrower) {
    DisplayList narrower = small_lines(title, colors().ink, narrow * room);
    if (narrower.width > narrow * room || narrower.ascent + narrower.depth > height) break;
    lines = std::move(narrower);
  }
  return lines;
}

void TextColumn::add_kind(const EarlierLabel& label, double left, ColumnPiece& piece) const {
  const double room = width_ - left;
  const std::string whole = label.word + (label.note.empty() ? "" : ", " + label.note);
  DisplayList words = small_lines(whole, colors().quiet, room);
  if (words.width > room) words = small_lines(label.in_short, colors().quiet, room);
  if (words.glyphs.empty()) return;
  const PlacedType& formula = piece.sheet.texts[*piece.formula];
  const double middle = formula.at.x() + 0.5 * (formula.list.width - words.width),
               x = std::round(std::clamp(middle, left, std::max(left, width_ - words.width))),
               baseline = std::ceil(piece.height + kBetweenLines * words.ascent + words.ascent);
  piece.height = std::ceil(baseline + words.depth);
  piece.sheet.texts.push_back({.list = std::move(words), .at = {x, baseline}});
}

Result<ColumnPiece> TextColumn::earlier_equation(const Equation& equation, const EarlierLabel& label) const {
  const double size = kEarlierSize * size_, between = std::round(kBesideGap * size_);
  Result<ColumnPiece> set = numbered(equation, size, {});
  if (!set) return set;
  ColumnPiece piece = std::move(set).value();
  // With its kind below it, and the title so far above its first baseline.
  const auto with = [&](ColumnPiece formula, const DisplayList& title, double baseline, double left) {
    add_kind(label, left, formula);
    formula.gap = kEarlierGap * size_;
    if (title.glyphs.empty()) return formula;
    formula.height = std::max(formula.height, std::ceil(baseline + title.depth));
    formula.sheet.texts.insert(formula.sheet.texts.begin(), {.list = title, .at = {0, std::round(baseline)}});
    ++*formula.formula;
    return formula;
  };
  const double room = std::round(kLabelRoom * width_);
  if (room >= kLeastBeside * size_) {
    const DisplayList title = balanced_title(label.title, room);
    // All equations stand in one column, but where that is too narrow beside a short title.
    for (const double column : {room, std::min(room, std::ceil(title.width))}) {
      const double left = column + between;
      Result<ColumnPiece> beside = numbered(equation, size, {}, left);
      if (!beside) return beside;
      const bool is_whole =
          beside->formula_scale >= kLeastScaleBeside * piece.formula_scale && beside->height <= piece.height;
      if (!is_whole || title.width > room) continue;
      // The middles of both at one height.
      const double height = title.ascent + title.depth, over = std::ceil(height - beside->height),
                   lower = std::round(std::max(0.0, 0.5 * over)),
                   top = std::round(std::max(0.0, -0.5 * over));
      return with(lowered(std::move(beside).value(), lower, lower), title, top + title.ascent, left);
    }
  }
  if (label.title.empty()) return with(std::move(piece), {}, 0, 0);
  const DisplayList title = small_lines(label.title, colors().ink, width_);
  const double lower = std::ceil(title.ascent + title.depth + kBetweenLines * size_);
  return with(lowered(std::move(piece), lower, lower), title, title.ascent, 0);
}

Result<ColumnPiece> TextColumn::from_before(const Equation& equation, bool below) const {
  TextStyle quiet = style(small_size(kVerdictSize), colors().quiet, 0);
  quiet.sans = true;
  DisplayList words = set_line(std::string(words::kFromBefore.in(language_)), quiet, fonts_);
  // Symbols without a colour of their own are as quiet as the rest.
  std::vector<MathSymbol> symbols = symbols_;
  for (MathSymbol& symbol : symbols)
    if (symbol.color == colors().ink) symbol.color = colors().quiet;
  MathStyle math{
      .size = kBeforeSize * size_, .color = colors().quiet, .strike = colors().quiet, .symbols = &symbols};
  const auto set = [&] { return or_why_not(set_math(numbers_.put_into(equation.math), math, fonts_)); };
  Result<DisplayList> list = set();
  if (!list) return failure(list.error());
  if (below && list->width > width_ && width_ >= kLeastBefore * list->width) {
    math.size *= 0.999 * width_ / list->width;
    list = set();
    if (!list) return failure(list.error());
  }
  const double above = below ? std::round(kBeforeLeading * quiet.size) : 0.0;
  const double top = std::round(above + std::max(list->ascent, kLineTop * size_)),
               x = below ? 0.0 : std::round(words.width + 0.6 * size_);
  ColumnPiece piece{.sheet = {},
                    .height = top + std::round(std::max(list->depth, kLineBottom * size_)),
                    .width = x + list->width,
                    .gap = kParagraphGap * size_};
  take_rooms(*list, {x, top}, piece);
  piece.sheet.texts.push_back({.list = std::move(words), .at = {0, below ? std::round(quiet.size) : top}});
  piece.sheet.texts.push_back({.list = std::move(list).value(), .at = {x, top}});
  if (equation.tag.empty()) return piece;
  DisplayList tag = set_line("(" + equation.tag + ")", style(kBeforeSize * size_, colors().quiet, 0), fonts_);
  const double after = std::round(piece.width + size_);
  if (after + tag.width > width_) return piece;
  piece.width = after + tag.width;
  piece.sheet.texts.push_back({.list = std::move(tag), .at = {after, top}});
  return piece;
}

/// Where small type is held at what can be read, the names beside the bars need more of the column: in the
/// same room "Question" was broken in the word.
double TextColumn::label_indent() const {
  if (profile_ == Profile::slides) return std::round(kBarIndent * size_);
  const double larger = small_size(kLabelSize) / (kLabelSize * size_) - 1.0;
  return std::round((kLabelIndent + larger * (kLabelIndent - kLabelGap - kBarGap)) * size_);
}

/// `plain` behind a bar, with its name on the left of it; on a slide the name stands above.
Result<ColumnPiece> TextColumn::labelled(const std::string& label, const Color& color,
                                         Result<ColumnPiece> plain) const {
  if (!plain) return plain;
  if (profile_ == Profile::slides) {
    TextStyle small = style(small_size(kLabelSize), color, 0);
    small.sans = small.bold = true;
    const double top = std::round(small.size), line = std::round(1.75 * small.size);
    ColumnPiece piece{.sheet = {}, .height = line + plain->height, .gap = plain->gap};
    piece.sheet.shapes.push_back(Stroke{
        .points = {{2, 2}, {2, piece.height - 2}}, .width = std::max(1.5, 0.09 * size_), .color = color});
    piece.sheet.texts.push_back({.list = set_line(label, small, fonts_), .at = {label_indent(), top}});
    add(piece, std::move(plain).value(), {label_indent(), line});
    return piece;
  }
  const double indent = label_indent(), bar = indent - std::round(kBarGap * size_);
  TextStyle small = style(small_size(kLabelSize), color, 0);
  small.sans = small.bold = true;
  small.leading = 1.2;
  const double baseline = plain->sheet.texts.front().at.y();
  DisplayList name = set_line(label, small, fonts_);
  if (const double room = bar - std::round(kLabelGap * size_); name.width > room) {  // in several lines
    small.width = room;
    TextSpan span;
    span.text = label;
    Result<DisplayList> lines = set({TextBlock{.indent = 0, .marker = {}, .spans = {span}}}, small);
    if (!lines) return failure(lines.error());
    name = std::move(lines).value();
  }
  const double name_end = std::ceil(baseline + name.depth + 0.1 * size_);
  ColumnPiece piece{.sheet = {}, .height = std::max(plain->height, name_end), .gap = plain->gap};
  piece.sheet.shapes.push_back(Stroke{
      .points = {{bar, 1}, {bar, piece.height - 1}}, .width = std::max(1.5, 0.09 * size_), .color = color});
  piece.sheet.texts.push_back({.list = std::move(name), .at = {0, baseline}});
  add(piece, std::move(plain).value(), {indent, 0});
  return piece;
}

Result<ColumnPiece> TextColumn::callout(const Callout& callout, const std::string& label,
                                        bool in_full) const {
  using Kind = Callout::Kind;
  const Color& color = callout.kind == Kind::said || callout.kind == Kind::quote ? colors().said
                       : callout.kind == Kind::meant                             ? colors().meant
                                                                                 : colors().quiet;
  const double em = kCalloutSize * size_;
  const double width = width_ - label_indent();
  const RichText& shown = callout.kind == Kind::derivation && !in_full ? callout.title : callout.text;
  return labelled(label, color,
                  piece_of(set(shown, style(em, colors().ink, width)), em, kParagraphGap * size_));
}

Result<ColumnPiece> TextColumn::footnote(const Footnote& note) const {
  const double em = small_size(kFootnoteSize);
  TextStyle small = style(em, colors().ink, width_);
  small.leading = 1.35;
  RichText text = note.text;
  if (!text.empty()) {
    text.front().marker = mark_of_note(note.number);
    text.front().indent = 1;
  }
  return piece_of(set(text, small), em, 0.3 * em);
}

ColumnPiece TextColumn::small_words(const std::string& text) const {
  const double em = small_size(kFootnoteSize);
  TextStyle small = style(em, colors().quiet, width_);
  small.leading = 1.35;
  return *piece_of(set_lines(text, small, fonts_), em, 0.3 * em);
}

Result<ColumnPiece> TextColumn::reference(const Reference& reference) const {
  const double em = small_size(kFootnoteSize);
  TextStyle small = style(em, colors().quiet, width_);
  small.leading = 1.35;
  TextSpan span;
  span.text = fmt::format("[{}] {}", reference.key, reference.text);
  TextBlock line;
  line.spans.push_back(std::move(span));
  return piece_of(set({std::move(line)}, small), em, 0.3 * em);
}

ColumnPiece TextColumn::footnote_rule() const {
  const double thickness = std::max(1.0, std::round(0.045 * size_)), y = 0.5 * thickness;
  ColumnPiece piece{.sheet = {}, .height = thickness, .gap = 0.55 * size_};
  piece.sheet.shapes.push_back(Stroke{.points = {{0, y}, {std::round(kFootnoteRule * size_), y}},
                                      .width = thickness,
                                      .color = colors().line});
  return piece;
}

Result<ColumnPiece> TextColumn::question(const Ask& ask) const {
  const double em = kCalloutSize * size_;
  const double width = width_ - label_indent();
  RichText text = without_goals(ask);
  for (std::size_t i = 0; i < ask.choice_texts.size(); ++i) {
    RichText choice = ask.choice_texts[i];
    if (!choice.empty()) {
      choice.front().marker = std::string(1, letter_of_choice(i)) + ".";
      choice.front().indent = 1;
    }
    text.insert(text.end(), choice.begin(), choice.end());
  }
  TextStyle plain = style(em, colors().ink, width);
  plain.between = 0.28;
  if (ask.type == Ask::Type::derive) plain.clearance = kFormulaClearance;
  Result<ColumnPiece> piece = labelled(std::string(words::kQuestionLabel.in(language_)), colors().question,
                                       piece_of(set(text, plain), em, 0.7 * size_));
  if (!piece || least_ == 0 || profile_ == Profile::slides) return piece;
  QuestionRows rows{&ask, label_indent(), width_, {}};
  if (!picks_choice(ask.type)) rows.y.push_back(0);
  RichText above = without_goals(ask);
  for (const RichText& choice : ask.choice_texts) {
    if (!picks_choice(ask.type)) break;
    const Result<ColumnPiece> so_far = piece_of(set(above, plain), em, 0);
    if (!so_far) return failure(so_far.error());
    rows.y.push_back(so_far->height);
    above.insert(above.end(), choice.begin(), choice.end());
  }
  rows.y.push_back(piece->height);
  piece->questions.push_back(std::move(rows));
  return piece;
}

Result<ColumnPiece> TextColumn::derived_line(const Math& formula, const std::string& word,
                                             Certainty certainty) const {
  const double left = label_indent(), room = width_ - left;
  MathStyle style{.size = size_,
                  .display = true,
                  .color = word.empty() ? colors().quiet : colors().ink,
                  .strike = colors().accent,
                  .line_width = room,
                  .symbols = &symbols_};
  Result<DisplayList> list = or_why_not(set_math(formula, style, fonts_));
  if (list && list->width > room) {
    style.size *= 0.999 * room / list->width;
    list = or_why_not(set_math(formula, style, fonts_));
  }
  if (!list) return failure(list.error());
  const double top = std::round(std::max(list->ascent, kLineTop * size_));
  ColumnPiece piece;
  piece.height = top + std::round(std::max(list->depth, kLineBottom * size_));
  piece.gap = 0.45 * size_;
  const double end = left + list->width;
  piece.sheet.texts.push_back({.list = std::move(list).value(), .at = {left, top}});
  if (word.empty()) return piece;
  ColumnPiece verdict = chip(word, certainty);
  const double gap = std::round(0.7 * size_);
  if (end + gap + verdict.width <= width_) {
    const double y = std::round(top - 0.3 * size_ - 0.5 * verdict.height);
    add(piece, std::move(verdict), {end + gap, std::max(0.0, y)});
  } else {
    const double y = piece.height + std::round(0.2 * size_);
    piece.height = y + verdict.height;
    add(piece, std::move(verdict), {left, y});
  }
  return piece;
}

double TextColumn::small_size(double part) const { return std::max(part * size_, std::min(least_, size_)); }

}  // namespace polhode

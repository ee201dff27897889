// SPDX-License-Identifier: MIT
#include "app/publish/text_edition/lesson_html.h"

#include "base/ascii.h"
#include "base/utf8.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/reader/markdown/footnotes.h"
#include "render/palette.h"
#include "render/typeset/characters.h"
#include "render/typeset/line_formulas.h"
#include "render/typeset/math/mathml.h"
#include "render/typeset/math/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace polhode {

namespace {

/// Schemes that open a page or a mail, and run nothing.
bool leads_to_the_web(std::string_view link) {
  constexpr std::array<std::string_view, 3> kSchemes = {"https://", "http://", "mailto:"};
  return std::any_of(kSchemes.begin(), kSchemes.end(),
                     [&](std::string_view scheme) { return link.starts_with(scheme); });
}

/// Of "2." or "2)" the number; nothing of a bullet.
std::optional<int> number_of(const std::string& marker) {
  int number = 0;
  const auto read = std::from_chars(marker.data(), marker.data() + marker.size(), number);
  if (read.ec != std::errc{}) return std::nullopt;
  return number;
}

/// Of a formula: as many as are printed, scripts and all.
int signs_of(std::string_view mathml) {
  int signs = 0;
  bool in_tag = false;
  for (const char c : mathml.substr(0, mathml.find("<annotation"))) {
    if (c == '<' || c == '>')
      in_tag = c == '<';
    else if (!in_tag && starts_character(c))
      ++signs;
  }
  return signs;
}

/// Some 250 px at the size of the text, 300 px with its letters spaced as readers may (WCAG 2.2, 1.4.12):
/// what is longer may be wider than a narrow screen, where browsers break a formula only if it is in pieces.
constexpr int kMostSigns = 16;

/// Browsers break lines before and after a formula, even where a bracket, a full stop or a unit touches it:
/// those stay with it, as far as that is not too long for a narrow screen.
std::string kept_together(std::string_view line) {
  constexpr std::string_view kBegin = "<math ", kEnd = "</math>", kLong = "<span class=\"long\">";
  std::string html;
  for (std::size_t at = 0;;) {
    const std::size_t begin = line.find(kBegin, at);
    if (begin == line.npos) return html += line.substr(at);
    std::size_t from = begin, end = begin;
    while (from > at && line[from - 1] != ' ' && line[from - 1] != '\n' && line[from - 1] != '>') --from;
    auto signs = static_cast<int>(begin - from);
    bool touched = from < begin;
    do {  // formulas that touch each other are one word
      const std::size_t after = line.find(kEnd, end) + kEnd.size();
      signs += signs_of(line.substr(end, after - end));
      end = after;
      for (; end < line.size() && line[end] != ' ' && line[end] != '\n' && line[end] != '<'; ++end) ++signs;
      touched = touched || end > after || line.substr(end).starts_with(kBegin);
    } while (line.substr(end).starts_with(kBegin));
    html += line.substr(at, from - at);
    const std::string_view word = line.substr(from, end - from);
    const bool fits = signs <= kMostSigns && !html.ends_with(kLong);
    html += touched && fits ? fmt::format("<span class=\"word\">{}</span>", word) : std::string(word);
    at = end;
  }
}

/// As much of a text as is a unit, "kg m²/s" of "kg m²/s, and so on"; 0: it begins with none.
std::size_t unit_at(std::string_view text) {
  constexpr std::string_view kEnds = " \n,;:!?)";
  std::size_t end = 0;
  for (std::size_t next = 0; next <= text.size();) {
    next = std::min(text.find_first_of(kEnds, next), text.size());
    std::string_view unit = text.substr(0, next);
    if (unit.ends_with('.')) unit.remove_suffix(1);
    if (unit.empty() || is_digit(unit.front()) || !(unit == "%" || scaled_unit(unit))) break;
    end = unit.size();
    if (next == text.size() || text[next] != ' ') break;
    ++next;
  }
  return end;
}

/// "3" of "axis 3", which tells one of several: one or two digits alone.
bool begins_with_place(std::string_view text) {
  std::size_t digits = 0;
  while (digits < text.size() && is_digit(text[digits])) ++digits;
  const std::string_view behind = text.substr(digits);
  const bool goes_on =
      !behind.empty() && (is_letter(behind[0]) || (behind.size() > 1 && is_digit(behind[1])));
  return (digits == 1 || digits == 2) && !goes_on;
}

constexpr char32_t kBegin = U' ', kFormula = 0;  // what stands before a text

/// Words as they are set: no line breaks between a number and its unit, nor within that, nor between "axis"
/// and "3"; quotation marks are curled. `last` is the character before them; a formula there may be a number.
std::string as_set(std::string_view text, char32_t last) {
  constexpr std::string_view kNoBreak = "\u00A0";
  const auto is_ascii = [](char32_t c, bool (*is)(char)) { return c < 0x80 && is(static_cast<char>(c)); };
  std::string set;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const char32_t c = next_character(text, at);
    const std::string_view behind = text.substr(at);
    const bool is_behind_number = last == kFormula || is_ascii(last, is_digit);
    const std::size_t unit = c == U' ' && is_behind_number ? unit_at(behind) : 0;
    const bool is_before_place = c == U' ' && is_ascii(last, is_letter) && begins_with_place(behind);
    if (unit > 0 || is_before_place)
      set += kNoBreak;
    else if (const char32_t curly = curled(c, last); curly != c)
      append_utf8(set, curly);
    else
      set += text.substr(begin, at - begin);
    for (const char of_unit : behind.substr(0, unit))
      set += of_unit == ' ' ? kNoBreak : std::string_view(&of_unit, 1);
    at += unit;
    last = unit > 0 ? U'm' : c;
  }
  return set;
}

char32_t last_of(std::string_view text) {
  std::size_t at = text.size();
  while (at > 0 && !starts_character(text[--at])) continue;
  return text.empty() ? kBegin : next_character(text, at);
}

/// A word, "From", which says what the item is to the others.
bool is_word(const std::string& marker) { return !marker.empty() && is_letter(marker.front()); }

/// The lists that are open, one in an item of the other.
class Lists {
 public:
  explicit Lists(std::string& html) : html_(html) {}

  /// Before a block of this depth.
  void close_to(std::size_t depth) {
    while (open_.size() > depth) close();
  }

  void begin_item(std::size_t depth, const std::string& marker) {
    const std::optional<int> number = number_of(marker);
    close_to(depth);
    if (open_.size() == depth && open_.back().is_numbered != number.has_value()) close();
    if (open_.size() == depth && number && *number <= open_.back().last) close();
    if (open_.size() == depth) html_ += "</li>\n";
    while (open_.size() < depth) {
      open_.push_back({number.has_value()});
      html_ += number ? "<ol>\n" : "<ul>\n";
      if (open_.size() < depth) html_ += "<li>";
    }
    html_ += number            ? fmt::format("<li value=\"{}\">", *number)
             : is_word(marker) ? "<li class=\"named\"><span class=\"by\">" + html_escaped(marker) + "</span> "
                               : "<li>";
    open_.back().last = number.value_or(0);
  }

  std::size_t depth() const { return open_.size(); }

 private:
  struct List {
    bool is_numbered = false;
    int last = 0;
  };

  void close() {
    html_ += open_.back().is_numbered ? "</li>\n</ol>\n" : "</li>\n</ul>\n";
    open_.pop_back();
  }

  std::string& html_;
  std::vector<List> open_;
};

}  // namespace

std::string class_of_role(std::string_view role) {
  return role_from(role) && role != "axes" ? "r-" + std::string(role) : "";
}

std::string step_id(const Stage& stage, std::size_t step) {
  return fmt::format("{}/step.{}", stage.id, step);
}

std::string equation_id(const Stage& stage, const Equation& equation) { return stage.id + '/' + equation.id; }

std::string note_id(const Stage& stage, int number) { return fmt::format("{}/note.{}", stage.id, number); }

LessonHtml::LessonHtml(const Lesson& lesson, const SpeechText& speech, const TextNumbers& numbers,
                       std::set<std::string> stages)
    : lesson_(lesson), speech_(speech), numbers_(numbers), stages_(std::move(stages)) {
  for (const auto& [name, symbol] : lesson.symbols) symbols_.push_back({name, symbol.math, {}});
}

std::string LessonHtml::address_of(std::string_view link) const {
  if (link.starts_with(kCiteLink)) return '#' + std::string(link);
  if (link.starts_with('#')) {
    const std::string stage(link.substr(1, link.find('/') - 1));
    return stages_.contains(stage) ? std::string(link) : "";
  }
  const std::size_t id_end = std::min(link.find('#'), link.size());
  if (const std::string id(link.substr(0, id_end)); lessons_.contains(id))
    return id + ".html" + std::string(link.substr(id_end));
  return leads_to_the_web(link) ? std::string(link) : "";
}

std::string LessonHtml::formula(const Math& math, std::string_view tex) const {
  return formula(math, tex, true, speech_.words(math));
}

std::string LessonHtml::formula_in_line(const Math& math, std::string_view tex,
                                        std::string_view before) const {
  return formula(math, tex, false, speech_.words_in_line(math, before));
}

std::string LessonHtml::formula(const Math& math, std::string_view tex, bool display,
                                const std::string& words) const {
  if (std::string link = reference_alone(math); !link.empty()) return link;
  const auto class_of = [this](std::string_view name) {
    const auto found = lesson_.symbols.find(std::string(name));
    return found == lesson_.symbols.end() ? "" : class_of_role(found->second.role);
  };
  const auto address = [this](std::string_view link) { return address_of(link); };
  const Math shown = numbers_.shown.put_into(math);
  MathMlStyle style{.display = display,
                    .symbols = &symbols_,
                    .class_of = class_of,
                    .address_of = address,
                    .words = words,
                    .tex = tex_to_copy(math, tex)};
  const std::string html = mathml(shown, style);
  if (signs_of(html) <= kMostSigns) return html;
  style.in_pieces = true;
  const std::string broken = mathml(shown, style);
  return display ? broken : "<span class=\"long\">" + broken + "</span>";
}

/// As other programs read it: with its numbers, and without what only this one knows.
std::string LessonHtml::tex_to_copy(const Math& math, std::string_view tex) const {
  const auto tex_of = [this](int id) {
    const auto found = numbers_.tex.find(id);
    return found == numbers_.tex.end() ? "\\ldots" : found->second;
  };
  std::string copy;
  std::size_t at = 0;
  for (const LiveNumber& number : math.live) {
    if (number.whole.begin < at || number.whole.end > tex.size()) continue;
    copy += tex.substr(at, number.whole.begin - at);
    copy += '{' + (number.typed.empty() ? tex_of(number.id) : number.typed) + '}' + unit_tex(number.unit);
    at = number.whole.end;
  }
  copy += tex.substr(at);
  for (const std::string_view command : {"\\term{", "\\proved{"})
    for (std::size_t found; (found = copy.find(command)) != copy.npos;) {
      const bool is_named = command == "\\term{";
      const std::size_t end = is_named ? copy.find('}', found) + 1 : found + command.size() - 1;
      copy.erase(found, end - found);
    }
  return copy;
}

/// A formula that is nothing but \eqref: words to a reader, with a link.
std::string LessonHtml::reference_alone(const Math& math) const {
  if (!math.root || math.references.size() != 1) return {};
  const MathNode& term = without_groups(*math.root);
  if (term.kind != MathNode::Kind::term || !is_link_name(term.text)) return {};
  const std::string& number = without_groups(term.children.front()).text;
  const std::string address = address_of(term.text);
  return address.empty() ? html_escaped(number)
                         : fmt::format("<a href=\"{}\">{}</a>", html_escaped(address), html_escaped(number));
}

std::string LessonHtml::note_mark(const TextSpan& span) const {
  if (stage_ == nullptr || span.text.empty()) return {};
  for (const Step& step : stage_->steps)
    for (const Footnote* note : blocks_of<Footnote>(step))
      if (span.text == raised_number(note->number))
        return fmt::format("<a class=\"note-mark\" role=\"doc-noteref\" href=\"#{}\">{}</a>",
                           html_escaped(note_id(*stage_, note->number)), html_escaped(span.text));
  return {};
}

std::string LessonHtml::span(const TextSpan& span, std::string_view before, char32_t last) const {
  std::string html;
  if (span.kind == TextSpan::Kind::math) {
    html = formula_in_line(span.math, span.text, before);
  } else {
    html = note_mark(span);
    if (html.empty()) html = html_escaped(span.code ? span.text : as_set(span.text, last));
  }
  if (span.code) html = "<code>" + html + "</code>";
  if (span.italic) html = "<em>" + html + "</em>";
  if (span.bold) html = "<strong>" + html + "</strong>";
  return html;
}

std::string LessonHtml::spans(const std::vector<TextSpan>& all) const {
  std::string html, before;
  for (std::size_t i = 0; i < all.size();) {
    const std::string& link = all[i].link;
    const std::string address = link.empty() ? "" : address_of(link);
    if (!address.empty()) html += "<a href=\"" + html_escaped(address) + "\">";
    // One link for all that it holds, a formula too.
    const std::size_t first = i;
    for (; i < all.size() && (i == first || (!address.empty() && all[i].link == link)); ++i) {
      const bool is_behind_formula = i > 0 && all[i - 1].kind == TextSpan::Kind::math;
      html += span(all[i], before, is_behind_formula ? kFormula : last_of(before));
      before = all[i].kind == TextSpan::Kind::math ? "" : before + all[i].text;
      if (all[i].break_after) html += "<br/>\n";
    }
    if (!address.empty()) html += "</a>";
  }
  return kept_together(html);
}

std::string LessonHtml::table(const TextTable& table) const {
  static constexpr std::array<std::string_view, 3> kPlaces = {"left", "center", "right"};
  const auto row_of = [&](const std::vector<TextTable::Cell>& cells, bool is_head) {
    std::string html = "<tr>";
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string_view place = kPlaces[static_cast<std::size_t>(table.columns[c])];
      // An empty head names nothing. A row is named by its first cell.
      const std::string_view name = (is_head || c == 0) && !cells[c].empty() ? "th" : "td";
      html += fmt::format("<{} class=\"{}\"{}>{}</{}>", name, place,
                          name == "td" ? ""
                          : is_head    ? " scope=\"col\""
                                       : " scope=\"row\"",
                          spans(cells[c]), name);
    }
    return html + "</tr>\n";
  };
  // Heard, a table is told from others by the names of its columns.
  std::string names;
  for (const TextTable::Cell& cell : table.rows.front())
    if (!cell.empty())
      names +=
          (names.empty() ? "" : ", ") + speech_.words(TextBlock{.indent = 0, .marker = {}, .spans = cell});
  std::string html = fmt::format("<div class=\"wide\"><table{}>\n<thead>{}</thead>\n<tbody>\n",
                                 names.empty() ? "" : " aria-label=\"" + html_escaped(names) + '"',
                                 row_of(table.rows.front(), true));
  for (std::size_t r = 1; r < table.rows.size(); ++r) html += row_of(table.rows[r], false);
  return html + "</tbody>\n</table></div>\n";
}

std::string LessonHtml::blocks(const RichText& text) const {
  std::string html;
  Lists lists(html);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const TextBlock& block = text[i];
    const auto depth = static_cast<std::size_t>(std::max(block.indent, 0));
    if (block.is_table()) {
      lists.close_to(0);
      html += table(block.table);
    } else if (!block.marker.empty() && depth > 0) {
      lists.begin_item(depth, block.marker);
      html += spans(block.spans);
    } else {
      lists.close_to(depth);
      html += "<p>" + spans(block.spans) + "</p>\n";
    }
  }
  lists.close_to(0);
  return html;
}

std::string LessonHtml::line(const RichText& text) const {
  std::string html;
  for (const TextBlock& block : text) {
    if (!html.empty()) html += ' ';
    html += spans(block.spans);
  }
  return html;
}

std::string LessonHtml::line(std::string_view words) const {
  std::string html;
  const auto add_words = [&](std::string_view plain) {
    std::string text(plain);
    for (std::size_t at = 0; (at = text.find("\\$", at)) != text.npos; ++at) text.erase(at, 1);
    html += html_escaped(as_set(text, html.empty() ? kBegin : kFormula));
  };
  std::size_t at = 0;
  for (const SourceSpan& found : formulas_of_line(words)) {
    add_words(words.substr(at, found.begin - 1 - at));
    const std::string_view tex = words.substr(found.begin, found.end - found.begin);
    auto math = parse_math(tex, lesson_.macros, lesson_.about.language);
    if (math) math->live.clear();  // only numbers that are shown as they are typed are left in such a line
    html += math ? formula_in_line(*math, tex, words.substr(0, found.begin - 1)) : html_escaped(tex);
    at = found.end + 1;
  }
  add_words(words.substr(at));
  return kept_together(html);
}

}  // namespace polhode

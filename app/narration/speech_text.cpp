// SPDX-License-Identifier: MIT
#include "app/narration/speech_text.h"

#include "app/narration/mark_shapes.h"
#include "app/narration/number_text.h"
#include "app/narration/step_formulas.h"
#include "app/narration/verdict_row.h"
#include "base/ascii.h"
#include "base/words/formula_words.h"
#include "base/words/speech_words.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/reader/markdown/footnotes.h"
#include "lessons/reader/questions/state_task.h"
#include "lessons/reader/scene/varied_scene.h"
#include "render/scene/model/drawn_marks.h"
#include "render/scene/model/scene_needs.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace polhode {

namespace {

/// As a sentence: with a full stop, unless it ends like one, but for marks of footnotes.
std::string sentence(std::string text) {
  std::string_view said = text;
  for (bool found = true; found;) {
    found = false;
    for (int digit = 0; digit <= 9 && !found; ++digit) {
      const std::string raised = raised_number(digit);
      found = said.ends_with(raised);
      if (found) said.remove_suffix(raised.size());
    }
  }
  if (!said.empty() && std::string_view(".:;!?").find(said.back()) == std::string_view::npos) text += '.';
  return text;
}

bool same_letters(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

/// Omega is another quantity than omega.
bool is_greek(std::string_view words) {
  const std::string_view first = words.substr(0, words.find(' '));
  for (char32_t letter = U'α'; letter <= U'ω'; ++letter) {
    std::string_view name = name_of_symbol(letter);
    if (name.starts_with("var")) name.remove_prefix(3);  // said, ε is epsilon
    if (name == first) return true;
  }
  return false;
}

/// Whether its last word is this one, whatever its first letter.
bool ends_with_word(std::string_view text, std::string_view word) {
  while (text.ends_with(' ')) text.remove_suffix(1);
  if (text.size() < word.size() || !same_letters(text.substr(text.size() - word.size()), word)) return false;
  return text.size() == word.size() || text[text.size() - word.size() - 1] == ' ';
}

/// At the start of a sentence a word, which a single letter is not, has a capital; a text may be one or not.
void add_formula(std::string& text, std::string_view words, bool begins_sentence = true) {
  const bool is_word = words.size() > 1 && is_lower(words[0]) && is_lower(words[1]) && !is_greek(words);
  const bool begins = text.empty() ? begins_sentence : text.ends_with(". ");
  text += words;
  if (is_word && begins) {
    char& first = text[text.size() - words.size()];
    first = static_cast<char>(first - 'a' + 'A');
  }
}

bool is_name(std::string_view written) {
  return !written.empty() && is_letter(written.front()) &&
         std::all_of(written.begin(), written.end(),
                     [](char c) { return is_letter(c) || is_digit(c) || c == '_'; });
}

bool is_axis(std::string_view written) {
  constexpr std::string_view kAxes = "123xyz";
  return written.size() == 2 && written[0] == 'e' && kAxes.find(written[1]) != std::string_view::npos;
}

/// Whether a text speaks of "the plate": what a lesson's file calls a body may be any word.
bool is_said_in_text(const std::string& name, const std::string& text) {
  for (const char* article : {" the ", " The ", " a ", " A ", " an ", " An "}) {
    const std::string said = article + name;
    for (std::size_t at = text.find(said); at != std::string::npos; at = text.find(said, at + 1))
      if (!is_letter(text[at + said.size()])) return true;
  }
  return false;
}

/// Whether it is among the words of an overlay that is drawn, "body cone", or one of the digits in them.
bool is_said_of_overlay(const std::string& note, const Scene& scene) {
  constexpr std::size_t kLeastWord = 4;
  if (note.size() < kLeastWord && !(note.size() == 1 && is_digit(note.front()))) return false;
  const OverlaySet drawn = drawn_overlays(scene);
  for (int i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    if (!drawn.contains(overlay)) continue;
    const std::string_view words = facts_of(overlay).words.in(scene.language);
    const std::size_t at = words.find(note);
    if (at == std::string_view::npos) continue;
    const std::size_t end = at + note.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || !is_letter(words[end]))) return true;
  }
  return false;
}

/// Those from `first` on stand so many bytes behind where they stood.
void moved_by(std::size_t bytes, std::size_t first, std::vector<NoteLink>& links) {
  for (std::size_t i = first; i < links.size(); ++i) {
    links[i].begin += bytes;
    links[i].end += bytes;
  }
}

void add(std::string& text, const std::string& more) {
  if (!text.empty() && !more.empty()) text += ' ';
  text += more;
}

}  // namespace

SpeechText::SpeechText(const Lesson& lesson, Effort effort)
    : lesson_(lesson), steps_of_numbers_(lesson.numbers.size()), stills_(std::move(effort)) {
  const auto belong_to = [&](const Step& step, const std::vector<int>& ids) {
    for (const int id : ids)
      if (const Step*& known = steps_of_numbers_[static_cast<std::size_t>(id)]; known == nullptr)
        known = &step;
  };
  for (const Stage& stage : lesson.stages)
    for (const Step& step : stage.steps) {
      places_.emplace(&step, places_.size());
      belong_to(step, numbers_in(step));
    }
}

Math SpeechText::with_spoken_numbers(const Math& math, const StillNumbers::Values* of) const {
  if (math.live.empty()) return math;
  std::vector<ShownNumber> shown;
  for (const LiveNumber& number : math.live) {
    shown.emplace_back();
    // \value says what is typed; and the formulas of a line that stands by itself are no lesson's.
    if (!number.typed.empty() || number.id < 0) continue;
    const Step* step = steps_of_numbers_.at(static_cast<std::size_t>(number.id));
    if (of == nullptr && step == nullptr) continue;
    const StillNumbers::Values& values = of ? *of : stills_.of(lesson_, *step);
    const auto value = values.find(number.id);
    const bool in_table = lesson_.numbers[static_cast<std::size_t>(number.id)].row != nullptr;
    if (value == values.end() && !in_table) continue;
    const std::string said = value != values.end() ? number_words(value->second, number.digits, language())
                                                   : std::string(words::kNotDefined.in(language()));
    if (auto set = parse_math("\\text{" + said + '}')) shown.back().number = std::move(*set);
  }
  return with_numbers(math, shown);
}

std::string SpeechText::number_in_words(double value) const {
  return with_decimals(fmt::format("{:.4g}", value), language());
}

std::string SpeechText::words_in_line(const Math& math, std::string_view before) const {
  return words_in_line(math, before, nullptr);
}

std::string SpeechText::words_in_line(const Math& math, std::string_view before,
                                      const StillNumbers::Values* numbers) const {
  Math numbered = with_spoken_numbers(math, numbers);
  numbered.language = language();  // formulas that the program makes know none
  std::string said = spoken(numbered, {}, {});
  const std::string_view vector = words::kVector.in(language());
  if (said.starts_with(vector) && ends_with_word(before, vector))
    said.erase(0, std::min(vector.size() + 1, said.size()));
  return said;
}

std::string SpeechText::words(const TextBlock& block, std::vector<NoteLink>* links) const {
  if (!block.is_table()) return words(block.spans, links);
  std::string text;
  for (const std::string& row : words_of_rows(block.table)) add(text, row);
  return text;
}

std::vector<std::string> SpeechText::words_of_rows(const TextTable& table) const {
  std::vector<std::string> head, said;
  std::string columns;
  for (const TextTable::Cell& cell : table.rows.front()) {
    head.push_back(words(cell, nullptr, false));
    if (!head.back().empty()) columns += (columns.empty() ? "" : ", ") + head.back();
  }
  said.push_back(columns.empty() ? opening(words::kTable)
                                 : words::kTableWithColumns.with(language(), {columns}));
  for (std::size_t r = 1; r < table.rows.size(); ++r) {
    std::string row;
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const std::string cell = words(table.rows[r][c], nullptr);
      if (!cell.empty()) row += (row.empty() ? "" : "; ") + (head[c].empty() ? cell : head[c] + ": " + cell);
    }
    if (!row.empty()) said.push_back(sentence(row));
  }
  return said;
}

std::string SpeechText::words(const std::vector<TextSpan>& spans, std::vector<NoteLink>* links,
                              bool is_sentence) const {
  std::string text;
  const TextSpan* before = nullptr;
  for (const TextSpan& span : spans) {
    const std::size_t begin = text.size();
    if (span.kind == TextSpan::Kind::math)
      add_formula(text, words_in_line(span.math, text), is_sentence);
    else
      text += span.text;
    if (links != nullptr && !span.link.empty()) {
      if (before == nullptr || before->link != span.link) links->push_back({begin, begin, span.link});
      links->back().end = text.size();
    }
    if (span.break_after) text += ' ';
    before = &span;
  }
  return text;
}

std::string SpeechText::words(const RichText& text, std::vector<NoteLink>* links) const {
  std::string all;
  for (const TextBlock& block : text) {
    const std::size_t known = links != nullptr ? links->size() : 0;
    const std::string more = words(block, links);
    add(all, more);
    if (links != nullptr) moved_by(all.size() - more.size(), known, *links);
  }
  return all;
}

std::string SpeechText::words(const Equation& equation) const {
  const std::string formula = sentence(words(equation.math));
  return equation.tag.empty() ? words::kEquation.with(language(), {formula})
                              : words::kEquationNumber.with(language(), {equation.tag, formula});
}

/// A line of text with formulas between dollar signs.
std::string SpeechText::words_of_line(const std::string& line) const {
  std::string text;
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = line.find('$', at),
                      end = begin == line.npos ? begin : line.find('$', begin + 1);
    text += line.substr(at, begin == line.npos ? begin : begin - at);
    if (end == line.npos) return text;
    if (const auto math = parse_math(line.substr(begin + 1, end - begin - 1), {}, language()))
      text += words_in_line(*math, text);
    at = end + 1;
  }
}

std::string SpeechText::words(const Claim& claim, const Scene* scene) const {
  const VerdictRow row = verdict_row(claim, scene, nullptr, language());
  const std::string word = capitalized(row.word);
  const std::string note =
      words_of_line(row.note + (row.note.empty() || row.example.empty() ? "" : ", ") + row.example);
  std::string text = note.empty() ? word + '.' : word + ", " + note + '.';
  std::string claimed;
  for (const std::string& tex : row.claimed)
    if (const auto math = parse_math(tex, {}, language()))
      claimed += (claimed.empty() ? "" : "; ") + words(*math);
  return claimed.empty() ? text : capitalized(row.claimed_is) + ": " + sentence(claimed) + ' ' + text;
}

std::string SpeechText::words(const Callout& callout, std::vector<NoteLink>* links) const {
  const auto own = lesson_.about.labels.find(callout.kind);
  const std::string_view label = own != lesson_.about.labels.end()
                                     ? std::string_view(own->second)
                                     : names_of(callout.kind).words.in(language());
  std::string text = fmt::format("{}: ", label);
  if (!callout.title.empty()) text += sentence(words(callout.title)) + ' ';
  const std::size_t known = links != nullptr ? links->size() : 0;
  const std::string said = sentence(words(callout.text, links));
  if (links != nullptr) moved_by(text.size(), known, *links);
  return text + said;
}

std::string SpeechText::words(const Ask& ask) const {
  std::string text = opening(words::kQuestion) + sentence(words(ask.prompt_text));
  for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
    add(text, words::kChoice.with(
                  language(), {std::string(1, letter_of_choice(i)), sentence(words(ask.choice_texts[i]))}));
  return text;
}

std::string SpeechText::words_of_answer(const Ask& ask) const {
  std::string text = ask.expression ? ask.expression->text
                     : ask.task     ? text_of(ask.task->solution)
                     : ask.number   ? with_decimals(polhode::words_of(*ask.number), language())
                                    : "";
  for (const int answer : ask.answers)
    text +=
        (text.empty() ? "" : ", ") + std::string(1, letter_of_choice(static_cast<std::size_t>(answer - 1)));
  if (ask.answers.size() == 1)
    text += ": " + words(ask.choice_texts[static_cast<std::size_t>(ask.answers.front() - 1)]);
  if (!text.empty()) text = sentence(std::move(text));
  if (!ask.because.empty()) add(text, sentence(words(ask.because)));
  return text;
}

std::string SpeechText::words_after(const Ask& ask, const AnswerJudgement& judgement) const {
  const auto picked = static_cast<std::size_t>(judgement.choice);
  std::string text = picked > 0 && picked <= ask.replies.size() ? words(ask.replies[picked - 1]) : "";
  if (judgement.mark == AnswerJudgement::Mark::right) add(text, words(ask.because));
  return text.empty() ? text : sentence(std::move(text));
}

std::string SpeechText::words_of_title(const Stage& stage) const {
  return sentence(curled(words(stage.title_text)));
}

std::string SpeechText::words_of_caption(const Step& step, std::size_t shown) const {
  const RichText* caption = caption_of(step, shown);
  if (caption == nullptr) return "";
  std::string text;
  for_each_span(*caption, [&](const TextSpan& span) {
    if (span.kind == TextSpan::Kind::math)
      add_formula(
          text, words_in_line(span.math, text,
                              span.math.live.empty() ? nullptr : &stills_.of_caption(lesson_, step, shown)));
    else
      text += span.text;
  });
  return text;
}

std::vector<std::string> SpeechText::captions_in_words(const Step& step, const Scene& shown) const {
  const std::vector<const Scene*> scenes = shown_scenes(shown);
  const bool have_one = have_one_caption(scenes);
  std::vector<std::string> captions;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const std::string caption = scenes[i]->caption.empty()
                                    ? ""
                                    : words_of_caption(step, have_one && step.scene ? step.scene->before : i);
    const std::string label = words_of_line(scenes[i]->label);
    captions.push_back(label + (label.empty() || caption.empty() ? "" : ". ") + caption);
  }
  return captions;
}

std::vector<SceneInWords> SpeechText::words_of_scenes(const Step& step, const Scene& shown) const {
  const std::vector<const Scene*> scenes = shown_scenes(shown);
  std::vector<std::string> captions = captions_in_words(step, shown);
  std::vector<SceneInWords> all;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    all.push_back({.caption = std::move(captions[i]),
                   .marks = marks_in_words(*scenes[i], place_of(step)),
                   .axes = names_of_axes(*scenes[i]),
                   .body = is_said_in_text(scenes[i]->body.name, printed().text) ? scenes[i]->body.name : "",
                   .is_asked = !blocks_of<Ask>(step).empty()});
  return all;
}

std::vector<FigureWords> SpeechText::words_of_figure(const Step& step) const {
  if (!step.scene) return {};
  if (step.varied) {
    std::vector<FigureWords> lines;
    if (step.captions.front())
      lines.push_back({opening(words::kFigure), words_of_caption(step, step.scene->before)});
    for (const Variation& number : step.scene->vary) {
      const VariedNumber& facts = *find_varied_number(number.number);
      lines.push_back(
          {opening(words::kVaried),
           words::kVariedFromTo.with(
               language(), {words_of_line('$' + std::string(facts.tex) + '$'), number_in_words(number.from),
                            number_in_words(number.to), facts.unit})});
    }
    return lines;
  }
  const std::vector<std::string> captions = captions_in_words(step, *step.scene);
  const auto is_first = [&](const std::string& caption) { return caption == captions.front(); };
  const bool is_shared = std::all_of(captions.begin(), captions.end(), is_first);
  std::vector<FigureWords> lines;
  if (is_shared && !captions.empty() && !captions.front().empty())
    lines.push_back({opening(words::kFigure), captions.front()});
  if (is_shared) return lines;
  for (std::size_t i = 0; i < captions.size(); ++i)
    if (!captions[i].empty())
      lines.push_back(
          {words::kFigureOf.with(language(), {std::to_string(i + 1), std::to_string(captions.size())}),
           captions[i]});
  return lines;
}

std::string SpeechText::words_of_plots(const Scene& scene) const {
  std::vector<std::string> plots;
  for (const PlotSpec& spec : scene.meters) {
    const auto* own = std::get_if<OwnPlot>(&spec);
    if (own == nullptr) continue;
    const auto spoken = [&](const std::string& tex) { return words_of_label(tex); };
    const auto name = [&](std::size_t i, const std::string& tex) {
      return spoken(i < own->tex.size() ? own->tex[i] : tex);
    };
    std::string text = own->title.empty() ? "" : words_of_line(own->title) + ": ";
    if (own->function) {
      text += name(0, own->function->tex) + opening(words::kPlottedAgainst) + spoken(own->function->of.tex);
      if (own->function->level) text += opening(words::kWithTheLevel) + spoken(own->function->level->tex);
    } else {
      for (std::size_t i = 0; i < own->curves.size(); ++i) {
        if (i > 0) text += i + 1 == own->curves.size() ? opening(words::kAnd) : ", ";
        text += name(i, own->curves[i].tex);
      }
      text += opening(words::kPlottedAgainst) +
              (own->against ? spoken(own->against->tex) : opening(words::kTime));
    }
    plots.push_back(std::move(text));
  }
  return plots.empty() ? "" : sentence(fmt::format("{}", fmt::join(plots, "; ")));
}

std::string SpeechText::words_of_tex(const std::string& tex) const {
  const auto math = parse_math(tex, {}, language());
  return math ? words(*math) : tex;
}

std::string SpeechText::words_of_label(const std::string& tex) const {
  const bool is_words = tex.find("\\text") != std::string::npos ||
                        std::all_of(tex.begin(), tex.end(), [](char c) { return is_digit(c); });
  return is_words ? words::kInQuotes.with(language(), {words_of_tex(tex)}) : words_of_tex(tex);
}

std::array<std::string, 3> SpeechText::names_of_axes(const Scene& scene) const {
  std::array<std::string, 3> names;
  for (const ArrowMark& arrow : scene.marks.arrows)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (!arrow.at && arrow.tex && !arrow.tex->empty() &&
          arrow.of.quantity.text == "e" + std::to_string(i + 1))
        names[i] = words_of_label(*arrow.tex);
  return names;
}

std::size_t SpeechText::place_of(const Step& step) const {
  const auto found = places_.find(&step);
  return found == places_.end() ? places_.size() : found->second;
}

const SpeechText::Printed& SpeechText::printed() const {
  if (printed_) return *printed_;
  std::vector<MathSymbol> symbols;
  for (const auto& [name, symbol] : lesson_.symbols) symbols.push_back({name, symbol.math, {}});
  for (const char axis : std::string_view("123xyz")) {
    const std::string name = std::string("e") + axis;
    const auto math = parse_math(std::string("\\hat e_") + axis);
    if (math && !lesson_.symbols.contains(name)) symbols.push_back({name, *math, {}});
  }
  Printed& found = printed_.emplace();
  const auto look_at = [&](const Math& math, std::size_t place) {
    spoken(math, symbols, [&](std::string_view name) {
      found.names.try_emplace(std::string(name), place);
      return std::string(name);
    });
  };
  for (const Stage& stage : lesson_.stages)
    for (const Step& step : stage.steps) {
      for_each_formula(step, [&](const Math& math) { look_at(math, place_of(step)); });
      for (const auto& caption : step.captions)
        if (caption) for_each_formula(*caption, [&](const Math& math) { look_at(math, place_of(step)); });
      for (const Block& block : step.blocks)
        if (const auto* prose = std::get_if<Prose>(&block))
          for_each_span(prose->text, [&](const TextSpan& span) {
            if (span.kind == TextSpan::Kind::text) found.text += ' ' + span.text + ' ';
          });
    }
  return found;
}

std::string SpeechText::words_of_vector(const std::string& written, const Scene& scene,
                                        std::size_t step) const {
  for (const bool from_centre : {true, false})
    for (const ArrowMark& arrow : scene.marks.arrows)
      if (arrow.of.quantity.text == written && arrow.at.has_value() != from_centre &&
          (!arrow.tex || !arrow.tex->empty()))
        return words_of_label(arrow.tex ? *arrow.tex : arrow.of.quantity.tex);
  if (!is_name(written)) return "";
  const auto own = lesson_.symbols.find(written);
  if (own != lesson_.symbols.end() && own->second.tex.empty()) return own->second.say;
  const auto first = printed().names.find(written);
  const bool is_known = first != printed().names.end() && first->second <= step;
  if (is_axis(written) && !is_known) return words::kAxis.with(language(), {written.substr(1)});
  if (own != lesson_.symbols.end() && is_known) return words_of_tex(own->second.tex);
  if (is_axis(written)) return words_of_tex("\\hat e_" + written.substr(1));
  // Another word for what has a name in the figure, or for an axis.
  if (own != lesson_.symbols.end()) {
    const std::string& say = own->second.say;
    for (const ArrowMark& arrow : scene.marks.arrows)
      if (arrow.tex && !arrow.tex->empty() && words_of_tex(*arrow.tex) == say) return say;
    for (const char axis : std::string_view("123"))
      if (words::kAxis.with(language(), {std::string(1, axis)}) == say) return say;
  }
  // Vectors that have their letters in every lesson.
  const QuantityFacts* facts = find_quantity(written);
  if (facts == nullptr || facts->arrow_letter.empty()) return "";
  return words_of_tex(own != lesson_.symbols.end() ? own->second.tex
                                                   : "\\vec " + std::string(facts->arrow_letter));
}

std::vector<std::string> SpeechText::marks_in_words(const Scene& scene, std::size_t step) const {
  std::vector<std::string> all;
  if (draws_poses(scene))
    all.push_back((scene.poses.count == 1 ? words::kBodyAtEarlierInstant : words::kBodyAtEarlierInstants)
                      .with(language(), {std::to_string(scene.poses.count)}));
  if (!draws_marks(scene)) return all;
  // Those without words, of which nothing is named, are counted.
  const auto add = [&](const auto& marks, const auto& words_of, const Phrase& one, const Phrase& several) {
    std::size_t count = 0;
    for (const auto& mark : marks)
      if (std::string words = words_of(mark); words.empty())
        ++count;
      else
        all.push_back(std::move(words));
    if (count > 0) all.push_back((count == 1 ? one : several).with(language(), {std::to_string(count)}));
  };
  const auto name = [&](const MarkVector& vector) {
    return words_of_vector(vector.quantity.text, scene, step);
  };
  const auto at_tip = [&](const std::optional<MarkVector>& vector, const Phrase& where = words::kAtTheTipOf) {
    const std::string of = vector ? name(*vector) : "";
    return of.empty() ? of : where.with(language(), {of});
  };
  /// "the angle theta from … to …", "the angle theta", or nothing.
  const auto between = [&](const Phrase& named, const Phrase& whole, const std::string& tex,
                           const MarkVector& from, const MarkVector& to) {
    const std::string own = tex.empty() ? "" : words_of_tex(tex), a = name(from), b = name(to);
    if (!a.empty() && !b.empty()) return whole.with(language(), {own.empty() ? "" : own + ' ', a, b});
    return own.empty() ? own : named.with(language(), {own});
  };
  add(
      scene.marks.trails,
      [&](const TrailMark& trail) {
        const std::string of = name(trail.of);
        return of.empty()
                   ? of
                   : (trail.on_sphere ? words::kTrailOnSphere : words::kTrailOfTip).with(language(), {of});
      },
      words::kATrail, words::kTrails);
  const OverlaySet drawn = drawn_overlays(scene);
  std::vector<const ArrowMark*> nameless;
  for (const ArrowMark& arrow : scene.marks.arrows) {
    const bool has_label = !arrow.tex || !arrow.tex->empty();
    // The angular velocity ω is said already.
    if (!arrow.tex && !arrow.at && arrow.of.overlay && drawn.contains(*arrow.of.overlay)) continue;
    const std::string of =
        !has_label ? name(arrow.of) : words_of_label(arrow.tex ? *arrow.tex : arrow.of.quantity.tex);
    if (of.empty())
      nameless.push_back(&arrow);
    else
      all.push_back((of.back() == '"' || of.ends_with("“") ? words::kArrowNamed : words::kArrowOf)
                        .with(language(), {of, at_tip(arrow.at)}));
  }
  if (!nameless.empty())
    all.push_back((are_tip_to_tail(nameless) ? words::kArrowsTipToTail
                   : nameless.size() == 1    ? words::kAnArrow
                                             : words::kArrows)
                      .with(language(), {std::to_string(nameless.size())}));
  add(
      scene.marks.angles,
      [&](const AngleMark& angle) {
        const std::string said =
            between(words::kTheAngle, words::kAngleFromTo, angle.tex, angle.from, angle.to);
        if (said.empty() && is_right_angle(angle, make_model(scene), still_time_s(scene)))
          return words::kARightAngle.with(language(), {at_tip(angle.at)});
        return said.empty() ? said : said + at_tip(angle.at);
      },
      words::kAnAngle, words::kAngles);
  add(
      scene.marks.areas,
      [&](const AreaMark& area) {
        return between(words::kTheParallelogram, words::kParallelogramOf, area.tex, area.from, area.to);
      },
      words::kAParallelogram, words::kParallelograms);
  if (are_edges_of_box(scene.marks.lines))
    all.emplace_back(words::kEdgesOfBox.in(language()));
  else
    add(
        scene.marks.lines,
        [&](const LineMark& line) {
          const std::string from = name(line.from), to = name(line.to);
          if (!from.empty() && !to.empty()) return words::kLineFromTo.with(language(), {from, to});
          const std::string& end = from.empty() ? to : from;
          return end.empty() ? end : words::kLineAt.with(language(), {end});
        },
        words::kALine, words::kLines);
  add(
      scene.marks.planes,
      [&](const PlaneMark& plane) {
        const std::string through = at_tip(plane.through, words::kThroughTheTipOf);
        const std::string normal = name(plane.normal);
        if (!normal.empty()) return words::kPlaneNormalTo.with(language(), {normal, through});
        const auto [first, second] = factors_of(plane.normal.quantity.text);
        const std::string a = words_of_vector(first, scene, step), b = words_of_vector(second, scene, step);
        return a.empty() || b.empty() ? "" : words::kPlaneOf.with(language(), {a, b, through});
      },
      words::kAPlane, words::kPlanes);
  for (const NoteMark& note : scene.marks.notes) {
    const std::string said = words_of_line(note.text);
    const bool is_name_of_vector =
        note.at.overlay && drawn.contains(*note.at.overlay) && said == name(note.at);
    if (!is_name_of_vector && !is_said_of_overlay(said, scene))
      all.push_back(words::kTheNote.with(language(), {said, at_tip(note.at)}));
  }
  return all;
}

std::string SpeechText::words_of_marks(const Step& step) const {
  if (!step.scene) return "";
  std::vector<std::string> all;
  for (const Scene* shown : shown_scenes(*step.scene))
    for (std::string& mark : marks_in_words(*shown, place_of(step)))
      if (std::find(all.begin(), all.end(), mark) == all.end()) all.push_back(std::move(mark));
  return all.empty() ? "" : sentence(fmt::format("{}", fmt::join(all, "; ")));
}

std::string SpeechText::words_of_page(const Stage& stage, int first, int last) const {
  std::string text = words_of_title(stage);
  for (int i = first; i <= last; ++i) {
    const Step& step = stage.steps[static_cast<std::size_t>(i - 1)];
    if (!step.title.empty()) add(text, sentence(words(step.title)));
    for (const Block& block : step.blocks) {
      if (const auto* prose = std::get_if<Prose>(&block)) add(text, words(prose->text));
      if (const auto* equation = std::get_if<Equation>(&block)) add(text, words(*equation));
      if (const auto* claim = std::get_if<Claim>(&block)) add(text, words(*claim, step.scene.get()));
      if (const auto* callout = std::get_if<Callout>(&block)) add(text, words(*callout));
      if (const auto* ask = std::get_if<Ask>(&block)) add(text, words(*ask));
      if (const auto* note = std::get_if<Footnote>(&block))
        add(text, raised_number(note->number) + ' ' + sentence(words(note->text)));
    }
  }
  return text;
}

}  // namespace polhode

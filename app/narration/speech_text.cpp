// SPDX-License-Identifier: MIT
#include "app/narration/speech_text.h"

#include "app/narration/verdict_row.h"
#include "lessons/reader/markdown/footnotes.h"
#include "render/scene/model/drawn_marks.h"

#include <fmt/format.h>

#include <algorithm>

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

/// Prose often names a quantity before its symbol: "the angular velocity" and "angular velocity" are one. The
/// symbol's words without those that the text ends with.
std::string_view unsaid_part(std::string_view text, std::string_view symbol) {
  constexpr std::size_t kShortest = 3;  // "S" may well follow "S"
  while (text.ends_with(' ')) text.remove_suffix(1);
  for (std::size_t end = symbol.size(); end >= kShortest; end = symbol.rfind(' ', end - 1)) {
    if (end == std::string_view::npos) break;
    const std::string_view begin = symbol.substr(0, end);
    if (begin.size() > text.size()) continue;
    const std::string_view tail = text.substr(text.size() - begin.size());
    const bool whole_words = tail.size() == text.size() || text[text.size() - tail.size() - 1] == ' ';
    if (whole_words && same_letters(tail, begin)) return symbol.substr(std::min(end + 1, symbol.size()));
  }
  return symbol;
}

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

/// At the start of a sentence a word, which a single letter is not, has a capital.
void add_symbol(std::string& text, std::string_view words) {
  const std::string_view rest = unsaid_part(text, words);
  if (rest.empty() && text.ends_with(' ')) text.pop_back();
  const bool is_word = rest.size() > 1 && is_lower(rest[0]) && is_lower(rest[1]);
  const bool begins = text.empty() || text.ends_with(". ");
  text += rest;
  if (is_word && begins) {
    char& first = text[text.size() - rest.size()];
    first = static_cast<char>(first - 'a' + 'A');
  }
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

SpeechText::SpeechText(const Lesson& lesson) : lesson_(lesson) {
  for (const auto& [name, symbol] : lesson.symbols) symbols_.push_back({name, symbol.math, {}});
}

std::string SpeechText::words(const Math& math) const {
  return spoken(math, symbols_, [this](std::string_view name) {
    const auto found = lesson_.symbols.find(std::string(name));
    return found == lesson_.symbols.end() ? std::string() : found->second.say;
  });
}

std::string SpeechText::words(const TextBlock& block, std::vector<NoteLink>* links) const {
  std::string text;
  const TextSpan* before = nullptr;
  for (const TextSpan& span : block.spans) {
    const std::size_t begin = text.size();
    if (span.kind == TextSpan::Kind::math)
      add_symbol(text, words(span.math));
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
  return equation.tag.empty() ? "Equation: " + formula
                              : fmt::format("Equation ({}): {}", equation.tag, formula);
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
    if (const auto math = parse_math(line.substr(begin + 1, end - begin - 1))) text += words(*math);
    at = end + 1;
  }
}

std::string SpeechText::words(const Claim& claim) const {
  const VerdictRow row = verdict_row(claim, nullptr, nullptr);
  std::string word(name_of(claim.kind));
  word.front() = static_cast<char>(word.front() - 'a' + 'A');
  const std::string note = words_of_line(row.note);
  std::string text = note.empty() ? word + '.' : word + ": " + note + '.';
  std::string claimed;
  for (const std::string& tex : row.claimed)
    if (const auto math = parse_math(tex)) claimed += (claimed.empty() ? "" : "; ") + words(*math);
  if (!claimed.empty()) text += " Claimed: " + sentence(claimed);
  return text;
}

std::string SpeechText::words(const Callout& callout, std::vector<NoteLink>* links) const {
  const auto own = lesson_.about.labels.find(callout.kind);
  const std::string_view label =
      own != lesson_.about.labels.end() ? std::string_view(own->second) : names_of(callout.kind).words;
  std::string text = fmt::format("{}: ", label);
  if (!callout.title.empty()) text += sentence(words(callout.title)) + ' ';
  const std::size_t known = links != nullptr ? links->size() : 0;
  const std::string said = sentence(words(callout.text, links));
  if (links != nullptr) moved_by(text.size(), known, *links);
  return text + said;
}

std::string SpeechText::words(const Ask& ask) const {
  std::string text = "Question: " + sentence(words(ask.prompt_text));
  for (std::size_t i = 0; i < ask.choice_texts.size(); ++i)
    add(text, fmt::format("Choice {}: {}", letter_of_choice(i), sentence(words(ask.choice_texts[i]))));
  return text;
}

std::string SpeechText::words_of_title(const Stage& stage) const { return sentence(words(stage.title_text)); }

std::string SpeechText::words_of_caption(const Stage& stage, int step) const {
  const auto& caption = stage.steps[static_cast<std::size_t>(step - 1)].caption;
  return caption ? words(*caption) : std::string();
}

std::string SpeechText::words_of_tex(const std::string& tex) const {
  const auto math = parse_math(tex);
  return math ? words(*math) : tex;
}

std::vector<std::string> SpeechText::words_of_marks(const Scene& scene) const {
  std::vector<std::string> all;
  if (!draws_marks(scene)) return all;
  const auto name = [this](const MarkVector& vector) { return words_of_tex(vector.quantity.tex); };
  const auto at_tip = [&](const std::optional<MarkVector>& vector, const char* where) {
    return vector ? fmt::format(" {} the tip of {}", where, name(*vector)) : std::string();
  };
  for (const TrailMark& trail : scene.marks.trails)
    all.push_back(trail.on_sphere
                      ? fmt::format("the trail of the direction of {} on the unit sphere", name(trail.of))
                      : fmt::format("the trail of the tip of {}", name(trail.of)));
  for (const ArrowMark& arrow : scene.marks.arrows) {
    const bool is_named = arrow.tex && !arrow.tex->empty();
    all.push_back(fmt::format("the arrow of {}{}", is_named ? words_of_tex(*arrow.tex) : name(arrow.of),
                              at_tip(arrow.at, "at")));
  }
  for (const AngleMark& angle : scene.marks.angles)
    all.push_back(fmt::format("the angle {}from {} to {}",
                              angle.tex.empty() ? "" : words_of_tex(angle.tex) + ' ', name(angle.from),
                              name(angle.to)));
  for (const PlaneMark& plane : scene.marks.planes)
    all.push_back(
        fmt::format("the plane normal to {}{}", name(plane.normal), at_tip(plane.through, "through")));
  for (const NoteMark& note : scene.marks.notes)
    all.push_back(fmt::format("the note \"{}\"{}", words_of_line(note.text), at_tip(note.at, "at")));
  return all;
}

std::string SpeechText::words_of_page(const Stage& stage, int first, int last) const {
  std::string text = words_of_title(stage);
  for (int step = first; step <= last; ++step)
    for (const Block& block : stage.steps[static_cast<std::size_t>(step - 1)].blocks) {
      if (const auto* prose = std::get_if<Prose>(&block)) add(text, words(prose->text));
      if (const auto* equation = std::get_if<Equation>(&block)) add(text, words(*equation));
      if (const auto* claim = std::get_if<Claim>(&block)) add(text, words(*claim));
      if (const auto* callout = std::get_if<Callout>(&block)) add(text, words(*callout));
      if (const auto* ask = std::get_if<Ask>(&block)) add(text, words(*ask));
      if (const auto* note = std::get_if<Footnote>(&block))
        add(text, raised_number(note->number) + ' ' + sentence(words(note->text)));
    }
  return text;
}

}  // namespace polhode

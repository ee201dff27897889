// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/prose/sentence.h"

#include "base/ascii.h"
#include "lessons/claims/customary_names.h"
#include "lessons/claims/expressions/dimension.h"
#include "lessons/reader/checks/formula_signs.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string_view>

namespace polhode {
namespace {

using Kind = SentencePart::Kind;
using Words = std::initializer_list<std::string_view>;

bool is_one_of(const SentencePart& part, Words words) {
  return part.kind == Kind::word && std::find(words.begin(), words.end(), part.word) != words.end();
}

/// What begins a clause on which another depends.
bool is_conjunction(const SentencePart& part) {
  return is_one_of(part, {"if", "when", "whenever", "where", "wherever", "unless", "once", "until", "till",
                          "provided", "whether", "while", "as"});
}
/// What begins a sentence that supposes.
bool is_supposing(const SentencePart& part) {
  return is_one_of(part, {"let", "suppose", "supposing", "assume", "assuming", "imagine", "consider"});
}
/// The base form of a verb that begins a clause tells the reader to do something to the body. Not "note" or
/// "recall", which state.
bool is_imperative(const SentencePart& part) {
  return is_supposing(part) ||
         is_one_of(part, {"change",  "drag", "move",  "tilt", "take",  "set",  "put",   "choose",
                          "hold",    "wait", "throw", "turn", "spin",  "give", "start", "drop",
                          "release", "push", "pull",  "keep", "bring", "make", "lift",  "wind"});
}
/// Behind one that may be a noun, "turn the book", "the turn".
bool is_object(const SentencePart& part) {
  return part.is_formula() || is_one_of(part, {"it", "the", "a", "an", "this", "them", "your", "its", "both",
                                               "all", "one", "for", "with", "any"});
}
bool is_before_imperative(const SentencePart& part) {
  return part.kind == Kind::pause ||
         is_one_of(part, {"now", "then", "and", "first", "next", "instead", "us"});
}
/// With an equation behind it a condition. Not "by" or "to": "is given by", "comes to".
bool is_preposition(const SentencePart& part) {
  return is_one_of(part, {"with", "without", "for", "at", "given", "under", "than", "unlike", "except"});
}
/// What the body that is shown does. Not "would spin".
bool says_how_it_moves(const SentencePart& part) {
  return is_one_of(part, {"spins", "turns", "rotates", "starts", "begins", "moves", "flies", "tumbles"});
}
/// The reader and the writer: what they do is no condition on a body.
bool is_person(const SentencePart& part) { return is_one_of(part, {"we", "you", "one", "i", "us"}); }

bool denies(const SentencePart& part) {
  if (part.kind == Kind::word && (part.word.ends_with("n't") || part.word.ends_with("n’t"))) return true;
  return is_one_of(
      part, {"not", "no", "never", "cannot", "neither", "nobody", "nothing", "none", "nowhere", "false",
             "wrong", "untrue", "doubt", "doubts", "doubted", "deny", "denied", "denies"});
}
/// Who must not do that to a fact has one: "do not forget that".
bool passes_over(const SentencePart& part) {
  return is_one_of(part, {"forget",  "forgets",   "forgotten", "overlook", "overlooked", "ignore", "ignored",
                          "neglect", "neglected", "omit",      "omitted",  "miss",       "missed", "fail",
                          "fails",   "dispute",   "disputed",  "escape",   "escapes",    "help"});
}
/// Behind "not": that what follows is so.
bool is_to_be_so(const SentencePart& part) {
  return is_one_of(part, {"true", "so", "follow", "follows", "mean", "means", "imply", "implies", "say",
                          "says", "case", "give", "prove", "think", "believe", "claim", "suppose"});
}

bool begins_clause(const SentencePart& part) {
  return is_one_of(
      part, {"so", "but", "because", "since", "hence", "thus", "therefore", "although", "though", "whereas"});
}

bool is_blank(unsigned char c) { return c == ' ' || c == '\n' || c == '\t'; }

}  // namespace

Sentences::Sentences(const std::vector<TextSpan>& line, const EquationNotation& notation) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].kind == TextSpan::Kind::math)
      add_formula(line, i, notation);
    else if (!line[i].code)
      add_words(line[i].text, i);
  }
}

void Sentences::add_words(const std::string& text, std::size_t span) {
  std::string word;
  const auto end_word = [&] {
    if (word.empty()) return;
    SentencePart part{Kind::word, std::move(word), span};
    word.clear();
    const bool is_not_so = part.word == "so" && !parts_.empty() && denies(parts_.back());
    if (begins_clause(part) && !is_not_so) parts_.push_back({Kind::pause, "", span});
    parts_.push_back(std::move(part));
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = std::string_view(text).substr(i);
    const char c = text[i];
    std::string_view after_blank = rest;
    if (is_blank(static_cast<unsigned char>(c)) || take_blank(after_blank)) {
      end_word();
      if (!after_blank.empty() && after_blank.size() < rest.size()) i += rest.size() - after_blank.size() - 1;
    } else if (rest.starts_with("–") || rest.starts_with("—")) {
      end_word();
      parts_.push_back({Kind::pause, ":", span});
      i += std::string_view("–").size() - 1;
    } else if (c == kRelationMark) {
      end_word();
      parts_.push_back({Kind::equation, "", span});
    } else if (std::string_view(".?!").find(c) != std::string_view::npos &&
               (i + 1 == text.size() || is_blank(static_cast<unsigned char>(text[i + 1])))) {
      end_word();
      parts_.push_back({c == '?' ? Kind::question : Kind::end, "", span});
    } else if (std::string_view(",:;()[]").find(c) != std::string_view::npos) {
      end_word();
      parts_.push_back({Kind::pause, std::string(1, c), span});
    } else {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  end_word();
}

void Sentences::add_formula(const std::vector<TextSpan>& line, std::size_t span,
                            const EquationNotation& notation) {
  const Math& math = line[span].math;
  const Statements& stated = stated_.emplace(span, stated_in(math, notation)).first->second;
  const auto is_letter_of_word = [](char c) { return is_letter(c); };
  if (std::any_of(stated.words.begin(), stated.words.end(), is_letter_of_word))
    return add_words(stated.words, span);
  SentencePart part{Kind::formula, "", span};
  if (math.root && (!relations_in(*math.root).empty() || says_no_equality(*math.root)))
    part.kind = Kind::equation;
  for (const StatedLink& link : stated.links) {
    if (!link.left.is_time() || !link.right.typed || link.relation != Relation::equal) continue;
    std::string unit = link.right.typed->unit;
    if (unit.empty() && span + 1 < line.size() && line[span + 1].kind == TextSpan::Kind::text)
      unit = unit_behind(line[span + 1].text);
    const auto scaled = scaled_unit(unit);
    part.kind = Kind::time;
    part.t_s = link.right.typed->value * (scaled ? scaled->size : 1);
  }
  parts_.push_back(std::move(part));
}

Sentences::Range Sentences::sentence_around(std::size_t part) const {
  const auto ends = [&](std::size_t i) {
    return parts_[i].kind == Kind::end || parts_[i].kind == Kind::question;
  };
  Range range{part, part};
  while (range.begin > 0 && !ends(range.begin - 1)) --range.begin;
  while (range.end < parts_.size() && !ends(range.end)) ++range.end;
  range.end = std::min(range.end + 1, parts_.size());
  return range;
}

Sentences::Range Sentences::clause_around(std::size_t part, Range sentence) const {
  Range clause{part, part + 1};
  while (clause.begin > sentence.begin && parts_[clause.begin - 1].kind != Kind::pause) --clause.begin;
  while (clause.end < sentence.end && parts_[clause.end].kind != Kind::pause) ++clause.end;
  return clause;
}

/// "if any", "where possible", "when we look", "once more" suppose nothing.
bool Sentences::is_condition(std::size_t conjunction, Range sentence) const {
  const SentencePart& word = parts_[conjunction];
  std::size_t end = conjunction + 1;
  bool has_equation = false;
  for (; end < sentence.end && parts_[end].kind != Kind::pause; ++end)
    has_equation = has_equation || parts_[end].kind == Kind::equation;
  const std::size_t first = conjunction + 1;
  if (first >= end) return false;
  const bool is_comparison = word.word == "as" || word.word == "while";
  if (is_comparison)  // "as long as it turns"
    return word.word == "as" && is_one_of(parts_[first], {"long"}) && first + 2 < end &&
           !is_person(parts_[first + 2]);
  if (word.word == "once" && is_one_of(parts_[first], {"more", "again"})) return false;
  if (has_equation) return true;
  constexpr std::size_t kSubjectAndPredicate = 2;
  return !is_person(parts_[first]) && end - first >= kSubjectAndPredicate;
}

std::size_t Sentences::equation_behind(std::size_t preposition, Range sentence) const {
  constexpr std::size_t kWordsOfName = 4;
  std::string name;
  for (std::size_t i = preposition + 1; i < sentence.end && i <= preposition + 1 + kWordsOfName; ++i) {
    if (parts_[i].is_formula()) {
      const bool is_of_quantity = name.empty() || !dimensions_of_words(name).empty() || name == " moments" ||
                                  name == " the moments" || name == " components";
      return is_of_quantity && parts_[i].kind != Kind::formula ? i : parts_.size();
    }
    if (parts_[i].kind != Kind::word) break;
    name += ' ' + parts_[i].word;
  }
  return parts_.size();
}

bool Sentences::has_supposition(std::size_t word, Range sentence) const {
  const SentencePart& object = parts_[word + 1];
  if (is_person(object) || is_one_of(object, {"nothing", "what", "whatever", "there"})) return false;
  const bool is_passive = word + 2 < sentence.end && is_one_of(parts_[word + 2], {"be"});
  return !(is_passive && is_one_of(object, {"it", "this", "that"}));
}

bool Sentences::is_number(const SentencePart& part) const {
  if (part.kind != Kind::formula) return false;
  const auto& sides = stated_.at(part.span).sides;
  return sides.size() == 1 && sides.front().first.nodes.front().operation == Operation::number;
}

bool Sentences::is_told_to_do(std::size_t imperative, Range sentence, std::size_t own) const {
  const std::size_t object = imperative + 1;
  if (object >= sentence.end || !is_object(parts_[object])) return false;
  // "Spin 200 rad/s" has a number of what it names.
  if (is_one_of(parts_[imperative], {"spin", "tilt"}) && is_number(parts_[object])) return false;
  if (object + 1 < sentence.end && is_one_of(parts_[object + 1], {"that"})) return false;
  const auto explains = [](const SentencePart& part) { return part.kind == Kind::pause && part.word == ":"; };
  const auto from = parts_.begin() + static_cast<std::ptrdiff_t>(object),
             to = parts_.begin() + static_cast<std::ptrdiff_t>(std::max(own, object));
  return std::none_of(from, to, explains);
}

bool Sentences::is_supposed(Range sentence, std::size_t own) const {
  for (std::size_t i = sentence.begin; i < sentence.end; ++i) {
    const SentencePart& part = parts_[i];
    const bool is_first = i == sentence.begin;
    if (part.kind == Kind::question) return true;
    const bool is_for_once = !is_first && is_one_of(part, {"once"}) && is_preposition(parts_[i - 1]);
    // "When $t = 4$ s" is a time.
    const bool is_time =
        is_one_of(part, {"when"}) && i + 1 < sentence.end && parts_[i + 1].kind == Kind::time;
    if (is_conjunction(part) && !is_for_once && !is_time && is_condition(i, sentence)) return true;
    if (is_imperative(part) && (is_first || is_before_imperative(parts_[i - 1])) && i + 1 < sentence.end &&
        (is_supposing(part) ? has_supposition(i, sentence) : is_told_to_do(i, sentence, own)))
      return true;
    const bool is_which = is_one_of(part, {"which"}) && !is_first &&
                          (is_preposition(parts_[i - 1]) || is_one_of(parts_[i - 1], {"on", "along", "in"}));
    const bool is_such = is_one_of(part, {"that"}) && !is_first && is_one_of(parts_[i - 1], {"such"});
    const bool is_instead = is_one_of(part, {"of"}) && !is_first && is_one_of(parts_[i - 1], {"instead"});
    if ((is_which || is_such || is_instead) && i + 1 < sentence.end && parts_[i + 1].kind == Kind::equation)
      return true;
    // "At the moment of the flip"; by itself "at the moment" is now.
    const bool is_moment = is_one_of(part, {"at"}) && i + 3 < sentence.end &&
                           is_one_of(parts_[i + 1], {"the"}) &&
                           is_one_of(parts_[i + 2], {"moment", "instant", "time"}) &&
                           (parts_[i + 3].kind == Kind::formula || is_one_of(parts_[i + 3], {"of", "when"}));
    if (is_moment) return true;
    // "for small $\\omega_1$"
    const bool has_limit = i + 2 < sentence.end &&
                           is_one_of(parts_[i + 1], {"small", "large", "fixed", "given"}) &&
                           parts_[i + 2].is_formula();
    if (is_one_of(part, {"for", "at", "with"}) && has_limit) return true;
    // "The block spins with $\omega_2 = 7$ rad/s" says how it does.
    const bool is_said_of_motion = is_one_of(part, {"with"}) && !is_first && says_how_it_moves(parts_[i - 1]);
    if (!is_preposition(part) || is_said_of_motion) continue;
    const std::size_t equation = equation_behind(i, sentence);
    if (equation < parts_.size() && parts_[equation].kind == Kind::equation) return true;
  }
  // "Then", "In such a spin", "What remains is"
  std::size_t begin = sentence.begin;
  if (begin + 1 < sentence.end && is_one_of(parts_[begin], {"in"})) ++begin;
  const bool goes_on =
      sentence.begin > 0 && is_one_of(parts_[begin], {"then", "this", "that", "such", "what"});
  return goes_on && parts_[sentence.begin - 1].kind != Kind::question &&
         is_supposed(sentence_around(sentence.begin - 1), sentence.begin - 1);
}

bool Sentences::is_of_passing_over(std::size_t denial, Range clause) const {
  constexpr std::size_t kWordsBetween = 2;
  for (std::size_t i = denial + 1; i < clause.end && i <= denial + 1 + kWordsBetween; ++i)
    if (passes_over(parts_[i])) return true;
  return false;
}

bool Sentences::is_denied(Range clause, std::size_t own) const {
  int denials = 0;
  bool is_unreal = false;
  std::size_t that = clause.begin;  // what stands before the last "that" speaks of another clause
  for (std::size_t i = clause.begin; i < own; ++i)
    if (is_one_of(parts_[i], {"that"})) that = i;
  const bool is_of_clause = that == clause.begin || is_to_be_so(parts_[that - 1]) || denies(parts_[that - 1]);
  for (std::size_t i = is_of_clause ? clause.begin : that; i < clause.end; ++i) {
    const bool is_of_torque =
        i > clause.begin && is_one_of(parts_[i], {"no"}) && is_preposition(parts_[i - 1]);
    const bool is_of_change =
        i + 1 < clause.end && is_one_of(parts_[i + 1], {"change", "changes", "vary", "varies"});
    const bool is_of_bound = i + 1 < clause.end && denies(parts_[i]) &&
                             (is_one_of(parts_[i + 1], {"exceed", "exceeds"}) ||
                              (i + 2 < clause.end && is_one_of(parts_[i + 1], {"falls", "drops", "rises"}) &&
                               is_one_of(parts_[i + 2], {"below", "above"})));
    if (is_of_change || is_of_bound) continue;  // "does not change", "never exceeds" is what is said
    const bool is_only = i + 1 < clause.end && is_one_of(parts_[i], {"not"}) &&
                         is_one_of(parts_[i + 1], {"only", "just", "merely"});
    const bool is_without = i > clause.begin && is_one_of(parts_[i - 1], {"without", "beyond"});
    if (denies(parts_[i]) && !is_of_torque && !is_only && !is_without && !is_of_passing_over(i, clause))
      ++denials;
    is_unreal = is_unreal || is_one_of(parts_[i], {"would", "were", "could", "might"});
    const auto is_or = [](const SentencePart& part) { return is_one_of(part, {"or"}); };
    if (is_one_of(parts_[i], {"either"}))  // one of two
      is_unreal = is_unreal || std::any_of(parts_.begin() + static_cast<std::ptrdiff_t>(i),
                                           parts_.begin() + static_cast<std::ptrdiff_t>(clause.end), is_or);
  }
  return is_unreal || denials % 2 == 1;
}

/// The noun behind an indefinite article is the last word before a verb, a preposition or a pause.
bool Sentences::has_kind_of_body(Range sentence) const {
  constexpr std::size_t kWordsOfNoun = 4;
  for (std::size_t i = sentence.begin; i < sentence.end; ++i) {
    if (!is_one_of(parts_[i], {"a", "an", "any"})) continue;
    std::size_t end = i + 1;
    while (end < sentence.end && end <= i + kWordsOfNoun && parts_[end].kind == Kind::word &&
           !is_preposition(parts_[end]) &&
           !is_one_of(parts_[end],
                      {"has", "have", "is", "of", "in", "one", "two", "all", "the", "that", "which"}))
      ++end;
    std::string noun;
    for (std::size_t k = i + 1; k < end; ++k) noun += (noun.empty() ? "" : " ") + parts_[k].word;
    const bool is_of_the_one = std::any_of(
        parts_.begin() + static_cast<std::ptrdiff_t>(i + 1),
        parts_.begin() + static_cast<std::ptrdiff_t>(end), [](const SentencePart& part) {
          return is_one_of(
              part, {"body", "motion", "state", "case", "rule", "law", "turn", "flip", "wobble", "spin"});
        });
    const bool has_noun = end > i + 1 && dimensions_of_words(noun).empty() && !is_of_the_one;
    const bool is_ended = end == sentence.end || end <= i + kWordsOfNoun;
    const bool is_subject = i == sentence.begin || is_one_of(parts_[i - 1], {"for", "of", "in", "to"}) ||
                            parts_[i - 1].kind == Kind::pause;
    if (has_noun && is_ended && is_subject) return true;
  }
  return false;
}

Standing Sentences::standing_of(std::size_t span) const {
  Standing standing;
  const auto is_own = [&](const SentencePart& part) { return part.span == span; };
  const auto first = std::find_if(parts_.begin(), parts_.end(), is_own);
  if (first == parts_.end()) return standing;
  const Range sentence = sentence_around(static_cast<std::size_t>(first - parts_.begin()));
  int times = 0;
  for (std::size_t i = sentence.begin; i < sentence.end; ++i) {
    if (parts_[i].kind == Kind::word) standing.words += (standing.words.empty() ? "" : " ") + parts_[i].word;
    if (parts_[i].kind != Kind::time || is_own(parts_[i])) continue;
    ++times;
    standing.at_s = parts_[i].t_s;
    // "After $t = 1$ s", "until $t = 2$ s" is a while, of which nobody can be asked.
    std::size_t before = i;
    while (before > sentence.begin && is_one_of(parts_[before - 1], {"the", "time"})) --before;
    const bool is_at =
        before > sentence.begin && is_one_of(parts_[before - 1], {"at", "for", "with", "when"});
    if (!is_at) standing.is_stated = false;
  }
  if (times > 1) standing.is_stated = false;
  // Words in the formula may part it to several clauses: each of its equations is looked at.
  for (std::size_t own = sentence.begin; own < sentence.end && standing.is_stated; ++own) {
    if (!is_own(parts_[own]) || !parts_[own].is_formula()) continue;
    if (is_denied(clause_around(own, sentence), own)) standing.is_stated = false;
  }
  const std::size_t own = static_cast<std::size_t>(first - parts_.begin());
  if (is_supposed(sentence, own)) standing.is_stated = false;
  standing.has_kind_of_body = has_kind_of_body(sentence);
  const Range clause = clause_around(own, sentence);
  for (std::size_t i = sentence.begin; i < sentence.end; ++i) {
    const SentencePart& part = parts_[i];
    const bool is_in_clause = i >= clause.begin && i < clause.end;
    const bool is_all_the_time =
        i + 1 < clause.end && (is_one_of(part, {"all", "every"})) &&
        (is_one_of(parts_[i + 1], {"times", "time", "moment", "instant"}) ||
         (i + 2 < clause.end && is_one_of(parts_[i + 1], {"the"}) && is_one_of(parts_[i + 2], {"time"})));
    if (is_in_clause && (is_all_the_time || is_one_of(part, {"always", "never", "throughout", "stays",
                                                             "remains", "constantly"})))
      standing.is_always = true;
    const bool is_after_seconds =
        is_one_of(part, {"at", "after", "for"}) && i + 2 < sentence.end && parts_[i + 1].kind == Kind::word &&
        is_digit(parts_[i + 1].word.front()) &&
        is_one_of(parts_[i + 2], {"s", "ms", "seconds", "second", "min", "minutes"});
    if (is_after_seconds ||
        is_one_of(part, {"start", "starts", "started", "begin", "begins", "began", "beginning", "initial",
                         "initially", "becomes", "became", "reaches", "end", "ends", "finally", "first"}))
      standing.is_of_moment = true;
  }
  return standing;
}

bool Sentences::speaks_of_each(std::size_t span) const {
  const auto first =
      std::find_if(parts_.begin(), parts_.end(), [&](const SentencePart& part) { return part.span == span; });
  if (first == parts_.end()) return false;
  const auto own = static_cast<std::size_t>(first - parts_.begin());
  const Range clause = clause_around(own, sentence_around(own));
  for (std::size_t i = clause.begin; i + 1 < own; ++i)
    if (is_one_of(parts_[i], {"both", "each"}) &&
        is_one_of(parts_[i + 1], {"have", "has", "bodies", "motions", "scenes", "pictures", "tops", "spin",
                                  "turn", "begin", "start"}))
      return true;
  return false;
}

std::optional<std::size_t> Sentences::thing_named(std::size_t span,
                                                  const std::vector<CalledBy>& things) const {
  const auto first =
      std::find_if(parts_.begin(), parts_.end(), [&](const SentencePart& part) { return part.span == span; });
  if (first == parts_.end()) return std::nullopt;
  const auto own = static_cast<std::size_t>(first - parts_.begin());
  const Range clause = clause_around(own, sentence_around(own));
  const auto stands_at = [&](const std::vector<std::string>& words, std::size_t at) {
    if (at + words.size() > clause.end) return false;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const SentencePart& part = parts_[at + i];
      const bool is_owner = part.word == words[i] + "'s" || part.word == words[i] + "’s";
      if (part.kind != Kind::word || (part.word != words[i] && !is_owner)) return false;
    }
    return true;
  };
  std::optional<std::size_t> named;
  for (std::size_t i = clause.begin; i < clause.end;) {
    std::size_t size = 0, thing = 0;
    for (std::size_t k = 0; k < things.size(); ++k)
      for (const auto& words : things[k])
        if (words.size() > size && stands_at(words, i)) size = words.size(), thing = k;
    const bool is_of_another =
        is_one_of(parts_[i], {"first", "second", "third", "other", "former", "latter", "both", "each"});
    // "Less than that of the slab", "unlike the slab": of which it is not said.
    const bool is_beside =
        is_one_of(parts_[i], {"than", "unlike", "beside", "besides", "like", "instead", "before"});
    if (size == 0 && (is_of_another || is_beside)) return std::nullopt;
    if (size > 0 && named.value_or(thing) != thing) return std::nullopt;
    if (size > 0) named = thing;
    i += std::max<std::size_t>(size, 1);
  }
  return named;
}

}  // namespace polhode

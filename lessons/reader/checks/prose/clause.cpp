// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/prose/clause.h"

#include "base/ascii.h"
#include "lessons/reader/text_units.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace polhode {
namespace {

constexpr std::array<std::string_view, 6> kNearly{"about",   "nearly", "almost",
                                                  "roughly", "some",   "approximately"};
constexpr std::array<std::string_view, 14> kAdverbs{"now",    "only",      "always", "then", "exactly",
                                                    "just",   "thus",      "here",   "also", "therefore",
                                                    "simply", "precisely", "again",  "still"};

/// Cut off the end of a text, as a word of its own.
bool take_last_word(std::string_view& text, std::string_view word) {
  if (!text.ends_with(word)) return false;
  const std::string_view rest = text.substr(0, text.size() - word.size());
  if (word != ":" && !rest.empty() && is_letter(rest.back())) return false;
  text = without_blanks(rest);
  return true;
}

/// An adverb says nothing about a number: it goes if it is there.
template <typename Take>
void take_adverb(const Take& take) {
  for (const std::string_view word : kAdverbs)
    if (take(word)) return;
}

}  // namespace

std::vector<TextSpan> clause_before(const std::vector<TextSpan>& line, std::size_t at) {
  std::vector<TextSpan> clause;
  for (std::size_t k = at; k > 0; --k) {
    TextSpan span = line[k - 1];
    if (span.kind == TextSpan::Kind::text) {
      const std::size_t last = span.text.find_last_not_of(": ");
      const std::size_t end = last == span.text.npos ? last : span.text.find_last_of(".,;:!?()", last);
      if (end != span.text.npos) {
        span.text.erase(0, end + 1);
        clause.insert(clause.begin(), std::move(span));
        break;
      }
    }
    clause.insert(clause.begin(), std::move(span));
  }
  return clause;
}

std::optional<Relation> take_verb(std::vector<TextSpan>& clause) {
  if (clause.empty() || clause.back().kind != TextSpan::Kind::text) return std::nullopt;
  constexpr std::array<std::string_view, 17> kVerbs{
      "is equal to", "is given by", "has the value", "is called",  "is",    "was",
      "are",         "equals",      "comes to",      "amounts to", "lasts", "takes",
      "stays",       "remains",     "becomes",       "measures",   ":"};
  constexpr std::array<std::string_view, 5> kOfLength{"has the length", "has the magnitude",
                                                      "has a length of", "has the size", "has the norm"};
  std::string& text = clause.back().text;
  const std::string all = text;
  std::string_view rest = without_blanks(all);
  Relation relation = Relation::equal;
  const auto take = [&](std::string_view word) { return take_last_word(rest, word); };
  if (std::any_of(kNearly.begin(), kNearly.end(), take))
    relation = Relation::approximate;
  else
    take_adverb(take);
  const bool is_of_length = std::any_of(kOfLength.begin(), kOfLength.end(), take);
  if (!is_of_length && std::none_of(kVerbs.begin(), kVerbs.end(), take)) return std::nullopt;
  text = std::string(rest);
  if (is_of_length) clause.emplace(clause.begin())->text = "length of ";
  return relation;
}

std::optional<Relation> take_comparison(std::vector<TextSpan>& clause) {
  if (clause.empty() || clause.back().kind != TextSpan::Kind::text) return std::nullopt;
  using enum Relation;
  using Phrase = std::pair<std::string_view, Relation>;
  constexpr std::array<Phrase, 6> kVerbs{{{"never falls below", greater_or_equal},
                                          {"never drops below", greater_or_equal},
                                          {"never rises above", less_or_equal},
                                          {"never exceeds", less_or_equal},
                                          {"does not exceed", less_or_equal},
                                          {"exceeds", greater}}};
  constexpr std::array<Phrase, 9> kBehindVerb{{{"more than", greater},
                                               {"greater than", greater},
                                               {"larger than", greater},
                                               {"above", greater},
                                               {"at least", greater_or_equal},
                                               {"less than", less},
                                               {"smaller than", less},
                                               {"below", less},
                                               {"at most", less_or_equal}}};
  const std::string all = clause.back().text;
  std::string_view rest = without_blanks(all);
  const auto take = [&](std::string_view word) { return take_last_word(rest, word); };
  const auto take_phrase = [&](const Phrase& phrase) { return take(phrase.first); };
  const Phrase* said = std::ranges::find_if(kVerbs, take_phrase);
  if (said == kVerbs.end()) {
    said = std::ranges::find_if(kBehindVerb, take_phrase);
    if (said == kBehindVerb.end()) return std::nullopt;
    take("always");
    if (!take("is") && !take("stays") && !take("remains")) return std::nullopt;
  }
  clause.back().text = std::string(rest);
  return said->second;
}

std::optional<bool> take_between(std::vector<TextSpan>& clause) {
  if (clause.empty() || clause.back().kind != TextSpan::Kind::text) return std::nullopt;
  constexpr std::array<std::string_view, 11> kOfAllTimes{
      "stays", "remains", "lies", "keeps", "varies", "moves", "swings", "oscillates", "goes", "runs", "nods"};
  const std::string all = clause.back().text;
  std::string_view rest = without_blanks(all);
  const auto take = [&](std::string_view word) { return take_last_word(rest, word); };
  if (!take("between")) return std::nullopt;
  take_adverb(take);
  const bool is_of_all_times = std::any_of(kOfAllTimes.begin(), kOfAllTimes.end(), take);
  if (!is_of_all_times && !take("is")) return std::nullopt;
  take_adverb(take);
  clause.back().text = std::string(rest);
  return is_of_all_times;
}

std::vector<TextSpan> clause_behind(const std::vector<TextSpan>& line, std::size_t at) {
  std::vector<TextSpan> clause;
  for (std::size_t k = at + 1; k < line.size(); ++k) {
    TextSpan span = line[k];
    if (span.kind == TextSpan::Kind::text) {
      const std::size_t end = span.text.find_first_of(".,;:!?()");
      if (end != span.text.npos) {
        span.text.erase(end);
        clause.push_back(std::move(span));
        break;
      }
    }
    clause.push_back(std::move(span));
  }
  return clause;
}

std::optional<Relation> take_verb_at_start(std::vector<TextSpan>& clause) {
  if (clause.empty() || clause.front().kind != TextSpan::Kind::text) return std::nullopt;
  std::string_view rest = without_blanks(clause.front().text);
  const auto take = [&](std::string_view word) {
    if (!rest.starts_with(word) || (rest.size() > word.size() && is_letter(rest[word.size()]))) return false;
    rest = without_blanks(rest.substr(word.size()));
    return true;
  };
  constexpr std::array<std::string_view, 9> kVerbs{"is equal to", "is called", "is",      "was",  "are",
                                                   "equals",      "means",     "remains", "stays"};
  if (std::none_of(kVerbs.begin(), kVerbs.end(), take)) return std::nullopt;
  const Relation relation =
      std::any_of(kNearly.begin(), kNearly.end(), take) ? Relation::approximate : Relation::equal;
  if (relation == Relation::equal) take_adverb(take);
  const std::string text(rest);
  clause.front().text = text;
  return relation;
}

bool has_words(const std::vector<TextSpan>& clause) {
  return std::any_of(clause.begin(), clause.end(), [](const TextSpan& span) {
    return span.kind == TextSpan::Kind::text && !without_blanks(span.text).empty();
  });
}

}  // namespace polhode

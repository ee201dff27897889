// SPDX-License-Identifier: MIT
// Whether a line of prose states a formula that stands in it, or supposes, asks or denies it.
#pragma once

#include "lessons/notation/tex_statements.h"
#include "lessons/reader/lesson.h"

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

/// A word of a line, or one of its formulas.
struct SentencePart {
  enum class Kind {
    word,
    equation,  ///< a formula with =, < or another sign of relation
    time,      ///< "t = 2", with its unit behind it perhaps
    formula,   ///< another one
    pause,     ///< a comma, a colon, a bracket, a dash, or a word that begins a clause of its own: "so"
    end,       ///< of a sentence
    question   ///< the same
  };
  Kind kind = Kind::word;
  std::string word;  ///< small letters
  std::size_t span = 0;
  double t_s = 0;  ///< of `time`

  bool is_formula() const { return kind == Kind::equation || kind == Kind::time || kind == Kind::formula; }
};

/// How a formula stands in its sentence.
struct Standing {
  bool is_stated = true;
  std::optional<double> at_s;     ///< "at $t = 2$ s": when
  std::string words;              ///< of the sentence, small letters, one blank between two
  bool has_kind_of_body = false;  ///< "a sphere", "an egg", "any coin": not "a body"
  bool is_always = false;         ///< "always", "stays", "at all times" in its own clause
  bool is_of_moment = false;  ///< "it begins with", "at the start", "after 3 s", "becomes" in its sentence
};

/// One of several things, by the words that it may be called with: "second body", "the coin".
using CalledBy = std::vector<std::vector<std::string>>;

/// A line, taken apart to sentences. A sentence is free to say what is not so in general only where it says
/// for what it is so; a universal word, "for every body", supposes nothing.
///
///   asked     a question
///   supposed  a clause behind "if", "when", "where" and their like that has a subject and a predicate, or an
///             equation; one that begins with "let", "take", "consider" and their like; an equation directly
///             behind "with", "for", "at", or behind one of them and the name of a quantity; a sentence
///             behind one of these that begins with "then"
///   denied    in its own clause an odd number of words of denial: "there is no doubt" has two; one before
///             "that" counts where what it denies is that it is so: "it does not follow that", and not "it is
///             not hard to see that"
///   unreal    "would", "were" in its own clause
class Sentences {
 public:
  Sentences(const std::vector<TextSpan>& line, const EquationNotation& notation);

  /// What the formula that is this span of the line says.
  const Statements& stated(std::size_t span) const { return stated_.at(span); }
  Standing standing_of(std::size_t span) const;
  /// Of which of these things the clause of a span speaks: nothing where it names none or several, or has
  /// another "first" or "second" in it.
  std::optional<std::size_t> thing_named(std::size_t span, const std::vector<CalledBy>& things) const;
  /// "Both have", "each has", "both bodies": its clause speaks of all that stand side by side.
  bool speaks_of_each(std::size_t span) const;

 private:
  using Parts = std::vector<SentencePart>;
  struct Range {
    std::size_t begin = 0, end = 0;  ///< behind its last part
  };
  void add_words(const std::string& text, std::size_t span);
  void add_formula(const std::vector<TextSpan>& line, std::size_t span, const EquationNotation& notation);
  Range sentence_around(std::size_t part) const;
  Range clause_around(std::size_t part, Range sentence) const;
  /// `own` is the formula that it is asked of.
  bool is_supposed(Range sentence, std::size_t own) const;
  /// "Let us see", "let it be said" and "suppose what you like" suppose nothing.
  bool has_supposition(std::size_t word, Range sentence) const;
  /// "Turn the book by 90°" tells to do something, and what follows is of that; "take it that" does not, and
  /// what stands behind a colon is not of what is done.
  bool is_told_to_do(std::size_t imperative, Range sentence, std::size_t own) const;
  bool is_number(const SentencePart& part) const;
  /// "not" in "do not forget that" denies nothing.
  bool is_of_passing_over(std::size_t denial, Range clause) const;
  bool is_condition(std::size_t conjunction, Range sentence) const;
  /// An equation that a preposition stands before; npos.
  std::size_t equation_behind(std::size_t preposition, Range sentence) const;
  bool has_kind_of_body(Range sentence) const;
  bool is_denied(Range clause, std::size_t own) const;

  Parts parts_;
  std::map<std::size_t, Statements> stated_;  ///< by the span
};

}  // namespace polhode

// SPDX-License-Identifier: MIT
// Sets the blocks of a lesson as they stand in the text column of a page.
#pragma once

#include "app/narration/verdict_row.h"
#include "app/page/page_theme.h"
#include "app/page/text/column_piece.h"
#include "render/typeset/paragraph.h"

#include <string>
#include <vector>

namespace polhode {

/// How an equation stands among others: in focus between bar and panel, or with the room that these took.
enum class Focus { none, now, before };

/// What an equation of an earlier step is, in a line as set_line has it.
struct EarlierLabel {
  std::string title;     ///< of its step; empty: none, or another equation has it
  std::string word;      ///< what kind of claim it is; empty: none
  std::string note;      ///< what that is given
  std::string in_short;  ///< word and note, where both do not fit into the column
};

/// No type of a window's page is smaller, indices apart: px of which 96 are an inch.
inline constexpr double kLeastSmall = 12;

class TextColumn {
 public:
  /// `size` is the em of prose, `least` that of the smallest type. Symbols, numbers and fonts are kept by
  /// reference.
  TextColumn(double width, double size, Theme theme, Profile profile, const std::vector<MathSymbol>& symbols,
             const PageNumbers& numbers, const Fonts& fonts, double least = 0,
             Language language = Language::en)
      : width_(width),
        size_(size),
        theme_(theme),
        profile_(profile),
        symbols_(symbols),
        numbers_(numbers),
        fonts_(fonts),
        least_(least),
        language_(language) {}

  // The error of each says why the text cannot be set: the fonts lack a character of it.

  Result<ColumnPiece> title(const RichText& title) const;
  /// Of a step, above its text on a page.
  Result<ColumnPiece> step_title(const RichText& title) const;
  /// With the verdicts on what it claims below it. Terms of these names are marked.
  Result<ColumnPiece> equation(const Equation& equation, Focus focus, const std::vector<std::string>& marked,
                               const std::vector<ColumnPiece>& verdicts = {}) const;
  /// A chip with the verdict's word, its note beside or below it, what is claimed above where the equation is
  /// not that itself; with rows for live values, or without.
  ColumnPiece verdict(const VerdictRow& row, bool is_live) const;
  /// An equation of an earlier step: small, without emphasis; the title of its step on its left, in several
  /// lines if need be, or above it where it is too wide; its kind below it: that is of the formula.
  Result<ColumnPiece> earlier_equation(const Equation& equation, const EarlierLabel& label = {}) const;
  /// "from before", and the equation: behind it, in a line, or below it, where it is set a little smaller if
  /// it is too wide.
  Result<ColumnPiece> from_before(const Equation& equation, bool below) const;
  Result<ColumnPiece> prose(const RichText& text) const;
  /// Of a derivation the title, or in full its text.
  Result<ColumnPiece> callout(const Callout& callout, const std::string& label, bool in_full = false) const;
  /// Small, behind its number.
  Result<ColumnPiece> footnote(const Footnote& note) const;
  /// The same column with footnote `before` + 1 of the stage as its first.
  TextColumn with_notes_after(int before) const;
  /// A text as set_lines has it, small and quiet.
  ColumnPiece small_words(const std::string& text) const;
  /// A source, with the key that it is cited by.
  Result<ColumnPiece> reference(const Reference& reference) const;
  /// The short line above all footnotes.
  ColumnPiece footnote_rule() const;
  Result<ColumnPiece> question(const Ask& ask) const;
  /// A formula, and behind it a chip with the word, or below it where there is no room.
  Result<ColumnPiece> derived_line(const Math& formula, const std::string& word, Certainty certainty) const;

 private:
  const PageColors& colors() const { return colors_of(theme_); }
  TextStyle style(double size, Color color, double width) const;
  /// All of this colour: they keep their names.
  std::vector<MathSymbol> symbols_in(const Color& color) const;
  Result<DisplayList> set(const RichText& text, const TextStyle& style) const;
  /// The number of a footnote on this page.
  std::string mark_of_note(int number) const;
  /// The list with its highest ink or line at y = 0, and the rooms of its running numbers.
  Result<ColumnPiece> piece_of(Result<DisplayList> list, double em, double gap) const;
  void take_rooms(DisplayList& list, const Vec2& at, ColumnPiece& piece) const;
  struct Formula {
    DisplayList list;
    double scale = 1;
  };
  Result<Formula> formula(const Equation& equation, double size, double room) const;
  /// In the middle between `left` and the right edge, where its number stands.
  Result<ColumnPiece> numbered(const Equation& equation, double size, const std::vector<std::string>& marked,
                               double left = 0) const;
  Result<ColumnPiece> labelled(const std::string& label, const Color& color, Result<ColumnPiece> plain) const;
  /// Of what stands beside and below equations of earlier steps.
  DisplayList small_lines(const std::string& text, const Color& color, double room) const;
  /// The same in lines of about one length: no single word on a line of its own.
  DisplayList balanced_title(const std::string& title, double room) const;
  /// What kind of claim an equation is and what that is given, below it and right of `left`.
  void add_kind(const EarlierLabel& label, double left, ColumnPiece& piece) const;
  double label_indent() const;
  double small_size(double part) const;
  Color color_of(Certainty certainty) const;
  ColumnPiece chip(const std::string& word, Certainty certainty) const;
  void add_claimed(const VerdictRow& verdict, const TextStyle& style, ColumnPiece& piece) const;

  double width_, size_;
  Theme theme_;
  Profile profile_;
  const std::vector<MathSymbol>& symbols_;
  const PageNumbers& numbers_;
  const Fonts& fonts_;
  double least_;
  Language language_;  ///< of what is said besides the lesson's own words
  int notes_before_ = 0;
};

}  // namespace polhode

// SPDX-License-Identifier: MIT
// TeX by recursive descent: what stands behind parse_math(). Internal to render/typeset/math/.
#pragma once

#include "render/typeset/math/commands.h"
#include "render/typeset/math/lexer.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace polhode {

inline SourceSpan joined(SourceSpan a, SourceSpan b) {
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

inline MathNode node_of(MathNode::Kind kind, SourceSpan span) {
  MathNode node;
  node.kind = kind;
  node.span = span;
  return node;
}

/// Without spaces at its ends.
std::string trimmed(std::string text);

/// "2pt", "0.5em": em. TeX's points are of a ten-point font. Nothing if it is no length.
std::optional<double> length_in_em(const std::string& text);

class MathParser {
  using Kind = MathNode::Kind;
  using Token = MathToken;
  using Action = MathCommand::Action;

 public:
  MathParser(std::string_view tex, const MathMacros& macros, MathErrors& errors)
      : tokens_(tex, macros, errors) {}
  Math run();

 private:
  /// What waits to be closed.
  struct Open {
    enum class Kind { formula, brace, left, environment, bracket, dollar, argument } kind;
    std::string what;     // as written: "{", "\left", "\begin{aligned}"
    std::string partner;  // what closes it
    Token at;
  };

  // --- rows ---------------------------------------------------------------------------------------------
  MathNode formula();
  /// Until what closes the innermost opener, or a cell's end; neither is read.
  MathNode row();
  bool at_end_of_row();
  /// Whether the first token closes the innermost opener. If not, it closes nothing, and is left behind.
  bool closes(const std::string& what);
  void closes_nothing(const Token& token, const std::string& what);
  void never_closed(const Open& open);
  /// The beginning of what it opens.
  std::string quoted(const Open& open) const;
  bool ends_cell(const std::string& what);
  /// At \end: reads its name.
  bool end_of_environment();
  /// What closes the opener has come: reads it. At the formula's end the opener stays open.
  bool close(Token* closing = nullptr);
  bool open(Open::Kind kind, std::string what, std::string partner, const Token& at);

  // --- atoms --------------------------------------------------------------------------------------------
  /// One more atom behind `into`, or something done to the last one.
  void item(std::vector<MathNode>& into);
  static const MathCommand* command_of(const Token& token);
  MathNode atom();
  MathNode group(const Token& at);
  MathNode symbol(const Token& at, char32_t character, MathClass atom_class) const;
  MathNode character(const Token& token);
  static MathNode space(const Token& token, double em);
  MathNode command(const Token& token);
  MathNode unknown(const Token& token);

  // --- arguments ----------------------------------------------------------------------------------------
  /// A group in braces or a single atom. `usage` says how the command is written.
  MathNode argument(const Token& command, std::string_view usage);
  static std::string written(const Token& token);
  static bool begins_argument(const Token& token);
  /// What stands in brackets, if a bracket comes.
  MathNode optional_argument();
  /// The text of braces that hold no braces, without commands. Nothing, and an error, if there are none.
  std::optional<std::string> plain_argument(const Token& command, const std::string& usage,
                                            std::size_t* offset = nullptr);
  /// Past the } of the group that has begun.
  void skip_group();
  std::optional<std::string> no_plain_argument(const Token& command, const std::string& usage);

  // --- scripts ------------------------------------------------------------------------------------------
  void script(std::vector<MathNode>& into);
  MathNode& scripted(std::vector<MathNode>& into, const Token& mark);
  /// All primes that follow, and the superscript behind them.
  MathNode primes(const Token& first);
  void set_limits(const MathCommand& command, std::vector<MathNode>& into);

  // --- commands with arguments --------------------------------------------------------------------------
  MathNode named_operator(const Token& token, const MathCommand& command);
  MathNode operator_name(const Token& token);
  MathNode alphabet(const Token& token, Alphabet wanted);
  /// \mathrm{max} is a word of the text's font, with its kerning.
  static std::optional<MathNode> as_word(const MathNode& letters, Alphabet wanted);
  /// The span of a node that holds its children.
  static void finish(MathNode& node);
  MathNode fraction(const Token& token, const MathCommand& command);
  /// a \over b: all before and all behind, as far as the braces go.
  void infix(const MathCommand& command, std::vector<MathNode>& into);
  MathNode radical(const Token& token);
  MathNode delimiter_node(const Token& token, char32_t character) const;
  /// The delimiter that comes next, if one does.
  std::optional<char32_t> next_delimiter();
  void take_delimiter();
  void skip_delimiter();
  MathNode delimiter(const Token& command, std::string_view usage);
  MathNode fenced(const Token& token);
  MathNode big(const Token& token, const MathCommand& command);
  MathNode stacked(const Token& token, const MathCommand& command);
  MathNode arrow(const Token& token, const MathCommand& command);
  MathNode negate(const Token& token);
  MathNode hspace(const Token& token);
  std::optional<Color> color_argument(const Token& token);
  MathNode text_color(const Token& token);
  void color_of_rest(std::vector<MathNode>& into);
  MathNode term(const Token& token);
  MathNode proved_part(const Token& token);
  /// name=value of […], where a value may stand in braces. Nothing, and an error, where they are not read.
  struct Option {
    std::string name, value;
    Token at, value_at;
  };
  std::optional<std::vector<Option>> options(const Token& command, const std::string& usage);
  void read_options(const std::vector<Option>& options, bool has_digits, LiveNumber& number);
  /// \live and \value, with the unit behind the number.
  void computed_number(const Token& token, const MathCommand& command, std::vector<MathNode>& into);
  MathNode reference(const Token& token);
  void tag();
  /// Accents, bars, braces, boxes and what else does something to one argument.
  MathNode wrapped(const Token& token, const MathCommand& command);

  // --- text ---------------------------------------------------------------------------------------------
  MathNode text(const Token& token, Face face);
  /// What stands in braces, as runs of text and formulas between $, behind `into`.
  bool text_group(const Token& at, Face face, MathNode& into);
  bool text_item(const Token& token, Face face, MathNode& into);
  static void add_text(const Token& token, Face face, char32_t c, MathNode& into);
  bool formula_in_text(const Token& token, MathNode& into);
  bool text_command(const Token& token, Face face, MathNode& into);

  // --- environments -------------------------------------------------------------------------------------
  std::optional<std::string> environment_name(std::string_view command, const Token& token);
  MathNode environment(const Token& token);
  /// [t] of aligned: alignments are centred on the axis always.
  /// [t], [c] or [b] is read; a formula's lines stand about the axis whatever it says.
  void vertical_place(const std::string& environment);
  void array_columns(const Token& token, MathGrid& grid);
  MathNode substack(const Token& token);
  /// Cells until what closes the innermost opener; rows shorter than others are filled with empty cells.
  MathNode cells(MathGrid grid, const Token& at);
  void lines_above(MathGrid& grid, int at_row);
  /// \\[2pt]
  double extra_skip(const Token& separator);
  static MathNode grid_node(MathGrid grid, std::vector<std::vector<MathNode>> rows, const Token& at);
  MathTokens tokens_;
  std::vector<Open> open_;
  Alphabet alphabet_ = Alphabet::normal;
  int infix_depth_ = 0;
  bool ended_ = false;  // the \end that the innermost environment waits for has been read
  std::uint32_t environment_end_ = 0, last_end_ = 0;
  std::string tag_;
  std::vector<std::string> terms_;
  std::vector<LiveNumber> live_;
  std::vector<MathReference> references_;
  std::vector<std::size_t> tag_offsets_, term_offsets_;
};

}  // namespace polhode

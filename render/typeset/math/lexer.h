// SPDX-License-Identifier: MIT
// TeX as tokens, with the author's macros already put in.
#pragma once

#include "render/typeset/math/math.h"

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// What is wrong with a formula, as far as it is worth telling.
class MathErrors {
 public:
  void add(std::size_t offset, std::string message, std::string hint = {});
  void add(TypeError error);
  bool full() const { return errors_.size() >= kMaxTypeErrors; }
  bool none() const { return errors_.empty(); }
  /// In the order of their offsets.
  std::vector<TypeError> take();

 private:
  std::vector<TypeError> errors_;
};

struct MathToken {
  enum class Kind : std::uint8_t { end, character, command, open, close, space, parameter };
  Kind kind = Kind::end;
  char32_t character = 0;    ///< of a parameter its number
  std::string_view name;     ///< of a command, without backslash
  SourceSpan span;           ///< of what a macro stands for: the whole call
  int origin = -1;           ///< index of the expansion it comes from
  std::uint32_t body = 0;    ///< byte of what the macro of that expansion stands for
  bool is_no_macro = false;  ///< it was looked up: a token is peeked at many times

  bool is(char32_t c) const { return kind == Kind::character && character == c; }
  bool is_command(std::string_view n) const { return kind == Kind::command && name == n; }
};

/// A stream of tokens. Macros are replaced when they come to its front; what they make in all, and how deep
/// they stand in each other, is bounded. `tex` and `macros` must outlive it.
class MathTokens {
 public:
  MathTokens(std::string_view tex, const MathMacros& macros, MathErrors& errors);

  /// The first token that is no space.
  MathToken peek();
  MathToken next();
  /// The first token, spaces included.
  MathToken peek_raw();
  MathToken next_raw();

  /// The rest is left out.
  void stop();
  bool stopped() const { return stopped_; }

  void error(const MathToken& at, std::string message, std::string hint = {});

  std::string_view source() const { return tex_; }
  /// So many tokens macros stood for up to now.
  std::size_t made() const { return made_; }
  /// Names of the author's macros.
  const MathMacros& macros() const { return macros_; }

 private:
  struct Expansion {
    std::string_view name;
    int parent = -1;
    int depth = 1;
  };
  using List = std::vector<MathToken>;

  List read(std::string_view tex, bool is_macro);
  void expand();
  /// Of something that the token does: said of the macro of the author that holds it, if one does.
  TypeError error_at(const MathToken& at, std::string message, std::string hint = {}) const;
  bool may_expand(const MathToken& call, std::string_view name);
  bool read_argument(const MathToken& call, std::string_view name, int count, List& into, std::uint32_t& end);
  void put_back(const List& body, const std::vector<List>& arguments, const MathToken& call, int origin);

  std::string_view tex_;
  const MathMacros& macros_;
  MathErrors& errors_;
  List ahead_;  // the next one is the last
  MathToken end_;
  std::vector<Expansion> expansions_;
  std::map<std::string_view, List> bodies_;
  std::size_t made_ = 0;
  bool stopped_ = false;
};

}  // namespace polhode

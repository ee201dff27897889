// SPDX-License-Identifier: MIT
#include "lessons/reader/checks/symbol_check.h"

#include "lessons/claims/customary_names.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/motion_words.h"
#include "lessons/claims/proof/proof.h"
#include "lessons/notation/tex_sides.h"
#include "render/typeset/math/tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <utility>

namespace polhode {
namespace {

/// Indices, alone or below a letter, the letters of d/dt, signs, and letters that look like Latin ones.
bool is_sign_of_language(const std::string& tex) {
  if (tex == "\\pi" || tex == "\\omega") return true;
  static const std::set<std::string> kSigns = {"i", "j", "k", "l", "d", "t", "=", "+", "-",
                                               ",", ";", "(", ")", "[", "]", "/", "|", ":"};
  if (kSigns.contains(tex)) return true;
  for (const char* index : {"_i", "_j", "_k", "_l"})
    if (tex.ends_with(index)) return true;
  const bool has_letter =
      std::any_of(tex.begin(), tex.end(), [](unsigned char c) { return std::isalpha(c); });
  const bool is_foreign = std::any_of(tex.begin(), tex.end(), [](unsigned char c) { return c >= 0x80; });
  return !has_letter || is_foreign;
}

/// dT, d\omega: nobody would read one name.
bool is_like_differential(const std::string& tex) {
  const auto letter = [&](std::size_t at) {
    return at < tex.size() && std::isalpha(static_cast<unsigned char>(tex[at]));
  };
  if (tex.size() < 2 || tex[0] != 'd' || tex.starts_with("d\\prime")) return false;
  return tex[1] == '\\' || (letter(1) && !letter(2));
}

/// Letters that stand for functions of time wherever the motion of a body is written about, and for the
/// moments of the body.
bool is_letter_of_state(char32_t letter) {
  return std::u32string_view(U"TEHtθϑφϕψIωLNpvF").find(letter) != std::u32string_view::npos;
}

/// "0", "max": what tells one value from the quantity of that letter.
bool has_index_of_value(const std::string& tex) {
  static const std::set<std::string> kIndices = {"0",   "00",  "max",  "min", "start",
                                                 "end", "ref", "crit", "c",   "s"};
  const std::size_t at = tex.find('_');
  return at != tex.npos && kIndices.contains(tex.substr(at + 1));
}

/// ω, L or N, whose colour is that of its components too; empty of other quantities.
std::string role_of_quantity(const std::string& name) {
  if (name == "omega" || name == "w1" || name == "w2" || name == "w3") return "omega";
  if (name == "L") return "L";
  return name == "N" || name == "N1" || name == "N2" || name == "N3" ? "N" : "";
}

/// Nothing where it cannot be told.
std::optional<Expression> expression_of_symbol(const std::string& name, const Symbol& symbol,
                                               const FrontMatter& front) {
  const std::string& text = symbol.means.empty() ? name : symbol.means;
  const SourceText source(text);
  Report unused(source, "");
  return read_expression(text, {1, 1}, unused, &front.notation.vocabulary);
}

/// False where it is known not to be one.
bool may_be_unit_vector(const std::string& name, const Symbol& symbol, const FrontMatter& front,
                        std::optional<Prover>& prover) {
  const auto expression = expression_of_symbol(name, symbol, front);
  if (!expression) return true;
  if (expression->type() != ExpressionType::vector) return false;
  const std::string& text = symbol.means.empty() ? name : symbol.means;
  const std::string square = "norm2(" + text + ')', one = "1";
  const SourceText source(square);
  Report unused(source, "");
  const Vocabulary& words = front.notation.vocabulary;
  auto left = read_expression(square, {1, 1}, unused, &words);
  auto right = read_expression(one, {1, 1}, unused, &words);
  if (!left || !right) return true;
  const Equality equality{std::move(*left), std::move(*right)};
  if (!prover) prover.emplace();
  const Verdict verdict = prover->settle(equality, LawsAssumed::motion);
  return verdict == Verdict::holds ||
         (verdict == Verdict::undecided && !prover->refute(equality, LawsAssumed::motion));
}

/// Whether words are the name of an angle, or of its cosine or sine.
enum class SaidOfAngle { nothing, angle, cosine };
SaidOfAngle said_of_angle(std::string words) {
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view article : {"the ", "its ", "a ", "an "})
    if (words.starts_with(article)) words.erase(0, article.size());
  const std::string first = words.substr(0, words.find(' '));
  if (first == "cosine" || first == "sine") return SaidOfAngle::cosine;
  return first == "angle" || first == "tilt" ? SaidOfAngle::angle : SaidOfAngle::nothing;
}

bool is_quantity(const std::string& name) {
  const auto& known = expression_symbols();
  return std::find(known.begin(), known.end(), name) != known.end();
}

/// Upright or slanted, wide or narrow: nobody tells them apart.
std::string without_alphabets(std::string tex) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kLooksAlike{{
      {"\\overrightarrow", "\\vec"},
      {"\\mathnormal", ""},
      {"\\textnormal", ""},
      {"\\mathit", ""},
      {"\\mathrm", ""},
      {"\\mathup", ""},
      {"\\symup", ""},
      {"\\symit", ""},
      {"\\textit", ""},
      {"\\textrm", ""},
      {"\\emph", ""},
      {"\\mbox", ""},
      {"\\text", ""},
      {"\\wide", "\\"},
  }};
  for (const auto& [other, usual] : kLooksAlike)
    for (std::size_t at = 0; (at = tex.find(other, at)) != tex.npos; at += usual.size()) {
      const std::size_t end = at + other.size();
      const bool is_whole =
          other == "\\wide" || end == tex.size() || !std::isalpha(static_cast<unsigned char>(tex[end]));
      if (is_whole)
        tex.replace(at, other.size(), usual);
      else
        ++at;
    }
  return tex;
}

/// A formula as an expression; nothing if that is nothing known, or each of three, as \omega_i.
std::optional<std::string> meaning_of(const Math& math, const EquationNotation& notation) {
  if (const auto read = read_side_of_claim(math, notation)) return read->text;
  // A tensor is no side of a claim, but known.
  const auto whole = read_one_side(math, notation);
  return whole || !whole.error().of_kinds ? std::nullopt : std::optional<std::string>("a tensor");
}

/// What a symbol's TeX is without the lesson's symbols.
std::optional<std::string> built_in_meaning(const Symbol& symbol, const EquationNotation& built_in,
                                            TextReader& texts) {
  const std::string tex = without_alphabets(symbol.tex);
  if (tex == symbol.tex) return meaning_of(symbol.math, built_in);
  const auto math = parse_math(tex, texts.macros());
  return math ? meaning_of(*math, built_in) : std::nullopt;
}

/// Latin, Greek and script letters: what else stands in formulas has a meaning there.
bool is_letter(char32_t c) {
  return (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z') || (c >= 0x370 && c <= 0x3FF) ||
         (c >= 0x2100 && c <= 0x214F);
}

bool is_index_letter(const MathNode& node) {
  return node.kind == MathNode::Kind::symbol && node.character >= U'i' && node.character <= U'l';
}

/// What nobody would notice in an index.
bool is_stop(char32_t character) {
  return std::u32string_view(U",.;:!'`·⋅∙∘").find(character) != std::u32string_view::npos;
}

/// T_{=5} would state something; ω_∥ does not.
bool is_relation(char32_t character) {
  return std::u32string_view(U"=<>≤≥⩽⩾≈≠≡∼≃≅∝").find(character) != std::u32string_view::npos;
}

/// ω², which would be read as the square of what ω is, and U⁻¹; σ² may be a symbol of its own.
bool is_power_of_quantity(const MathNode& scripts) {
  const MathNode &base = scripts.children[0], &power = without_groups(scripts.children[2]);
  const auto is_digit = [](const MathNode& node) {
    return node.kind == MathNode::Kind::symbol && node.character >= U'0' && node.character <= U'9';
  };
  if (power.kind == MathNode::Kind::row && power.children.size() > 1) {
    const MathNode& first = power.children.front();
    const bool is_sign = first.character == U'−' || first.character == U'+';
    return (is_digit(first) || is_sign) &&
           std::all_of(power.children.begin() + 1, power.children.end(), is_digit);
  }
  return base.kind == MathNode::Kind::symbol &&
         std::u32string_view(U"TIωLNmpvFA").find(base.character) != std::u32string_view::npos &&
         is_digit(power);
}

/// A letter that a reader takes for a digit: O, o, and l and I where they have no slant. With an index it is
/// none, as in o_0.
bool looks_like_digit(const MathNode& node) {
  using Kind = MathNode::Kind;
  if (node.kind == Kind::scripts) return node.children[1].absent() && looks_like_digit(node.children[0]);
  if (node.kind != Kind::symbol) {
    const bool is_seen_through = node.kind == Kind::row || node.kind == Kind::alphabet;
    return is_seen_through && !node.children.empty() && looks_like_digit(node.children.front());
  }
  if (std::u32string_view(U"OoΟοι").find(node.character) != std::u32string_view::npos) return true;
  const bool is_straight = node.alphabet == Alphabet::upright || node.alphabet == Alphabet::sans ||
                           node.alphabet == Alphabet::mono;
  return is_straight && (node.character == U'l' || node.character == U'I');
}

/// \hat n, which everywhere is a vector of length 1.
bool has_hat(const MathNode& node) {
  if (node.kind == MathNode::Kind::scripts) return has_hat(node.children[0]);
  const bool is_hat = node.kind == MathNode::Kind::accent && node.character == 0x0302;
  return is_hat || std::any_of(node.children.begin(), node.children.end(), has_hat);
}

/// A letter, or some side by side, with indices and marks that can be seen, none of which formulas use
/// otherwise: no dots, fractions, roots, functions, blanks.
bool is_plain_symbol(const MathNode& node, bool is_index = false) {
  using Kind = MathNode::Kind;
  constexpr std::u32string_view kDots = U"\u0307\u0308\u20DB\u20DC";
  const auto are_plain = [&](bool in_index) {
    return std::all_of(node.children.begin(), node.children.end(),
                       [in_index](const MathNode& child) { return is_plain_symbol(child, in_index); });
  };
  switch (node.kind) {
    case Kind::symbol:
      if (!is_index) return is_letter(node.character);
      return !is_stop(node.character) && !is_relation(node.character);
    case Kind::row:
      // An i beside other indices is one of a sum.
      if (is_index && std::any_of(node.children.begin(), node.children.end(), is_index_letter)) return false;
      return !node.children.empty() && are_plain(is_index);
    case Kind::alphabet:
      return !node.children.empty() && are_plain(is_index);
    case Kind::accent:
      return kDots.find(node.character) == std::u32string_view::npos && are_plain(is_index);
    case Kind::bar:
      return are_plain(is_index);
    case Kind::text:
      return is_index && node.text.find_first_of("0123456789") == std::string::npos &&
             node.text.find_first_not_of(' ') != std::string::npos;
    case Kind::scripts:
      return !is_power_of_quantity(node) && is_plain_symbol(node.children[0], is_index) &&
             (node.children[1].absent() || is_plain_symbol(node.children[1], true)) &&
             (node.children[2].absent() || is_plain_symbol(node.children[2], true));
    default:
      return false;
  }
}

/// What a symbol's TeX would be read as by the other symbols of the lesson; nothing if by none.
std::optional<std::string> meaning_by_others(const std::string& name, const Symbol& symbol,
                                             FrontMatter& front) {
  // A symbol without a formula is found in none.
  std::vector<EquationSymbol>& symbols = front.notation.symbols;
  const auto own =
      std::find_if(symbols.begin(), symbols.end(), [&](const EquationSymbol& s) { return s.name == name; });
  Math kept = own == symbols.end() ? Math() : std::exchange(own->math, Math());
  auto meaning = meaning_of(symbol.math, front.notation);
  if (own != symbols.end()) own->math = std::move(kept);
  return meaning;
}

/// Whether an arrow stands above all of it, as above a vector.
bool has_arrow(const MathNode& node) {
  const MathNode& inner = without_groups(node);
  if (inner.kind == MathNode::Kind::accent) return inner.character == 0x20D7;
  const bool is_decorated = inner.kind == MathNode::Kind::scripts || inner.kind == MathNode::Kind::alphabet;
  return is_decorated && !inner.children.empty() && has_arrow(inner.children.front());
}
/// An arrow, a hat or bold type.
bool is_printed_as_vector(const MathNode& node) {
  const MathNode& inner = without_groups(node);
  if (inner.kind == MathNode::Kind::accent || inner.alphabet == Alphabet::bold ||
      inner.alphabet == Alphabet::bold_italic)
    return true;
  return std::any_of(inner.children.begin(), inner.children.end(), is_printed_as_vector);
}

/// The axis of space that an index names, of an expression that speaks of another one; 0: of none.
char axis_of_another(const MathNode& node, const Expression& expression) {
  const MathNode& inner = without_groups(node);
  if (inner.kind != MathNode::Kind::scripts || inner.children[1].absent()) return 0;
  const MathNode& index = without_groups(inner.children[1]);
  const bool is_axis =
      index.kind == MathNode::Kind::symbol && index.character >= U'x' && index.character <= U'z';
  if (!is_axis) return 0;
  constexpr std::array<Quantity, 3> kAxes{Quantity::ex, Quantity::ey, Quantity::ez};
  const std::size_t named = index.character - U'x';
  const bool speaks_of_one =
      std::any_of(kAxes.begin(), kAxes.end(), [&](Quantity axis) { return expression.uses(axis); });
  return speaks_of_one && !expression.uses(kAxes[named]) ? static_cast<char>(index.character) : '\0';
}

/// A letter alone, the words that are said for it and its colour are those of a quantity of this kind.
void check_name(const TomlEntry& entry, const Symbol& symbol, const FrontMatter& front, Report& report) {
  const bool is_known = is_quantity(entry.key);
  const Vocabulary::Word* word = front.notation.vocabulary.find(entry.key);
  const auto refuse = [&](const std::string& why, const std::string& hint) {
    report.error(entry.place, "symbol " + in_quotes(entry.key) + ' ' + why, hint);
  };
  const char32_t letter = symbol.math.root ? letter_of_name(symbol.math) : U'\0';
  const bool is_alone = symbol.tex.find_first_of("_^'") == std::string::npos;
  // With an index E is still an energy; p_φ is no momentum, and an ω_A may be drawn without a unit.
  const bool keeps_kind = letter == U'E';
  const auto of_letter =
      letter != U'\0' && (is_alone || keeps_kind) ? dimensions_of_letter(letter) : std::vector<Dimension>();
  if (!is_known && word == nullptr && symbol.means.empty()) {
    // Of what means nothing there are letter, words and unit alone.
    const auto of_words = dimensions_of_words(symbol.say);
    const auto unit = symbol.unit.empty() ? std::nullopt : dimension_of_unit(symbol.unit);
    if (!can_have(of_words, unit) || !can_have(of_letter, unit))
      return refuse("has the unit of another quantity", "say what it is");
    const bool agree = of_letter.empty() || of_words.empty() ||
                       std::any_of(of_words.begin(), of_words.end(),
                                   [&](const Dimension& one) { return can_have(of_letter, one); });
    if (!agree)
      refuse("is printed as another quantity than " + in_quotes(symbol.say),
             "take another letter, or say what it is");
    return;
  }
  const auto expression = expression_of_symbol(entry.key, symbol, front);
  const auto dimension = expression ? dimension_of(*expression, front.dimensions).dimension : std::nullopt;
  const bool is_constant = word != nullptr && word->constant();
  if (expression && symbol.math.root) {
    const MathNode& printed = *symbol.math.root;
    if (expression->type() == ExpressionType::scalar && has_arrow(printed))
      return refuse("is a number, and has the arrow of a vector", "leave out \\vec");
    const bool is_direction = dimension == kNumber;  // a name of an axis
    if (expression->type() == ExpressionType::vector && !is_direction && !is_printed_as_vector(printed))
      return refuse("is a vector, and is printed as a number", "write \\vec");
    if (const char axis = axis_of_another(printed, *expression); axis != 0)
      return refuse("has the index " + in_quotes(std::string(1, axis)) + ", and is along another axis",
                    "give it the index of its axis");
  }
  if (is_constant && !dimension && !of_letter.empty())
    return refuse("is printed as a quantity of " + to_string(of_letter.front()) + ", and has no unit",
                  "say which: unit = \"…\", or take another letter");
  if (!can_have(of_letter, dimension))
    return refuse(
        "is " + to_string(*dimension) + ", and is printed as what is " + to_string(of_letter.front()),
        "take another letter, or give it an index");
  if (!can_have(dimensions_of_words(symbol.say), dimension))
    return refuse("is " + to_string(*dimension) + ", and is said as " + in_quotes(symbol.say),
                  "say what it is");
  if (dimension && *dimension != kNumber && said_of_angle(symbol.say) != SaidOfAngle::nothing)
    return refuse("is " + to_string(*dimension) + ", and is said as " + in_quotes(symbol.say),
                  "say what it is");
  if (expression && dimension == kNumber && expression->type() == ExpressionType::scalar) {
    const SaidOfAngle said = said_of_angle(symbol.say);
    const Operation last = expression->nodes.back().operation;
    const bool is_angle = last == Operation::acos || last == Operation::atan2;
    const bool is_ratio = expression->order() == 0 && (word == nullptr || !word->constant()) &&
                          !why_not_in(*expression, "rad").empty();
    const bool is_letter_of_angle =
        letter != U'\0' && is_alone && std::u32string_view(U"θϑ").find(letter) != std::u32string_view::npos;
    if (is_letter_of_angle && is_ratio)
      return refuse("is no angle, and is printed as one", "take another letter, such as u");
    if ((said == SaidOfAngle::cosine && is_angle) || (said == SaidOfAngle::angle && is_ratio))
      return refuse((is_angle ? "is an angle, and is said as " : "is no angle, and is said as ") +
                        in_quotes(symbol.say),
                    "say what it is");
  }
  const std::string own = role_of_quantity(entry.key);
  const bool is_role_of_quantity = symbol.role == "omega" || symbol.role == "L" || symbol.role == "N";
  if (!own.empty() && is_role_of_quantity && symbol.role != own)
    refuse("has the colour of another quantity, role " + in_quotes(symbol.role),
           "its own is " + in_quotes(own));
}

}  // namespace

bool is_component_name(std::string_view name) {
  constexpr std::array<std::string_view, 8> kVectors{"omega", "w", "L", "N", "A", "v", "p", "F"};
  return !is_quantity(std::string(name)) &&
         std::any_of(kVectors.begin(), kVectors.end(), [&](std::string_view vector) {
           if (!name.starts_with(vector)) return false;
           std::string_view index = name.substr(vector.size());
           if (index.starts_with('_')) index.remove_prefix(1);
           return index.size() == 1 && std::string_view("123xyz").find(index[0]) != std::string_view::npos;
         });
}

void check_meanings(const std::vector<const TomlEntry*>& entries, FrontMatter& front, TextReader& texts) {
  const auto key_of = [](const std::string& written) {
    std::string tex = without_alphabets(written);
    std::erase_if(tex, [](char c) { return c == ' ' || c == '{' || c == '}'; });
    return tex;
  };
  // Two that look the same are told apart from what others are read as.
  std::map<std::string, int> alike;  // how many have this key
  for (const auto& [name, symbol] : front.symbols) ++alike[key_of(symbol.tex)];
  const auto has_twin = [&](const std::string& tex) { return alike[tex] > 1; };
  std::optional<Prover> prover;  // of vectors with a hat
  EquationNotation built_in;
  built_in.xyz_are_body_axes = front.notation.xyz_are_body_axes;
  std::map<std::string, std::string> names;
  for (const Vocabulary::Word& word : front.notation.vocabulary.words())
    if (word.tex.empty()) names.emplace(key_of(word.name), word.name);  // as it is printed
  for (const TomlEntry* one : entries) {
    const TomlEntry& entry = *one;
    const auto found = front.symbols.find(entry.key);
    if (found == front.symbols.end() || found->second.tex.empty()) continue;
    const Symbol& symbol = found->second;
    const auto refuse = [&](const std::string& why, const std::string& hint) {
      texts.report().error(entry.place, "symbol " + in_quotes(entry.key) + ' ' + why, hint);
    };
    const auto known = built_in_meaning(symbol, built_in, texts);
    const std::string tex = key_of(symbol.tex);
    const auto [same, is_new] = names.emplace(tex, entry.key);
    const Vocabulary::Word* word = front.notation.vocabulary.find(entry.key);
    const bool means = !symbol.means.empty() || word != nullptr;
    const auto other = front.symbols.find(same->second);
    const bool other_means = other == front.symbols.end() || !other->second.means.empty();
    if (!is_new && same->second != entry.key && (means || other_means))
      refuse("looks like symbol " + in_quotes(same->second), "one of them needs another letter");
    else if (!symbol.means.empty() && is_component_name(entry.key))
      refuse("has the name that learners type for a component",
             "take another name, such as \"" + entry.key.substr(0, 1) + "_after\"");
    else if (means && known)
      refuse("is known already: it is " + *known, "leave out \"means\", or take another letter");
    else if (const bool is_plain = symbol.math.root && is_plain_symbol(*symbol.math.root);
             (means && (is_sign_of_language(tex) || !is_plain)) ||
             (is_quantity(entry.key) && known != entry.key && symbol.math.root && !is_plain))
      refuse("has a sign that formulas use otherwise", "take a letter, with an index or a mark");
    else if (means && symbol.math.root && looks_like_digit(*symbol.math.root))
      refuse("is printed as a letter that looks like a digit", "take another letter");
    else if (means && symbol.math.root && has_hat(*symbol.math.root) &&
             !may_be_unit_vector(entry.key, symbol, front, prover))
      refuse("has a hat, and is no vector of length 1", "take a letter without one: \\vec n, or n");
    else if ((means || is_quantity(entry.key)) && is_like_differential(tex))
      refuse("reads as a differential", "take a letter without a d before it");
    else if (const char32_t letter = symbol.math.root ? letter_of_name(symbol.math) : U'\0';
             word != nullptr && word->constant() && is_letter_of_state(letter) && !has_index_of_value(tex))
      refuse("is a constant, and is printed as what changes with the motion, or is known of the body",
             "a value that does not change has an index: E_0, \\omega_\\text{max}");
    else if (const auto by_others =
                 means && !has_twin(tex) ? meaning_by_others(entry.key, symbol, front) : std::nullopt)
      refuse("is known already: the other symbols make it " + *by_others, "take another letter");
    else if (!means && known && *known != entry.key && is_quantity(entry.key))
      refuse("is printed as " + *known + ", and has the name of another quantity",
             "give it the name " + *known);
    check_name(entry, symbol, front, texts.report());
  }
}

}  // namespace polhode

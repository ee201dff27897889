// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_equation.h"

#include "base/words/formula_words.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/notation/tex_terms.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Items = TexTerms::Items;
using Joint = EquationSentence::Joint;

bool is_symbol(const TexItem& item, char32_t c) {
  return item.kind == ItemKind::operand && item.node->kind == Kind::symbol && item.node->character == c &&
         item.sub == nullptr && item.sup == nullptr;
}

bool is_digit_item(const TexItem& item) {
  return item.kind == ItemKind::operand && item.node->kind == Kind::symbol && item.node->character >= U'0' &&
         item.node->character <= U'9';
}

std::string words_of(const TexItem& item) {
  const std::string& text = item.node->text;
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == text.npos) return "";
  return std::string(
      words::read_in_english(std::string_view(text).substr(begin, text.find_last_not_of(' ') - begin + 1)));
}

bool is_implication(const TexItem& item) {
  return item.is(ItemKind::relation, U'⇒') || item.is(ItemKind::relation, U'⟹');
}

bool has_struck(const MathNode& node) {
  return node.kind == Kind::cancel || std::any_of(node.children.begin(), node.children.end(), has_struck);
}

/// The formula taken apart to sentences, before any side is read.
struct Sentence {
  Joint joint = Joint::none;
  bool is_premise = false;  ///< ":" or ⇒ stands behind it
  Items items;
};

class EquationReader {
 public:
  EquationReader(const Math& math, const EquationNotation& notation, const Math* above)
      : math_(math),
        vocabulary_(notation.vocabulary),
        terms_(math, notation),
        items_(formula_items(*math.root, kMaxEquationNesting)) {
    if (above != nullptr && above->root && !items_.empty() &&
        (items_.front().is(ItemKind::relation, U'=') || items_.front().is(ItemKind::relation, U'≈'))) {
      if (has_proved_part(*above->root)) throw_above("of that formula only a part is read");
      if (hidden_part(*above->root) != nullptr) throw_above("a part of it may not be seen");
      go_on_with(formula_items(*above->root, kMaxEquationNesting), !above->live.empty());
      above_root_ = above->root.get();
    }
  }

  ReadEquation read() {
    result_.is_part = has_proved_part(*math_.root);
    terms_.any_inertia = anywhere(has_tensor_component);
    Items items = take_ends(items_);
    std::vector<Sentence> sentences = split(items);
    take_conditions(sentences);
    if (ranges_.empty()) take_index_of_all(sentences);
    std::vector<std::array<std::pair<char32_t, int>, 3>> assignments = ranges_;
    if (assignments.empty()) assignments.emplace_back();
    const bool twice = anywhere(has_struck);
    for (const auto& assignment : assignments) {
      terms_.indices.clear();
      for (const auto& [letter, axis] : assignment)
        if (letter != 0) terms_.indices[letter] = axis;
      for (int pass = 0; pass < (twice ? 2 : 1); ++pass) {
        terms_.without_struck = pass == 1;
        for (const Sentence& sentence : sentences) add(sentence);
      }
    }
    if (in_space_ && terms_.has_body_rate)
      throw TexFault(items_.back().span, "\"in S\" stands at a rate as seen from the body");
    if (terms_.has_space_inertia && (terms_.has_inertia || terms_.has_matrix))
      throw TexFault(math_.root->span, "components in S are not told from those on the body's axes here",
                     "say it with \\mathbf I_S alone, or with \\mathbf I alone");
    if (terms_.has_matrix && terms_.has_rate)
      throw TexFault(math_.root->span, "the rate of a matrix of components is not read");
    if (result_.sentences.empty()) throw TexFault(math_.root->span, "there is no equation here");
    return std::move(result_);
  }

 private:
  bool anywhere(bool (*found)(const MathNode&)) const {
    return found(*math_.root) || (above_root_ != nullptr && found(*above_root_));
  }

  /// The last side of the formula above.
  void go_on_with(TexItems above, bool has_numbers) {
    while (!above.empty() && (above.back().kind == ItemKind::gap || above.back().kind == ItemKind::comma))
      above.pop_back();
    if (has_several_equations(above)) throw_above("it is more than one equation");
    std::size_t begin = above.size();
    while (begin > 0 && above[begin - 1].kind != ItemKind::relation) --begin;
    above.erase(above.begin(), above.begin() + static_cast<std::ptrdiff_t>(begin));
    const bool is_side = std::none_of(above.begin(), above.end(), [](const TexItem& item) {
      return item.kind == ItemKind::comma || item.kind == ItemKind::gap || item.kind == ItemKind::text ||
             item.kind == ItemKind::line;
    });
    if (above.empty() || !is_side || has_numbers) throw_above();
    above_ = std::move(above);
  }

  [[noreturn]] void throw_above(const std::string& why = "") const {
    throw TexFault(items_.front().span, "the side that this goes on with, in the formula above, is not read" +
                                            (why.empty() ? "" : ": " + why));
  }

  TexValue side_above() {
    try {
      TexValue value = terms_.side(above_);
      value.span = items_.front().span;
      value.marks.clear();  // they are bytes of the other formula
      return value;
    } catch (const TexFault& fault) {
      throw_above(fault.what());
    }
  }

  /// Without gaps and a full stop at the ends, and the words in front.
  Items take_ends(Items items) {
    const auto trim = [&items] {
      while (!items.empty() && items.front().kind == ItemKind::gap) items = items.subspan(1);
      while (!items.empty() && (items.back().kind == ItemKind::gap || items.back().kind == ItemKind::comma ||
                                is_symbol(items.back(), U'.')))
        items = items.first(items.size() - 1);
    };
    trim();
    if (!items.empty() && items.front().kind == ItemKind::text) {
      const std::string words = words_of(items.front());
      if (words == "tempting:" || words == "tempting on any axes:") {
        result_.is_tempting = true;
        terms_.any_inertia = terms_.any_inertia || words != "tempting:";
        items = items.subspan(1);
        trim();
      }
    }
    // "in S" at the end says of d/dt what it means here anyway.
    const std::size_t size = items.size();
    if (size >= 2 && is_symbol(items[size - 1], U'S') && items[size - 2].kind == ItemKind::text &&
        words_of(items[size - 2]) == "in") {
      in_space_ = true;
      items = items.first(size - 2);
      trim();
    }
    return items;
  }

  /// Of "i = 1, 2, 3".
  static bool is_of_range(Items items, std::size_t comma) {
    if (comma < 3 || !items[comma - 2].is(ItemKind::relation, U'=')) return false;
    constexpr std::u32string_view kLetters = U"ijkl";
    return std::any_of(kLetters.begin(), kLetters.end(),
                       [&](char32_t letter) { return is_symbol(items[comma - 3], letter); });
  }

  std::vector<Sentence> split(Items items) {
    std::vector<Sentence> sentences;
    Joint joint = Joint::none;
    std::size_t begin = 0;
    const auto end_at = [&](std::size_t end, bool is_premise) {
      Items part = items.subspan(begin, end - begin);
      while (!part.empty() && part.front().kind == ItemKind::gap) part = part.subspan(1);
      while (!part.empty() && part.back().kind == ItemKind::gap) part = part.first(part.size() - 1);
      if (part.empty())
        throw TexFault(end < items.size() ? items[end].span : math_.root->span,
                       "an equation is missing here");
      sentences.push_back({joint, is_premise, part});
    };
    for (std::size_t i = 0; i < items.size(); ++i) {
      const TexItem& item = items[i];
      const bool words = item.kind == ItemKind::text;
      const bool is_and = words && words_of(item) == "and";
      const bool does_not_follow = (words && words_of(item) == "does not give") ||
                                   item.is(ItemKind::relation, U'⇏') || item.is(ItemKind::relation, U'↛');
      const bool colon = item.is(ItemKind::relation, U':');
      if (item.kind == ItemKind::comma && i > begin && i + 1 < items.size() && is_digit_item(items[i - 1]) &&
          is_digit_item(items[i + 1]))
        throw is_of_range(items, i) ? TexFault(item.span, "what an index runs over stands in brackets",
                                               "write \\quad (i = 1, 2, 3) behind the equation")
                                    : TexFault(item.span, "a number has a point",
                                               "write 0.5; equations are parted by a comma and \\quad");
      if (item.kind != ItemKind::comma && item.kind != ItemKind::line && !is_and && !does_not_follow &&
          !colon && !is_implication(item))
        continue;
      // ", and" is one separator.
      const bool follows_separator = is_and && !sentences.empty() &&
                                     std::all_of(items.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 items.begin() + static_cast<std::ptrdiff_t>(i),
                                                 [](const TexItem& t) { return t.kind == ItemKind::gap; });
      if (!follows_separator) {
        end_at(i, colon || is_implication(item));
        joint = does_not_follow                 ? Joint::does_not_follow
                : colon || is_implication(item) ? Joint::follows
                                                : Joint::none;
      }
      begin = i + 1;
    }
    end_at(items.size(), false);
    return sentences;
  }

  /// "… \quad (condition)" at the end of the last sentence, and premises that are conditions.
  void take_conditions(std::vector<Sentence>& sentences) {
    Items& last = sentences.back().items;
    if (last.size() >= 3 && last.back().kind == ItemKind::group && last.back().open == U'(' &&
        last.back().sub == nullptr && last.back().sup == nullptr &&
        last[last.size() - 2].kind == ItemKind::gap) {
      read_condition(last.back(), sentences.size() == 1);
      last = last.first(last.size() - 2);
      while (!last.empty() && last.back().kind == ItemKind::gap) last = last.first(last.size() - 1);
    }
    if (sentences.front().is_premise && sentences.size() > 1 && is_spin(sentences.front().items)) {
      // Of "A => B, C" the page leaves open whether C is said under A.
      if (sentences.size() > 2 && !sentences[2].items.empty())
        throw TexFault(sentences[2].items.front().span, "what follows from what here?",
                       "write A = B \\Rightarrow C = D, and nothing else, in a formula of its own");
      read_spin(sentences.front().items);
      sentences.erase(sentences.begin());
      sentences.front().joint = Joint::none;
    }
  }

  /// "L_i = I_i\omega_i": an index that both sides of each = have, and no sum binds, is each of 1, 2, 3.
  void take_index_of_all(const std::vector<Sentence>& sentences) {
    char32_t only = 0;
    for (const char32_t letter : std::u32string_view(U"ijkl")) {
      const auto has_it = [letter](const TexItem& item) { return has_index(item, letter); };
      if (std::none_of(items_.begin(), items_.end(), has_it)) continue;
      if (only != 0) return;
      only = letter;
    }
    if (only == 0 || has_sum(*math_.root)) return;
    for (const Sentence& sentence : sentences)
      for (std::size_t begin = 0, i = 0; i <= sentence.items.size(); ++i) {
        if (i < sentence.items.size() && sentence.items[i].kind != ItemKind::relation) continue;
        const Items side = sentence.items.subspan(begin, i - begin);
        if (std::none_of(side.begin(), side.end(),
                         [only](const TexItem& item) { return has_index(item, only); }))
          return;
        begin = i + 1;
      }
    for (int axis = 1; axis <= 3; ++axis) ranges_.push_back({{{only, axis}, {0, 0}, {0, 0}}});
  }

  static bool has_index(const TexItem& item, char32_t letter) {
    const auto below = [letter](const auto& self, const MathNode& node, bool is_index) -> bool {
      if (is_index && node.kind == Kind::symbol && node.character == letter) return true;
      for (std::size_t i = 0; i < node.children.size(); ++i)
        if (self(self, node.children[i], is_index || (node.kind == Kind::scripts && i == 1))) return true;
      return false;
    };
    if (item.sub != nullptr && below(below, *item.sub, true)) return true;
    if (item.node != nullptr && item.kind == ItemKind::operand && below(below, *item.node, false))
      return true;
    return std::any_of(item.inside.begin(), item.inside.end(),
                       [letter](const TexItem& inner) { return has_index(inner, letter); });
  }

  static bool has_sum(const MathNode& node) {
    return (node.kind == Kind::symbol && node.character == U'∑') ||
           std::any_of(node.children.begin(), node.children.end(), has_sum);
  }

  void read_condition(const TexItem& group, bool alone) {
    const Items inside(group.inside);
    if (read_range(inside)) return;
    if (!alone) throw TexFault(group.span, "which of the equations does this condition belong to?");
    if (is_no_torque(inside)) {
      result_.without_torque = result_.has_condition = true;
      return;
    }
    if (!read_spin(inside))
      throw TexFault(group.span, "this condition is not read",
                     "(i = 1, 2, 3), (\\{i, j, k\\} = \\{1, 2, 3\\}), (\\omega_2 = 0), (\\vec\\omega = "
                     "\\omega_3\\hat e_3), (\\vec N = 0)");
  }

  /// i = 1, 2, 3, or {i, j, k} = {1, 2, 3}: all permutations.
  bool read_range(Items items) {
    const auto letter = [this](const TexItem& item) {
      for (const char32_t c : {U'i', U'j', U'k', U'l'}) {
        if (!is_symbol(item, c)) continue;
        if (terms_.is_redefined(item))
          throw TexFault(item.span, "this index is a symbol of the lesson", "take another letter");
        return c;
      }
      return U'\0';
    };
    const auto is_list = [](Items list, const auto& fits) {
      if (list.size() != 5) return false;
      for (std::size_t i = 0; i < 5; ++i)
        if (i % 2 == 1 ? !list[i].is(ItemKind::comma, U',') : !fits(list[i], i / 2)) return false;
      return true;
    };
    const auto is_digit = [](const TexItem& item, std::size_t i) {
      return is_symbol(item, static_cast<char32_t>(U'1' + i));
    };
    if (items.size() == 7 && letter(items[0]) != 0 && items[1].is(ItemKind::relation, U'=') &&
        is_list(items.subspan(2), is_digit)) {
      for (int axis = 1; axis <= 3; ++axis) ranges_.push_back({{{letter(items[0]), axis}, {0, 0}, {0, 0}}});
      return true;
    }
    const auto is_set = [](const TexItem& item) { return item.kind == ItemKind::group && item.open == U'{'; };
    const auto is_letter = [&letter](const TexItem& item, std::size_t) { return letter(item) != 0; };
    if (items.size() != 3 || !is_set(items[0]) || !items[1].is(ItemKind::relation, U'=') ||
        !is_set(items[2]) || !is_list(items[0].inside, is_letter) || !is_list(items[2].inside, is_digit))
      return false;
    const std::array<char32_t, 3> letters{letter(items[0].inside[0]), letter(items[0].inside[2]),
                                          letter(items[0].inside[4])};
    if (letters[0] == letters[1] || letters[1] == letters[2] || letters[0] == letters[2]) return false;
    std::array<int, 3> axes{1, 2, 3};
    do {
      ranges_.push_back({{{letters[0], axes[0]}, {letters[1], axes[1]}, {letters[2], axes[2]}}});
    } while (std::next_permutation(axes.begin(), axes.end()));
    return true;
  }

  static const MathNode* arrowed(const TexItem& item, char32_t letter) {
    if (item.kind != ItemKind::operand || item.sub != nullptr || item.sup != nullptr) return nullptr;
    const bool arrow = item.node->kind == Kind::accent && item.node->character == 0x20D7;
    if (!arrow) return nullptr;
    const MathNode& base = plain_node(item.node->children.front());
    return base.kind == Kind::symbol && base.character == letter ? &base : nullptr;
  }

  static bool is_no_torque(Items items) {
    return items.size() == 3 && arrowed(items[0], U'N') != nullptr && items[1].is(ItemKind::relation, U'=') &&
           is_symbol(items[2], U'0');
  }

  /// The axis of ω_n or ê_n; 0 if it is neither.
  int axis_of(const TexItem& item, bool unit_vector) const {
    if (item.kind != ItemKind::operand || item.sub == nullptr || item.sup != nullptr) return 0;
    const bool omega = item.node->kind == Kind::symbol && item.node->character == U'ω';
    const bool hat = item.node->kind == Kind::accent && item.node->character == 0x0302 &&
                     plain_node(item.node->children.front()).character == U'e';
    if (unit_vector ? !hat : !omega) return 0;
    const MathNode& sub = plain_node(*item.sub);
    const bool number = sub.kind == Kind::symbol && sub.character >= U'1' && sub.character <= U'3';
    return number ? static_cast<int>(sub.character - U'0') : 0;
  }

  bool is_spin(Items items) const {
    if (items.size() == 3 && axis_of(items[0], false) != 0 && items[1].is(ItemKind::relation, U'=') &&
        is_symbol(items[2], U'0'))
      return true;
    return items.size() == 4 && arrowed(items[0], U'ω') != nullptr && items[1].is(ItemKind::relation, U'=') &&
           axis_of(items[2], false) != 0 && axis_of(items[2], false) == axis_of(items[3], true);
  }

  bool read_spin(Items items) {
    if (!is_spin(items)) return false;
    for (const TexItem& item : items)
      if (item.kind == ItemKind::operand && !is_symbol(item, U'0') && terms_.is_redefined(item))
        throw TexFault(item.span, "a condition on a symbol of the lesson is not read");
    result_.has_condition = true;
    if (items.size() == 3) {
      terms_.no_spin_about[static_cast<std::size_t>(axis_of(items[0], false) - 1)] = true;
    } else {
      for (int axis = 1; axis <= 3; ++axis)
        if (axis != axis_of(items[2], false)) terms_.no_spin_about[static_cast<std::size_t>(axis - 1)] = true;
    }
    return true;
  }

  /// A number of \live and its own unit, which is known to fit; other words behind it are not.
  bool is_live(Items side) const {
    if (side.empty() || side[0].kind != ItemKind::operand || side[0].node->kind != Kind::term) return false;
    const std::optional<std::size_t> index = index_of_live(*side[0].node);
    if (side.size() == 1 || !index || *index >= math_.live.size()) return side.size() == 1;
    return side.size() == 2 && side[1].kind == ItemKind::text &&
           unit_tex(math_.live[*index].unit).ends_with("\\text{" + side[1].node->text + '}');
  }

  void add(const Sentence& sentence) {
    EquationSentence read;
    read.joint = sentence.joint;
    read.is_no_torque = sentence.is_premise && is_no_torque(sentence.items);
    result_.has_condition = result_.has_condition || read.is_no_torque;
    read.source = joined_span(sentence.items.front().span, sentence.items.back().span);
    std::vector<std::pair<TexValue, TexValue>> labels;
    terms_.labels = &labels;
    std::optional<TexValue> left;
    const Items items = sentence.items;
    std::size_t begin = 0;
    if (!above_.empty() && items.data() == items_.data()) {
      left = side_above();
      begin = 1;
    }
    for (std::size_t i = begin; i <= items.size(); ++i) {
      if (i < items.size() && items[i].kind != ItemKind::relation) continue;
      if (i == begin)
        throw TexFault(i < items.size() ? items[i].span : items.back().span,
                       "a side is missing beside this =");
      // Its rate is 0, of a vector that as seen from space.
      if (left && says_constant(items.subspan(begin, i - begin)) &&
          items[begin - 1].is(ItemKind::relation, U'=')) {
        const SourceSpan span = items[begin].span;
        if (i < items.size()) throw TexFault(items[i].span, "what does not change ends a chain");
        if (sentence.is_premise || sentence.joint != Joint::none)
          throw TexFault(span, "words in what follows, or does not, are not read", "write the rate, and = 0");
        if (terms_.is_conditioned()) throw TexFault(span, "rates are not read under a condition on ω");
        terms_.has_rate = true;
        link(read, rate_of(*left, true, span), atom_value("0", TexValue::Type::zero, span), Relation::equal);
        read.links.back().is_side_by_side = false;
        break;
      }
      const bool is_number = i == items.size() && left && is_live(items.subspan(begin, i - begin));
      terms_.may_be_live = is_number;
      TexValue right = terms_.side(items.subspan(begin, is_number ? 1 : i - begin));
      terms_.may_be_live = false;
      if (left) {
        const std::size_t first = read.links.size();
        const Relation relation = proved_relation(items[begin - 1]);
        if (is_number && is_order(relation))
          throw TexFault(right.span, "a rounded number is neither the greater nor the less",
                         "compare what it is the number of, and let the number end a chain of =");
        link(read, *left, right, relation);
        read.links.back().is_number = is_number;
        if (first > 0 && read.links.size() == first + 1) read.links.back().goes_on = true;
      }
      left = std::move(right);
      begin = i + 1;
    }
    if (read.links.empty()) throw TexFault(read.source, "there is no = here");
    const std::size_t printed = read.links.size();
    for (const auto& [contents, label] : labels) link(read, contents, label, Relation::equal);
    for (std::size_t i = 0; i < read.links.size(); ++i)
      if (i >= printed || terms_.without_struck) read.links[i].is_side_by_side = false;
    result_.sentences.push_back(std::move(read));
  }

  static Relation proved_relation(const TexItem& item) {
    if (const auto relation = relation_of(item)) return *relation;
    throw TexFault(item.span, "only = < > \\le \\ge \\approx are proved",
                   "keep a claim for what can be proved");
  }

  void link(EquationSentence& sentence, const TexValue& left, const TexValue& right, Relation relation) {
    const SourceSpan span = joined_span(left.span, right.span);
    if (is_order(relation) && (!left.is_scalar() || !right.is_scalar()))
      throw TexFault(span, "only of numbers one is the greater", "compare lengths, |\\vec a|");
    if (left.is_tensor() || right.is_tensor()) {
      // Equal if they do the same to each unit vector.
      for (int axis = 1; axis <= 3; ++axis) {
        const TexValue e = unit_vector(axis, span);
        const auto column = [&](const TexValue& side) {
          if (side.type == TexValue::Type::zero) return side;
          if (!side.is_tensor()) throw TexKindFault(span, "a tensor and something else cannot be equal");
          return applied(*side.tensor, e, span);
        };
        push(sentence, column(left), column(right), span);
        sentence.links.back().is_side_by_side = false;
        sentence.links.back().relation = relation;
      }
      return;
    }
    push(sentence, left, right, span);
    sentence.links.back().relation = relation;
  }

  void push(EquationSentence& sentence, const TexValue& left, const TexValue& right, SourceSpan span) {
    if (++links_ > kMaxEquationLinks)
      throw TexFault(span, "a formula states at most " + std::to_string(kMaxEquationLinks) + " equalities");
    EquationLink link{{side_of(left, right), side_of(right, left)}, span};
    if (!fit(link.equality.left.type(), link.equality.right.type()))
      throw TexKindFault(span, std::string(name_of(link.equality.left.type())) + " and " +
                                   std::string(name_of(link.equality.right.type())) + " cannot be equal");
    sentence.links.push_back(std::move(link));
  }

  Expression side_of(const TexValue& value, const TexValue& other) const {
    if (value.form != TexValue::Form::rate_of_length || other.type != TexValue::Type::zero)
      return expression_of(value, vocabulary_);
    TexValue square = value;
    square.text = "ddt(norm2(" + value.of + "))";
    square.marks.clear();
    return expression_of(square, vocabulary_);
  }

  const Math& math_;
  const Vocabulary& vocabulary_;
  TexTerms terms_;
  TexItems items_, above_;
  const MathNode* above_root_ = nullptr;
  ReadEquation result_;
  std::vector<std::array<std::pair<char32_t, int>, 3>> ranges_;
  bool in_space_ = false;
  std::size_t links_ = 0;
};

}  // namespace

Result<ReadEquation, UnreadableEquation> read_equation(const Math& math, const EquationNotation& notation,
                                                       const Math* above) {
  try {
    if (!math.root) return Failure<UnreadableEquation>{{{}, "there is no formula here", ""}};
    check_is_seen(*math.root);
    return EquationReader(math, notation, above).read();
  } catch (const TexKindFault& fault) {
    return Failure<UnreadableEquation>{{fault.place, fault.what(), fault.hint, true}};
  } catch (const TexFault& fault) {
    return Failure<UnreadableEquation>{{fault.place, fault.what(), fault.hint}};
  }
}

namespace {

std::string letter_of(const QuantityFacts& facts) {
  const std::string name(facts.name);
  if (name == "omega" || name.front() == 'w' || name.front() == 'd') return "omega";
  if (name.front() == 'J') return "I";
  return name.substr(0, 1);
}

/// Adds the letters of what stands in a node: of each part that can be read, the smallest first to fail.
class LetterSearch {
 public:
  LetterSearch(const Math& math, const EquationNotation& notation, IndexedLetters indexed)
      : terms_(math, notation), vocabulary_(notation.vocabulary), indexed_(indexed) {}

  void add(const MathNode& node, int depth = 0) {
    if (depth > kMaxEquationNesting) return;
    try {
      add(items_of(node, kMaxEquationNesting), depth);
    } catch (const TexFault&) {
      add_children(node, depth);
    }
  }

  std::set<std::string> take() { return std::move(letters_); }

 private:
  void add(const TexItems& items, int depth) {
    for (const TexItem& item : items) {
      add(item.inside, depth + 1);
      if (item.kind != TexItem::Kind::operand || add_value(item)) continue;
      if (indexed_ == IndexedLetters::as_printed) add_indexed(item);
      for (const MathNode* part : {item.node, item.sub, item.sup})
        if (part != nullptr) add_children(*part, depth);
    }
  }

  void add_children(const MathNode& node, int depth) {
    for (const MathNode& child : node.children) add(child, depth + 1);
  }

  /// False if it cannot be read.
  bool add_value(const TexItem& item) {
    try {
      const TexValue value = terms_.side({&item, 1});
      if (value.is_tensor()) {
        letters_.insert("I");
        return true;
      }
      letters_.merge(letters_in(expression_of(value, vocabulary_)));
      return true;
    } catch (const TexFault&) {
      return false;
    }
  }

  /// Of a letter that is something known without its index.
  void add_indexed(TexItem item) {
    if (item.sub == nullptr) return;
    const MathNode& index = without_groups(*item.sub);
    const bool is_digit =
        index.kind == MathNode::Kind::symbol && index.character >= U'0' && index.character <= U'9';
    const std::string behind = is_digit ? std::string(1, static_cast<char>(index.character)) : "…";
    item.sub = nullptr;
    try {
      for (const std::string& letter : letters_in(expression_of(terms_.side({&item, 1}), vocabulary_)))
        letters_.insert(letter + '_' + behind);
    } catch (const TexFault&) {  // it is none
    }
  }

  TexTerms terms_;
  const Vocabulary& vocabulary_;
  IndexedLetters indexed_;
  std::set<std::string> letters_;
};

}  // namespace

std::set<std::string> letters_in(const Expression& expression) {
  std::set<std::string> letters;
  for (const QuantityFacts& facts : kQuantities)
    if (expression.uses(facts.quantity)) letters.insert(letter_of(facts));
  for (const Operation of_tensor : {Operation::inertia, Operation::apply, Operation::trace})
    if (expression.uses(of_tensor)) letters.insert("I");
  return letters;
}

std::vector<std::string> quantity_letters() {
  std::set<std::string> letters;
  for (const QuantityFacts& facts : kQuantities) letters.insert(letter_of(facts));
  return {letters.begin(), letters.end()};
}

std::set<std::string> letters_in(const Math& math, const EquationNotation& notation, IndexedLetters indexed) {
  if (!math.root) return {};
  LetterSearch search(math, notation, indexed);
  search.add(*math.root);
  return search.take();
}

Result<std::vector<ClaimLine>, UnreadableEquation> claim_lines_of(const ReadEquation& equation,
                                                                  ClaimKind kind,
                                                                  const PlaceOfSpan& place_of) {
  const auto refuse = [](SourceSpan at, std::string reason, std::string hint = {}) {
    return Failure<UnreadableEquation>{{at, std::move(reason), std::move(hint)}};
  };
  const SourceSpan whole = equation.sentences.front().source;
  if (equation.is_tempting && kind != ClaimKind::is_false)
    return refuse(whole, "\"tempting:\" stands before what is false", "the kind is false");
  if (equation.without_torque && kind != ClaimKind::free && kind != ClaimKind::is_false)
    return refuse(whole, "the condition says that there is no torque", "the kind is free");
  // Of "A => B => C" the first arrow would be nobody's claim.
  for (std::size_t i = 2; i < equation.sentences.size(); ++i)
    if (equation.sentences[i].joint == EquationSentence::Joint::follows)
      return refuse(equation.sentences[i].source, "what follows from what here?",
                    "write A = B \\Rightarrow C = D, and nothing else, in a formula of its own");
  const bool follows_somewhere = std::any_of(
      equation.sentences.begin(), equation.sentences.end(),
      [](const EquationSentence& sentence) { return sentence.joint == EquationSentence::Joint::follows; });
  const auto is_number = [](const EquationLink& link) { return link.is_number; };
  for (const EquationSentence& sentence : equation.sentences) {
    if (std::none_of(sentence.links.begin(), sentence.links.end(), is_number)) continue;
    if (equation.has_condition || follows_somewhere)
      return refuse(sentence.source, "a computed number is of one motion, and this is said under a condition",
                    "let the number end a formula without one");
    if (std::all_of(sentence.links.begin(), sentence.links.end(), is_number))
      return refuse(sentence.source, "only a computed number stands here: of this body and motion, no law",
                    "leave out the kind, and nothing is called proved");
  }
  const bool orders =
      std::any_of(equation.sentences.begin(), equation.sentences.end(), [](const EquationSentence& sentence) {
        return std::any_of(sentence.links.begin(), sentence.links.end(),
                           [](const EquationLink& link) { return is_order(link.relation); });
      });
  if (orders && (kind == ClaimKind::measured || kind == ClaimKind::non_sequitur))
    return refuse(whole, "an inequality is not of this kind", "the kind is identity, motion, free or false");
  std::vector<ClaimLine> lines;
  const bool infers =
      std::any_of(equation.sentences.begin(), equation.sentences.end(),
                  [](const EquationSentence& s) { return s.joint == Joint::does_not_follow; });
  if (infers != (kind == ClaimKind::non_sequitur))
    return refuse(whole,
                  infers ? "this says what does not follow" : "a non-sequitur says \"… does not give …\"",
                  infers ? "the kind is non-sequitur" : "A \\quad\\text{does not give}\\quad B");
  const auto provable = [kind](const Equality& equality) {
    return kind == ClaimKind::measured || is_provable(equality);
  };
  for (std::size_t i = 0; i < equation.sentences.size(); ++i) {
    const EquationSentence& sentence = equation.sentences[i];
    if (sentence.is_no_torque) continue;
    const EquationSentence* premise =
        i > 0 && sentence.joint == EquationSentence::Joint::follows && !equation.sentences[i - 1].is_no_torque
            ? &equation.sentences[i - 1]
            : nullptr;
    if (premise != nullptr && (kind == ClaimKind::is_false || kind == ClaimKind::measured))
      return refuse(sentence.source, "what follows is neither false nor measured", "the kind motion or free");
    // Of "A, B => C" and "A => B, C" the page leaves open what belongs together.
    if (premise != nullptr && (equation.sentences.size() != 2 || premise->links.size() != 1 || orders))
      return refuse(sentence.source, "what follows from what here?",
                    "write A = B \\Rightarrow C = D, and nothing else, in a formula of its own");
    if (i + 1 < equation.sentences.size() &&
        equation.sentences[i + 1].joint == EquationSentence::Joint::follows)
      continue;  // a premise
    for (const EquationLink& link : sentence.links) {
      if (!provable(link.equality))
        return has_angles(link.equality)
                   ? refuse(link.source, std::string(kNoAngles), "measure the claim")
                   : refuse(link.source,
                            "a length is a root, and a proof has none: it is a whole side, |a| = |b|, or one "
                            "with moments and numbers as factors",
                            "square both sides, or measure the claim");
      const bool follows = premise != nullptr;
      if (follows && !provable(premise->links[0].equality))
        return refuse(premise->source, "this condition has lengths or angles in it", "square both sides");
      lines.push_back({.equality = follows ? premise->links[0].equality : link.equality,
                       .conclusion = follows ? std::optional(link.equality) : std::nullopt,
                       .within = {},
                       .place = place_of(link.source),
                       .goes_on = link.goes_on && !follows,
                       .is_side_by_side = link.is_side_by_side && !follows,
                       .judgement = {},
                       .relation = link.relation,
                       .is_number = link.is_number});
    }
  }
  if (kind == ClaimKind::non_sequitur) {
    const auto& s = equation.sentences;
    if (s.size() != 2 || s[0].links.size() != 1 || s[1].links.size() != 1)
      return refuse(whole, "a non-sequitur has one equality on either side");
    return std::vector<ClaimLine>{{.equality = s[0].links[0].equality,
                                   .conclusion = s[1].links[0].equality,
                                   .within = {},
                                   .place = place_of(whole)}};
  }
  if (kind == ClaimKind::is_false && lines.size() != 1)
    return refuse(whole, "which of these equalities is false?", "what is false is one equality");
  return lines;
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_items.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using Item = TexItem;

const MathNode* present(const MathNode& node) { return node.absent() ? nullptr : &node; }

char32_t closing_of(char32_t open) {
  switch (open) {
    case U'(':
      return U')';
    case U'[':
      return U']';
    case U'{':
      return U'}';
    case U'|':
      return U'|';
    default:
      return 0;
  }
}

/// What a symbol is before brackets are matched: brackets and bars are operands here.
Item::Kind kind_of(const MathNode& symbol) {
  const char32_t c = symbol.character;
  if (symbol.kind == Kind::arrow) return Item::Kind::relation;
  if (c == U'+' || c == U'−') return Item::Kind::sign;
  if (c == U'⋅' || c == U'×' || c == U'/') return Item::Kind::times;
  if (symbol.atom == MathClass::relation) return Item::Kind::relation;
  if (c == U',' || c == U';') return Item::Kind::comma;
  return Item::Kind::operand;
}

bool is_bracket(const Item& item) {
  return item.kind == Item::Kind::operand && item.node != nullptr &&
         (item.node->kind == Kind::symbol || item.node->kind == Kind::delimiter) &&
         std::u32string_view(U"()[]{}|‖⟨⟩⌊⌋⌈⌉⟮⟯").find(item.node->character) != std::u32string_view::npos;
}

bool is_empty(const MathNode& label) {
  const MathNode& words = without_groups(label);
  return words.kind == Kind::row && words.children.empty();
}

constexpr double kScriptStyle = 2;

/// Lines that are printed over one another are not read, nor rules, which look like bars of fractions and of
/// determinants.
void check_grid(const MathNode& grid) {
  constexpr double kTouching = -0.3;  // em: below, lines of letters with indices meet
  for (const double skip : grid.grid->skips)
    if (skip < kTouching)
      throw TexFault(grid.span, "a line that goes back may be printed over another", "leave \\\\[…] out");
  if (!grid.grid->rows_with_line.empty() || !grid.grid->columns_with_line.empty())
    throw TexFault(grid.span,
                   "a rule between lines or columns looks like the bar of a fraction, or a bracket",
                   "leave \\hline and | out");
}

/// The row without brackets matched: what only decorates is gone.
class Flattening {
 public:
  TexItems run(const MathNode& node) {
    const MathNode* whole = &node;  // a box around all of it groups nothing
    while ((whole->kind == Kind::row || whole->kind == Kind::box) && whole->children.size() == 1)
      whole = &whole->children.front();
    add(*whole, false);
    return std::move(items_);
  }

 private:
  void push(Item item) {
    if (items_.size() > 8192) throw TexFault(item.span, "this formula is too long to be read");
    gone_on_ = 0;
    items_.push_back(std::move(item));
  }

  void add(const MathNode& node, bool struck) {
    switch (node.kind) {
      case Kind::nothing:
        return;
      case Kind::phantom:
        for (const MathNode& child : node.children)
          if (hidden_part(child) != nullptr)
            throw TexFault(node.span, "what is not printed here may print one thing over another");
        return;
      case Kind::style:
        if (node.amount >= kScriptStyle)
          throw TexFault(node.span, "small type looks like an index or a power", "write _ or ^");
        return;
      case Kind::term:
        if (index_of_live(node)) return push_operand(node, node, struck);
        [[fallthrough]];
      case Kind::row:
      case Kind::alphabet:
        for (const MathNode& child : node.children) add(child, struck);
        return;
      case Kind::color:
        throw TexFault(node.span, "a colour may hide what is proved", "mark the part with \\term{id}{…}");
      case Kind::box:
        throw TexFault(node.span, "does this box hold its contents together?",
                       "write brackets, or box all of it");
      case Kind::cancel:
        if (node.character == U'n')
          throw TexFault(node.span, "a relation that is struck through is not read");
        if (nucleus_of(node.children.front()).character == U'd')
          throw TexFault(node.span, "a d alone cannot be struck out");
        for (const MathNode& child : node.children) add(child, true);
        return;
      case Kind::space: {
        gone_on_ += node.amount;
        if (node.amount < kThinBack || gone_on_ < kThinBack)
          throw TexFault(node.span, "a space that goes back may print one thing over another");
        if (gone_on_ < kQuad) return;
        Item gap;
        gap.kind = Item::Kind::gap;
        gap.node = &node;
        gap.span = node.span;
        return push(std::move(gap));
      }
      case Kind::text:
        if (node.atom != MathClass::large && node.text != "tr") {
          Item text;
          text.kind = Item::Kind::text;
          text.node = &node;
          text.span = node.span;
          return push(std::move(text));
        }
        return push_operand(node, node, struck);
      case Kind::scripts:
        return add_scripts(node, struck);
      case Kind::brace:
        return push_brace(node, node, nullptr, struck);
      case Kind::symbol:
      case Kind::arrow: {
        Item item;
        item.kind = kind_of(node);
        item.node = &node;
        item.character = node.character;
        item.struck = struck;
        item.span = node.span;
        if (struck && (item.kind == Item::Kind::relation || item.kind == Item::Kind::comma))
          throw TexFault(node.span, "this is not read when it is struck out");
        if (node.kind == Kind::arrow)
          for (const MathNode& label : node.children)
            if (!label.absent() && !is_empty(label))
              throw TexFault(label.span, "what stands on an arrow is not read",
                             "write \\Rightarrow, and the words into the text");
        return push(std::move(item));
      }
      case Kind::grid:
        check_grid(node);
        [[fallthrough]];
      default:
        return push_operand(node, node, struck);
    }
  }

  void push_operand(const MathNode& node, const MathNode& whole, bool struck, const MathNode* sub = nullptr,
                    const MathNode* sup = nullptr) {
    Item item;
    item.node = &node;
    item.sub = sub;
    item.sup = sup;
    item.struck = struck;
    item.span = whole.span;
    push(std::move(item));
  }

  /// The one atom that scripts stand at, through what only decorates.
  static const MathNode& nucleus_of(const MathNode& node) {
    const MathNode* inner = &node;
    while ((inner->kind == Kind::row || inner->kind == Kind::alphabet || inner->kind == Kind::term) &&
           inner->children.size() == 1 && !index_of_live(*inner))
      inner = &inner->children.front();
    return *inner;
  }

  void add_scripts(const MathNode& node, bool struck) {
    const MathNode& nucleus = nucleus_of(node.children[0]);
    const MathNode *sub = present(node.children[1]), *sup = present(node.children[2]);
    for (const MathNode* script : {sub, sup})
      if (script != nullptr && nucleus_of(*script).kind == Kind::cancel)
        throw TexFault(script->span, "an index or power that is struck out is not read");
    if (nucleus.kind == Kind::brace && sub != nullptr && sup != nullptr)
      throw TexFault(sup->span, "what is raised by this, the brace or what it holds?", "write brackets");
    if (nucleus.kind == Kind::brace) return push_brace(nucleus, node, sub != nullptr ? sub : sup, struck);
    if (nucleus.kind == Kind::row && nucleus.children.empty())
      throw TexFault(node.span, "this index or power stands at nothing");
    if (nucleus.kind == Kind::row || nucleus.kind == Kind::alphabet || nucleus.kind == Kind::term ||
        nucleus.kind == Kind::color || nucleus.kind == Kind::scripts)
      throw TexFault(node.span, "an index or power at a group is not read: nobody sees the braces",
                     "write brackets that are seen");
    if (nucleus.kind == Kind::cancel)
      throw TexFault(node.span, "is the index or power struck out too?", "strike out all of it");
    if (nucleus.kind == Kind::symbol && kind_of(nucleus) != Item::Kind::operand)
      throw TexFault(node.span, "an index or power at a sign is not read");
    if (nucleus.kind == Kind::text && nucleus.atom != MathClass::large && nucleus.text != "tr") {
      Item text;  // a unit such as m²
      text.kind = Item::Kind::text;
      text.node = &nucleus;
      text.sub = sub;
      text.sup = sup;
      text.span = node.span;
      return push(std::move(text));
    }
    push_operand(nucleus, node, struck, sub, sup);
  }

  void push_brace(const MathNode& brace, const MathNode& whole, const MathNode* label, bool struck) {
    Item item;
    item.kind = Item::Kind::group;
    item.node = &brace;
    item.open = U'⏟';
    item.label = label;
    item.struck = struck;
    item.span = whole.span;
    push(std::move(item));
  }

  TexItems items_;
  double gone_on_ = 0;  ///< the space since the last thing, em
};

bool is_decoration(const Item& item) { return item.kind == Item::Kind::gap; }

void drop_gaps_in_front(TexItems& items) {
  items.erase(items.begin(), std::find_if_not(items.begin(), items.end(), is_decoration));
}

/// Of what a brace holds: space there makes the brace wider.
void drop_gaps_at_ends(TexItems& items) {
  drop_gaps_in_front(items);
  while (!items.empty() && is_decoration(items.back())) items.pop_back();
}

/// Matches brackets, by a stack of its own.
class Brackets {
 public:
  explicit Brackets(int depth) : depth_(depth) {}

  TexItems run(TexItems flat) {
    open_.emplace_back();
    for (Item& item : flat) take(std::move(item));
    if (open_.size() > 1) throw TexFault(open_.back().opening.span, "this bracket is never closed");
    return std::move(open_.back().items);
  }

 private:
  struct Open {
    Item opening;
    TexItems items;
  };

  bool after_operand() const {
    const TexItems& row = open_.back().items;
    return !row.empty() && (row.back().kind == Item::Kind::operand || row.back().kind == Item::Kind::group);
  }

  void take(Item item) {
    if (item.node == nullptr) return open_.back().items.push_back(std::move(item));
    if (item.node->kind == Kind::fenced) return take_fenced(std::move(item));
    if (item.kind == Item::Kind::group) {
      item.inside = items_of(item.node->children.front(), depth_ - 1);
      drop_gaps_at_ends(item.inside);
      return open_.back().items.push_back(std::move(item));
    }
    if (!is_bracket(item)) return open_.back().items.push_back(std::move(item));
    const char32_t c = item.node->character;
    const bool may_close = open_.size() > 1 && closing_of(open_.back().opening.node->character) == c;
    if (may_close && (c != U'|' || after_operand())) return close(item);
    if (closing_of(c) == 0) throw TexFault(item.span, "this bracket is not read, or closes nothing");
    if (item.sub != nullptr || item.sup != nullptr)
      throw TexFault(item.span, "an index or power at an opening bracket is not read",
                     c == U'|' ? std::string(kRatesOfFrames) : "");
    if (static_cast<int>(open_.size()) > depth_) throw TexFault(item.span, "brackets are nested too deep");
    open_.push_back({std::move(item), {}});
  }

  void close(const Item& closing) {
    Open done = std::move(open_.back());
    open_.pop_back();
    Item group;
    group.kind = Item::Kind::group;
    group.node = done.opening.node;
    group.open = done.opening.node->character;
    group.sub = closing.sub;
    group.sup = closing.sup;
    group.struck = done.opening.struck;
    group.span = joined_span(done.opening.span, closing.span);
    group.inside = std::move(done.items);
    open_.back().items.push_back(std::move(group));
  }

  void take_fenced(Item item) {
    const MathNode& node = *item.node;
    if (node.children.size() != 3) throw TexFault(item.span, "\\middle is not read");
    item.open = node.children[0].character;
    if (closing_of(item.open) == 0 || closing_of(item.open) != node.children[2].character)
      throw TexFault(item.span, "these brackets are no pair that is read");
    item.kind = Item::Kind::group;
    item.inside = items_of(node.children[1], depth_ - 1);
    open_.back().items.push_back(std::move(item));
  }

  int depth_;
  std::vector<Open> open_;
};

bool has_relation(const TexItems& items) {
  return std::any_of(items.begin(), items.end(),
                     [](const Item& i) { return i.kind == Item::Kind::relation; });
}

void append(TexItems& to, TexItems from) { std::move(from.begin(), from.end(), std::back_inserter(to)); }

/// The lines of an alignment, joined where one goes on with the one above.
TexItems lines_of(const MathNode& grid, int depth) {
  check_grid(grid);
  TexItems all, last;                                     // `last`: since the last sentence ended
  bool above_is_open = false, last_cell_is_open = false;  // of the line above: which equation goes on?
  const auto columns = static_cast<std::size_t>(std::max(grid.grid->columns, 1));
  for (std::size_t at = 0; at < grid.children.size(); at += columns) {
    TexItems line;
    bool first_is_empty = true, is_wide = false;
    std::size_t last_cell = 0;
    for (std::size_t c = 0; c < columns && at + c < grid.children.size(); ++c) {
      TexItems cell = items_of(grid.children[at + c], depth - 1);
      drop_gaps_in_front(cell);
      if (c == 0) first_is_empty = cell.empty();
      // Columns stand in pairs, and wide apart from the next pair.
      const bool begins_pair = grid.grid->kind == MathGrid::Kind::aligned ? c % 2 == 0 : true;
      if (begins_pair && !cell.empty() && !line.empty()) {
        Item end;
        end.kind = Item::Kind::line;
        end.span = cell.front().span;
        line.push_back(std::move(end));
      }
      if (cell.empty()) continue;
      is_wide = is_wide || c >= 2;
      last_cell = line.size();
      append(line, std::move(cell));
    }
    if (line.empty()) continue;
    const Item& first = line.front();
    const bool goes_on = first.kind == Item::Kind::relation ||
                         (first.kind == Item::Kind::sign && !(has_relation(last) && has_relation(line)));
    const bool begins_left_of_align = columns > 1 && !first_is_empty;
    if (!last.empty() && first.kind == Item::Kind::sign && !goes_on && !begins_left_of_align)
      throw TexFault(first.span, "does this line go on with the one above, or begin an equation?",
                     "put its left side before the &");
    if (!last.empty() && !goes_on) {
      Item end;
      end.kind = Item::Kind::line;
      end.span = first.span;
      last.push_back(std::move(end));
      append(all, std::exchange(last, {}));
    }
    // An = behind the & stands below that of the line above.
    if (!last.empty() && (columns > 1 && first_is_empty ? last_cell_is_open : above_is_open))
      throw TexFault(first.span, "which equation of the line above does this go on with?",
                     "write its left side again");
    above_is_open = is_wide || has_several_equations(line);
    last_cell_is_open = is_wide || has_several_equations(std::span(line).subspan(last_cell));
    append(last, std::move(line));
  }
  append(all, std::move(last));
  return all;
}

}  // namespace

const MathNode* hidden_part(const MathNode& node) {
  const bool has_width = node.kind == Kind::phantom && static_cast<int>(node.amount) % 2 == 1;
  const bool goes_back = node.kind == Kind::space && node.amount < kThinBack;
  if (node.kind == Kind::color || has_width || goes_back) return &node;
  for (const MathNode& child : node.children)
    if (const MathNode* found = hidden_part(child)) return found;
  return nullptr;
}

void check_is_seen(const MathNode& root) {
  const MathNode* hidden = hidden_part(root);
  if (hidden == nullptr) return;
  if (hidden->kind == Kind::color)
    throw TexFault(hidden->span, "a colour may hide what is proved", "mark the part with \\term{id}{…}");
  if (hidden->kind == Kind::phantom)
    throw TexFault(hidden->span, "the room of what is not printed may move one thing over another, or apart",
                   "leave spaces to TeX; \\quad stands between equations");
  throw TexFault(hidden->span, "a space that goes back may print one thing over another");
}

bool has_several_equations(std::span<const Item> items) {
  const auto stands_in_front = [](const Item& item) {
    return item.kind == Item::Kind::text || item.kind == Item::Kind::gap;
  };
  return std::any_of(std::find_if_not(items.begin(), items.end(), stands_in_front), items.end(),
                     [](const Item& item) {
                       return item.kind == Item::Kind::comma || item.kind == Item::Kind::gap ||
                              item.kind == Item::Kind::text || item.kind == Item::Kind::line ||
                              item.is(Item::Kind::relation, U':') || item.is(Item::Kind::relation, U'⇒') ||
                              item.is(Item::Kind::relation, U'⟹');
                     });
}

bool states_something(const MathNode& words) {
  static const std::set<std::string, std::less<>> kStating = {
      "zero",     "null",     "nothing", "none",     "vanish", "vanishes",  "vanishing",    "one",
      "two",      "three",    "four",    "five",     "six",    "seven",     "eight",        "nine",
      "ten",      "half",     "twice",   "double",   "equal",  "equals",    "is",           "are",
      "was",      "always",   "never",   "constant", "const",  "conserved", "positive",     "true",
      "negative", "infinite", "false",   "wrong",    "cancel", "cancels",   "drops",        "not",
      "no",       "small",    "nought",  "naught",   "nil",    "gone",      "proportional", "differs",
      "large",    "fixed"};
  const std::string& text = words.text;
  if (text.find_first_of("0123456789=<>%") != text.npos || text.find("≠") != text.npos ||
      text.find("∝") != text.npos || text.find("½") != text.npos || text.find("∞") != text.npos)
    return true;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    std::string word;
    while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[end++])));
    if (kStating.contains(word)) return true;
    at = end + 1;
  }
  return std::any_of(words.children.begin(), words.children.end(), states_something);
}

std::string words_of(const MathNode& node) {
  const MathNode& whole = without_groups(node);
  if (whole.kind == Kind::text) return whole.text;
  std::string words;
  if (whole.kind != Kind::row) return words;
  for (const MathNode& part : whole.children) {
    if (part.kind != Kind::text && part.kind != Kind::space) return "";
    words += part.kind == Kind::text ? part.text : " ";
  }
  return words;
}

bool says_constant(std::span<const TexItem> side) {
  std::string words;
  for (const TexItem& item : side) {
    if (item.sub != nullptr || item.sup != nullptr || item.node == nullptr) return false;
    const bool is_letter = item.kind == TexItem::Kind::operand && item.node->kind == MathNode::Kind::symbol &&
                           item.node->character < 0x80 &&
                           (item.node->alphabet == Alphabet::upright || item.node->character == U'.');
    if (item.kind != TexItem::Kind::text && !is_letter) return false;
    words += is_letter ? std::string(1, static_cast<char>(item.node->character)) : item.node->text;
  }
  const std::size_t begin = words.find_first_not_of(' ');
  if (begin == words.npos) return false;
  words = words.substr(begin, words.find_last_not_of(' ') - begin + 1);
  return words == "const" || words == "const." || words == "constant";
}

std::optional<Relation> relation_of(const TexItem& item) {
  switch (item.character) {
    case U'=':
      return Relation::equal;
    case U'<':
      return Relation::less;
    case U'>':
      return Relation::greater;
    case U'≤':
    case U'⩽':
      return Relation::less_or_equal;
    case U'≥':
    case U'⩾':
      return Relation::greater_or_equal;
    case U'≈':
      return Relation::approximate;
    default:
      return std::nullopt;
  }
}

SourceSpan joined_span(SourceSpan first, SourceSpan last) {
  return {std::min(first.begin, last.begin), std::max(first.end, last.end)};
}

TexItems items_of(const MathNode& node, int depth) {
  if (depth <= 0) throw TexFault(node.span, "brackets are nested too deep");
  return Brackets(depth).run(Flattening().run(node));
}

TexItems formula_items(const MathNode& root, int depth) {
  const std::vector<const MathNode*> parts = proved_parts(root);
  if (parts.empty()) return whole_formula(root, depth);
  TexItems all;
  for (const MathNode* part : parts) {
    TexItems items = whole_formula(*part, depth);
    if (items.empty()) continue;
    if (!all.empty()) {
      Item line;
      line.kind = Item::Kind::line;
      line.span = items.front().span;
      all.push_back(std::move(line));
    }
    std::move(items.begin(), items.end(), std::back_inserter(all));
  }
  return all;
}

TexItems whole_formula(const MathNode& root, int depth) {
  const auto is_lines = [](const MathNode& node) {
    return node.kind == Kind::grid &&
           (node.grid->kind == MathGrid::Kind::aligned || node.grid->kind == MathGrid::Kind::gathered);
  };
  if (is_lines(root)) return lines_of(root, depth);
  TexItems items = items_of(root, depth);
  const auto grid = std::find_if(items.begin(), items.end(), [&](const Item& item) {
    return item.kind == Item::Kind::operand && item.node != nullptr && is_lines(*item.node);
  });
  if (grid == items.end()) return items;
  for (const Item& item : items)
    if (&item != &*grid && item.kind != Item::Kind::gap && item.kind != Item::Kind::comma)
      throw TexFault(item.span, "aligned lines beside other things are not read");
  return lines_of(*grid->node, depth - 1);
}

}  // namespace polhode

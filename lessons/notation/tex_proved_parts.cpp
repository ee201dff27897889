// SPDX-License-Identifier: MIT
// The parts of a formula that its author marks as proved, and what may stand beside them.
#include "lessons/notation/tex_items.h"
#include "lessons/notation/tex_number_parts.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace polhode {
namespace {

using Kind = MathNode::Kind;

bool is_proved_part(const MathNode& node) { return node.kind == Kind::term && node.text == kProvedPart; }

/// The parts of one line of a formula, and what stands before and behind each.
class ProvedParts {
 public:
  explicit ProvedParts(std::vector<const MathNode*>& parts) : parts_(parts) {}

  void add_lines(const MathNode& node) {
    const MathNode& whole = without_groups(node);
    if (whole.kind == Kind::grid) return add_grid(whole);
    std::vector<const MathNode*> line;
    add_to(line, whole);
    check(line);
  }

 private:
  void add_grid(const MathNode& grid) {
    const bool is_lines =
        grid.grid->kind == MathGrid::Kind::aligned || grid.grid->kind == MathGrid::Kind::gathered;
    if (!is_lines && has_proved_part(grid)) refuse(grid);
    const auto columns = static_cast<std::size_t>(std::max(grid.grid->columns, 1));
    for (std::size_t at = 0; is_lines && at < grid.children.size(); at += columns)
      for (std::size_t pair = 0; pair < columns; pair += 2) {
        std::vector<const MathNode*> line;
        for (std::size_t c = pair; c < std::min(pair + 2, columns) && at + c < grid.children.size(); ++c)
          add_to(line, grid.children[at + c]);
        check(line);
      }
  }

  /// What stands beside each other in a row, however braces group it.
  void add_to(std::vector<const MathNode*>& line, const MathNode& node) const {
    const bool is_seen_through = node.kind == Kind::row || node.kind == Kind::alphabet ||
                                 (node.kind == Kind::term && !is_proved_part(node) && !index_of_live(node));
    if (!is_seen_through) return line.push_back(&node);
    for (const MathNode& child : node.children) add_to(line, child);
  }

  void check(const std::vector<const MathNode*>& line) {
    for (const MathNode* node : line) {
      if (node->kind == Kind::grid)
        add_grid(*node);
      else if (!is_proved_part(*node) && has_proved_part(*node))
        refuse(*node);
      else if (node->kind == Kind::text && !states_nothing(*node))
        throw TexFault(node->span, "words beside a part that is proved say something of it",
                       "write them into the text");
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (!is_proved_part(*line[i])) continue;
      parts_.push_back(&line[i]->children.front());
      const auto at = line.begin() + static_cast<std::ptrdiff_t>(i);
      if (!is_apart(std::reverse_iterator(at), line.rend()) || !is_apart(at + 1, line.end()))
        refuse(*line[i]);
    }
  }

  static bool states_nothing(const MathNode& words) {
    TexItem item;
    item.node = &words;
    return joins_sentences(item);
  }

  /// Of what stands beside a part, the nearest first.
  template <class Iterator>
  static bool is_apart(Iterator at, Iterator end) {
    bool is_wide = false;
    for (; at != end; ++at) {
      const MathNode* node = *at;
      if (node->kind == Kind::space) {
        if (node->amount < kThinBack) return false;
        is_wide = is_wide || node->amount >= kQuad;
        continue;
      }
      if (node->kind == Kind::nothing) continue;
      const bool is_symbol = node->kind == Kind::symbol;
      if (is_symbol && (node->atom == MathClass::punctuation || node->character == U'.'))
        return is_wide || !begins_number(std::next(at), end);
      if (is_symbol && node->character >= U'0' && node->character <= U'9') return false;
      if (node->kind == Kind::text) return true;  // it parts what is said of two things
      // A sign, or a condition in brackets, reaches across a space.
      const bool reaches = node->kind == Kind::arrow || node->kind == Kind::fenced ||
                           node->kind == Kind::cancel || node->atom == MathClass::relation ||
                           node->atom == MathClass::binary || node->atom == MathClass::opening ||
                           node->atom == MathClass::closing;
      return is_wide && !reaches;
    }
    return true;
  }

  /// "2.5" and "2,5" are numbers, however little space stands behind the point.
  template <class Iterator>
  static bool begins_number(Iterator at, Iterator end) {
    for (; at != end; ++at) {
      if (((*at)->kind == Kind::space && (*at)->amount < kQuad) || (*at)->kind == Kind::nothing) continue;
      const MathNode* node = &without_groups(**at);
      while (node->kind == Kind::scripts) node = &without_groups(node->children.front());
      return node->kind == Kind::symbol && node->character >= U'0' && node->character <= U'9';
    }
    return false;
  }

  [[noreturn]] static void refuse(const MathNode& at) {
    throw TexFault(at.span, "what stands beside this part, or around it, is not proved and joins on to it",
                   "part it off by a comma, \\quad or a new line, or write a formula of its own");
  }

  std::vector<const MathNode*>& parts_;
};

}  // namespace

bool has_proved_part(const MathNode& root) {
  return is_proved_part(root) || std::any_of(root.children.begin(), root.children.end(), has_proved_part);
}

std::vector<const MathNode*> proved_parts(const MathNode& root) {
  std::vector<const MathNode*> parts;
  if (has_proved_part(root)) ProvedParts(parts).add_lines(root);
  return parts;
}

}  // namespace polhode

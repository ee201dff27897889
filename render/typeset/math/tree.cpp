// SPDX-License-Identifier: MIT
#include "render/typeset/math/tree.h"

#include "base/utf8.h"
#include "render/typeset/math/math.h"

#include <algorithm>

namespace polhode {

namespace {
constexpr std::string_view kLivePrefix = "live ";
}

std::string live_name(std::size_t index) { return std::string(kLivePrefix) + std::to_string(index); }

std::optional<std::size_t> index_of_live(const MathNode& node) {
  if (node.kind != MathNode::Kind::term || !node.text.starts_with(kLivePrefix)) return std::nullopt;
  return static_cast<std::size_t>(std::atoi(node.text.c_str() + kLivePrefix.size()));
}

using Kind = MathNode::Kind;

namespace {

void show_references(MathNode& node, const std::map<std::string, ShownReference>& shown) {
  for (MathNode& child : node.children) show_references(child, shown);
  if (node.kind != Kind::term || !node.text.starts_with(kReferenceMark)) return;
  const auto found = shown.find(node.text.substr(kReferenceMark.size()));
  if (found == shown.end()) return;
  node.text = found->second.link;
  MathNode& number = node.children.front();
  number.text = '(' + found->second.number + ')';
  number.sources.assign(static_cast<std::size_t>(count_characters(number.text)), node.span);
}

void put_numbers(MathNode& node, const Math& math, const std::vector<ShownNumber>& shown) {
  for (std::size_t i = 0; node.kind == Kind::term && i < math.live.size(); ++i) {
    if (node.text != live_name(i)) continue;
    if (math.live[i].typed.empty() && shown[i].number.root) {
      MathNode number = *shown[i].number.root;
      number.span = node.span;
      node.children = {std::move(number)};
    }
    node.text = shown[i].name;
    if (node.text.empty()) node.kind = Kind::row;
    return;
  }
  for (MathNode& child : node.children) put_numbers(child, math, shown);
}

/// Of 0.5², whose last digit has the power, the 5.
const MathNode& without_scripts(const MathNode& node) {
  return node.kind == Kind::scripts ? node.children.front() : node;
}

bool is_digit(const MathNode& node) {
  return node.kind == Kind::symbol && U'0' <= node.character && node.character <= U'9';
}

/// Behind spaces: a digit, or a minus.
bool begins_number(const std::vector<MathNode>& atoms, std::size_t i) {
  while (i < atoms.size() && atoms[i].kind == Kind::space) ++i;
  return i < atoms.size() && (is_digit(without_scripts(atoms[i])) || atoms[i].character == U'−');
}

/// Numbers of a list with decimals stand between semicolons then: (0,5; 1; 2).
void put_decimal_commas(MathNode& node) {
  // A decimal comma in TeX is {,}.
  const auto is_mark = [](const MathNode& child) {
    return child.character == U'.' || (child.kind == MathNode::Kind::row && child.children.size() == 1 &&
                                       child.children.front().character == U',');
  };
  const auto is_decimal = [&](std::size_t i) {
    return i > 0 && i + 1 < node.children.size() && is_mark(node.children[i]) &&
           is_digit(without_scripts(node.children[i - 1])) && is_digit(without_scripts(node.children[i + 1]));
  };
  bool has_decimals = false;
  for (std::size_t i = 0; i < node.children.size(); ++i) has_decimals = has_decimals || is_decimal(i);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    MathNode& child = node.children[i];
    put_decimal_commas(child);
    if (is_decimal(i)) {
      if (child.kind == MathNode::Kind::row) child = MathNode(child.children.front());
      child.character = U',';
      child.atom = MathClass::ordinary;
    } else if (has_decimals && child.kind == Kind::symbol && child.character == U',' &&
               child.atom == MathClass::punctuation && i > 0 &&
               is_digit(without_scripts(node.children[i - 1])) && begins_number(node.children, i + 1)) {
      child.character = U';';
    }
  }
}

}  // namespace

std::shared_ptr<const MathNode> with_decimals(const Math& math) {
  if (decimal_mark(math.language) == '.' || !math.root) return math.root;
  auto root = std::make_shared<MathNode>(*math.root);
  put_decimal_commas(*root);
  return root;
}

bool is_decimal_comma(const MathNode& node) {
  return node.kind == Kind::symbol && node.character == U',' && node.atom == MathClass::ordinary;
}

Math with_numbers(const Math& math, const std::vector<ShownNumber>& shown) {
  if (!math.root || math.live.empty()) return math;
  auto root = std::make_shared<MathNode>(*math.root);
  put_numbers(*root, math, shown);
  Math made = math;
  made.root = std::move(root);
  return made;
}

Math with_references(const Math& math, const std::map<std::string, ShownReference>& shown) {
  if (!math.root) return math;
  auto root = std::make_shared<MathNode>(*math.root);
  show_references(*root, shown);
  Math made = math;
  made.root = std::move(root);
  return made;
}

const MathNode& without_groups(const MathNode& node) {
  const MathNode* inner = &node;
  while ((inner->kind == Kind::row || inner->kind == Kind::alphabet) && inner->children.size() == 1)
    inner = &inner->children.front();
  return *inner;
}

bool same_math(const MathNode& first, const MathNode& second) {
  const MathNode& a = without_groups(first);
  const MathNode& b = without_groups(second);
  if (a.kind != b.kind || a.character != b.character || a.alphabet != b.alphabet || a.text != b.text ||
      a.amount != b.amount || a.wide != b.wide || a.face != b.face || a.binomial != b.binomial ||
      a.children.size() != b.children.size())
    return false;
  if ((a.grid == nullptr) != (b.grid == nullptr) || (a.grid && *a.grid != *b.grid)) return false;
  return std::equal(a.children.begin(), a.children.end(), b.children.begin(), same_math);
}

}  // namespace polhode

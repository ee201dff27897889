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

}  // namespace

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

// SPDX-License-Identifier: MIT
#include "render/typeset/math/tree.h"

#include <algorithm>

namespace polhode {

std::string live_name(std::size_t index) { return "live " + std::to_string(index); }

using Kind = MathNode::Kind;

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

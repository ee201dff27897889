// SPDX-License-Identifier: MIT
#include "render/typeset/morph.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {
namespace {

constexpr std::size_t kMostCompared = 2000;

std::string_view name_at(const DisplayList& list, std::int16_t index) {
  return index < 0 ? std::string_view() : std::string_view(list.names[static_cast<std::size_t>(index)]);
}

/// How much it is worth to match two parts: nothing if they are different things.
int worth(const Naming& a, const DisplayList& from, const Naming& b, const DisplayList& to) {
  constexpr int kSame = 2, kSameName = 1;
  return kSame + (name_at(from, a.term) == name_at(to, b.term) ? kSameName : 0) +
         (name_at(from, a.symbol) == name_at(to, b.symbol) ? kSameName : 0);
}

bool alike(const Glyph& a, const Glyph& b) { return a.face == b.face && a.id == b.id; }

enum class Direction { horizontal, vertical, rising, falling };
Direction direction_of(const Rule& r) {
  if (r.y0 == r.y1) return Direction::horizontal;
  if (r.x0 == r.x1) return Direction::vertical;
  return (r.y1 - r.y0) * (r.x1 - r.x0) < 0.0 ? Direction::rising : Direction::falling;
}
bool alike(const Rule& a, const Rule& b) { return direction_of(a) == direction_of(b); }

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The common subsequence of the greatest worth, between a common beginning and end.
template <class Part>
Pairs matched(const std::vector<Part>& a, const DisplayList& from, const std::vector<Part>& b,
              const DisplayList& to) {
  std::size_t begin = 0, a_end = a.size(), b_end = b.size();
  while (begin < a_end && begin < b_end && alike(a[begin], b[begin])) ++begin;
  while (a_end > begin && b_end > begin && alike(a[a_end - 1], b[b_end - 1])) --a_end, --b_end;

  Pairs pairs;
  for (std::size_t i = 0; i < begin; ++i) pairs.emplace_back(i, i);
  const std::size_t n = a_end - begin, m = b_end - begin;
  if (n > 0 && m > 0 && n <= kMostCompared && m <= kMostCompared) {
    // best[i][j]: the worth of what can be matched from i and j on.
    std::vector<int> best((n + 1) * (m + 1), 0);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return best[i * (m + 1) + j]; };
    const auto with_pair = [&](std::size_t i, std::size_t j) {
      const Part &x = a[begin + i], &y = b[begin + j];
      return alike(x, y) ? at(i + 1, j + 1) + worth(x.naming, from, y.naming, to) : -1;
    };
    for (std::size_t i = n; i-- > 0;)
      for (std::size_t j = m; j-- > 0;) at(i, j) = std::max({at(i + 1, j), at(i, j + 1), with_pair(i, j)});
    for (std::size_t i = 0, j = 0; i < n && j < m;) {
      if (at(i, j) == with_pair(i, j))
        pairs.emplace_back(begin + i++, begin + j++);
      else if (at(i, j) == at(i + 1, j))
        ++i;
      else
        ++j;
    }
  }
  for (std::size_t i = 0; a_end + i < a.size(); ++i) pairs.emplace_back(a_end + i, b_end + i);
  return pairs;
}

Glyph between(const Glyph& a, const Glyph& b, double u) {
  Glyph g = b;
  g.x = std::lerp(a.x, b.x, u);
  g.y = std::lerp(a.y, b.y, u);
  g.size = std::lerp(a.size, b.size, u);
  g.color = between(a.color, b.color, static_cast<float>(u));
  return g;
}

/// Whichever end lies further left or up comes first: a rule does not turn over on its way.
Rule in_order(Rule r) {
  if (std::pair(r.x0, r.y0) > std::pair(r.x1, r.y1)) {
    std::swap(r.x0, r.x1);
    std::swap(r.y0, r.y1);
  }
  return r;
}

Rule between(const Rule& first, const Rule& last, double u) {
  const Rule a = in_order(first), b = in_order(last);
  Rule r = b;
  r.x0 = std::lerp(a.x0, b.x0, u);
  r.y0 = std::lerp(a.y0, b.y0, u);
  r.x1 = std::lerp(a.x1, b.x1, u);
  r.y1 = std::lerp(a.y1, b.y1, u);
  r.thickness = std::lerp(a.thickness, b.thickness, u);
  r.color = between(a.color, b.color, static_cast<float>(u));
  return r;
}

/// The parts at u: matched ones in between, the others as visible as they are then.
template <class Part>
std::vector<Part> parts_at(std::vector<Part> a, const DisplayList& from, const std::vector<Part>& b,
                           const DisplayList& to, double u, const std::vector<std::int16_t>& place) {
  const Pairs pairs = matched(a, from, b, to);
  const auto leaving = static_cast<float>(std::clamp(1.0 - 2.0 * u, 0.0, 1.0)),
             coming = static_cast<float>(std::clamp(2.0 * u - 1.0, 0.0, 1.0));
  std::vector<bool> stays(a.size(), false), is_there(b.size(), false);
  std::vector<Part> parts;
  for (const auto& [i, j] : pairs) {
    stays[i] = is_there[j] = true;
    parts.push_back(between(a[i], b[j], u));
  }
  const auto add_faded = [&](Part part, float alpha) {
    part.color.a *= alpha;
    if (alpha > 0.0F) parts.push_back(part);
  };
  const auto renamed = [&](std::int16_t i) { return i < 0 ? i : place[static_cast<std::size_t>(i)]; };
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (stays[i]) continue;
    a[i].naming = {renamed(a[i].naming.term), renamed(a[i].naming.symbol)};
    add_faded(a[i], leaving);
  }
  for (std::size_t j = 0; j < b.size(); ++j)
    if (!is_there[j]) add_faded(b[j], coming);
  return parts;
}

}  // namespace

DisplayList morph(const DisplayList& from, const DisplayList& to, double u) {
  if (!(u > 0.0)) return from;
  if (u >= 1.0) return to;
  DisplayList list;
  list.names = to.names;
  std::vector<std::int16_t> place;  // of the names of `from`
  for (const std::string& name : from.names) place.push_back(index_of(list, name));
  list.glyphs = parts_at(from.glyphs, from, to.glyphs, to, u, place);
  list.rules = parts_at(from.rules, from, to.rules, to, u, place);
  list.width = std::lerp(from.width, to.width, u);
  list.ascent = std::lerp(from.ascent, to.ascent, u);
  list.depth = std::lerp(from.depth, to.depth, u);
  return list;
}

}  // namespace polhode

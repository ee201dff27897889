// SPDX-License-Identifier: MIT
#include "lessons/notation/tex_units.h"

#include "lessons/claims/expressions/dimension.h"
#include "lessons/notation/tex_atoms.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace polhode {
namespace {

using Kind = MathNode::Kind;
using ItemKind = TexItem::Kind;
using Items = std::span<const TexItem>;

/// "2" or "-1" of a power that units have; nothing of another.
std::optional<int> power_of(const MathNode* sup) {
  if (sup == nullptr) return 1;
  const TexItems items = items_of(*sup, kMaxEquationNesting);
  const bool minus = items.size() == 2 && items[0].is(ItemKind::sign, U'−');
  if (items.size() != 1 && !minus) return std::nullopt;
  const TexItem& digit = items.back();
  if (!is_digit(digit) || !is_plain(digit)) return std::nullopt;
  const int power = static_cast<int>(digit.node->character - U'0');
  return minus ? -power : power;
}

/// The only child of a row in a row.
const MathNode* plain(const MathNode& node) { return &without_groups(node); }

}  // namespace

std::string unit_of(Items items) {
  std::string above, below, word;
  bool is_below = false;
  const auto end_word = [&](int power) {
    if (word.empty()) return true;
    std::string& into = (power < 0) != is_below ? below : above;
    const std::string raised = std::abs(power) == 1 ? "" : '^' + std::to_string(std::abs(power));
    const std::size_t slash = word.find('/');
    if (slash != word.npos && (power != 1 || is_below)) return false;
    into += (into.empty() ? "" : " ") + word.substr(0, slash) + raised;
    if (slash != word.npos) below += (below.empty() ? "" : " ") + word.substr(slash + 1);
    word.clear();
    return true;
  };
  std::uint32_t end = 0;
  for (const TexItem& item : items) {
    const bool is_letter = item.kind == ItemKind::operand && item.node != nullptr &&
                           item.node->kind == Kind::symbol && item.node->alphabet == Alphabet::upright;
    if (item.sub != nullptr || item.struck) return "";
    if (item.is(ItemKind::times, U'/') || item.is(ItemKind::times, U'⋅')) {
      if (!end_word(1) || (item.character == U'/' && is_below)) return "";
      is_below = is_below || item.character == U'/';
      continue;
    }
    const auto power = power_of(item.sup);
    if (!power || *power == 0) return "";
    if (item.kind == ItemKind::text) {
      const std::string& text = item.node->text;
      const std::size_t first = text.find_first_not_of(' ');
      if (!end_word(1)) return "";
      if (first == text.npos) continue;
      word = text.substr(first, text.find_last_not_of(' ') - first + 1);
    } else if (is_letter && item.node->character < 0x80) {
      if (item.span.begin > end && !end_word(1)) return "";
      word += static_cast<char>(item.node->character);
    } else if (is_symbol(item, U'°')) {
      if (!end_word(1)) return "";
      word = "°";
    } else {
      return "";
    }
    end = item.span.end;
    if ((item.sup != nullptr || item.kind == ItemKind::text) && !end_word(*power)) return "";
  }
  if (!end_word(1) || (above.empty() && below.empty())) return "";
  const std::string unit = (above.empty() ? "1" : above) + (below.empty() ? "" : '/' + below);
  return scaled_unit(unit) ? unit : "";
}

std::optional<TypedNumber> typed_number(Items items) {
  TypedNumber number;
  const auto take = [&items](bool fits) {
    if (fits) items = items.subspan(1);
    return fits;
  };
  const bool minus = take(!items.empty() && items[0].is(ItemKind::sign, U'−'));
  int decimals = 0;
  bool has_point = false, has_digit = false;
  std::uint32_t end = 0;
  while (!items.empty()) {
    const TexItem& item = items[0];
    const bool is_point =
        is_symbol(item, U'.') && !has_point && items.size() > 1 && is_digit(items[1]) && is_plain(item);
    const bool is_raised =
        is_digit(item) && item.sub == nullptr && item.sup != nullptr && is_symbol(plain(*item.sup), U'∘');
    if (!is_point && !is_raised && !(is_digit(item) && is_plain(item))) break;
    if (has_digit && item.span.begin > end) return std::nullopt;  // digits in groups
    end = item.span.end;
    if (is_point) {
      has_point = true;
    } else {
      number.value = 10 * number.value + static_cast<double>(item.node->character - U'0');
      has_digit = true;
      decimals += has_point ? 1 : 0;
    }
    items = items.subspan(1);
    if (is_raised) {
      number.unit = "°";
      break;
    }
  }
  if (!has_digit) return std::nullopt;
  int power = -decimals;
  // "\cdot 10^{-3}"
  if (number.unit.empty() && items.size() >= 3 && items[0].kind == ItemKind::times &&
      items[0].character != U'/' && is_symbol(items[1], U'1') && is_plain(items[1]) &&
      is_symbol(items[2], U'0') && items[2].sub == nullptr && items[2].sup != nullptr) {
    const auto ten_to = power_of(items[2].sup);
    if (!ten_to) return std::nullopt;
    power += *ten_to;
    items = items.subspan(3);
  }
  number.last_digit = std::pow(10.0, power);
  number.value *= (minus ? -1 : 1) * number.last_digit;
  if (items.empty()) return number;
  const bool is_percent = items.size() == 1 && is_symbol(items[0], U'%') && is_plain(items[0]);
  if (!number.unit.empty()) return std::nullopt;  // behind degrees
  number.unit = is_percent ? "%" : unit_of(items);
  return number.unit.empty() ? std::nullopt : std::optional(number);
}

std::string in_si(const TypedNumber& number) {
  const auto unit = number.unit == "%" ? std::nullopt : scaled_unit(number.unit);
  const double percent = 0.01, size = unit ? unit->size : number.unit == "%" ? percent : 1;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.15g", number.value * size);
  return text.front() == '-' ? '(' + std::string(text.data()) + ')' : std::string(text.data());
}

char32_t letter_of_name(Items items) {
  constexpr std::u32string_view kNoNames = U"eidπ", kMarks = U"′″‴∗⋆†+−";
  if (items.size() == 2 && (is_symbol(items[0], U'Δ') || is_symbol(items[0], U'δ')) && is_plain(items[0]))
    items = items.subspan(1);
  if (items.size() != 1 || items[0].kind != ItemKind::operand || items[0].struck) return 0;
  const TexItem& item = items[0];
  constexpr char32_t kDot = 0x0307, kTwoDots = 0x0308;
  const MathNode* node = item.node;
  const bool is_rate = node->kind == Kind::accent && (node->character == kDot || node->character == kTwoDots);
  if (is_rate) return 0;
  while ((node->kind == Kind::accent || node->kind == Kind::bar || node->kind == Kind::row ||
          node->kind == Kind::alphabet) &&
         node->children.size() == 1)
    node = &node->children.front();
  if (node->kind != Kind::symbol || node->alphabet == Alphabet::blackboard) return 0;
  if (item.sup != nullptr) {
    const MathNode* mark = plain(*item.sup);
    const bool is_mark = mark->kind == Kind::symbol && kMarks.find(mark->character) != kMarks.npos;
    if (!is_mark && mark->kind != Kind::text) return 0;
  }
  const char32_t c = node->character;
  const bool is_letter = (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z') || (c >= 0x391 && c <= 0x3C9) ||
                         std::u32string_view(U"ϑϕϵϱℓ").find(c) != std::u32string_view::npos;
  return is_letter && kNoNames.find(c) == kNoNames.npos ? c : U'\0';
}

bool is_letter_of_rotation(char32_t letter) {
  return std::u32string_view(U"TIωL").find(letter) != std::u32string_view::npos;
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "render/typeset/math/alphabets.h"

#include <string_view>

namespace polhode {
namespace {

/// Where an alphabet's capital A, capital alpha, small alpha and zero are; 0: it has none of its own.
struct Block {
  char32_t latin = 0, greek_capital = 0, greek_small = 0, zero = 0;
};

Block block_of(Alphabet alphabet) {
  switch (alphabet) {
    case Alphabet::normal:
      return {0x1D434, 0, 0x1D6FC, 0};
    case Alphabet::italic:
      return {0x1D434, 0x1D6E2, 0x1D6FC, 0};
    case Alphabet::bold:
      return {0x1D400, 0x1D6A8, 0x1D6C2, 0x1D7CE};
    case Alphabet::bold_italic:
      return {0x1D468, 0x1D6A8, 0x1D736, 0x1D7CE};
    case Alphabet::script:
      return {0x1D49C, 0, 0, 0};
    case Alphabet::blackboard:
      return {0x1D538, 0, 0, 0x1D7D8};
    case Alphabet::fraktur:
      return {0x1D504, 0, 0, 0};
    case Alphabet::sans:
      return {0x1D5A0, 0, 0, 0x1D7E2};
    case Alphabet::mono:
      return {0x1D670, 0, 0, 0x1D7F6};
    default:
      return {};
  }
}

/// Letters that had a place before the block was made.
char32_t older(char32_t c, Alphabet alphabet) {
  struct Letters {
    Alphabet alphabet;
    std::u32string_view plain, styled;
  };
  static constexpr Letters kOlder[] = {
      {Alphabet::normal, U"h", U"ℎ"},
      {Alphabet::italic, U"h", U"ℎ"},
      {Alphabet::script, U"BEFHILMRego", U"ℬℰℱℋℐℒℳℛℯℊℴ"},
      {Alphabet::fraktur, U"CHIRZ", U"ℭℌℑℜℨ"},
      {Alphabet::blackboard, U"CHNPQRZ", U"ℂℍℕℙℚℝℤ"},
  };
  for (const Letters& letters : kOlder) {
    const std::size_t at = letters.plain.find(c);
    if (letters.alphabet == alphabet && at != std::u32string_view::npos) return letters.styled[at];
  }
  return 0;
}

}  // namespace

char32_t in_alphabet(char32_t c, Alphabet alphabet) {
  if (const char32_t styled = older(c, alphabet)) return styled;
  const Block block = block_of(alphabet);
  const auto from = [c](char32_t first, char32_t base) { return base == 0 ? c : base + (c - first); };
  if (U'A' <= c && c <= U'Z') return from(U'A', block.latin);
  if (U'a' <= c && c <= U'z') return block.latin == 0 ? c : block.latin + 26 + (c - U'a');
  if (U'0' <= c && c <= U'9') return from(U'0', block.zero);
  if (U'Α' <= c && c <= U'Ω') return from(U'Α', block.greek_capital);
  if (U'α' <= c && c <= U'ω') return from(U'α', block.greek_small);
  constexpr std::u32string_view kVariants = U"∂ϵϑϰϕϱϖ";
  const std::size_t variant = kVariants.find(c);
  if (variant != std::u32string_view::npos && block.greek_small != 0)
    return block.greek_small + 25 + static_cast<char32_t>(variant);
  const bool slanted = alphabet == Alphabet::normal || alphabet == Alphabet::italic;
  if (c == U'ı' && slanted) return 0x1D6A4;
  if (c == U'ȷ' && slanted) return 0x1D6A5;
  const bool bold = alphabet == Alphabet::bold || alphabet == Alphabet::bold_italic;
  if (c == U'∇' && bold) return 0x1D6C1;
  return c;
}

}  // namespace polhode

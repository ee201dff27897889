// SPDX-License-Identifier: MIT
#include "base/words/phrase.h"

#include <gtest/gtest.h>

namespace polhode {
namespace {

TEST(Languages, HaveTags) {
  for (const Language language : kLanguages) EXPECT_EQ(language_from(tag_of(language)), language);
  EXPECT_FALSE(language_from("DE"));
  EXPECT_FALSE(language_from(""));
}

TEST(Phrases, AreFilledInTheOrderOfEachLanguage) {
  constexpr Phrase kPhrase{"{0} of {1}", "von {1} das {0}."};
  EXPECT_EQ(kPhrase.with(Language::en, {"2", "3"}), "2 of 3");
  EXPECT_EQ(kPhrase.with(Language::de, {"2", "3"}), "von 3 das 2.");
  constexpr Phrase kTex{"a {,} {x} {0", "b {,} {x} {0"};
  EXPECT_EQ(kTex.with(Language::de, {"7"}), "b {,} {x} {0") << "braces of TeX stay";
}

TEST(Phrases, AreFoundByTheirNamesInThePage) {
  constexpr NamedPhrase kPhrases[] = {{"left", {"to the left", "nach links"}}, {"up", {"up", "nach oben"}}};
  EXPECT_EQ(json_of(kPhrases, Language::en), R"({"decimal":".","left":"to the left","up":"up"})");
  EXPECT_EQ(json_of(kPhrases, Language::de), R"({"decimal":",","left":"nach links","up":"nach oben"})");
}

TEST(Decimals, AreThoseOfTheLanguage) {
  EXPECT_EQ(with_decimals("|L| = 2.50 J, $h$ = $0.02$ s.", Language::en), "|L| = 2.50 J, $h$ = $0.02$ s.");
  EXPECT_EQ(with_decimals("|L| = 2.50 J, $h$ = $0.02$ s.", Language::de), "|L| = 2,50 J, $h$ = $0{,}02$ s.");
  EXPECT_EQ(with_decimals("(0.31, −0.20, 0)", Language::de), "(0,31; −0,20; 0)")
      << "in a list numbers stand between semicolons";
  EXPECT_EQ(with_decimals("1. a.b 2.", Language::de), "1. a.b 2.") << "neither is a decimal";
}

TEST(Decimals, OfAnAuthorsLineChangeInFormulasAlone) {
  EXPECT_EQ(with_decimals_in_formulas("Achsen 1, 2: $0.5$ und 3,5 bei §2.1 und $1.5$", Language::de),
            "Achsen 1, 2: $0{,}5$ und 3,5 bei §2.1 und $1{,}5$");
  EXPECT_EQ(with_decimals_in_formulas("$0.5", Language::de), "$0{,}5") << "what is never closed is kept";
  EXPECT_EQ(with_decimals_in_formulas("", Language::de), "");
}

}  // namespace
}  // namespace polhode

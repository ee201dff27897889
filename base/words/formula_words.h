// SPDX-License-Identifier: MIT
// What is said of the signs of formulas (spoken() of render/typeset/math/math.h), and of numbers.
#pragma once

#include "base/words/phrase.h"

#include <array>

namespace polhode::words {

struct SignWords {
  char32_t sign;
  Phrase words;
};

inline constexpr auto kSigns = std::to_array<SignWords>({
    {U'+', {"plus", "plus"}},
    {U'−', {"minus", "minus"}},
    {U'±', {"plus or minus", "plus oder minus"}},
    {U'∓', {"minus or plus", "minus oder plus"}},
    {U'×', {"cross", "Kreuz"}},
    {U'⋅', {"dot", "mal"}},
    {U'÷', {"divided by", "geteilt durch"}},
    {U'/', {"over", "durch"}},
    {U'∗', {"star", "Stern"}},
    {U'⊗', {"tensor", "Tensor"}},
    {U'∧', {"wedge", "Keil"}},
    {U'∘', {"after", "nach"}},
    {U'∪', {"union", "vereinigt mit"}},
    {U'∩', {"intersection", "geschnitten mit"}},
    {U'∖', {"without", "ohne"}},
    {U'=', {"equals", "gleich"}},
    {U'≠', {"not equal to", "ungleich"}},
    {U'<', {"less than", "kleiner als"}},
    {U'>', {"greater than", "größer als"}},
    {U'≤', {"at most", "kleiner gleich"}},
    {U'≥', {"at least", "größer gleich"}},
    {U'≪', {"much less than", "sehr viel kleiner als"}},
    {U'≫', {"much greater than", "sehr viel größer als"}},
    {U'≡', {"is identical to", "identisch gleich"}},
    {U'≈', {"is about", "etwa gleich"}},
    {U'∼', {"is of the order of", "von der Größenordnung"}},
    {U'≃', {"is asymptotically", "asymptotisch gleich"}},
    {U'≅', {"is congruent to", "kongruent zu"}},
    {U'∝', {"is proportional to", "proportional zu"}},
    {U'≔', {"is defined as", "definiert als"}},
    {U'∈', {"in", "Element von"}},
    {U'∉', {"not in", "nicht Element von"}},
    {U'⊂', {"is a subset of", "Teilmenge von"}},
    {U'⊆', {"is a subset of", "Teilmenge von"}},
    {U'⟂', {"is perpendicular to", "senkrecht zu"}},
    {U'∥', {"parallel", "parallel zu"}},
    {U'∣', {"such that", "so dass"}},
    {U'→', {"to", "gegen"}},
    {U'←', {"from", "von"}},
    {U'↦', {"maps to", "wird abgebildet auf"}},
    {U'⇒', {"implies", "daraus folgt"}},
    {U'⟹', {"implies", "daraus folgt"}},
    {U'⇐', {"follows from", "folgt aus"}},
    {U'⟸', {"follows from", "folgt aus"}},
    {U'⇔', {"is equivalent to", "genau dann, wenn"}},
    {U'⟺', {"is equivalent to", "genau dann, wenn"}},
    {U'∂', {"partial", "partiell"}},
    {U'∇', {"nabla", "Nabla"}},
    {U'ℏ', {"h bar", "h quer"}},
    {U'ℓ', {"l", "l"}},
    {U'∞', {"infinity", "unendlich"}},
    {U'∅', {"the empty set", "die leere Menge"}},
    {U'∀', {"for all", "für alle"}},
    {U'∃', {"there is", "es gibt"}},
    {U'⊤', {"transposed", "transponiert"}},
    {U'†', {"dagger", "adjungiert"}},
    {U'…', {"and so on", "und so weiter"}},
    {U'⋯', {"and so on", "und so weiter"}},
    {U'⋮', {"and so on", "und so weiter"}},
    {U'⋱', {"and so on", "und so weiter"}},
    {U'′', {"prime", "Strich"}},
    {U'″', {"double prime", "zwei Strich"}},
    {U'‴', {"triple prime", "drei Strich"}},
    {U'!', {"factorial", "Fakultät"}},
    {U'∑', {"the sum", "die Summe"}},
    {U'∏', {"the product", "das Produkt"}},
    {U'∫', {"the integral", "das Integral"}},
    {U'∬', {"the double integral", "das Doppelintegral"}},
    {U'∭', {"the triple integral", "das Dreifachintegral"}},
    {U'∮', {"the closed integral", "das geschlossene Integral"}},
    {U'∯', {"the closed surface integral", "das geschlossene Oberflächenintegral"}},
    {U'(', {"open parenthesis", "Klammer auf"}},
    {U')', {"close parenthesis", "Klammer zu"}},
    {U'[', {"open bracket", "eckige Klammer auf"}},
    {U']', {"close bracket", "eckige Klammer zu"}},
    {U'{', {"open brace", "geschweifte Klammer auf"}},
    {U'}', {"close brace", "geschweifte Klammer zu"}},
    {U'⟨', {"open angle", "spitze Klammer auf"}},
    {U'⟩', {"close angle", "spitze Klammer zu"}},
    {U'‖', {"norm", "Norm"}},
    {U'°', {"degrees", "Grad"}},
    {U'%', {"percent", "Prozent"}},
    {U'ı', {"dotless i", "i ohne Punkt"}},
    {U'ȷ', {"dotless j", "j ohne Punkt"}},
    {U'ℜ', {"the real part", "Realteil"}},
    {U'ℑ', {"the imaginary part", "Imaginärteil"}},
    {U'℘', {"Weierstrass p", "Weierstraß-p"}},
    {U'ℵ', {"aleph", "Aleph"}},
    {U'∄', {"there is no", "es gibt kein"}},
    {U'¬', {"not", "nicht"}},
    {U'⊥', {"perpendicular", "senkrecht"}},
    {U'∠', {"the angle", "der Winkel"}},
    {U'∡', {"the angle", "der Winkel"}},
    {U'△', {"triangle", "Dreieck"}},
    {U'□', {"square", "Quadrat"}},
    {U'■', {"filled square", "ausgefülltes Quadrat"}},
    {U'\\', {"backslash", "umgekehrter Schrägstrich"}},
    {U'√', {"root sign", "Wurzelzeichen"}},
    {U'♭', {"flat", "B"}},
    {U'♮', {"natural", "Auflösungszeichen"}},
    {U'♯', {"sharp", "Kreuz"}},
    {U'♣', {"clubs", "Treff"}},
    {U'♢', {"diamonds", "Karo"}},
    {U'♡', {"hearts", "Herz"}},
    {U'♠', {"spades", "Pik"}},
    {U'‡', {"double dagger", "Doppelkreuz"}},
    {U'§', {"section", "Paragraph"}},
    {U'¶', {"paragraph", "Absatz"}},
    {U'£', {"pounds", "Pfund"}},
    {U'©', {"copyright", "Copyright"}},
    {U'#', {"number sign", "Raute"}},
    {U'&', {"and", "und"}},
    {U'$', {"dollar", "Dollar"}},
    {U'_', {"underscore", "Unterstrich"}},
    {U'⋆', {"star", "Stern"}},
    {U'∙', {"bullet", "Punkt"}},
    {U'⊕', {"direct sum", "direkte Summe mit"}},
    {U'⊖', {"circled minus", "Minus im Kreis"}},
    {U'⊘', {"circled slash", "Schrägstrich im Kreis"}},
    {U'⊙', {"circled dot", "Punkt im Kreis"}},
    {U'∨', {"or", "oder"}},
    {U'⊎', {"disjoint union", "disjunkt vereinigt mit"}},
    {U'⊓', {"meet", "Infimum mit"}},
    {U'⊔', {"join", "Supremum mit"}},
    {U'≀', {"wreath product", "Kranzprodukt mit"}},
    {U'⨿', {"coproduct", "Koprodukt mit"}},
    {U'⋄', {"diamond", "Raute"}},
    {U'⋉', {"semidirect product from the left", "semidirektes Produkt von links mit"}},
    {U'⋊', {"semidirect product from the right", "semidirektes Produkt von rechts mit"}},
    {U'∔', {"plus with a dot", "Plus mit Punkt"}},
    {U'⊲', {"is a normal subgroup of", "Normalteiler von"}},
    {U'⊳', {"has the normal subgroup", "hat den Normalteiler"}},
    {U'◁', {"triangle to the left", "Dreieck nach links"}},
    {U'▷', {"triangle to the right", "Dreieck nach rechts"}},
    {U'⩽', {"at most", "kleiner gleich"}},
    {U'⩾', {"at least", "größer gleich"}},
    {U'≲', {"at most about", "höchstens etwa"}},
    {U'≳', {"at least about", "mindestens etwa"}},
    {U'≶', {"less or greater than", "kleiner oder größer als"}},
    {U'⋘', {"very much less than", "sehr viel kleiner als"}},
    {U'⋙', {"very much greater than", "sehr viel größer als"}},
    {U'≊', {"is about or equal to", "etwa oder genau gleich"}},
    {U'≐', {"approaches", "nähert sich"}},
    {U'≕', {"defines", "definiert"}},
    {U'≜', {"is equal by definition to", "nach Definition gleich"}},
    {U'≍', {"is of the same order as", "von derselben Ordnung wie"}},
    {U'∋', {"contains", "enthält"}},
    {U'⊃', {"is a superset of", "Obermenge von"}},
    {U'⊇', {"is a superset of", "Obermenge von"}},
    {U'⊊', {"is a proper subset of", "echte Teilmenge von"}},
    {U'⊋', {"is a proper superset of", "echte Obermenge von"}},
    {U'⊑', {"is below or equal to", "unter oder gleich"}},
    {U'⊒', {"is above or equal to", "über oder gleich"}},
    {U'≺', {"precedes", "geht voran"}},
    {U'≻', {"follows", "folgt auf"}},
    {U'⪯', {"precedes or equals", "geht voran oder ist gleich"}},
    {U'⪰', {"follows or equals", "folgt auf oder ist gleich"}},
    {U'∦', {"not parallel to", "nicht parallel zu"}},
    {U'∤', {"does not divide", "teilt nicht"}},
    {U'⊢', {"proves", "beweist"}},
    {U'⊣', {"is left adjoint to", "linksadjungiert zu"}},
    {U'⊨', {"satisfies", "erfüllt"}},
    {U'∵', {"because", "weil"}},
    {U'∴', {"therefore", "also"}},
    {U'⋈', {"joined with", "verbunden mit"}},
    {U'⌣', {"smile", "Bogen nach unten"}},
    {U'⌢', {"frown", "Bogen nach oben"}},
    {U'↔', {"goes both ways to", "geht hin und her zu"}},
    {U'↑', {"up", "nach oben"}},
    {U'↓', {"down", "nach unten"}},
    {U'↕', {"up and down", "auf und ab"}},
    {U'↗', {"up to the right", "nach rechts oben"}},
    {U'↘', {"down to the right", "nach rechts unten"}},
    {U'↙', {"down to the left", "nach links unten"}},
    {U'↖', {"up to the left", "nach links oben"}},
    {U'⇑', {"double arrow up", "Doppelpfeil nach oben"}},
    {U'⇓', {"double arrow down", "Doppelpfeil nach unten"}},
    {U'⇕', {"double arrow up and down", "Doppelpfeil auf und ab"}},
    {U'⟶', {"to", "gegen"}},
    {U'⟵', {"from", "von"}},
    {U'⟷', {"goes both ways to", "geht hin und her zu"}},
    {U'⟼', {"maps to", "wird abgebildet auf"}},
    {U'↪', {"is embedded in", "eingebettet in"}},
    {U'↩', {"embeds", "enthält eingebettet"}},
    {U'⇀', {"harpoon to the right", "Harpune nach rechts"}},
    {U'⇁', {"lower harpoon to the right", "untere Harpune nach rechts"}},
    {U'↼', {"harpoon to the left", "Harpune nach links"}},
    {U'↽', {"lower harpoon to the left", "untere Harpune nach links"}},
    {U'⇌', {"is in equilibrium with", "im Gleichgewicht mit"}},
    {U'⇄', {"there and back to", "hin und zurück zu"}},
    {U'↺', {"anticlockwise", "gegen den Uhrzeigersinn"}},
    {U'↻', {"clockwise", "im Uhrzeigersinn"}},
    {U'↶', {"arrow curved to the left", "nach links gebogener Pfeil"}},
    {U'↷', {"arrow curved to the right", "nach rechts gebogener Pfeil"}},
    {U'↛', {"does not go to", "geht nicht gegen"}},
    {U'⇏', {"does not imply", "daraus folgt nicht"}},
    {U'⇝', {"leads to", "führt zu"}},
    {U'⌊', {"open floor", "Abrundung auf"}},
    {U'⌋', {"close floor", "Abrundung zu"}},
    {U'⌈', {"open ceiling", "Aufrundung auf"}},
    {U'⌉', {"close ceiling", "Aufrundung zu"}},
    {U'⟮', {"open group", "Gruppe auf"}},
    {U'⟯', {"close group", "Gruppe zu"}},
    {U'∐', {"the coproduct", "das Koprodukt"}},
    {U'∰', {"the closed volume integral", "das geschlossene Volumenintegral"}},
    {U'⋂', {"the intersection", "der Durchschnitt"}},
    {U'⋃', {"the union", "die Vereinigung"}},
    {U'⨆', {"the join", "das Supremum"}},
    {U'⋁', {"the disjunction", "die Disjunktion"}},
    {U'⋀', {"the conjunction", "die Konjunktion"}},
    {U'⨀', {"the circled product", "das Produkt im Kreis"}},
    {U'⨁', {"the direct sum", "die direkte Summe"}},
    {U'⨂', {"the tensor product", "das Tensorprodukt"}},
    {U'⨄', {"the disjoint union", "die disjunkte Vereinigung"}},
    {U'ϵ', {"epsilon", "Epsilon"}},
    {U'ε', {"epsilon", "Epsilon"}},
    {U'ϑ', {"theta", "Theta"}},
    {U'ϰ', {"kappa", "Kappa"}},
    {U'ϖ', {"pi", "Pi"}},
    {U'ϱ', {"rho", "Rho"}},
    {U'ς', {"final sigma", "Schluss-Sigma"}},
    {U'ϕ', {"phi", "Phi"}},
    {U'φ', {"phi", "Phi"}},
});

/// Of a vector's parts, as indices and labels: the sign has nothing on its right.
inline constexpr auto kParts = std::to_array<SignWords>({
    {U'⟂', {"perpendicular", "senkrecht"}},
    {U'⊥', {"perpendicular", "senkrecht"}},
    {U'∥', {"parallel", "parallel"}},
});

/// Of accents, behind what they stand on; \vec's is said before it.
inline constexpr auto kAccents = std::to_array<SignWords>({
    {0x0302, {"hat", "Dach"}},
    {0x030C, {"check", "Hatschek"}},
    {0x0303, {"tilde", "Tilde"}},
    {0x0307, {"dot", "Punkt"}},
    {0x0308, {"double dot", "zwei Punkte"}},
    {0x20DB, {"triple dot", "drei Punkte"}},
    {0x20DC, {"quadruple dot", "vier Punkte"}},
    {0x0304, {"bar", "quer"}},
    {0x0306, {"breve", "Breve"}},
    {0x030A, {"ring", "Ring"}},
    {0x0301, {"acute", "Akut"}},
    {0x0300, {"grave", "Gravis"}},
});
/// Of what dots stand on that a scalar product could follow: "omega dot" is no half of one.
inline constexpr Phrase kTimeDerivativeOf{"the time derivative of", "Zeitableitung von"};
inline constexpr Phrase kSecondTimeDerivativeOf{"the second time derivative of", "zweite Zeitableitung von"};
inline constexpr Phrase kVector{"vector", "Vektor"};
inline constexpr Phrase kBar{"bar", "quer"};
inline constexpr Phrase kUnderlined{"underlined", "unterstrichen"};
inline constexpr Phrase kCapital{"capital {0}", "groß {0}"};

/// Between numbers; between vectors × and ⋅ have the words of kSigns.
inline constexpr Phrase kTimes{"times", "mal"};
inline constexpr Phrase kMagnitudeOf{"magnitude of", "Betrag von"};
inline constexpr Phrase kEndOfMagnitude{"end of magnitude", "Ende des Betrags"};
inline constexpr Phrase kItsValueNow{"its value now", "aktueller Wert"};
inline constexpr Phrase kDegrees{"degrees", "Grad"};
inline constexpr Phrase kStruckOut{"struck out:", "durchgestrichen:"};
inline constexpr Phrase kEndOfStruckOut{"end of struck out", "Ende des Durchgestrichenen"};
inline constexpr Phrase kNot{"not", "nicht"};
inline constexpr Phrase kGoesTo{"goes to", "geht über in"};
inline constexpr Phrase kBy{"by", "durch"};
inline constexpr Phrase kWithBelow{"with below", "darunter"};
inline constexpr Phrase kWithAbove{"with above", "darüber"};
inline constexpr Phrase kWhichIs{"which is", "das ist"};
inline constexpr Phrase kSub{"sub", ""};
inline constexpr Phrase kSubLetter{"sub", "Index"};  ///< no number, which in German is said alone
inline constexpr Phrase kUnitTensor{"the unit tensor", "Einheitstensor"};
inline constexpr Phrase kSuper{"super", "oben"};
inline constexpr Phrase kSquared{"squared", "Quadrat"};
inline constexpr Phrase kCubed{"cubed", "hoch 3"};
inline constexpr Phrase kInverse{"inverse", "hoch minus 1"};
inline constexpr Phrase kToThePower{"to the power", "hoch"};
inline constexpr Phrase kEndOfPower{"end of power", "Ende des Exponenten"};
inline constexpr Phrase kOver{"over", "durch"};      ///< of a fraction
inline constexpr Phrase kLimitOver{"over", "über"};  ///< of a sum
inline constexpr Phrase kLimitFrom{"from", "von"};
inline constexpr Phrase kLimitTo{"to", "bis"};
inline constexpr Phrase kOf{"of", "von"};
inline constexpr Phrase kChoose{"choose", "über"};
inline constexpr Phrase kOneHalf{"one half", "einhalb"};
inline constexpr Phrase kTheFraction{"the fraction", "Bruch"};
inline constexpr Phrase kEndOfFraction{"end of fraction", "Ende des Bruchs"};
inline constexpr Phrase kSquareRootOf{"the square root of", "Wurzel aus"};
inline constexpr Phrase kRootOfOrder{"the root of order", "die Wurzel der Ordnung"};
inline constexpr Phrase kRootOf{"of", "aus"};
inline constexpr Phrase kEndOfRoot{"end of root", "Ende der Wurzel"};
inline constexpr Phrase kDeterminantWithRows{"the determinant with rows", "die Determinante mit den Zeilen"};
inline constexpr Phrase kMatrixWithRows{"the matrix with rows", "die Matrix mit den Zeilen"};
inline constexpr Phrase kInCases{"in cases", "in den Fällen"};

// Computed numbers.
inline constexpr Phrase kMinus{"minus {0}", "minus {0}"};
inline constexpr Phrase kTimesTenToThePower{"{0} times 10 to the power {1}", "{0} mal 10 hoch {1}"};
inline constexpr Phrase kNotDefined{"not defined", "nicht definiert"};

// Words of an author that formulas are read with, in any of the languages.
inline constexpr std::array<Phrase, 3> kReadInFormulas = {
    {{"and", "und"}, {"so", "also"}, {"does not give", "ergibt nicht"}}};

/// What a word of a formula is in English, by which formulas are read; others stay.
constexpr std::string_view read_in_english(std::string_view words) {
  for (const Phrase& phrase : kReadInFormulas)
    for (const Language language : kLanguages)
      if (phrase.in(language) == words) return phrase.in(Language::en);
  return words;
}

}  // namespace polhode::words

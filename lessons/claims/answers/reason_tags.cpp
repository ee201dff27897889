// SPDX-License-Identifier: MIT
#include "lessons/claims/answers/reason_tags.h"

#include "base/words/phrase.h"
#include "lessons/claims/answers/told_in_language.h"

#include <algorithm>
#include <array>

namespace polhode {

namespace {

struct Row {
  std::string_view tag;
  Phrase words;
};

/// With a letter, and with a number, behind them.
constexpr std::string_view kChoice = "choice-", kPlace = "place-";
constexpr Phrase kWasChosen{"{0} was chosen", "{0} wurde gewählt"};
constexpr Phrase kOrderIsWrong{"the order is wrong from place {0}",
                               "die Reihenfolge ist ab Platz {0} falsch"};

/// Those of answers (lessons/claims/answers/answers.h, number_answer.h) and of lines of derivations (Slip,
/// whose names they are).
constexpr std::array<Row, 25> kReasons{{
    {"degrees", {"degrees and radians are mixed up", "Grad und Bogenmaß sind verwechselt"}},
    {"derivative", {"a derivative is left in the answer", "eine Ableitung steht noch in der Antwort"}},
    {"extra", {"a term is too many", "ein Term ist zu viel"}},
    {"factor", {"a number as a factor is wrong", "ein Zahlenfaktor ist falsch"}},
    {"frame",
     {"the rate is that seen from the other frame", "die Änderungsrate ist die im anderen Bezugssystem"}},
    {"goal", {"the motion does not reach its goal", "die Bewegung erreicht ihr Ziel nicht"}},
    {"index", {"an index is wrong", "ein Index ist falsch"}},
    {"indices", {"the indices are mixed up", "die Indizes sind vertauscht"}},
    {"inertia",
     {"a moment of inertia is missing or misplaced",
      "ein Trägheitsmoment fehlt oder steht an falscher Stelle"}},
    {"kind",
     {"a vector stands where a number belongs, or a number where a vector does",
      "ein Vektor steht, wo eine Zahl hingehört, oder umgekehrt"}},
    {"law",
     {"Euler's law is used where it is not given",
      "die eulerschen Gleichungen werden benutzt, wo sie nicht gegeben sind"}},
    {"letters",
     {"it is written with letters that are not asked for",
      "sie ist mit Buchstaben geschrieben, nach denen nicht gefragt ist"}},
    {"missing", {"a term is missing", "ein Term fehlt"}},
    {"other", {"another reason", "aus einem anderen Grund"}},
    {"power",
     {"a square or a factor is missing or too many", "ein Quadrat oder ein Faktor fehlt oder ist zu viel"}},
    {"power-of-ten", {"it is off by a power of ten", "sie ist um eine Zehnerpotenz falsch"}},
    {"rate", {"a derivative is missing or too many", "eine Ableitung fehlt oder ist zu viel"}},
    {"restated", {"the question is written again", "die Frage ist noch einmal hingeschrieben"}},
    {"rounding", {"it is rounded too coarsely", "sie ist zu grob gerundet"}},
    {"sign", {"the sign of a term is wrong", "das Vorzeichen eines Terms ist falsch"}},
    {"signs", {"all signs are the other way round", "alle Vorzeichen sind umgekehrt"}},
    {"torque", {"the torque is left out", "das Drehmoment fehlt"}},
    {"transport", {"omega x … is missing", "der Term mit ω× fehlt"}},
    {"turns", {"turns and radians are mixed up", "Umdrehungen und Bogenmaß sind verwechselt"}},
    {"unit", {"the unit is wrong", "die Einheit ist falsch"}},
}};

}  // namespace

bool is_reason_tag(std::string_view text) {
  constexpr std::size_t kMostCharacters = 24;
  return !text.empty() && text.size() <= kMostCharacters && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  });
}

bool is_known_reason(std::string_view tag, std::size_t choices) {
  if (std::any_of(kReasons.begin(), kReasons.end(), [tag](const Row& row) { return row.tag == tag; }))
    return true;
  for (std::size_t i = 0; i < choices; ++i)
    if (tag == std::string(kChoice) + static_cast<char>('A' + i) ||
        tag == std::string(kPlace) + std::to_string(i + 1))
      return true;
  return false;
}

std::string words_of_reason_in(Language language, std::string_view tag) {
  const auto found =
      std::find_if(kReasons.begin(), kReasons.end(), [tag](const Row& row) { return row.tag == tag; });
  if (found != kReasons.end()) return std::string(found->words.in(language));
  if (tag.starts_with(kChoice)) return kWasChosen.with(language, {tag.substr(kChoice.size())});
  if (tag.starts_with(kPlace)) return kOrderIsWrong.with(language, {tag.substr(kPlace.size())});
  return std::string(tag);
}

std::string words_of_reason(std::string_view tag) { return words_of_reason_in(Language::en, tag); }

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "lessons/notation/typed/typed_names.h"

#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/expressions/expression_tex.h"

#include <vector>

namespace polhode {
namespace {

/// A name whose letter an index may follow.
struct Letter {
  std::string_view name, plain;  ///< as it is typed; TeX of it before an index
  std::string alone;             ///< TeX of it without an index; empty: it needs one
};

const std::vector<Letter>& letters() {
  static const std::vector<Letter> kLetters = [] {
    std::vector<Letter> all{
        {"w", "\\omega", ""}, {"I", "I", std::string(kTensorTex)}, {"e", "\\hat e", ""}, {"T", "T", "T"}};
    for (const QuantityFacts& facts : kQuantities)
      if (!facts.arrow_letter.empty())
        all.push_back({facts.name, facts.arrow_letter, tex_of(facts.quantity)});
    return all;
  }();
  return kLetters;
}

}  // namespace

std::optional<PrintedName> printed_name(const std::string& text, const TypedNames& names) {
  if (const auto own = names.find(text); own != names.end()) {
    const bool is_arrow = own->second.starts_with("\\vec") || own->second.starts_with("\\boldsymbol");
    return PrintedName{own->second, "", is_arrow || text == "I", text == "omega"};
  }
  if (text == "w") return printed_name("omega", names).value_or(PrintedName{"\\vec\\omega", "", true, true});
  if (text == "m") return PrintedName{"m", ""};
  for (const Letter& letter : letters()) {
    if (!text.starts_with(letter.name)) continue;
    std::string index = text.substr(letter.name.size());
    if (index.starts_with('_')) index.erase(0, 1);
    if (index.empty() && text == letter.name && !letter.alone.empty())
      return PrintedName{letter.alone, "", letter.name != "T", letter.name == "omega"};
    const bool is_index = !index.empty() && letter.name != "T" &&
                          index.size() <= (letter.name == "I" ? 2u : 1u) &&
                          index.find_first_not_of("123xyz") == index.npos;
    if (is_index) return PrintedName{std::string(letter.plain), index, letter.name == "e"};
  }
  return std::nullopt;
}

}  // namespace polhode

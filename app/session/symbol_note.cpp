// SPDX-License-Identifier: MIT
#include "app/session/symbol_note.h"

#include "app/narration/speech_text.h"
#include "base/words/page_words.h"
#include "lessons/claims/live_claims.h"
#include "render/scene/model/translation.h"
#include "render/typeset/math/symbols.h"
#include "render/typeset/math/tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace polhode {

namespace {

std::string superscript(int number) {
  constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : std::to_string(number)) text += c == '-' ? "⁻" : kDigits[c - '0'];
  return text;
}

/// With a minus sign; nothing is −0.
std::string decimal(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = text.find_first_not_of("0.") == std::string::npos;
  if (is_zero) return "0";
  return value < 0 ? "−" + text : text;
}

/// So many digits of the largest; a power of ten is set apart where there are too many zeros.
std::string text_of(std::span<const double> values, int digits = 3) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (!std::isfinite(largest)) return "";
  int exponent = largest > 0 ? static_cast<int>(std::floor(std::log10(largest))) : 0;
  const double tenth = 10 - 0.5 * std::pow(10.0, 1 - digits);  // of three digits 9.996 is 10.0
  if (largest > 0 && largest / std::pow(10.0, exponent) >= tenth) ++exponent;
  const int factor = exponent < -2 || exponent > 3 ? exponent : 0;
  const int decimals = std::clamp(digits - 1 - (exponent - factor), 0, digits + 1);
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + decimal(value / std::pow(10.0, factor), decimals);
  if (values.size() > 1) text = '(' + text + ')';
  return factor == 0 ? text : text + "·10" + superscript(factor);
}

/// Whether the scene has what the expression is of.
bool is_of_scene(const Expression& expression, const Scene& scene) {
  for (const Quantity of_center : {Quantity::p, Quantity::v, Quantity::F, Quantity::m})
    if (expression.uses(of_center) && !drifts(scene)) return false;
  return !expression.uses(Quantity::A) || scene.show.contains(Overlay::transport);
}

/// What a symbol is, in the words of the lesson; nothing if it is nothing that has a value.
std::optional<Expression> meaning_of(const Lesson& lesson, const std::string& name) {
  const std::string& means = lesson.symbols.at(name).means;
  const std::string& text = means.empty() ? name : means;
  const SourceText source(text);
  Report report(source, "");
  return read_expression(text, {1, 1}, report, &lesson.notation.vocabulary);
}

void add_value(const Lesson& lesson, const std::string& name, const SceneModel& model, double t_s,
               SymbolNote& note) {
  if (name == "I") {
    const Vec3 moments = model.scene.body.moments.vector();
    note.value = text_of({moments.data(), 3});
    note.frame = "body";
    return;
  }
  const auto expression = meaning_of(lesson, name);
  if (!expression || !is_of_scene(*expression, model.scene)) return;
  const auto live = live_state(model, t_s);
  const View view = model.scene.views.front();
  const auto value = live ? live_quantity(*expression, *live, view) : std::nullopt;
  if (!value) return;
  note.value = text_of({value->components.data(), value->is_vector ? 3u : 1u});
  if (value->is_vector) note.frame = view == View::space ? "space" : "body";
}

const MathNode* find_term(const MathNode& node, const std::string& name) {
  if (node.kind == MathNode::Kind::term && node.text == name) return &node;
  for (const MathNode& child : node.children)
    if (const MathNode* found = find_term(child, name)) return found;
  return nullptr;
}

/// The formula of the first term of this name on a step; without a root if there is none.
Math term_on(const Step& step, const std::string& name) {
  for (const Equation* equation : blocks_of<Equation>(step)) {
    if (!equation->math.root) continue;
    const MathNode* term = find_term(*equation->math.root, name);
    Math content;
    // The tree lives as long as the part of it that is asked for.
    if (term) content.root = std::shared_ptr<const MathNode>(equation->math.root, term);
    if (term) return content;
  }
  return {};
}

Math term_seen_last(const Lesson& lesson, const std::string& name, const std::string& stage_id,
                    std::size_t step) {
  if (const Stage* stage = lesson.find_stage(stage_id))
    for (std::size_t i = std::min(step + 1, stage->steps.size()); i-- > 0;)
      if (Math term = term_on(stage->steps[i], name); term.root) return term;
  for (const Stage& stage : lesson.stages)
    for (const Step& any : stage.steps)
      if (Math term = term_on(any, name); term.root) return term;
  return {};
}

/// "Go to: Which spins are stable?", or what is cited.
std::string words_of_link(const Lesson& lesson, const std::string& link) {
  if (const auto place = target_of(lesson, link))
    return words::kGoTo.with(lesson.about.language,
                             {SpeechText(lesson).words(lesson.stages[place->stage].title_text)});
  for (const Reference& reference : lesson.references)
    if (link == std::string(kCiteLink) + reference.key) return reference.text;
  const Phrase& phrase = link.find("://") == link.npos ? words::kInAnotherLesson : words::kClickToCopy;
  return phrase.with(lesson.about.language, {link});
}

/// The lesson's symbol that a term is, and nothing beside it; empty: it is more, or none.
std::string symbol_in(const Lesson& lesson, const Math& term) {
  std::vector<MathSymbol> symbols;
  for (const auto& [name, symbol] : lesson.symbols) symbols.push_back({name, symbol.math, {}});
  std::span<const MathNode> atoms(term.root.get(), 1);
  while (atoms.size() == 1 && (atoms[0].kind == MathNode::Kind::row || atoms[0].kind == MathNode::Kind::term))
    atoms = atoms[0].children;
  if (atoms.empty()) return "";
  const MathSymbols::Found found = MathSymbols(&symbols).at(atoms, 0);
  return found.symbol != nullptr && found.count == atoms.size() ? found.symbol->name : "";
}

}  // namespace

std::string readable(double value, int digits) {
  return std::isfinite(value) ? text_of(std::span(&value, 1), digits) : "";
}

std::string readable(const Vec3& components, int digits) {
  return components.allFinite() ? text_of({components.data(), 3}, digits) : "";
}

std::string with_minus(std::string number) {
  std::string text;
  for (const char c : number) text += c == '-' ? std::string("−") : std::string(1, c);
  return text;
}

SymbolNote note_of(const Lesson& lesson, const std::string& name, const SceneModel* model, double t_s,
                   const std::string& stage_id, std::size_t step) {
  SymbolNote note;
  if (is_link_name(name)) {
    note.meaning = words_of_link(lesson, name);
    return note;
  }
  const auto found = lesson.symbols.find(name);
  if (found == lesson.symbols.end()) {
    const Math term = term_seen_last(lesson, name, stage_id, step);
    if (!term.root) return note;
    if (const std::string symbol = symbol_in(lesson, term); !symbol.empty())
      return note_of(lesson, symbol, model, t_s, stage_id, step);
    note.meaning = SpeechText(lesson).words(term);
    return note;
  }
  note.meaning = found->second.note.empty() ? found->second.say : found->second.note;
  note.unit = found->second.unit;
  if (model) add_value(lesson, name, *model, t_s, note);
  note.value = with_decimals(std::move(note.value), lesson.about.language);
  return note;
}

}  // namespace polhode

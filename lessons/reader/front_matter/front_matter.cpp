// SPDX-License-Identifier: MIT
#include "lessons/reader/front_matter/front_matter.h"

#include "base/numbers.h"
#include "base/spelling.h"
#include "lessons/claims/expressions/expression_names.h"
#include "lessons/claims/motion_words.h"
#include "lessons/reader/checks/symbol_check.h"
#include "physics/body/bodies.h"
#include "physics/body/pivot.h"
#include "render/typeset/characters.h"
#include "render/typeset/math/tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace polhode {
namespace {

constexpr std::int64_t kFormat = 1;
constexpr std::string_view kFence = "+++";

void read_format(const TomlEntry& entry, Report& report) {
  const auto* format = entry.value.as<std::int64_t>();
  if (format == nullptr || *format != kFormat) {
    report.error(entry.value.place, "this program reads format 1 only", "write format = 1");
  }
}

void read_lesson_id(const TomlEntry& entry, FrontMatter& front, Report& report) {
  const auto id = read_text(entry, report);
  if (!id) return;
  if (is_id(*id))
    front.id = *id;
  else
    report.error(entry.value.place, "bad lesson id " + in_quotes(*id), std::string(kIdRule));
}

void read_title(const TomlEntry& entry, FrontMatter& front, Report& report) {
  const auto title = read_text(entry, report);
  if (!title) return;
  if (is_blank(*title) || !is_plain_line(*title)) {
    report.error(entry.value.place, "a title is one line of text without control characters");
  }
  front.title = curled(*title);
}

// What [body.NAME] may say; nothing is filled in that the author did not write.
struct BodyKeys {
  std::optional<Vec3> moments;
  std::optional<ShapeKind> shape;
  std::optional<Vec3> size_m;
  std::optional<double> mass_kg;
  std::optional<Vec3> pivot_m;
  std::optional<ShapeKind> draw;
};

std::optional<ShapeKind> read_shape(const TomlEntry& entry, Report& report) {
  const auto name = read_text(entry, report);
  if (!name) return std::nullopt;
  const auto kind = shape_kind_from(*name);
  if (!kind) {
    report.error(entry.value.place, "unknown shape " + in_quotes(*name),
                 suggestion(*name, shape_kind_names()));
  }
  return kind;
}

BodyKeys read_body_keys(const TomlTable& table, const std::string& where, Report& report) {
  BodyKeys keys;
  read_keys(table, where,
            {{"moments", [&](const TomlEntry& e) { keys.moments = read_vector(e, report); }},
             {"shape", [&](const TomlEntry& e) { keys.shape = read_shape(e, report); }},
             {"size_m", [&](const TomlEntry& e) { keys.size_m = read_vector(e, report); }},
             {"mass_kg", [&](const TomlEntry& e) { keys.mass_kg = read_positive_number(e, report); }},
             {"pivot_m", [&](const TomlEntry& e) { keys.pivot_m = read_vector(e, report); }},
             {"draw", [&](const TomlEntry& e) { keys.draw = read_shape(e, report); }}},
            report);
  return keys;
}

// True if the keys together say one thing: moments, or a shape with size and mass; and a mass with a pivot.
bool check_body_keys(const TomlEntry& entry, const TomlTable& table, Report& report) {
  const bool by_moments = table.find("moments") != nullptr;
  bool consistent = true;
  const bool is_drawn = table.find("draw") != nullptr;
  for (const char* key : {"shape", "size_m", "mass_kg"}) {
    const TomlEntry* given = table.find(key);
    if (by_moments && given != nullptr && (given->key == "shape" || (given->key == "size_m" && !is_drawn))) {
      report.error(given->place, "a body has moments or a shape, not both",
                   "leave one out, or say how the body is drawn: draw = \"ellipsoid\" and size_m");
      return false;
    }
    if (!by_moments && given == nullptr) {
      report.error(entry.place, "body " + in_quotes(entry.key) + " lacks " + in_quotes(key),
                   "give moments = [I1, I2, I3], or shape, size_m and mass_kg");
      consistent = false;
    }
  }
  if (!by_moments && is_drawn) {
    report.error(table.find("draw")->place, "\"draw\" is for bodies given by moments",
                 "a body with a shape is drawn as that shape");
    consistent = false;
  }
  const TomlEntry* pivot = table.find("pivot_m");
  if (by_moments && pivot != nullptr && table.find("mass_kg") == nullptr) {
    report.error(pivot->place,
                 "body " + in_quotes(entry.key) + " lacks \"mass_kg\": its weight is to turn it",
                 "write mass_kg = 1.0 in kg");
    consistent = false;
  }
  if (by_moments && pivot != nullptr && is_drawn) {
    report.error(table.find("draw")->place, "\"draw\" is for bodies without a pivot",
                 "one on a pivot is drawn as it hangs there");
    consistent = false;
  }
  return consistent;
}

/// Whether a body can be held there: the point is another than its centre of mass, and 1, 2, 3 are principal.
bool check_pivot(const Body& body, const Vec3& pivot_m, SourcePlace place, Report& report) {
  if (pivot_m.isZero(0.0)) {
    report.error(place, "\"pivot_m\" is the centre of mass, about which no weight turns a body",
                 "leave it out");
    return false;
  }
  const auto held = about_pivot(body, {weight_at(body.mass_kg, pivot_m)});
  if (!held)
    report.error(place, held.error(),
                 "let two of its numbers be 0, or give moments about the pivot and a torque \"heavy:…\"");
  return held.ok();
}

std::optional<Body> make_body_from(const std::string& name, const BodyKeys& keys) {
  if (keys.moments) {
    const Vec3& I = *keys.moments;
    Body body{name, PrincipalMoments(I[0], I[1], I[2]), std::nullopt, keys.mass_kg.value_or(1.0)};
    if (keys.draw && keys.size_m)
      body.shape = make_body(name, *keys.draw, *keys.size_m, body.mass_kg).shape;
    else if (keys.draw)
      body.shape = equivalent_box(body.moments, body.mass_kg);
    return body;
  }
  if (keys.shape && keys.size_m && keys.mass_kg)
    return make_body(name, *keys.shape, *keys.size_m, *keys.mass_kg);
  return std::nullopt;
}

/// False if it cannot be.
bool read_body(const TomlEntry& entry, LessonBodies& bodies, Report& report) {
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr) {
    report.error(entry.value.place, "a body takes a table, found " + std::string(entry.value.kind()),
                 "write [body." + entry.key + "] and its keys below");
    return false;
  }
  if (!is_id(entry.key)) {
    report.error(entry.place, "bad body name " + in_quotes(entry.key), std::string(kIdRule));
    return false;
  }
  const BodyKeys keys = read_body_keys(*table, "[body." + entry.key + "]", report);
  if (!check_body_keys(entry, *table, report)) return false;
  if (keys.draw && *keys.draw != ShapeKind::box && table->find("size_m") == nullptr) {
    report.error(table->find("draw")->value.place, "only a box follows from the moments",
                 "write \"box\", or size_m = [x, y, z] as well, in m");
    return false;
  }
  try {
    const auto body = make_body_from(entry.key, keys);
    if (!body) return false;
    if (keys.pivot_m) {
      if (!check_pivot(*body, *keys.pivot_m, table->find("pivot_m")->value.place, report)) return false;
      bodies.pivots_m.insert_or_assign(entry.key, *keys.pivot_m);
    }
    if (keys.draw) bodies.drawn.insert(entry.key);
    bodies.named.insert_or_assign(entry.key, *body);
    return true;
  } catch (const std::domain_error& error) {
    const bool by_size = keys.size_m && !(keys.moments && why_impossible(keys.moments->x(), keys.moments->y(),
                                                                         keys.moments->z()));
    const TomlEntry* culprit = table->find(by_size ? "size_m" : "moments");
    report.error(culprit->place, error.what());
    return false;
  }
}

void read_bodies(const TomlEntry& entry, FrontMatter& front, Report& report) {
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr) {
    report.error(entry.value.place,
                 "\"body\" takes a table of bodies, found " + std::string(entry.value.kind()),
                 "write [body.NAME]; a scene's body goes below [scene]");
    return;
  }
  for (const TomlEntry& one : table->entries)
    if (!read_body(one, front.bodies, report)) front.bodies.complete = false;
}

void read_role(const TomlEntry& entry, Symbol& symbol, Report& report) {
  const auto role = read_text(entry, report);
  if (!role) return;
  const auto& roles = color_roles();
  if (std::find(roles.begin(), roles.end(), *role) != roles.end())
    symbol.role = *role;
  else
    report.error(entry.value.place, "unknown role " + in_quotes(*role), suggestion(*role, roles));
}

/// Parts of all definitions of a lesson together, once they are written out.
constexpr std::size_t kMaxDefinedParts = 20'000;

/// What is printed where no macros of the lesson are known; empty if that cannot be.
std::string without_macros(const std::string& tex) { return parse_math(tex) ? tex : ""; }

/// The tables whose entries say what letters are.
enum class SymbolTable { constants, define, symbols };

/// The value of a cosine that none can have, made of numbers and constants alone.
std::optional<double> angle_without_cosine(const Expression& expression) {
  std::vector<std::optional<double>> values;
  for (const ExpressionNode& n : expression.nodes) {
    const auto value = [&](int index) {
      return index < 0 ? std::optional(0.0) : values[static_cast<std::size_t>(index)];
    };
    const auto a = value(n.a), b = value(n.b);
    values.emplace_back();
    if (!a || !b) continue;
    switch (n.operation) {
      case Operation::number:
      case Operation::constant:
        values.back() = n.number.value;
        break;
      case Operation::negate:
        values.back() = -*a;
        break;
      case Operation::add:
        values.back() = *a + *b;
        break;
      case Operation::subtract:
        values.back() = *a - *b;
        break;
      case Operation::multiply:
        values.back() = *a * *b;
        break;
      case Operation::divide:
        values.back() = *a / *b;
        break;
      case Operation::power:
        values.back() = std::pow(*a, n.integer);
        break;
      case Operation::acos:
        if (std::abs(*a) > 1) return a;
        break;
      default:
        break;
    }
  }
  return std::nullopt;
}

/// An expression of the language of claims, which is known by the symbol's name from now on, or a tensor's
/// name.
void read_meaning(const TomlEntry& entry, const std::string& name, Symbol& symbol, FrontMatter& front,
                  TextReader& texts) {
  Report& report = texts.report();
  const auto text = read_text(entry, report);
  if (!text) return;
  const bool is_tensor = *text == "I" || *text == "J";
  const SourcePlace start =
      texts.source().place_of(located_string(texts.source(), entry.value.place, *text).offset_of(0));
  if (!is_plain_line(*text)) {
    report.error(entry.value.place, "\"means\" is one line of text without control characters");
    return;
  }
  if (is_tensor) {
    symbol.means = *text;
    return;
  }
  auto expression = read_expression(*text, start, report, &front.notation.vocabulary);
  if (!expression) return;
  std::size_t parts = expression->nodes.size();
  for (const Vocabulary::Word& word : front.notation.vocabulary.words()) parts += word.means.nodes.size();
  if (parts > kMaxDefinedParts) {
    report.error(entry.value.place,
                 "written out, the definitions of a lesson have at most " + std::to_string(kMaxDefinedParts) +
                     " parts",
                 "definitions in definitions grow quickly");
    return;
  }
  if (const auto beyond = angle_without_cosine(*expression)) {
    report.error(entry.value.place, "there is no such angle: this is acos(" + digits(*beyond, 4) + ")",
                 "a cosine lies between -1 and 1");
    return;
  }
  symbol.means = *text;
  Vocabulary& vocabulary = front.notation.vocabulary;
  if (vocabulary.find(name) != nullptr) {
    report.error(entry.place, in_quotes(name) + " has a meaning already, above", "leave out \"means\"");
  } else if (why_no_word(name).empty()) {
    vocabulary.define(name, std::move(*expression), without_macros(symbol.tex));
  }
}

/// The value of a constant.
void read_value(const TomlEntry& entry, const std::string& name, Symbol& symbol, FrontMatter& front,
                Report& report) {
  const auto value = read_number(entry, report);
  Vocabulary& vocabulary = front.notation.vocabulary;
  if (!value || vocabulary.find(name) != nullptr) return;
  if (vocabulary.constants() && vocabulary.constants()->size() == kMaxConstants) {
    report.error(entry.value.place, "a lesson has at most " + std::to_string(kMaxConstants) + " constants",
                 "write numbers where they are used once");
    return;
  }
  vocabulary.add_constant(name, *value, without_macros(symbol.tex));
  symbol.means = name;
}

/// False, and a report, if this cannot be a word of expressions.
bool check_word(const TomlEntry& entry, const FrontMatter& front, Report& report) {
  const std::string why = why_no_word(entry.key);
  if (!why.empty())
    report.error(entry.place, "bad name " + in_quotes(entry.key) + ": " + why, "take another name");
  else if (is_component_name(entry.key))
    report.error(entry.place, "bad name " + in_quotes(entry.key) + ": learners type it for a component",
                 "take another name, such as \"" + entry.key.substr(0, 1) + "_after\"");
  else if (front.notation.vocabulary.find(entry.key) != nullptr)
    report.error(entry.place, in_quotes(entry.key) + " is a constant already, or defined",
                 "take another name");
  else
    return true;
  return false;
}

/// Whether a symbol's unit is that of what it stands for, and what it means adds nothing of different units.
void check_unit(const TomlEntry& entry, FrontMatter& front, Report& report) {
  const auto* table = entry.value.as<TomlTable>();
  const TomlEntry* unit_entry = table == nullptr ? nullptr : table->find("unit");
  const auto* text = unit_entry == nullptr ? nullptr : unit_entry->value.as<std::string>();
  const auto unit = text == nullptr ? std::nullopt : dimension_of_unit(*text);
  const QuantityFacts* quantity = find_quantity(entry.key);
  const Vocabulary::Word* word = front.notation.vocabulary.find(entry.key);
  // Their numbers are those of SI everywhere: 0.3 kg, never 300 g.
  const auto scaled = text == nullptr ? std::nullopt : scaled_unit(*text);
  if (scaled && scaled->size != 1) {
    report.error(unit_entry->value.place,
                 "the unit of " + in_quotes(entry.key) + " is one of SI, " + in_quotes(*text) + " is none",
                 "numbers are shown in other units by \\live[unit=…], plots by their \"unit\"");
    return;
  }
  std::optional<Dimension> known;
  if (const auto constant = word == nullptr ? std::nullopt : word->constant()) {
    if (unit) front.dimensions.insert_or_assign(constant->first, *unit);
    return;
  }
  if (word != nullptr) {
    const DimensionReading reading = dimension_of(word->means, front.dimensions);
    if (reading.fault)
      report.error(entry.place, in_quotes(entry.key) + ": " + reading.fault->message,
                   "a number with a unit is a constant: name = { value = …, unit = \"…\" }");
    known = reading.dimension;
  } else if (quantity != nullptr && table != nullptr && table->find("means") == nullptr) {
    known = quantity->dimension;
  }
  static const Expression kOfNothing = zero_expression();
  const std::string why = unit ? why_not_in(word != nullptr ? word->means : kOfNothing, *text) : "";
  if (!why.empty())
    report.error(unit_entry->value.place, why);
  else if (unit && known && *unit != *known)
    report.error(unit_entry->value.place, "units disagree: " + in_quotes(entry.key) + " is in " +
                                              to_string(*known) + ", and this is " + to_string(*unit));
}

void read_symbol(const TomlEntry& entry, SymbolTable which, FrontMatter& front, TextReader& texts) {
  Report& report = texts.report();
  if (which != SymbolTable::symbols && !check_word(entry, front, report)) return;
  if (front.symbols.contains(entry.key)) {
    report.error(entry.place, "symbol " + in_quotes(entry.key) + " is there already, above", "leave one out");
    return;
  }
  const auto* table = entry.value.as<TomlTable>();
  Symbol symbol;
  if (table == nullptr && which == SymbolTable::constants)
    return read_value(entry, entry.key, symbol, front, report);
  if (table == nullptr && which == SymbolTable::define)
    return read_meaning(entry, entry.key, symbol, front, texts);
  if (table == nullptr) {
    report.error(entry.value.place, "a symbol takes a table, found " + std::string(entry.value.kind()),
                 "write " + entry.key + " = { tex = '…', say = \"…\" }");
    return;
  }
  const auto text_into = [&report](std::string& target) {
    return [&report, &target](const TomlEntry& e) {
      if (auto text = read_text(e, report)) target = std::move(*text);
    };
  };
  const auto line_into = [&report](std::string& target) {
    return [&report, &target](const TomlEntry& e) {
      auto text = read_text(e, report);
      if (text && !is_plain_line(*text))
        report.error(e.value.place, in_quotes(e.key) + " is one line of text without control characters");
      else if (text)
        target = std::move(*text);
    };
  };
  const std::string what = which == SymbolTable::constants ? "constant "
                           : which == SymbolTable::define  ? "definition "
                                                           : "symbol ";
  const auto later = [](const TomlEntry&) {};  // what it means is printed as `tex` says
  std::vector<KeyHandler> keys{{"tex", text_into(symbol.tex)},
                               {"role", [&](const TomlEntry& e) { read_role(e, symbol, report); }},
                               {"say", line_into(symbol.say)},
                               {"unit", line_into(symbol.unit)},
                               {"note", line_into(symbol.note)}};
  keys.push_back({which == SymbolTable::constants ? "value" : "means", later});
  read_keys(*table, what + in_quotes(entry.key), keys, report);
  if (const TomlEntry* value = table->find("value"); value != nullptr && which == SymbolTable::constants)
    read_value(*value, entry.key, symbol, front, report);
  else if (which == SymbolTable::constants)
    report.error(entry.place, what + in_quotes(entry.key) + " lacks \"value\"");
  if (const TomlEntry* means = table->find("means"); means != nullptr && which != SymbolTable::constants)
    read_meaning(*means, entry.key, symbol, front, texts);
  else if (which == SymbolTable::define)
    report.error(entry.place, what + in_quotes(entry.key) + " lacks \"means\"");
  if (const TomlEntry* tex = table->find("tex")) {
    const LocatedText located = located_string(texts.source(), tex->value.place, symbol.tex);
    symbol.offset = located.offset_of(0);
    if (auto math = texts.formula(located)) symbol.math = std::move(*math);
    if (!symbol.math.references.empty())
      report.error(tex->value.place, "\\eqref stands in texts and displays only");
  } else if (which == SymbolTable::symbols) {
    report.error(entry.place, what + in_quotes(entry.key) + " lacks \"tex\"");
  } else {
    // A word of expressions alone: it stands in no formula that could have its colour.
    if (const TomlEntry* role = table->find("role"))
      report.warning(role->place,
                     "the role of " + what + in_quotes(entry.key) + " has no effect without a \"tex\"",
                     "write how it is printed, tex = '…', or give the arrow a role");
    return;
  }
  if (symbol.means.empty()) front.notation.vocabulary.print_as(entry.key, without_macros(symbol.tex));
  // By its name, where that is a word: it is written as that.
  const bool is_word = front.notation.vocabulary.find(entry.key) != nullptr;
  front.notation.symbols.push_back(equation_symbol(entry.key, symbol.math, is_word ? "" : symbol.means));
  front.symbols.insert_or_assign(entry.key, std::move(symbol));
}

/// [constants], [define] and [symbols], in this order: each may use the words of those before it.
void read_all_symbols(const TomlTable& table, Meanings meanings, FrontMatter& front, TextReader& texts) {
  Report& report = texts.report();
  std::vector<const TomlEntry*> all;
  constexpr std::array<std::pair<const char*, SymbolTable>, 3> kTables{{{"constants", SymbolTable::constants},
                                                                        {"define", SymbolTable::define},
                                                                        {"symbols", SymbolTable::symbols}}};
  for (const auto& [name, which] : kTables) {
    const TomlEntry* entry = table.find(name);
    if (entry == nullptr) continue;
    const auto* entries = entry->value.as<TomlTable>();
    if (entries == nullptr) {
      report.error(entry->value.place,
                   in_quotes(name) + " takes a table, found " + std::string(entry->value.kind()));
      continue;
    }
    if (all.size() + entries->entries.size() > kMaxSymbols) {
      report.error(entry->place, "a lesson has at most " + std::to_string(kMaxSymbols) +
                                     " symbols, constants and definitions");
      return;
    }
    std::vector<const TomlEntry*> written;  // in their order: TOML sorts them by name
    std::set<std::string> later;
    for (const TomlEntry& one : entries->entries) {
      written.push_back(&one);
      const auto* keys = one.value.as<TomlTable>();
      if (which != SymbolTable::symbols || (keys != nullptr && keys->find("means") != nullptr))
        later.insert(one.key);
    }
    std::sort(written.begin(), written.end(), [](const TomlEntry* a, const TomlEntry* b) {
      return std::pair(a->place.line, a->place.column) < std::pair(b->place.line, b->place.column);
    });
    front.notation.vocabulary.announce(std::move(later));
    for (const TomlEntry* one : written) {
      read_symbol(*one, which, front, texts);
      check_unit(*one, front, report);
    }
    all.insert(all.end(), written.begin(), written.end());
    front.notation.vocabulary.announce({});
  }
  if (meanings == Meanings::checked) check_meanings(all, front, texts);
}

void read_axes(const TomlEntry& entry, FrontMatter& front, Report& report) {
  const auto axes = read_text(entry, report);
  if (axes && *axes != "xyz" && *axes != "123")
    report.error(entry.value.place, "unknown names of the body's axes " + in_quotes(*axes),
                 "write \"123\", or \"xyz\" where x, y, z are axes of the body");
  front.notation.xyz_are_body_axes = axes == "xyz";
}

void read_base_scene(const TomlEntry& entry, FrontMatter& front, TextReader& texts) {
  Report& report = texts.report();
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr) {
    report.error(entry.value.place, "\"scene\" takes a table, found " + std::string(entry.value.kind()));
    return;
  }
  for (const PlacedText& name : read_scene_keys(*table, front.bodies, front.words(), front.scene, texts)) {
    if (overlay_from(name.text)) continue;
    report.error(name.place,
                 "the front matter can highlight overlays only, " + in_quotes(name.text) + " is none",
                 suggestion(name.text, overlay_names()));
  }
}

// '…', or { arguments = 1, tex = '…' }.
void read_macro(const TomlEntry& entry, TextReader& texts) {
  Report& report = texts.report();
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!std::all_of(entry.key.begin(), entry.key.end(), is_letter)) {
    report.error(entry.place, "bad name of a macro " + in_quotes(entry.key),
                 "a macro's name has letters only");
    return;
  }
  MathMacro macro;
  const auto arguments = [&](const TomlEntry& e) {
    const auto* count = e.value.as<std::int64_t>();
    if (count == nullptr || *count < 0 || *count > 9)
      report.error(e.value.place, "a macro has 0 to 9 arguments");
    else
      macro.arguments = static_cast<int>(*count);
  };
  const auto tex = [&](const TomlEntry& e) {
    auto text = read_text(e, report);
    if (!text) return;
    texts.locate_macro(entry.key, located_string(texts.source(), e.value.place, *text));
    macro.body = std::move(*text);
  };
  if (const auto* table = entry.value.as<TomlTable>()) {
    read_keys(*table, "macro " + in_quotes(entry.key), {{"arguments", arguments}, {"tex", tex}}, report);
    if (table->find("tex") == nullptr)
      report.error(entry.place, "macro " + in_quotes(entry.key) + " lacks \"tex\"");
  } else {
    tex(entry);
  }
  texts.macros().insert_or_assign(entry.key, std::move(macro));
}

void read_macros(const TomlEntry& entry, TextReader& texts) {
  const auto* table = entry.value.as<TomlTable>();
  if (table == nullptr) {
    texts.report().error(entry.value.place,
                         "\"macros\" takes a table, found " + std::string(entry.value.kind()),
                         "write [macros], and name = '…' below");
    return;
  }
  if (table->entries.size() > kMaxMacros) {
    texts.report().error(entry.place, "a lesson has at most " + std::to_string(kMaxMacros) + " macros");
    return;
  }
  for (const TomlEntry& macro : table->entries) read_macro(macro, texts);
}

void read_front_table(const TomlTable& table, Meanings meanings, FrontMatter& front, TextReader& texts) {
  Report& report = texts.report();
  // Formulas are in the lesson's language and use macros, so these come first; the scene names bodies, so it
  // comes last.
  if (const TomlEntry* language = table.find("language")) {
    read_language(*language, front.about.about, report);
    texts.write_in(front.about.about.language);
    front.scene.scene.language = front.about.about.language;
  }
  if (const TomlEntry* macros = table.find("macros")) read_macros(*macros, texts);
  if (const TomlEntry* axes = table.find("axes")) read_axes(*axes, front, report);
  read_all_symbols(table, meanings, front, texts);
  const TomlEntry* scene = table.find("scene");
  const auto later = [](const TomlEntry&) {};  // or already
  std::vector<KeyHandler> handlers = {{"format", [&](const TomlEntry& e) { read_format(e, report); }},
                                      {"id", [&](const TomlEntry& e) { read_lesson_id(e, front, report); }},
                                      {"title", [&](const TomlEntry& e) { read_title(e, front, report); }},
                                      {"body", [&](const TomlEntry& e) { read_bodies(e, front, report); }},
                                      {"language", later},
                                      {"axes", later},
                                      {"macros", later},
                                      {"constants", later},
                                      {"define", later},
                                      {"symbols", later},
                                      {"assume", later},
                                      {"scene", later}};
  for (KeyHandler& handler : about_key_handlers(front.about, report)) handlers.push_back(std::move(handler));
  read_keys(table, "the front matter", handlers, report);
  for (const Reference& reference : front.about.references) texts.citable()[reference.key] = false;
  if (const TomlEntry* assume = table.find("assume"))
    front.assumptions = read_assumptions(*assume, front.notation.vocabulary, front.dimensions, texts);
  texts.speak(front.notation.vocabulary, front.dimensions);
  if (scene != nullptr) read_base_scene(*scene, front, texts);
  for (const char* key : {"format", "id", "title"}) {
    if (table.find(key) == nullptr) {
      report.error({1, 1}, "the front matter lacks " + in_quotes(key));
    }
  }
}

}  // namespace

const std::vector<std::string>& color_roles() {
  static const std::vector<std::string> kRoles = {"omega", "L",       "N",      "polhode", "herpolhode",
                                                  "axes",  "axis-1",  "axis-2", "axis-3",  "violet",
                                                  "brown", "crimson", "black"};
  return kRoles;
}

FrontMatter read_front_matter(TextReader& texts, Meanings meanings) {
  Report& report = texts.report();
  const SourceText& source = texts.source();
  FrontMatter front;
  if (trimmed(source.line(1)) != kFence) {
    report.error({1, 1}, "a lesson starts with a line +++ and its front matter",
                 "write +++, then format = 1, id, title, then +++");
    front.bodies.complete = false;
    return front;
  }
  int last = 2;
  while (last <= source.line_count() && trimmed(source.line(last)) != kFence) ++last;
  if (last > source.line_count()) {
    report.error({1, 1}, "the front matter is never closed", "end it with a line +++");
    front.next_line = source.line_count() + 1;
    return front;
  }
  front.next_line = last + 1;
  if (const auto table = parse_toml(source.lines(2, last - 1), 2, report)) {
    read_front_table(*table, meanings, front, texts);
  } else {
    front.bodies.complete = false;
  }
  return front;
}

}  // namespace polhode

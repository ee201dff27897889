// SPDX-License-Identifier: MIT
#include "lessons/reader/ask_block.h"

#include "base/spelling.h"
#include "lessons/claims/expression_tex.h"
#include "lessons/claims/expression_variants.h"
#include "lessons/derivation/derivation.h"
#include "lessons/reader/keys.h"
#include "lessons/reader/state_keys.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace polhode {
namespace {

const std::vector<std::string> kTypeNames = {"expression", "choice", "predict", "order", "derive", "state"};
const std::vector<std::string> kModuloNames = {"identity", "motion", "free"};

class AskReader {
 public:
  AskReader(const TomlTable& table, std::string id, SourcePlace place, const FrontMatter& front,
            TextReader& texts)
      : table_(table), front_(front), texts_(texts), report_(texts.report()) {
    ask_.id = std::move(id);
    ask_.place = place;
  }

  std::optional<Ask> read() {
    read_keys(
        table_, "the question",
        {{"type", [this](const TomlEntry& e) { type(e); }},
         {"prompt", [this](const TomlEntry& e) { prompt(e); }},
         {"choices", [this](const TomlEntry& e) { texts(e, kMaxChoices, ask_.choices, ask_.choice_texts); }},
         {"answer", [](const TomlEntry&) {}},  // read last: it depends on the others
         {"modulo", [this](const TomlEntry& e) { modulo(e); }},
         {"given", [this](const TomlEntry& e) { given(e); }},
         {"hints", [this](const TomlEntry& e) { texts(e, kMaxHints, ask_.hints, ask_.hint_texts); }},
         {"start", [](const TomlEntry&) {}},
         {"goal", [](const TomlEntry&) {}},
         {"facts", [](const TomlEntry&) {}},
         {"worked", [](const TomlEntry&) {}},
         {"least", [](const TomlEntry&) {}},
         {"goals", [](const TomlEntry&) {}},
         {"change", [](const TomlEntry&) {}},
         {"solution", [](const TomlEntry&) {}}},
        report_);
    for (const char* key : {"type", "prompt"}) need(key);
    if (ask_.type == Ask::Type::derive) {
      for (const char* key : {"start", "goal", "worked"}) need(key);
      if (ok_) derivation();
    } else if (ask_.type == Ask::Type::state) {
      if (ok_) task();
    } else {
      need("answer");
    }
    if (ok_) check_together();
    if (ok_ && has_answer()) answer(*table_.find("answer"));
    if (ok_ && !ask_.given.empty()) say_what_is_given();
    return ok_ ? std::optional(std::move(ask_)) : std::nullopt;
  }

 private:
  void fail(SourcePlace place, std::string message, std::string hint = {}) {
    report_.error(place, std::move(message), std::move(hint));
    ok_ = false;
  }

  // Position of a string among the names, or nothing.
  std::optional<std::size_t> one_of(const TomlEntry& entry, const std::vector<std::string>& names) {
    const auto name = read_text(entry, report_);
    if (!name) {
      ok_ = false;
      return std::nullopt;
    }
    const auto found = std::find(names.begin(), names.end(), *name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    fail(entry.value.place, "unknown " + entry.key + ' ' + in_quotes(*name), suggestion(*name, names));
    return std::nullopt;
  }

  void type(const TomlEntry& entry) {
    if (const auto index = one_of(entry, kTypeNames)) ask_.type = static_cast<Ask::Type>(*index);
  }
  void modulo(const TomlEntry& entry) {
    if (const auto index = one_of(entry, kModuloNames)) ask_.modulo = kModuloNames[*index];
  }

  /// A line as it is typed; nothing, and a report, where it cannot be read.
  std::optional<DerivedLine> typed_line(const std::string& text, SourcePlace place,
                                        const DerivedLine* above) {
    auto line = read_line(text, notation(), above);
    if (line) return std::move(*line);
    const UnreadableLine& fault = line.error();
    fail(advanced(inside_quotes(place), text, SourceText(text).offset_of({1, fault.column})), fault.message,
         fault.hint);
    return std::nullopt;
  }

  const LineNotation& notation() {
    if (notation_.notation == nullptr)
      notation_ = line_notation(front_.notation, front_.symbols, texts_.macros());
    return notation_;
  }

  std::optional<DerivedLine> line_of(const char* key, const DerivedLine* above = nullptr) {
    const TomlEntry& entry = *table_.find(key);
    const auto text = read_text(entry, report_);
    if (!text) ok_ = false;
    return text ? typed_line(*text, entry.value.place, above) : std::nullopt;
  }

  /// { line, point, teach }
  void worked_line(const TomlValue& value, Derivation& derivation) {
    const auto* table = value.as<TomlTable>();
    if (table == nullptr || table->find("line") == nullptr)
      return fail(value.place, "a worked line is a table, found " + std::string(value.kind()),
                  "worked = [{ line = \"…\", point = \"…\", teach = \"…\" }]");
    WorkedLine worked;
    const auto text_into = [this](std::string& into) {
      return [this, &into](const TomlEntry& e) {
        if (auto text = read_text(e, report_)) {
          line(*text, e.value.place);  // what is wrong with it is said
          into = std::move(*text);
        }
      };
    };
    std::optional<DerivedLine> read;
    read_keys(*table, "a worked line",
              {{"line",
                [&](const TomlEntry& e) {
                  const DerivedLine& above =
                      derivation.worked.empty() ? derivation.start : derivation.worked.back().line;
                  if (const auto text = read_text(e, report_))
                    read = typed_line(*text, e.value.place, &above);
                }},
               {"point", text_into(worked.point)},
               {"teach", text_into(worked.teach)}},
              report_);
    ok_ = ok_ && read;
    if (read) {
      worked.line = std::move(*read);
      derivation.worked.push_back(std::move(worked));
    }
  }

  void derivation() {
    Derivation derivation;
    derivation.given = ask_.given;
    derivation.assumption = ask_.modulo == "free"     ? Assumption::free
                            : ask_.modulo == "motion" ? Assumption::motion
                                                      : Assumption::identity;
    auto start = line_of("start"), goal = line_of("goal");
    if (!start || !goal) return;
    derivation.start = std::move(*start);
    derivation.goal = std::move(*goal);
    if (const TomlEntry* facts = table_.find("facts")) {
      const auto list = read_texts(*facts, kMaxFacts, report_);
      ok_ = ok_ && list;
      for (const PlacedText& fact : list.value_or(std::vector<PlacedText>()))
        if (auto read = typed_line(fact.text, fact.place, nullptr))
          derivation.facts.push_back(std::move(*read));
    }
    const TomlEntry& worked = *table_.find("worked");
    const auto* lines = worked.value.as<TomlArray>();
    if (lines == nullptr || lines->empty() || lines->size() > kMaxWorkedLines)
      return fail(worked.value.place, "\"worked\" lists 1 to " + std::to_string(kMaxWorkedLines) + " lines");
    for (const TomlValue& line : *lines) worked_line(line, derivation);
    derivation.least_lines = static_cast<int>(std::min<std::size_t>(2, derivation.worked.size()));
    if (const TomlEntry* least = table_.find("least")) {
      const auto* number = least->value.as<std::int64_t>();
      if (number == nullptr || *number < 1 || *number > static_cast<std::int64_t>(derivation.worked.size()))
        return fail(least->value.place, "\"least\" lies between 1 and the number of worked lines");
      derivation.least_lines = static_cast<int>(*number);
    }
    if (!ok_) return;
    derivation.letters = letters_of(derivation);
    say_what_leads_where(derivation);
    ask_.derivation = std::make_shared<const Derivation>(std::move(derivation));
  }

  bool has_answer() const { return ask_.type != Ask::Type::derive && ask_.type != Ask::Type::state; }

  void task() {
    auto task = read_state_task(table_, ask_.place, texts_);
    ok_ = ok_ && task;
    if (!task) return;
    say_what_is_to_be_reached(*task, front_.notation.vocabulary, ask_.prompt_text);
    ask_.task = std::make_shared<const StateTask>(std::move(*task));
  }

  /// Behind what is asked: "From: … Goal: … You may use: …".
  void say_what_leads_where(const Derivation& derivation) {
    const auto add = [&](const std::string& words, const std::vector<const DerivedLine*>& lines) {
      TextBlock block;
      TextSpan& text = block.spans.emplace_back();
      text.text = words;
      for (const DerivedLine* line : lines) {
        if (line != lines.front()) block.spans.emplace_back().text = ", ";
        auto math = parse_math(line->tex, texts_.macros());
        TextSpan& span = block.spans.emplace_back();
        span.kind = TextSpan::Kind::math;
        if (math) span.math = std::move(*math);
        span.text = line->tex;
      }
      ask_.prompt_text.push_back(std::move(block));
    };
    add("From: ", {&derivation.start});
    add("To: ", {&derivation.goal});
    std::vector<const DerivedLine*> facts;
    for (const DerivedLine& fact : derivation.facts) facts.push_back(&fact);
    if (!facts.empty()) add("You may use ", facts);
  }

  // The name of an assumption, or a list of some.
  void given(const TomlEntry& entry) {
    const auto names = read_texts(entry, kMaxGiven, report_);
    auto given = names ? given_by(*names, front_.assumptions, report_) : std::nullopt;
    ok_ = ok_ && given;
    if (given) ask_.given = std::move(*given);
  }

  void prompt(const TomlEntry& entry) {
    auto text = read_text(entry, report_);
    ok_ = ok_ && text;
    if (!text) return;
    if (is_blank(*text)) fail(entry.value.place, "a prompt says what is asked");
    ask_.prompt_text = line(*text, entry.value.place);
    ask_.prompt = std::move(*text);
  }

  RichText line(const std::string& text, SourcePlace place) {
    return texts_.line(located_string(texts_.source(), place, text));
  }

  void texts(const TomlEntry& entry, std::size_t max_count, std::vector<std::string>& into,
             std::vector<RichText>& rich) {
    const auto list = read_texts(entry, max_count, report_);
    ok_ = ok_ && list;
    if (!list) return;
    for (const PlacedText& text : *list) {
      rich.push_back(line(text.text, text.place));
      into.push_back(text.text);
    }
  }

  void need(const char* key) {
    if (table_.find(key) == nullptr) fail(ask_.place, "a question lacks " + in_quotes(key));
  }

  void check_given() {
    const TomlEntry* given = table_.find("given");
    if (given != nullptr && !ask_.given.small.empty())
      fail(given->place, "an answer is right or wrong to all orders: it is given nothing that is small");
    if (given != nullptr && ask_.modulo == "free" && ask_.given.sets_torque())
      fail(given->place, "this gives a torque, and modulo = \"free\" says that there is none");
  }

  void check_together() {
    const bool derives = ask_.type == Ask::Type::derive;
    for (const char* key : {"start", "goal", "facts", "worked", "least"})
      if (const TomlEntry* entry = table_.find(key); entry != nullptr && !derives)
        fail(entry->place, in_quotes(key) + " is of questions of type \"derive\"");
    for (const char* key : {"answer", "hints", "choices"})
      if (const TomlEntry* entry = table_.find(key); entry != nullptr && derives)
        fail(entry->place, in_quotes(key) + " is not of questions of type \"derive\"",
             "what leads to the goal stands in \"worked\"");
    const bool steers = ask_.type == Ask::Type::state;
    for (const char* key : kKeysOfStates)
      if (const TomlEntry* entry = table_.find(key); entry != nullptr && !steers)
        fail(entry->place, in_quotes(key) + " is of questions of type \"state\"");
    for (const char* key : {"answer", "choices", "modulo", "given"})
      if (const TomlEntry* entry = table_.find(key); entry != nullptr && steers)
        fail(entry->place, in_quotes(key) + " is not of questions of type \"state\"",
             "what is to be reached stands in \"goals\"");
    const bool expression = ask_.type == Ask::Type::expression;
    const TomlEntry* choices = table_.find("choices");
    const TomlEntry* modulo = table_.find("modulo");
    check_given();
    if (derives || steers) return;
    if (expression && choices != nullptr) fail(choices->place, "a question for an expression has no choices");
    if (!expression && ask_.choices.size() < 2) {
      fail(choices == nullptr ? ask_.place : choices->value.place,
           "a question of type " + in_quotes(kTypeNames[static_cast<std::size_t>(ask_.type)]) +
               " needs at least two choices");
    }
    if (!expression && modulo != nullptr) fail(modulo->place, "\"modulo\" is of questions for an expression");
    const TomlEntry* given = table_.find("given");
    if (!expression && given != nullptr) fail(given->place, "\"given\" is of questions for an expression");
    if (expression && modulo == nullptr) ask_.modulo = "identity";
  }

  /// Behind what is asked: "Given: $I_2 = I_1$."
  void say_what_is_given() {
    TextBlock block;
    const auto add = [&](TextSpan::Kind kind, std::string text) {
      TextSpan& span = block.spans.emplace_back();
      span.kind = kind;
      if (kind == TextSpan::Kind::math) span.math = parse_math(text).value();
      span.text = std::move(text);
    };
    for (const std::string& condition : printed_conditions(ask_.given)) {
      add(TextSpan::Kind::text, block.spans.empty() ? "Given: " : ", ");
      add(TextSpan::Kind::math, condition);
    }
    add(TextSpan::Kind::text, ".");
    ask_.prompt_text.push_back(std::move(block));
  }

  void answer(const TomlEntry& entry) {
    if (ask_.type == Ask::Type::expression) {
      const auto text = read_text(entry, report_);
      if (text)
        ask_.expression =
            read_expression(*text, inside_quotes(entry.value.place), report_, &front_.notation.vocabulary);
      ok_ = ask_.expression.has_value();
      if (ok_ && ask_.expression->uses(Operation::norm))
        fail(entry.value.place, "a length is a root, and answers are proved: norm cannot be in them",
             "ask for its square, norm2(a)");
      else if (ok_ && !is_rational(*ask_.expression))
        fail(entry.value.place, "answers are proved, and " + std::string(kNoAngles));
      else if (ok_ && ask_.given.sets_spin() &&
               std::any_of(ask_.expression->nodes.begin(), ask_.expression->nodes.end(), is_rate))
        fail(entry.value.place, "what is given of ω holds at an instant, and says nothing of rates");
    } else if (ask_.type == Ask::Type::order) {
      order(entry);
    } else {
      index(entry.value);
    }
  }

  // A 1-based index of a choice.
  bool index(const TomlValue& value) {
    const auto* number = value.as<std::int64_t>();
    const auto count = static_cast<std::int64_t>(ask_.choices.size());
    if (number == nullptr || *number < 1 || *number > count) {
      fail(value.place, "the answer is the number of a choice, 1 to " + std::to_string(count));
      return false;
    }
    ask_.answers.push_back(static_cast<int>(*number));
    return true;
  }

  void order(const TomlEntry& entry) {
    const auto* list = entry.value.as<TomlArray>();
    if (list == nullptr || list->size() != ask_.choices.size()) {
      fail(entry.value.place, "the answer lists the numbers of all " + std::to_string(ask_.choices.size()) +
                                  " choices in their order");
      return;
    }
    std::set<int> seen;
    for (const TomlValue& value : *list) {
      if (!index(value)) return;
      if (!seen.insert(ask_.answers.back()).second)
        fail(value.place, "choice " + std::to_string(ask_.answers.back()) + " twice");
    }
  }

  const TomlTable& table_;
  const FrontMatter& front_;
  TextReader& texts_;
  Report& report_;
  LineNotation notation_;
  Ask ask_;
  bool ok_ = true;
};

}  // namespace

LineNotation line_notation(const EquationNotation& notation, const std::map<std::string, Symbol>& symbols,
                           const MathMacros& macros) {
  LineNotation how{&notation, {}, macros};
  for (const auto& [name, symbol] : symbols) how.names.emplace(name, symbol.tex);
  return how;
}

LineNotation line_notation(const Lesson& lesson) {
  return line_notation(lesson.notation, lesson.symbols, lesson.macros);
}

std::optional<Ask> read_ask(const TomlTable& table, std::string id, SourcePlace place,
                            const FrontMatter& front, TextReader& texts) {
  return AskReader(table, std::move(id), place, front, texts).read();
}

}  // namespace polhode

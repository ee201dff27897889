// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/ask_block.h"

#include "base/spelling.h"
#include "base/words/page_words.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/claims/expressions/expression_variants.h"
#include "lessons/derivation/derivation.h"
#include "lessons/derivation/restatement.h"
#include "lessons/reader/front_matter/keys.h"
#include "lessons/reader/questions/asked_formulas.h"
#include "lessons/reader/questions/line_notation.h"
#include "lessons/reader/questions/number_question.h"
#include "lessons/reader/questions/outcome_key.h"
#include "lessons/reader/questions/state_keys.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace polhode {
namespace {

const std::vector<std::string> kTypeNames = {"expression", "choice", "predict", "order",
                                             "number",     "derive", "state"};
const std::vector<std::string> kModuloNames = {"identity", "motion", "free"};

class AskReader {
 public:
  AskReader(const TomlTable& table, std::string id, SourcePlace place, const FrontMatter& front,
            TextReader& texts, const ChoiceList* list, std::string_view stage_id)
      : table_(table),
        list_(list),
        stage_id_(stage_id),
        front_(front),
        texts_(texts),
        report_(texts.report()) {
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
         {"letters", [](const TomlEntry&) {}},
         {"because", [this](const TomlEntry& e) { because(e); }},
         {"shuffle", [this](const TomlEntry& e) { shuffle_ = read_flag(e, report_); }},
         {"plays", [this](const TomlEntry& e) { plays(e); }},
         {"unit", [](const TomlEntry&) {}},
         {"within", [](const TomlEntry&) {}},
         {"hints", [this](const TomlEntry& e) { texts(e, kMaxHints, ask_.hints, ask_.hint_texts); }},
         {"outcome", [this](const TomlEntry& e) { outcomes(e); }},
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
    } else if (list_ == nullptr) {
      need("answer");
    }
    if (list_ != nullptr && ok_) take_list();
    if (ok_) check_together();
    if (ok_ && has_answer() && list_ == nullptr) answer(*table_.find("answer"));
    if (ok_ && ask_.expression) letters();
    if (ok_ && ask_.expression) ask_.asked = asked_formulas(ask_.prompt_text, notation());
    if (ok_ && has_choices(ask_.type)) shuffle();
    if (ok_ && ask_.number) add_to_prompt(words_of_what_is_asked(*ask_.number));
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

  void outcomes(const TomlEntry& entry) {
    auto numbers = read_outcomes(entry, front_.about.about.outcomes.size(), report_);
    ok_ = ok_ && numbers;
    ask_.outcomes = std::move(numbers).value_or(std::vector<int>());
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
    derivation.laws = ask_.modulo == "free"     ? LawsAssumed::free
                      : ask_.modulo == "motion" ? LawsAssumed::motion
                                                : LawsAssumed::identity;
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
    say_what_is_to_be_reached(*task, front_.notation.vocabulary, texts_.written_in(), ask_.prompt_text);
    ask_.task = std::make_shared<const StateTask>(std::move(*task));
  }

  /// Behind what is asked, a line each, one below the other: "From …", "to …", "by …".
  void say_what_leads_where(const Derivation& derivation) {
    const auto add = [&](const char* word, const DerivedLine& line) {
      TextBlock block{.indent = 1, .marker = word, .spans = {}};
      TextSpan& span = block.spans.emplace_back();
      span.kind = TextSpan::Kind::math;
      if (auto math = parse_math("\\displaystyle " + line.tex, texts_.macros(), texts_.written_in()))
        span.math = std::move(*math);
      span.text = line.tex;
      ask_.prompt_text.push_back(std::move(block));
    };
    add("From", derivation.start);
    add("to", derivation.goal);
    for (const DerivedLine& fact : derivation.facts)
      add(&fact == &derivation.facts.front() ? "by" : "", fact);
  }

  // The name of an assumption, or a list of some.
  void given(const TomlEntry& entry) {
    const auto names = read_texts(entry, kMaxGiven, report_);
    auto given = names ? given_by(*names, front_.assumptions, report_) : std::nullopt;
    ok_ = ok_ && given;
    if (given) ask_.given = std::move(*given);
  }

  /// What an answer may be written with, as the lesson's own is.
  void letters() {
    const TomlEntry* entry = table_.find("letters");
    if (entry == nullptr) return;
    const auto list = read_texts(*entry, kMaxLetters, report_);
    ok_ = ok_ && list;
    if (!list) return;
    std::vector<std::string> known = quantity_letters();
    if (const auto& constants = front_.notation.vocabulary.constants())
      known.insert(known.end(), constants->begin(), constants->end());
    for (const PlacedText& letter : *list) {
      const std::string& name = letter.text;
      const std::string plain = name.ends_with('\'') ? name.substr(0, name.size() - 1) : name;
      if (std::find(known.begin(), known.end(), plain) == known.end())
        fail(letter.place, "unknown letter " + in_quotes(name),
             "one of " + joined(known) + ", without an index; with ' behind it for its rate");
      ask_.letters.push_back(name);
    }
    for (const std::string& used : letters_used(*ask_.expression))
      if (ok_ && std::find(ask_.letters.begin(), ask_.letters.end(), used) == ask_.letters.end())
        fail(entry->place,
             "the answer itself has " +
                 (used == kRateOfMore ? "a rate of more than one letter" : in_quotes(used)) +
                 ", which is not among the letters",
             "add it, or write the answer without it");
  }

  static std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
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

  void because(const TomlEntry& entry) {
    const auto text = read_text(entry, report_);
    ok_ = ok_ && text;
    if (text) ask_.because = texts_.note(located_string(texts_.source(), entry.value.place, *text));
  }

  void plays(const TomlEntry& entry) {
    const auto times = read_numbers(entry, 2, report_);
    ok_ = ok_ && times;
    if (!times) return;
    ask_.plays = {times->front(), times->back()};
    if (!(ask_.plays->to_s > ask_.plays->from_s))
      fail(entry.value.place, "this plays nothing: it ends before it begins", "plays = [from, to], in s");
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

  /// The choices of the list, in the order in which they are written.
  void take_list() {
    const std::string type = in_quotes(kTypeNames[static_cast<std::size_t>(ask_.type)]);
    if (!has_choices(ask_.type))
      return fail(list_->place, "a question of type " + type + " has no list of choices");
    for (const char* key : {"answer", "choices"})
      if (const TomlEntry* entry = table_.find(key))
        fail(entry->place, in_quotes(key) + " and a list of choices: the list says both",
             "leave out " + in_quotes(key));
    if (list_->is_numbered != (ask_.type == Ask::Type::order))
      return fail(
          list_->place,
          "a question of type " + type + " takes a list with " + (list_->is_numbered ? "boxes" : "numbers"),
          list_->is_numbered ? "- [x] the right one, - [ ] the others" : "1. 2. 3. as the right order is");
    if (list_->items.size() > kMaxChoices)
      return fail(list_->items[kMaxChoices].place,
                  "a question has at most " + std::to_string(kMaxChoices) + " choices");
    ask_.is_listed = true;
    for (const ChoiceList::Item& item : list_->items) take_item(item);
    if (ask_.type != Ask::Type::order && ask_.answers.empty())
      fail(list_->place, "none of the choices is marked as right", "write - [x] before it");
  }

  void take_item(const ChoiceList::Item& item) {
    ask_.choices.push_back(item.text.text());
    ask_.choice_texts.push_back(texts_.line(item.text));
    ask_.replies.push_back(item.reply.text().empty() ? RichText() : texts_.note(item.reply));
    const auto number = static_cast<int>(ask_.choices.size());
    const bool orders = ask_.type == Ask::Type::order;
    if (orders && !item.reply.text().empty())
      fail(item.place, "no part of an order has a reply: no one of them is picked",
           "say in \"because\" why the order is right");
    if (item.is_right && !ask_.answers.empty())
      return fail(item.place, "two choices are marked as right", "write - [ ] before the wrong one");
    if (orders || item.is_right) ask_.answers.push_back(number);
  }

  /// Changes the order in which choices are shown, and their numbers in the answer with it.
  void shuffle() {
    ask_.replies.resize(ask_.choices.size());
    const bool orders = ask_.type == Ask::Type::order;
    if (!shuffle_.value_or(ask_.is_listed)) return;
    std::vector<std::size_t> shown = shuffled_order(front_.id, stage_id_, ask_.id, ask_.choices.size());
    if (orders && std::is_sorted(shown.begin(), shown.end()))  // that would give the answer away
      std::rotate(shown.begin(), shown.begin() + 1, shown.end());
    const auto take_in_order = [&](auto& all) {
      std::remove_reference_t<decltype(all)> old = std::move(all);
      all.clear();
      for (const std::size_t from : shown) all.push_back(std::move(old[from]));
    };
    take_in_order(ask_.choices);
    take_in_order(ask_.choice_texts);
    take_in_order(ask_.replies);
    for (int& answer : ask_.answers)
      answer =
          1 + static_cast<int>(std::find(shown.begin(), shown.end(), static_cast<std::size_t>(answer - 1)) -
                               shown.begin());
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
    for (const char* key : {"answer", "choices", "modulo", "given", "letters"})
      if (const TomlEntry* entry = table_.find(key); entry != nullptr && steers)
        fail(entry->place, in_quotes(key) + " is not of questions of type \"state\"",
             "what is to be reached stands in \"goals\"");
    const auto is_only_of = [&](const char* key, bool is_so, const char* of) {
      if (const TomlEntry* entry = table_.find(key); entry != nullptr && !is_so)
        fail(entry->place, in_quotes(key) + " is of questions " + of);
    };
    const bool is_number = ask_.type == Ask::Type::number;
    is_only_of("unit", is_number, "of type \"number\"");
    is_only_of("within", is_number, "of type \"number\"");
    is_only_of("plays", ask_.type == Ask::Type::predict, "of type \"predict\"");
    is_only_of("shuffle", picks_choice(ask_.type),
               ask_.type == Ask::Type::order ? "for one choice: an order in a list is always shuffled"
                                             : "for a choice");
    is_only_of("because", !derives, "of other types than \"derive\"");
    const bool expression = ask_.type == Ask::Type::expression, chooses = has_choices(ask_.type);
    const TomlEntry* choices = table_.find("choices");
    const TomlEntry* modulo = table_.find("modulo");
    check_given();
    if (derives || steers) return;
    if (!chooses && choices != nullptr)
      fail(choices->place,
           std::string("a question for ") + (is_number ? "a number" : "an expression") + " has no choices");
    if (chooses && ask_.choices.size() < 2) {
      fail(list_ != nullptr     ? list_->place
           : choices == nullptr ? ask_.place
                                : choices->value.place,
           "a question of type " + in_quotes(kTypeNames[static_cast<std::size_t>(ask_.type)]) +
               " needs at least two choices");
    }
    if (!expression && modulo != nullptr) fail(modulo->place, "\"modulo\" is of questions for an expression");
    const TomlEntry* given = table_.find("given");
    if (!expression && given != nullptr) fail(given->place, "\"given\" is of questions for an expression");
    if (const TomlEntry* letters = table_.find("letters"); !expression && letters != nullptr)
      fail(letters->place, "\"letters\" is of questions for an expression");
    if (expression && modulo == nullptr) ask_.modulo = "identity";
  }

  /// Behind what is asked, in a line of its own.
  void add_to_prompt(std::string words) {
    TextBlock block;
    block.spans.emplace_back().text = std::move(words);
    ask_.prompt_text.push_back(std::move(block));
  }

  /// Behind what is asked: "Given: $I_2 = I_1$."
  void say_what_is_given() {
    TextBlock block;
    const auto add = [&](TextSpan::Kind kind, std::string text) {
      TextSpan& span = block.spans.emplace_back();
      span.kind = kind;
      if (kind == TextSpan::Kind::math) span.math = parse_math(text, {}, texts_.written_in()).value();
      span.text = std::move(text);
    };
    for (const std::string& condition : printed_conditions(ask_.given)) {
      add(TextSpan::Kind::text,
          block.spans.empty() ? std::string(words::kGivenOpening.in(texts_.written_in())) : ", ");
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
    } else if (ask_.type == Ask::Type::number) {
      auto number = read_number_answer(table_, texts_);
      ok_ = ok_ && number;
      if (number) ask_.number = std::make_shared<const NumberAnswer>(std::move(*number));
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
  const ChoiceList* list_;  ///< null: there is none
  std::string_view stage_id_;
  const FrontMatter& front_;
  TextReader& texts_;
  Report& report_;
  LineNotation notation_;
  Ask ask_;
  std::optional<bool> shuffle_;
  bool ok_ = true;
};

}  // namespace

std::optional<Ask> read_ask(const TomlTable& table, std::string id, SourcePlace place,
                            const FrontMatter& front, TextReader& texts, const ChoiceList* list,
                            std::string_view stage_id) {
  return AskReader(table, std::move(id), place, front, texts, list, stage_id).read();
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "lessons/reader/questions/state_keys.h"

#include "base/spelling.h"
#include "base/words/page_words.h"
#include "lessons/claims/expressions/expression_tex.h"
#include "lessons/reader/scene/quantity_key.h"
#include "lessons/reader/scene/varied_scene.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace polhode {
namespace {

constexpr const char* kGoalForm =
    "for example { of = \"norm(omega)\", say = \"rate of turning\", is = 3, within = 0.1, unit = \"rad/s\" }";

class StateTaskReader {
 public:
  explicit StateTaskReader(TextReader& texts) : texts_(texts), report_(texts.report()) {}

  std::optional<StateTask> read(const TomlTable& table, SourcePlace place) {
    for (const char* key : kKeysOfStates)
      if (table.find(key) == nullptr) fail(place, "a question of type \"state\" lacks " + in_quotes(key));
    if (!ok_) return std::nullopt;
    goals(*table.find("goals"));
    change(*table.find("change"));
    solution(*table.find("solution"));
    return ok_ ? std::optional(std::move(task_)) : std::nullopt;
  }

 private:
  void fail(SourcePlace place, std::string message, std::string hint = {}) {
    report_.error(place, std::move(message), std::move(hint));
    ok_ = false;
  }

  void goals(const TomlEntry& entry) {
    const auto* list = entry.value.as<TomlArray>();
    if (list == nullptr || list->empty() || list->size() > kMaxGoals)
      return fail(entry.value.place, "\"goals\" lists 1 to " + std::to_string(kMaxGoals) + " tables",
                  kGoalForm);
    for (const TomlValue& value : *list) {
      if (const auto* table = value.as<TomlTable>())
        goal(*table, value.place);
      else
        fail(value.place, "a goal is a table, found " + std::string(value.kind()), kGoalForm);
    }
  }

  struct Numbers {
    std::optional<double> is, within, least, most;
  };

  void goal(const TomlTable& table, SourcePlace place) {
    StateGoal goal;
    std::optional<PlacedText> of;
    Numbers numbers;
    LiveNumber written;
    SourcePlace unit_place = place;
    const auto number_into = [this](std::optional<double>& into) {
      return [this, &into](const TomlEntry& e) {
        into = read_number(e, report_);
        ok_ = ok_ && into;
      };
    };
    read_keys(table, "a goal",
              {{"of", [&](const TomlEntry& e) { of = line(e); }},
               {"say",
                [&](const TomlEntry& e) {
                  if (auto text = line(e)) goal.say = std::move(text->text);
                }},
               {"unit",
                [&](const TomlEntry& e) {
                  written.unit = read_text(e, report_).value_or("");
                  unit_place = e.value.place;
                }},
               {"is", number_into(numbers.is)},
               {"within", number_into(numbers.within)},
               {"at_least", number_into(numbers.least)},
               {"at_most", number_into(numbers.most)}},
              report_);
    if (table.find("of") == nullptr)
      return fail(place, "a goal says which number of the motion it is \"of\"", kGoalForm);
    range(table, numbers, goal);
    if (!of || !ok_) return;
    written.expression = of->text;
    const SourcePlace at =
        texts_.source().place_of(located_string(texts_.source(), of->place, of->text).offset_of(0));
    auto number = texts_.computed_number(written, at, unit_place);
    ok_ = ok_ && number && has_value_on_motions(number->expression, at, report_);
    if (!ok_) return;
    goal.number = std::move(*number);
    task_.goals.push_back(std::move(goal));
  }

  /// "is" with "within", or one or both ends.
  void range(const TomlTable& table, const Numbers& numbers, StateGoal& goal) {
    const bool has_middle = table.find("is") != nullptr;
    const bool has_end = table.find("at_least") != nullptr || table.find("at_most") != nullptr;
    const SourcePlace place = table.entries.front().place;
    if (has_middle == has_end)
      return fail(place, "a goal has \"is\" and \"within\", or \"at_least\" or \"at_most\"", kGoalForm);
    if (has_middle != (table.find("within") != nullptr))
      return fail(place, "\"is\" and \"within\" go together: no number that is set by hand is exact",
                  kGoalForm);
    if (!ok_) return;
    if (has_middle) {
      if (!(*numbers.within > 0)) return fail(table.find("within")->value.place, "\"within\" is positive");
      goal.is = numbers.is;
      goal.least = *numbers.is - *numbers.within;
      goal.most = *numbers.is + *numbers.within;
      return;
    }
    goal.least = numbers.least;
    goal.most = numbers.most;
    if (goal.least && goal.most && !(*goal.least < *goal.most))
      fail(table.find("at_most")->value.place, "\"at_most\" is larger than \"at_least\"");
  }

  std::optional<PlacedText> line(const TomlEntry& entry) {
    auto text = read_text(entry, report_);
    if (text && is_plain_line(*text) && !is_blank(*text)) return PlacedText{*text, entry.value.place};
    if (text) report_.error(entry.value.place, in_quotes(entry.key) + " is one line of plain text");
    ok_ = false;
    return std::nullopt;
  }

  void change(const TomlEntry& entry) {
    const auto names = read_texts(entry, kSteered.size(), report_);
    ok_ = ok_ && names;
    std::vector<std::string> known;
    for (const SteeredFacts& facts : kSteered) known.emplace_back(facts.name);
    for (const PlacedText& name : names.value_or(std::vector<PlacedText>())) {
      const auto found = std::find(known.begin(), known.end(), name.text);
      if (found != known.end())
        task_.change.insert(static_cast<Steered>(found - known.begin()));
      else
        fail(name.place, "unknown part of a motion " + in_quotes(name.text), suggestion(name.text, known));
    }
    if (ok_ && task_.change.empty())
      fail(entry.value.place, "something has to be changed to reach a goal", "write change = [\"omega\"]");
  }

  void solution(const TomlEntry& entry) {
    const auto* table = entry.value.as<TomlTable>();
    if (table == nullptr)
      return fail(entry.value.place, "\"solution\" is a table, found " + std::string(entry.value.kind()),
                  "write solution = { omega = [0.1, 3, 0.1] }");
    auto state = read_steered_state(*table, "the solution", report_);
    ok_ = ok_ && state;
    if (state) task_.solution = std::move(*state);
  }

  TextReader& texts_;
  Report& report_;
  StateTask task_;
  bool ok_ = true;
};

TextSpan words_span(std::string text) {
  TextSpan span;
  span.text = std::move(text);
  return span;
}

TextSpan formula(const std::string& tex) {
  TextSpan span;
  span.kind = TextSpan::Kind::math;
  if (auto math = parse_math(tex)) span.math = std::move(*math);
  span.text = tex;
  return span;
}

const char* tex_of(Steered part) {
  switch (part) {
    case Steered::omega:
      return "\\vec\\omega";
    case Steered::t:
      return "t";
    default:
      return nullptr;
  }
}

/// Why what a question asks to change is not there to be changed; empty: it is.
std::string why_not_there(const StateTask& task, const Scene& scene) {
  const auto is_heavy = [](const TorqueTerm& term) { return std::holds_alternative<HeavyTop>(term); };
  if (task.change.contains(Steered::moments) &&
      std::any_of(scene.torque.begin(), scene.torque.end(), is_heavy))
    return "the moments of a body that is held follow from where it is held";
  const bool has_attitude = scene.attitude && std::holds_alternative<Quat>(*scene.attitude);
  if (task.change.contains(Steered::omega) && has_attitude && !task.change.contains(Steered::attitude))
    return "a hand that takes ω in this scene lets the body start from where it is then: "
           "\"attitude\" has to be in \"change\" too";
  return "";
}

}  // namespace

std::optional<StateTask> read_state_task(const TomlTable& table, SourcePlace place, TextReader& texts) {
  return StateTaskReader(texts).read(table, place);
}

void say_what_is_to_be_reached(const StateTask& task, const Vocabulary& vocabulary, Language language,
                               RichText& prompt) {
  TextBlock goals;
  for (const StateGoal& goal : task.goals) {
    goals.spans.push_back(words_span(goals.spans.empty() ? std::string(words::kGoal.in(language)) : "; "));
    if (goal.say.empty())
      goals.spans.push_back(formula(tex_of(goal.number.expression, &vocabulary)));
    else
      goals.spans.push_back(words_span(goal.say));
    goals.spans.push_back(words_span((goal.is ? " = " : " ") + range_of(goal, language)));
  }
  if (!task.change.contains(Steered::t))
    goals.spans.push_back(words_span(std::string(words::kAsTheMotionBegins.in(language))));
  goals.spans.push_back(words_span("."));
  prompt.push_back(std::move(goals));
  TextBlock change;
  for (std::size_t i = 0; i < kSteered.size(); ++i) {
    const auto part = static_cast<Steered>(i);
    if (!task.change.contains(part)) continue;
    change.spans.push_back(
        words_span(change.spans.empty() ? std::string(words::kYouMayChange.in(language)) : ", "));
    if (const char* tex = tex_of(part))
      change.spans.push_back(formula(tex));
    else
      change.spans.push_back(words_span(std::string(facts_of(part).words.in(language))));
  }
  change.spans.push_back(words_span("."));
  prompt.push_back(std::move(change));
}

RichText without_goals(const Ask& ask) {
  constexpr std::ptrdiff_t kSaidBehind = 2;  // what is to be reached, and what may be changed
  RichText asked = ask.prompt_text;
  if (ask.task) asked.erase(asked.end() - kSaidBehind, asked.end());
  return asked;
}

void place_state_questions(Step& step, Report& report) {
  for (Block& block : step.blocks) {
    auto* ask = std::get_if<Ask>(&block);
    if (ask == nullptr || ask->task == nullptr) continue;
    if (step.scene == nullptr) {
      report.error(ask->place, "a question of type \"state\" needs a scene, which its readers change",
                   "add a ```scene fence to this step or above it");
      continue;
    }
    StateTask task = *ask->task;
    Scene scene = step.varied ? step.varied->alone() : *step.scene;
    scene.beside.clear();
    scene.before = 0;
    task.scene = std::make_shared<const Scene>(std::move(scene));
    if (const std::string why = why_not_there(task, *task.scene); !why.empty())
      report.error(ask->place, "question " + in_quotes(ask->id) + ": " + why);
    ask->task = std::make_shared<const StateTask>(std::move(task));
  }
}

void check_state_task(const Ask& ask, Report& report, const Effort& effort) {
  using Mark = AnswerJudgement::Mark;
  const StateTask& task = *ask.task;
  const AnswerJudgement solved = judge_state(task, task.solution, effort);
  if (solved.mark == Mark::unreadable)
    return report.error(ask.place,
                        "the solution of question " + in_quotes(ask.id) + " cannot be: " + solved.reason,
                        solved.hint);
  if (solved.mark == Mark::wrong)
    report.error(ask.place, "the solution of question " + in_quotes(ask.id) +
                                " does not reach its goal: " + solved.reason);
  if (judge_state(task, SteeredState(), effort).mark == Mark::right)
    report.error(ask.place,
                 "the scene of question " + in_quotes(ask.id) + " is at the goal before anything is changed",
                 "begin farther from the goal");
}

}  // namespace polhode

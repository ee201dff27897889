// SPDX-License-Identifier: MIT
// polhode derive: a derivation, line by line from standard input, and what is to be said of each.
#include "app/cli/commands/commands.h"
#include "app/cli/kept_answers.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/narration/speech_text.h"
#include "app/narration/transcript.h"
#include "app/session/answers/derivation_work.h"
#include "base/printable.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace polhode {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string lesson, stage, ask, hint;
  bool json = false;
};

std::string readable(const std::string& text) { return printable_line(text); }

void print_line(std::size_t number, const std::string& typed, const LineJudgement& judgement) {
  fmt::print("{:3}  {:<10}  {}\n", number, name_of(judgement.mark), readable(typed));
  if (!judgement.reason.empty())
    fmt::print("     {}{}\n", readable(judgement.reason),
               judgement.hint.empty() ? "" : " (" + readable(judgement.hint) + ')');
  if (const auto& counter = judgement.counterexample)
    fmt::print("     At {} the left side is {}, the right side {}.\n", counter->state, counter->left,
               counter->right);
}

Json json_of(const std::string& typed, const LineJudgement& judgement) {
  Json json = {{"line", typed},
               {"verdict", name_of(judgement.mark)},
               {"slip", name_of(judgement.slip)},
               {"reason", judgement.reason},
               {"hint", judgement.hint},
               {"column", judgement.column > 0 ? Json(judgement.column) : Json(nullptr)},
               {"tex", judgement.tex},
               {"counterexample", nullptr}};
  if (const auto& counter = judgement.counterexample)
    json["counterexample"] = {{"state", counter->state}, {"left", counter->left}, {"right", counter->right}};
  return json;
}

int hint_level(const std::string& level) {
  if (level.empty()) return 0;
  if (level.size() == 1 && level[0] >= '1' && level[0] <= '3') return level[0] - '0';
  throw CommandError(ExitCode::usage, "--hint is 1, what to use, 2, how, or 3, the line itself");
}

void print_end(const DerivationWork& work, const std::string& hint) {
  if (work.is_done())
    fmt::print("The goal is reached, in {} {}.\n", work.count(), work.count() == 1 ? "line" : "lines");
  else if (work.is_too_short())
    fmt::print("That is the goal itself. Show how you get there: at least {} lines, this one included.\n",
               work.derivation().least_lines);
  else
    fmt::print("Not there yet. The goal: {}\n", readable(work.derivation().goal.typed));
  if (!hint.empty()) fmt::print("Hint: {}\n", readable(hint));
}

ExitCode derive(const Options& options) {
  const int level = hint_level(options.hint);
  const LoadedLesson loaded = or_fail(load_lesson(options.lesson));
  const Stage& stage = stage_of(loaded.lesson, options.stage);
  const Ask& ask = ask_of(stage, options.ask);
  if (!ask.derivation)
    throw CommandError(
        ExitCode::usage,
        fmt::format("question \"{}\" asks for no derivation: polhode answer judges it", ask.id));
  DerivationWork work(loaded.lesson, ask);
  Json lines = Json::array();
  std::vector<std::string_view> slips;
  std::size_t number = 0;
  for (std::string typed; !work.is_done() && std::getline(std::cin, typed);) {
    if (typed.find_first_not_of(" \t\r") == typed.npos) continue;
    if (++number > kMostDerivedLines)
      throw CommandError(ExitCode::usage,
                         fmt::format("a derivation has at most {} lines", kMostDerivedLines));
    if (typed.back() == '\r') typed.pop_back();
    const LineJudgement& judgement = work.add(typed);
    if (judgement.mark == LineJudgement::Mark::wrong) slips.push_back(name_of(judgement.slip));
    if (options.json)
      lines.push_back(json_of(typed, judgement));
    else
      print_line(number, typed, judgement);
  }
  const std::string hint = level > 0 ? SpeechText(loaded.lesson).words_of_line(work.hint(level)) : "";
  if (options.json) {
    const Json json = {{"lines", lines}, {"goal_reached", work.is_done()}, {"hint", hint}};
    fmt::print("{}\n", printable(json.dump(2, ' ', false, Json::error_handler_t::replace)));
  } else {
    print_end(work, hint);
  }
  std::fflush(stdout);
  if (number > 0)
    KeptAnswers(loaded.lesson.id, answer_name(stage.id, ask.id))
        .change_if_possible(
            [&](AnswerLog& log, const std::string& name) {
              note_try(log[name], work.is_done(), work.text());
              for (const std::string_view slip : slips) note_reason(log[name], slip);
            },
            "the derivation is not kept");
  return work.is_done() ? ExitCode::done : ExitCode::different;
}

}  // namespace

ProgramCommand derive_command() {
  const auto options = std::make_shared<Options>();
  return {"derive",
          "Judge a derivation, line by line from standard input",
          {{"LESSON", &options->lesson, "Lesson file or id", "", true, offer_lessons()},
           {"STAGE", &options->stage, "Id of the stage", "", true},
           {"ASK", &options->ask, "Id of the question, which is of the type derive", "", true},
           {"--hint", &options->hint, "What to do next: 1 what to use, 2 how, 3 the line itself", "1|2|3",
            false, offer({"1", "2", "3"})},
           {"--json", &options->json, "Each line's verdict, slip, reason and TeX as JSON"}},
          wrapped("A line is one equation, such as \"dL/dt = d*L/dt + omega x L\". What is typed: " +
                      std::string(kWordsOfDerivations) + ".",
                  "") +
              "A line holds, is the goal, leads away (true, but no step) or is wrong; --hint 3 is the next\n"
              "line. Exit code 0 if the goal is reached, 4 if not yet, 2 if there is no such question.",
          [options](const CommandWords&) { return derive(*options); },
          true};
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
// polhode answer: the verdict on a learner's answer, with the reason.
#include "app/cli/commands/commands.h"
#include "app/cli/kept_answers.h"
#include "app/cli/lesson_lookup.h"
#include "app/cli/message.h"
#include "app/cli/or_fail.h"
#include "app/narration/speech_text.h"
#include "app/narration/transcript.h"
#include "app/session/answers/answer_log.h"
#include "app/session/saved/state_file.h"
#include "base/printable.h"
#include "base/shell_line.h"
#include "base/spelling.h"
#include "base/utf8.h"
#include "lessons/derivation/answer_reasons.h"
#include "lessons/diagnostics/source_text.h"
#include "lessons/reader/questions/line_notation.h"
#include "lessons/reader/questions/state_task.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace polhode {

namespace {

using Mark = AnswerJudgement::Mark;

struct Options {
  std::string lesson, stage, ask;
  std::optional<std::string> answer;
  bool hint = false, reset = false, json = false;
};

const char* word_of(Mark mark) {
  if (mark == Mark::right) return "right";
  return mark == Mark::wrong ? "wrong" : "unreadable";
}

ExitCode code_of(Mark mark) {
  if (mark == Mark::right) return ExitCode::done;
  return mark == Mark::wrong ? ExitCode::different : ExitCode::usage;
}

void print_json(const AnswerJudgement& judgement, const std::string& reply) {
  using Json = nlohmann::ordered_json;
  Json json = {{"verdict", word_of(judgement.mark)},
               {"reason", judgement.reason},
               {"tag", judgement.tag.empty() ? Json(nullptr) : Json(judgement.tag)},
               {"hint", judgement.hint},
               {"reply", reply},
               {"column", judgement.column > 0 ? Json(judgement.column) : Json(nullptr)},
               {"counterexample", nullptr}};
  if (const auto& counter = judgement.counterexample)
    json["counterexample"] = {
        {"state", counter->state}, {"answer", counter->left}, {"right", counter->right}};
  fmt::print("{}\n", printable(json.dump(2, ' ', false, Json::error_handler_t::replace)));
}

/// The column counts characters, of which the answer as it is shown may have more.
void print_place(const std::string& answer, int column) {
  if (column <= 0) return;
  const std::size_t offset = SourceText(answer).offset_of({1, column});
  const int before = count_characters(printable_line(answer.substr(0, offset)));
  fmt::print("  {}\n  {:>{}}\n", printable_line(answer), '^', before + 1);
}

void print_verdict(const AnswerJudgement& judgement, const std::string& answer, const std::string& reply) {
  if (judgement.mark == Mark::unreadable) return;
  if (judgement.mark == Mark::wrong && judgement.choice > 0)
    fmt::print("{}.\n", judgement.reason);  // the whole sentence: "A is not right"
  else
    fmt::print("{}{}{}\n", word_of(judgement.mark), judgement.reason.empty() ? "" : ": ",
               printable_line(judgement.reason));
  print_place(answer, judgement.column);
  if (const auto& counter = judgement.counterexample)
    fmt::print("At {} yours is {}, right is {}.\n", counter->state, counter->left, counter->right);
  if (!reply.empty()) fmt::print("{}", wrapped(printable_line(reply), ""));
}

ExitCode show_hint(const Ask& ask, const SpeechText& speech, const KeptAnswers& kept) {
  AnswerRecord unseen;
  const std::size_t hints = ask.hints.size();
  std::optional<std::size_t> next = note_help(unseen, hints);  // where no log can be read
  bool is_told = false;
  kept.change_if_possible(
      [&](AnswerLog& log, const std::string& name) {
        AnswerRecord record = log.contains(name) ? log[name] : AnswerRecord();
        is_told = polhode::is_told(record, hints);
        next = note_help(record, hints);
        if (next) log[name] = std::move(record);
      },
      "the hint is not noted");
  if (next && *next < hints) {
    fmt::print("Hint {} of {}: {}\n", *next + 1, hints, speech.words(ask.hint_texts[*next]));
    if (*next + 1 == hints) fmt::print("That was the last hint: after it --hint tells the answer.\n");
    return ExitCode::done;
  }
  if (!next && !is_told) {
    fmt::print("There is no hint. Try an answer: after it --hint tells the right one.\n");
    return ExitCode::done;
  }
  fmt::print("{}", wrapped("The answer is " + printable_line(speech.words_of_answer(ask)), ""));
  return ExitCode::done;
}

/// Unless the command, in which the lesson's path is one word, would show as another than it is.
void offer_hint(const Options& options) {
  const std::vector<std::string> command = {"polhode",     "answer",    options.lesson,
                                            options.stage, options.ask, "--hint"};
  if (shows_as_it_is(command)) fmt::print("A hint: {}\n", shell_line(command));
}

ExitCode judge_and_keep(const Ask& ask, const SpeechText& speech, const LineNotation& how,
                        const std::string& given, const Options& options, const KeptAnswers& kept) {
  const AnswerJudgement judgement =
      ask.task ? judge_state(*ask.task, given) : judge_with_reasons(ask, given, Prover(), how);
  const std::string reply = speech.words_after(ask, judgement);
  options.json ? print_json(judgement, reply) : print_verdict(judgement, given, reply);
  if (judgement.mark == Mark::unreadable && !options.json) {
    print_place(given, judgement.column);
    throw CommandError(ExitCode::usage, judgement.hint.empty()
                                            ? judgement.reason
                                            : fmt::format("{} ({})", judgement.reason, judgement.hint));
  }
  if (judgement.mark != Mark::unreadable) {
    if (!options.json && judgement.mark == Mark::wrong && !ask.hints.empty()) offer_hint(options);
    std::fflush(stdout);  // the verdict need not wait for another process that keeps an answer just now
    kept.change_if_possible(
        [&](AnswerLog& log, const std::string& name) { note_judged(log[name], judgement, given); },
        "the answer is not kept");
  }
  return code_of(judgement.mark);
}

ExitCode answer(const Options& options) {
  if (options.answer.has_value() == (options.hint || options.reset) || (options.hint && options.reset))
    throw CommandError(ExitCode::usage, "give an answer, or --hint, or --reset");
  const LoadedLesson loaded = or_fail(load_lesson(options.lesson));
  const Stage& stage = stage_of(loaded.lesson, options.stage);
  const Ask& ask = ask_of(stage, options.ask);
  if (ask.derivation && !options.reset)
    throw CommandError(ExitCode::usage,
                       fmt::format("question \"{}\" asks for a derivation: polhode derive takes "
                                   "its lines, and has hints",
                                   ask.id));
  const KeptAnswers kept(loaded.lesson.id, answer_name(stage.id, ask.id));
  const SpeechText speech(loaded.lesson);
  if (options.hint) return show_hint(ask, speech, kept);
  if (options.reset) {
    or_fail(kept.change([](AnswerLog& log, const std::string& name) { log.erase(name); }));
    return ExitCode::done;
  }
  return judge_and_keep(ask, speech, line_notation(loaded.lesson, ask), *options.answer, options, kept);
}

}  // namespace

ProgramCommand answer_command() {
  const auto options = std::make_shared<Options>();
  return {
      "answer",
      "Judge an answer to a question of a lesson",
      {{"LESSON", &options->lesson, "Lesson file or id", "", true, offer_lessons()},
       {"STAGE", &options->stage, "Id of the stage", "", true},
       {"ASK", &options->ask, "Id of the question", "", true},
       {"ANSWER", &options->answer, "What is answered, as its type wants it"},
       {"--hint", &options->hint, "Show the next hint instead; behind the last, the answer"},
       {"--reset", &options->reset, "Forget what was answered to the question, and its hints"},
       {"--json", &options->json, "verdict, reason, tag, reply, column, counterexample as JSON"}},
      fmt::format(
          "An expression is written as \"{}\" or \"2a (b - c)\", a choice as B or 2, an order as \"{}\",\n"
          "a number as \"4.2 mJ\", a state as \"{}\".\n",
          form_of_answer(Ask::Type::expression), form_of_answer(Ask::Type::order),
          form_of_answer(Ask::Type::state)) +
          "Exit code 0 if the answer is right, 4 if it is wrong, 2 if it cannot be read. What was\n"
          "answered is kept in $XDG_STATE_HOME/polhode, or ~/.local/state/polhode.",
      [options](const CommandWords&) { return answer(*options); },
      true};
}

}  // namespace polhode

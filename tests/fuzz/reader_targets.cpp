// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "lessons/claims/answers/answers.h"
#include "lessons/derivation/answer_reasons.h"
#include "lessons/derivation/derivation.h"
#include "lessons/derivation/typed_answer.h"
#include "lessons/notation/typed/expression_typing.h"
#include "lessons/reader/reader.h"
#include "tests/fuzz/math_inputs.h"
#include "tests/fuzz/targets.h"
#include "tests/fuzz/text_inputs.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace polhode::fuzz {
namespace {

const Fonts& fonts() {
  static const Fonts kFonts = [] {
    auto opened = Fonts::open();
    if (!opened) throw std::runtime_error(opened.error());
    return std::move(*opened);
  }();
  return kFonts;
}

const Prover& prover() {
  static const Prover kProver;
  return kProver;
}

/// The message of a fault has words, and no control character.
std::string finding_in_words(const std::string& message) {
  if (message.empty()) return "a complaint without words";
  return shows_as_it_is(message) ? "" : "a complaint that steers the terminal: " + printable_line(message);
}

std::string finding_in_reading(std::string_view text) {
  const LessonReading reading = read_lesson(text, "lesson.md");
  const SourceText source(text);
  bool is_refused = false;
  for (const Diagnostic& d : reading.diagnostics) {
    is_refused = is_refused || d.severity == Severity::error;
    if (std::string finding = finding_in_words(to_string(d)); !finding.empty()) return finding;
    if (d.message.empty()) return "a complaint without words";
    if (source.clamp(d.place) != d.place) return "a complaint outside the lesson: " + to_string(d);
  }
  if (reading.lesson && is_refused) return "a lesson with errors";
  if (!reading.lesson && !is_refused) return "a lesson refused without a reason";
  return {};
}

std::string finding_in_lesson(std::string_view bytes) { return finding_in_reading(bytes); }

std::string finding_in_front_matter(std::string_view bytes) {
  return finding_in_reading("+++\nformat = 1\nid = \"a\"\n" + std::string(bytes) + "\n+++\n# A {a}\nText.\n");
}

std::string finding_in_formula(std::string_view bytes) { return finding_in(std::string(bytes), fonts()); }

std::string finding_in_markdown(std::string_view bytes) {
  return finding_in_text(std::string(bytes), bytes.size() % 2 == 1, fonts());
}

std::string finding_in_expression(std::string_view bytes) {
  const SourceText source(bytes);
  Report report(source, "text");
  const auto expression = read_expression(bytes, {1, 1}, report);
  if (!expression && !report.has_errors()) return "an expression refused without a reason";
  for (const Diagnostic& d : report.take())
    if (std::string finding = finding_in_words(to_string(d)); !finding.empty()) return finding;
  if (!expression) return {};
  // It can be told as one would type it. (Not all of it can be typed by learners: h and k are no words of
  // theirs.)
  typed_formula(typing_of(*expression, static_cast<int>(expression->nodes.size()) - 1), {});
  return {};
}

/// What is wrong with what a learner types has words, and a place in it; 0: the whole.
std::string finding_in_unreadable(const UnreadableLine& line, std::string_view bytes) {
  if (line.column < 0 || line.column > static_cast<int>(bytes.size()) + 1)
    return "a fault at column " + std::to_string(line.column);
  return finding_in_words(line.message);
}

const EquationNotation& no_notation() {
  static const EquationNotation kNone;
  return kNone;
}

LineNotation notation() { return {.notation = &no_notation(), .names = {}, .macros = {}, .own = {}}; }

DerivedLine line_of(const char* typed) {
  auto line = read_line(typed, notation(), nullptr);
  if (!line) throw std::logic_error(line.error().message);
  return std::move(*line);
}

/// That of Euler's equations: from the law to the rate in the body.
const Derivation& derivation() {
  static const Derivation kDerivation = [] {
    Derivation one{.start = line_of("dL/dt = N"),
                   .goal = line_of("d*L/dt + omega x L = N"),
                   .laws = LawsAssumed::motion,
                   .given = {},
                   .facts = {},
                   .letters = {},
                   .worked = {},
                   .least_lines = 1};
    one.letters = letters_of(one);
    return one;
  }();
  return kDerivation;
}

std::string finding_in_line(std::string_view bytes) {
  const TypedFormula formula = typed_formula(bytes, {});
  if (formula.fault && formula.fault->at > bytes.size()) return "a fault behind the end";
  for (const auto& [tex, line] : formula.marks)
    if (tex > formula.tex.size() || line > bytes.size()) return "a mark behind the end";
  for (std::size_t at = 0; at <= formula.tex.size(); ++at)
    if (typed_offset(formula, at) > bytes.size()) return "a place behind the end";
  const auto read = read_line(bytes, notation(), nullptr);
  if (!read) return finding_in_unreadable(read.error(), bytes);
  if (const auto math = parse_math(read->tex); !math) return "a line that cannot be set: " + read->tex;
  const LineJudgement judged = judge_line(derivation(), {derivation().start}, bytes, notation(), prover());
  if (judged.mark == LineJudgement::Mark::wrong && judged.reason.empty())
    return "a wrong line without a reason";
  return {};
}

Question asking(const char* answer) {
  const SourceText source(answer);
  Report report(source, "answer");
  Question question;
  question.modulo = "motion";
  question.expression = read_expression(answer, {1, 1}, report);
  return question;
}

std::string finding_in_answer(std::string_view bytes) {
  static const Question kComponent = asking("w3*w1*(I1 - I3)"), kVector = asking("cross(omega, L)");
  if (const auto typed = read_typed_answer(bytes, notation()); !typed)
    return finding_in_unreadable(typed.error(), bytes);
  for (const Question* question : {&kComponent, &kVector}) {
    const AnswerJudgement judged = judge_answer(*question, bytes, prover());
    if (judged.mark != AnswerJudgement::Mark::right && judged.reason.empty())
      return "no reason for a wrong answer";
    if (judged.column < 0 || judged.column > static_cast<int>(bytes.size()) + 1)
      return "a reason outside the answer";
  }
  return {};
}

constexpr std::array<Target, 7> kTargets = {{{"lesson", finding_in_lesson},
                                             {"front_matter", finding_in_front_matter},
                                             {"formula", finding_in_formula},
                                             {"text", finding_in_markdown},
                                             {"expression", finding_in_expression},
                                             {"line", finding_in_line},
                                             {"answer", finding_in_answer}}};

}  // namespace

std::span<const Target> reader_targets() { return kTargets; }

}  // namespace polhode::fuzz

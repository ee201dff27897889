// SPDX-License-Identifier: MIT
// Reports that were changed on the way, or by somebody who would like to have been right, with a new checksum
// too. What is collected as right has to be so in the text itself: behind the line of its question there is
// an answer that is right. Which lines that are is found here without the reader.
#include "app/session/answers/collected_answers.h"
#include "base/sha256.h"
#include "lessons/derivation/answer_reasons.h"
#include "lessons/reader/questions/line_notation.h"
#include "tests/app/session/quiz_lesson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace polhode {
namespace {

using State = CollectedAnswer::State;

const Lesson& quiz() { return test::quiz()->lesson; }

using Lines = std::vector<std::string>;
Lines lines_in(const std::string& text) {
  Lines lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = text.substr(at, end - at);
    line.erase(line.find_last_not_of(" \t\r") + 1);
    lines.push_back(line);
    at = end + 1;
  }
  return lines;
}
std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// With a checksum that fits what stands above it.
std::string signed_again(const std::string& text) {
  Lines lines = lines_in(text);
  const auto end = std::find_if(lines.begin(), lines.end(),
                                [](const std::string& line) { return line.starts_with("Checksum: "); });
  if (end == lines.end()) return text;
  *end = "Checksum: " + sha256_hex(joined({lines.begin(), end})).substr(0, 16);
  return joined(lines);
}

std::vector<std::string> seeds() {
  std::vector<std::string> reports;
  const auto add = [&](const AnswerLog& answers, const std::string& name) {
    reports.push_back(*answer_report(quiz(), answers, name));
  };
  add(test::all_right(), "Right");
  add({}, "Nothing");
  add({{"first/sign", {0, 1, 0, "w3*w1*(I3 - I1)", "", {{"signs", 1}}}},
       {"first/which", {0, 3, 1, "A", "", {{"choice-A", 2}, {"choice-C", 1}}}},
       {"first/order", {0, 1, 0, "A B C", "", {{"place-1", 1}}}},
       {"second/derive", {0, 2, 3, "d*L/dt + omega x L = N", "", {{"sign", 1}}}}},
      "Wrong");
  AnswerLog half = test::all_right();
  half["first/which"] = {0, 1, 0, "C", "", {{"choice-C", 1}}};
  half.erase("first/order");
  add(half, "");
  return reports;
}

class Mutations {
 public:
  explicit Mutations(std::vector<std::string> reports) : reports_(std::move(reports)) {}

  std::string next() {
    std::string text = one_of(reports_);
    const std::size_t changes = 1 + below(3);
    for (std::size_t i = 0; i < changes; ++i) change(text);
    return below(3) == 0 ? text : signed_again(text);
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  template <class T>
  const T& one_of(const std::vector<T>& of) {
    return of[below(of.size())];
  }

  void change(std::string& text) {
    static const std::vector<std::pair<std::string, std::string>> kLies = {
        {"not right", "right"},
        {"not answered, tries 0", "right, tries 1"},
        {"A B C", "C A B C"},
        {"answer: A", "answer: "},
        {"answer: A", "answer: A\n  answer: B"},
        {"answer: C", "answer: C B"},
        {"first/sign", "first/which"},
        {"w1", "w2"},
        {"I3 - I1", "I3-I2"},
        {"hints 0", "hints 0\n  answer: B"},
        {"hints 0", "hints 0\n  right, tries 1, hints 0"},
        {"Lesson: quiz", "Lesson: quiz\n  right"}};
    if (text.empty()) text = "\n";
    Lines lines = lines_in(text);
    switch (below(8)) {
      case 0:
        text[below(text.size())] = static_cast<char>(below(256));
        return;
      case 1:
        text.insert(below(text.size()), 1, "\n :,/0123456789ABCw*"[below(20)]);
        return;
      case 2:
        text.erase(below(text.size()), 1 + below(40));
        return;
      case 3:
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())));
        break;
      case 4:
        std::swap(lines[below(lines.size())], lines[below(lines.size())]);
        break;
      case 5: {
        const Lines others = lines_in(one_of(reports_));
        lines[below(lines.size())] = one_of(others);
        break;
      }
      case 6: {
        const Lines others = lines_in(one_of(reports_));
        const std::size_t from = below(others.size()), to = from + below(others.size() - from);
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size())),
                     others.begin() + static_cast<std::ptrdiff_t>(from),
                     others.begin() + static_cast<std::ptrdiff_t>(to));
        break;
      }
      default: {
        const auto& [what, by] = one_of(kLies);
        if (const std::size_t at = text.find(what, below(text.size())); at != text.npos)
          text.replace(at, what.size(), by);
        return;
      }
    }
    text = joined(lines);
  }

  std::vector<std::string> reports_;
  std::mt19937_64 random_{20260714};
};

/// Answers that stand in a text behind a line of the question.
std::vector<std::string> answers_in(const std::string& text, const std::string& question) {
  std::vector<std::string> answers;
  bool is_of_it = false;
  std::string answer;
  const auto close = [&] {
    if (!answer.empty()) answers.push_back(answer);
    answer.clear();
  };
  for (const std::string& line : lines_in(text)) {
    if (!line.starts_with(' ') && !line.empty()) {
      close();
      is_of_it = line.starts_with(question + ": ");
    } else if (is_of_it && line.starts_with("  answer: ")) {
      answer += (answer.empty() ? "" : "\n") + line.substr(10);
    }
  }
  close();
  return answers;
}

/// Judged by what a learner is told, line by line, not by what reports are judged by.
bool is_told_right(const PlacedAsk& question, const std::string& answer) {
  static const Prover prover;
  if (!question.ask->derivation)
    return judge_with_reasons(*question.ask, answer, prover, line_notation(quiz(), *question.ask)).mark ==
           AnswerJudgement::Mark::right;
  const LineNotation how = line_notation(quiz(), *question.ask);
  const Derivation& derivation = *question.ask->derivation;
  std::vector<DerivedLine> lines;
  for (const std::string& typed : lines_in(answer)) {
    const LineJudgement judgement = judge_line(derivation, lines, typed, how, prover);
    if (judgement.mark != LineJudgement::Mark::holds && judgement.mark != LineJudgement::Mark::goal)
      return false;
    lines.push_back(*judgement.line);
  }
  return lines.size() >= 2 && is_goal(derivation, lines.back(), prover);
}

TEST(MutatedReports, AreNeverReadAsAFalseRight) {
  constexpr int kReports = 10'000;
  Mutations mutations(seeds());
  const std::vector<PlacedAsk> questions = questions_of(quiz());
  std::map<std::pair<std::string, std::string>, bool> told;
  int read = 0, lies = 0, right = 0;
  for (int i = 0; i < kReports; ++i) {
    const std::string text = mutations.next();
    const auto report = read_answer_report(text);
    if (!report) continue;
    ++read;
    static CollectedAnswers collected(quiz());
    AnswerReport named = *report;
    named.student = std::to_string(i);
    const auto added = collected.add(named.student, named);
    if (!added) continue;
    lies += !added->empty();
    const CollectedStudent& student = collected.students().back();
    for (std::size_t q = 0; q < questions.size(); ++q) {
      if (student.answers[q].state != State::right) continue;
      ++right;
      const auto answers = answers_in(text, questions[q].name);
      EXPECT_TRUE(std::any_of(answers.begin(), answers.end(),
                              [&](const std::string& answer) {
                                const auto [known, is_new] = told.try_emplace({questions[q].name, answer});
                                if (is_new) known->second = is_told_right(questions[q], answer);
                                return known->second;
                              }))
          << questions[q].name << " in\n"
          << text;
    }
  }
  // Enough of them got past the checksum and the reader to be judged, and enough of those lied.
  EXPECT_GT(read, kReports / 10);
  EXPECT_GT(lies, kReports / 200);
  EXPECT_GT(right, kReports / 10);
  RecordProperty("read", read);
  RecordProperty("lies", lies);
}

TEST(MutatedReports, WithoutANewChecksumAreDamaged) {
  const std::vector<std::string> reports = seeds();
  std::mt19937_64 random(7);
  for (int i = 0; i < 2000; ++i) {
    std::string text = reports[static_cast<std::size_t>(i) % reports.size()];
    const std::size_t end = text.find("\nIt shows");
    const std::size_t at = random() % end;
    const char before = text[at];
    text[at] = static_cast<char>(static_cast<unsigned char>(before) ^ (1U << (random() % 8)));
    if (std::isspace(static_cast<unsigned char>(before)) ||
        std::isspace(static_cast<unsigned char>(text[at])))
      continue;  // blanks at the end of a line do not count
    EXPECT_FALSE(read_answer_report(text)) << "byte " << at << " of\n" << text;
  }
}

}  // namespace
}  // namespace polhode

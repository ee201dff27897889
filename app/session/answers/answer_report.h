// SPDX-License-Identifier: MIT
// What a student hands in: a text that says what was answered to the questions of a lesson, for people to
// read and for `polhode answers collect`.
//
//   Answers to a lesson of polhode, format 1
//   Lesson: quiz
//   Version: 0123456789abcdef                 of the lesson's text
//   Program: polhode 0.1.0
//   Name: …                                   only if one was typed; nothing else is known of who it is
//   Title: …, Right: …, Outcome 1: …          for people
//                                             then for each question, with a blank line above it:
//   quiz/sign: What is the component?
//     right, tries 3, hints 1                 or "not right", or "not answered"
//     answer: w3*w1*(I1 - I3)                 the last one, or the last that was right; a line for each line
//     reasons: sign 1, index 1                why others were wrong (reason_tags.h)
//
//   Checksum: 0123456789abcdef                of all that stands above it
//
// Ends of lines, blanks before them, a byte order mark and whatever stands behind the checksum may change on
// the way. The checksum guards against accidents. It is no signature: anybody can compute it. So who collects
// reports judges their answers again, and believes them nothing else that is good for the student.
#pragma once

#include "app/session/answers/answer_log.h"
#include "base/result.h"
#include "lessons/reader/lesson.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polhode {

inline constexpr std::size_t kMaxReportBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMaxReportLines = 50'000;

struct ReportedAnswer {
  std::string name;  ///< "stage/ask"
  bool right = false;
  int tries = 0, hints = 0;
  std::string answer;
  std::map<std::string, int> reasons;
  bool operator==(const ReportedAnswer&) const = default;
};

struct AnswerReport {
  std::string lesson_id, version, program;
  std::string student;  ///< as it was typed; empty: none was
  std::vector<ReportedAnswer> answers;
  std::string checksum;
  std::string head{};  ///< what it says at its head for people: how many are right
};

/// Of the lesson's text: 16 digits of its SHA-256.
std::string version_of(const Lesson& lesson);

/// The head of a report for people, of what was answered and whether it is right: a line each.
std::string head_of_report(const Lesson& lesson, const AnswerLog& judged);

/// What is right is judged anew, for the log may be that of an older version of the lesson. An error if the
/// name cannot be taken (fault_of_name).
Result<std::string> answer_report(const Lesson& lesson, const AnswerLog& answers, const std::string& student);

/// The error says what is wrong, and in which line: one sentence. Linear in the text; at most kMaxReportBytes
/// are read.
Result<AnswerReport> read_answer_report(std::string_view text);

}  // namespace polhode

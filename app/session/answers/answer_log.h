// SPDX-License-Identifier: MIT
// What a learner has answered so far. How it is kept from one run to the next:
// app/session/saved/answer_file.h.
#pragma once

#include "lessons/claims/answers/answers.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace polhode {

struct AnswerRecord {
  int right = 0;                          ///< how many tries were right; the file keeps only whether any was
  int tries = 0;                          ///< how many answers could be read, right or wrong
  int hints = 0;                          ///< how many hints were shown
  std::string last;                       ///< the last answer
  std::string accepted = {};              ///< the last one that was right
  std::map<std::string, int> wrong = {};  ///< how often each reason (reason_tags.h) was given
  bool operator==(const AnswerRecord&) const = default;
};

/// Answers of one lesson by "STAGE/ASK".
using AnswerLog = std::map<std::string, AnswerRecord>;
std::string answer_name(std::string_view stage_id, std::string_view ask_id);

void note_try(AnswerRecord& record, bool is_right, std::string_view answer);
/// Notes why an answer, or a line of a derivation, was wrong; empty: for another reason.
void note_reason(AnswerRecord& record, std::string_view tag);
/// Notes a try that was judged. Precondition: it could be read.
void note_judged(AnswerRecord& record, const AnswerJudgement& judgement, std::string_view answer);
/// Notes that one more of the question's `hints` hints is shown, and says which, from 0; nothing if all were
/// shown before.
std::optional<std::size_t> note_hint(AnswerRecord& record, std::size_t hints);

/// The same, and behind the last hint the answer itself: then it is `hints`, and the record has one hint more
/// than there are. Of a question without hints the answer is told to who has tried.
std::optional<std::size_t> note_help(AnswerRecord& record, std::size_t hints);
inline bool is_told(const AnswerRecord& record, std::size_t hints) {
  return record.hints > static_cast<int>(hints);
}

/// Applies to a log the changes that turned `before`, a copy of it, into `now`, and nothing else: what
/// another process has added or removed in the meantime stays so.
void merge_answers(AnswerLog& log, const AnswerLog& before, const AnswerLog& now);

}  // namespace polhode

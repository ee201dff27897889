// SPDX-License-Identifier: MIT
// Whether what was answered to a question is right, judged anew: of reports nothing else is believed.
#pragma once

#include "lessons/claims/proof/proof.h"
#include "lessons/derivation/derivation.h"
#include "lessons/reader/lesson.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace polhode {

class AnswerCheck {
 public:
  /// `lesson` must outlive it.
  explicit AnswerCheck(const Lesson& lesson);

  /// `answer` as a log has it: of a derivation its lines. What was judged once is not judged again, for in a
  /// class many give the same answer. What people type takes some 0.1 ms, a line of a derivation 1 ms.
  bool is_right(const Ask& ask, std::string_view answer);

  /// The word for why it is wrong (reason_tags.h), judged anew; empty: it is right, cannot be read, or is a
  /// derivation, whose lines that hold are all that is kept. Some 30 ms at most.
  std::string reason(const Ask& ask, std::string_view answer);

 private:
  bool judge(const Ask& ask, std::string_view answer);
  const LineNotation& notation(const Ask& ask);

  const Lesson& lesson_;
  std::map<const Ask*, LineNotation> how_;
  Prover prover_;
  std::map<std::pair<const Ask*, std::string>, bool> known_;
  std::map<std::pair<const Ask*, std::string>, std::string> reasons_;
};

}  // namespace polhode

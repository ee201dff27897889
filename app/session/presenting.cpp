// SPDX-License-Identifier: MIT
// Before an audience: what it sees, and which stages are for it.
#include "app/session/lesson_session.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace polhode {

void LessonSession::set_presenting(bool presenting) {
  if (presenting != presenting_) {
    set_frozen(false);
    has_speaker_ = black_ = pointing_ = false;
    if (presenting) {
      panel = Panel::none;
      forget_trials();
    }
  }
  presenting_ = presenting;
}

void LessonSession::set_speaker(bool wanted) {
  if (wanted)
    set_presenting(true);
  else
    set_frozen(false);
  has_speaker_ = wanted;
}

void LessonSession::set_frozen(bool frozen) {
  if (frozen_ && !frozen) forget_trials();
  frozen_ = has_speaker_ && frozen;
  if (frozen_) transition_ = 1;  // the audience goes on seeing this step, and all of it
}

void LessonSession::forget_trials() {
  if (judged_.empty() && derivations_.empty() && !awaited_) return;
  const bool has_played = !judged_.empty() || awaited_;
  if (awaited_) playing_ = false;
  judged_.clear();
  derivations_.clear();
  awaited_.reset();
  if (has_scene() && has_played) reset_time();
}

void LessonSession::set_left_out(const std::set<std::string>& stages) {
  std::set<std::string> kept;  // what is given may be left_out_ itself
  for (const Stage& known : lesson().stages)
    if (stages.contains(known.id)) kept.insert(known.id);
  left_out_ = std::move(kept);
}

void LessonSession::leave_out(const std::string& stage, bool is_left_out) {
  std::set<std::string> stages = left_out_;
  if (is_left_out)
    stages.insert(stage);
  else
    stages.erase(stage);
  set_left_out(stages);
}

std::vector<std::size_t> LessonSession::chosen_stages() const {
  const std::vector<Stage>& stages = lesson().stages;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (left_out_.size() == stages.size() || !left_out_.contains(stages[i].id)) chosen.push_back(i);
  return chosen;
}

bool LessonSession::passes_over(std::size_t stage) const {
  const std::vector<Stage>& stages = lesson().stages;
  return presenting_ && left_out_.size() < stages.size() && left_out_.contains(stages[stage].id);
}

std::vector<std::size_t> LessonSession::counted_stages() const {
  if (presenting_) return chosen_stages();
  std::vector<std::size_t> all(lesson().stages.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::optional<LessonSession::StageNumber> LessonSession::stage_number(std::size_t stage) const {
  const std::vector<std::size_t> counted = counted_stages();
  const auto found = std::find(counted.begin(), counted.end(), stage);
  if (found == counted.end()) return std::nullopt;
  return StageNumber{static_cast<std::size_t>(found - counted.begin()) + 1, counted.size()};
}

std::optional<std::size_t> LessonSession::stage_beside(int way) const {
  const auto count = static_cast<std::ptrdiff_t>(lesson().stages.size());
  for (auto i = static_cast<std::ptrdiff_t>(place_.stage) + way; i >= 0 && i < count; i += way)
    if (!passes_over(static_cast<std::size_t>(i))) return static_cast<std::size_t>(i);
  return std::nullopt;
}

}  // namespace polhode

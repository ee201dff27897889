// SPDX-License-Identifier: MIT
// What a computation costs, told while it goes on to whoever asked for it, who can so limit or stop it.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>

namespace polhode {

/// Called every few milliseconds at least, with the number of evaluations of the right-hand side made since
/// the last call, and on the thread that made them. What it throws comes out of the call of Motion::at that
/// needed the evaluations. The motion stays good: it keeps the steps it has made, the next call goes on from
/// there, and the answers are those of a motion that was never stopped. Empty: nobody wants to know.
using Effort = std::function<void(std::int64_t evaluations)>;

inline void spend(const Effort& effort, std::int64_t evaluations) {
  if (effort) effort(evaluations);
}

/// Thrown by a Budget. No std::domain_error: what was asked for may be right, it is only too dear.
struct BudgetSpent : std::runtime_error {
  BudgetSpent() : std::runtime_error("more evaluations than the budget has") {}
};

/// Allows so many evaluations and no more. It counts evaluations, not seconds, so that it ends at the same
/// place on every machine. For one thread.
class Budget {
 public:
  explicit Budget(std::int64_t evaluations) : left_(evaluations) {}

  /// @throws BudgetSpent, and from then on always
  void spend(std::int64_t evaluations) {
    left_ = evaluations < left_ ? left_ - evaluations : 0;
    if (left_ == 0) throw BudgetSpent();
  }
  bool is_spent() const { return left_ == 0; }
  std::int64_t left() const { return left_; }

  /// The budget must outlive whoever is given this.
  Effort effort() {
    return [this](std::int64_t evaluations) { spend(evaluations); };
  }

 private:
  std::int64_t left_;
};

}  // namespace polhode

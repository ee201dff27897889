// SPDX-License-Identifier: MIT
// Random access to a sequence y_{k+1} = step(y_k) that can only be computed in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace polhode {

/// after(k) is y_k, to the last bit the same whatever was asked before and from however many threads: `step`
/// must depend on its argument alone. States are kept every `spacing` steps; when there would be more than
/// kMaxSaved of them every second one is dropped and the spacing doubled, so memory is bounded and a revisit
/// costs at most k_largest/8192 + 16 steps. New ground is computed under a lock, by one thread for all.
template <class State>
class Checkpoints {
 public:
  using Step = std::function<State(const State&)>;
  using IsAlive = std::function<bool(const State&)>;

  static constexpr std::size_t kMaxSaved = 16384;
  static constexpr std::int64_t kFirstSpacing = 16;

  /// A state for which is_alive is false ends the sequence: all later ones are taken to be dead too.
  Checkpoints(State start, Step step, IsAlive is_alive)
      : step_(std::move(step)), is_alive_(std::move(is_alive)), saved_{std::move(start)} {}

  /// y_k for k ≥ 0; nothing if it lies past the end of the sequence or is itself dead.
  std::optional<State> after(std::int64_t k) const {
    auto from = nearest_saved(k);
    if (!from) return std::nullopt;
    State y = advance(std::move(from->state), k - from->index);
    if (!is_alive_(y)) return std::nullopt;
    return y;
  }

 private:
  struct Saved {
    State state;
    std::int64_t index;
  };

  std::optional<Saved> nearest_saved(std::int64_t k) const {
    const std::lock_guard lock(mutex_);
    while (!dead_at_ && last_index() + spacing_ <= k) extend();
    if (dead_at_ && k >= *dead_at_) return std::nullopt;
    const auto place = static_cast<std::size_t>(k / spacing_);
    return Saved{saved_[place], k / spacing_ * spacing_};
  }

  std::int64_t last_index() const { return static_cast<std::int64_t>(saved_.size() - 1) * spacing_; }

  void extend() const {
    State next = advance(saved_.back(), spacing_);
    if (!is_alive_(next)) {
      dead_at_ = last_index() + spacing_;
      return;
    }
    saved_.push_back(std::move(next));
    if (saved_.size() > kMaxSaved) thin();
  }

  void thin() const {
    std::vector<State> kept;
    kept.reserve(kMaxSaved);
    for (std::size_t i = 0; i < saved_.size(); i += 2) kept.push_back(saved_[i]);
    saved_ = std::move(kept);
    spacing_ *= 2;
  }

  State advance(State y, std::int64_t steps) const {
    for (std::int64_t i = 0; i < steps; ++i) y = step_(y);
    return y;
  }

  Step step_;
  IsAlive is_alive_;
  mutable std::mutex mutex_;          // guards what follows
  mutable std::vector<State> saved_;  // y_0, y_spacing, y_2·spacing, ...
  mutable std::int64_t spacing_ = kFirstSpacing;
  mutable std::optional<std::int64_t> dead_at_;
};

}  // namespace polhode

// SPDX-License-Identifier: MIT
// Random access to a sequence y_0, y_1, y_2, ... that can only be computed in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace polhode {

/// Answers are to the last bit the same whatever was asked before and from however many threads: `advance`
/// must depend on its arguments alone, and n steps at once must be n single steps. States are kept every
/// `spacing` steps; when there would be more than kMaxSaved of them every second one is dropped and the
/// spacing doubled, so memory is bounded and a revisit costs at most k_largest/8192 + 16 steps. New ground is
/// computed under a lock, by one thread for all.
template <class State>
class Checkpoints {
 public:
  using Advance = std::function<void(State&, std::int64_t)>;  ///< n steps on
  using IsAlive = std::function<bool(const State&)>;

  static constexpr std::size_t kMaxSaved = 16384;
  static constexpr std::int64_t kFirstSpacing = 16;

  /// A state for which is_alive is false ends the sequence: all later ones are taken to be dead too.
  Checkpoints(State start, Advance advance, IsAlive is_alive)
      : advance_(std::move(advance)), is_alive_(std::move(is_alive)), saved_{std::move(start)} {}

  /// y_k for k ≥ 0; nothing if it lies past the end of the sequence or is itself dead.
  std::optional<State> after(std::int64_t k) const {
    auto from = nearest_saved(k);
    if (!from) return std::nullopt;
    advance_(from->state, k - from->index);
    if (!is_alive_(from->state)) return std::nullopt;
    return std::move(from->state);
  }

  /// The y_k with k < k_end for which is_before holds and for which it no longer holds of y_{k+1}; nothing if
  /// there is none, or y_{k+1} is past the end of the sequence. is_before must be true of y_0 and up to some
  /// state, and false from there on.
  template <class IsBefore>
  std::optional<State> last_before(const IsBefore& is_before, std::int64_t k_end) const {
    Saved from = last_saved_before(is_before, k_end);
    for (; from.index < k_end; ++from.index) {
      State next = from.state;
      advance_(next, 1);
      if (!is_alive_(next)) return std::nullopt;
      if (!is_before(next)) return std::move(from.state);
      from.state = std::move(next);
    }
    return std::nullopt;
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

  template <class IsBefore>
  Saved last_saved_before(const IsBefore& is_before, std::int64_t k_end) const {
    const std::lock_guard lock(mutex_);
    while (!dead_at_ && last_index() < k_end && is_before(saved_.back())) extend();
    const auto after = std::partition_point(std::next(saved_.begin()), saved_.end(), is_before);
    const auto place = std::prev(after) - saved_.begin();
    return {saved_[static_cast<std::size_t>(place)], place * spacing_};
  }

  std::int64_t last_index() const { return static_cast<std::int64_t>(saved_.size() - 1) * spacing_; }

  void extend() const {
    State next = saved_.back();
    advance_(next, spacing_);
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

  Advance advance_;
  IsAlive is_alive_;
  mutable std::mutex mutex_;          // guards what follows
  mutable std::vector<State> saved_;  // y_0, y_spacing, y_2·spacing, ...
  mutable std::int64_t spacing_ = kFirstSpacing;
  mutable std::optional<std::int64_t> dead_at_;
};

}  // namespace polhode

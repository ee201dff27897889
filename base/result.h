// SPDX-License-Identifier: MIT
// A value, or the reason why there is none (std::expected does not exist in GCC 12).
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace polhode {

template <class E>
struct Failure {
  E error;
};
template <class E>
Failure(E) -> Failure<E>;

/// Holds a T if ok(), otherwise an E. The text of a std::string error is one sentence for a user: what was
/// found, what was expected, what to do.
template <class T, class E = std::string>
class [[nodiscard]] Result {
 public:
  Result(T value) : held_(std::in_place_index<0>, std::move(value)) {}
  Result(Failure<E> failure) : held_(std::in_place_index<1>, std::move(failure.error)) {}

  bool ok() const { return held_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return there(std::get_if<0>(&held_)); }
  const T& value() const& { return there(std::get_if<0>(&held_)); }
  T&& value() && { return std::move(there(std::get_if<0>(&held_))); }
  T& operator*() { return value(); }
  const T& operator*() const { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const E& error() const { return there(std::get_if<1>(&held_)); }

 private:
  template <class P>
  static P& there(P* held) {
    assert(held);
    return *held;
  }

  std::variant<T, E> held_;
};

/// Success without a value.
using Status = Result<std::monostate>;
inline Status success() { return std::monostate{}; }
inline Failure<std::string> failure(std::string text) { return {std::move(text)}; }

}  // namespace polhode

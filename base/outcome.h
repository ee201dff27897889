// SPDX-License-Identifier: MIT
// A value, or an error that also says whose fault it is: for work whose failures end a program in different
// ways.
#pragma once

#include "base/result.h"

namespace polhode {

enum class Fault : unsigned char {
  failed,  ///< of the machine: a missing file, font or context, a full disk; also what cannot be computed
  usage,   ///< of what was asked for
  invalid  ///< of the lesson, the body or the state
};

struct Error {
  std::string text;  ///< as that of a Result
  Fault fault = Fault::failed;
};

template <class T>
using Outcome = Result<T, Error>;
/// Success without a value.
using Done = Outcome<std::monostate>;
inline Done done() { return std::monostate{}; }

inline Failure<Error> failure_of(Fault fault, std::string text) { return {{std::move(text), fault}}; }

/// The error of a result that is none, where the machine is to blame.
template <class T>
Failure<Error> failed(const Result<T>& result) {
  return {{result.error()}};
}
template <class T>
Outcome<T> outcome_of(Result<T>&& result) {
  if (!result) return failed(result);
  return std::move(result).value();
}

template <class T>
Failure<Error> passed_on(const Outcome<T>& outcome) {
  return {outcome.error()};
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
// The value of a Result, or the end of the command.
#pragma once

#include "app/cli/exit_codes.h"
#include "base/outcome.h"

#include <utility>

namespace polhode {

/// @throws CommandError failed, with the result's error
template <class T>
T or_fail(Result<T>&& result) {
  if (!result) throw CommandError(ExitCode::failed, result.error());
  return std::move(result).value();
}

/// The same, with the exit code of whose fault it is. @throws CommandError
template <class T>
T or_fail(Outcome<T>&& outcome) {
  if (!outcome) throw CommandError(exit_code_of(outcome.error().fault), outcome.error().text);
  return std::move(outcome).value();
}

/// The same where what was asked for is malformed, unknown or out of range. @throws CommandError usage
template <class T>
T or_usage(Result<T>&& result) {
  if (!result) throw CommandError(ExitCode::usage, result.error());
  return std::move(result).value();
}

}  // namespace polhode

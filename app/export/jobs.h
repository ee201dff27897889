// SPDX-License-Identifier: MIT
// Parts of one work in processes of their own, on this machine.
#pragma once

#include "base/interrupt.h"
#include "base/outcome.h"

#include <cstddef>
#include <functional>
#include <string>

namespace polhode {

/// Told by a job before each piece of its work.
using TellJob = std::function<void()>;

/// How a job ended that did not fail.
enum class JobEnd : unsigned char { done, interrupted };

/// Runs job(0) … job(jobs − 1), each in a forked process; waits for all of them. Call before this process has
/// threads or OpenGL. `told(n)` is called here when n pieces were begun in all. An interruption is passed on
/// to all jobs, and so is the death of this process. If a job fails or is killed, the others are interrupted.
/// @returns interrupted if a job was; fails with the error of the first job that did
Outcome<JobEnd> run_jobs(int jobs, const std::function<Outcome<JobEnd>(int job, const TellJob&)>& job,
                         const std::function<void(std::size_t)>& told, const InterruptWatch& watch);

}  // namespace polhode

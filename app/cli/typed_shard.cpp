// SPDX-License-Identifier: MIT
#include "app/cli/typed_shard.h"

#include "app/cli/exit_codes.h"
#include "app/cli/numbers.h"
#include "base/numbers.h"

#include <fmt/format.h>

#include <cstdlib>

namespace polhode {

namespace {

constexpr const char* kForm = "write it like 2/8 (the second of eight), or slurm";

std::int64_t slurm_number(const char* name) {
  const char* value = std::getenv(name);
  if (!value || !*value)
    throw CommandError(
        ExitCode::usage,
        fmt::format("--shard slurm: {} is not set; it is for the tasks of sbatch --array", name));
  constexpr long long kMost = 1'000'000'000;
  return whole_number(std::string("--shard slurm: ") + name, value, 0, kMost);
}

Shard slurm_shard() {
  const std::int64_t id = slurm_number("SLURM_ARRAY_TASK_ID"), least = slurm_number("SLURM_ARRAY_TASK_MIN"),
                     step = slurm_number("SLURM_ARRAY_TASK_STEP"),
                     count = slurm_number("SLURM_ARRAY_TASK_COUNT");
  const bool a_range = step > 0 && id >= least && (id - least) % step == 0 && (id - least) / step < count;
  if (!a_range)
    throw CommandError(ExitCode::usage,
                       fmt::format("--shard slurm: task {} is none of {} tasks from {} in steps of {}; the "
                                   "array has to be a range, like --array=1-8",
                                   id, count, least, step));
  return {(id - least) / step + 1, count};
}

}  // namespace

Shard shard_from(const std::string& typed) {
  if (typed.empty()) return {};
  if (typed == "slurm") return slurm_shard();
  const auto terms = split(typed, '/');
  if (terms.size() != 2)
    throw CommandError(ExitCode::usage, fmt::format("--shard: \"{}\" is no shard; {}", typed, kForm));
  const std::int64_t count = whole_number("--shard", terms[1], 1, kMostShards);
  return {whole_number("--shard", terms[0], 1, count), count};
}

}  // namespace polhode

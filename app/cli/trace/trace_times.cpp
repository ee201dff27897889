// SPDX-License-Identifier: MIT
#include "app/cli/trace/trace_times.h"

#include "app/cli/exit_codes.h"
#include "app/cli/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polhode {

namespace {

/// Whether a way was chosen; all its options must then be there.
bool chosen(std::initializer_list<std::pair<const char*, const std::string*>> options) {
  const auto given = [](const auto& option) { return !option.second->empty(); };
  if (std::none_of(options.begin(), options.end(), given)) return false;
  for (const auto& option : options)
    if (!given(option)) throw usage(fmt::format("{} is missing", option.first));
  return true;
}

std::int64_t step_count(double from_s, double to_s, double every_s) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;  // 2⁻⁵³
  if (every_s == 0) throw usage("--every: 0 never arrives; give a step in seconds");
  const double steps = std::floor((to_s - from_s) / every_s * (1 + 4 * kEpsilon));
  if (!(steps >= 0)) throw usage("--every leads away from --to: no time lies between");
  if (steps >= static_cast<double>(kMaxTraceRows))
    throw usage(fmt::format("more than {} rows", kMaxTraceRows));
  return static_cast<std::int64_t>(steps) + 1;
}

}  // namespace

double TraceTimes::operator()(std::int64_t i) const {
  if (!listed_.empty()) return listed_[static_cast<std::size_t>(i)];
  if (every_s_ != 0) return from_s_ + static_cast<double>(i) * every_s_;
  return i == 0 ? from_s_ : from_s_ + static_cast<double>(i) * whole_s_ / static_cast<double>(count_ - 1);
}

double TraceTimes::furthest_s() const {
  double furthest = std::max(std::abs((*this)(0)), std::abs((*this)(count_ - 1)));
  for (double t_s : listed_) furthest = std::max(furthest, std::abs(t_s));
  return furthest;
}

TraceTimes trace_times(const TypedTimes& typed, double period_s, double duration_s) {
  const bool says_no_span = typed.times.empty() && typed.from.empty() && typed.to.empty() &&
                            typed.every.empty() && typed.periods.empty();
  if (says_no_span && duration_s > 0) {
    TraceTimes times;
    times.count_ =
        typed.samples.empty() ? kUsualTraceRows : whole_number("--samples", typed.samples, 2, kMaxTraceRows);
    times.whole_s_ = duration_s;
    return times;
  }
  const bool listed = !typed.times.empty();
  const bool has_every = !typed.every.empty(), has_samples = !typed.samples.empty();
  const bool from_to = chosen({{"--from", &typed.from}, {"--to", &typed.to}});
  const bool of_periods = !typed.periods.empty();
  const bool is_one_way = listed ? !from_to && !of_periods && !has_every && !has_samples
                                 : from_to != of_periods && !(has_every && (has_samples || of_periods));
  if (!is_one_way)
    throw usage(
        "give the times in one way: --times, or --from --to with --every or --samples, or --periods "
        "--samples");
  if (from_to && !has_every && !has_samples) throw usage("--every, or --samples, is missing");
  if (of_periods && !has_samples) throw usage("--samples is missing");

  TraceTimes times;
  if (listed) {
    times.listed_ = finite_numbers("--times", typed.times);
    times.count_ = static_cast<std::int64_t>(times.listed_.size());
    return times;
  }
  if (has_samples) times.count_ = whole_number("--samples", typed.samples, 2, kMaxTraceRows);
  if (from_to) {
    times.from_s_ = finite_number("--from", typed.from);
    const double to_s = finite_number("--to", typed.to);
    times.whole_s_ = to_s - times.from_s_;
    if (!std::isfinite(times.whole_s_)) throw usage("--from and --to are farther apart than a double holds");
    if (has_every) {
      times.every_s_ = finite_number("--every", typed.every);
      times.count_ = step_count(times.from_s_, to_s, times.every_s_);
    }
  } else {
    const double periods = finite_number("--periods", typed.periods);
    if (!(period_s > 0)) throw usage("--periods: a body at rest has no period; use --times or --from --to");
    times.whole_s_ = periods * period_s;
  }
  return times;
}

}  // namespace polhode

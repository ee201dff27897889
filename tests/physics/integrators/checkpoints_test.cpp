// SPDX-License-Identifier: MIT
#include "physics/integrators/checkpoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <thread>

namespace polhode {
namespace {

using Counter = Checkpoints<std::int64_t>;

bool always(const std::int64_t&) { return true; }

Counter::Advance single(std::function<std::int64_t(std::int64_t)> step) {
  return [step = std::move(step)](std::int64_t& y, std::int64_t n) {
    for (; n > 0; --n) y = step(y);
  };
}

TEST(Checkpoints, GiveTheStateAfterAnyNumberOfStepsInAnyOrder) {
  const Counter path(7, single([](std::int64_t y) { return y + 3; }), always);
  std::vector<std::int64_t> wanted{0, 1, 15, 16, 17, 63, 64, 1000, 5000, 12345};
  std::shuffle(wanted.begin(), wanted.end(), std::mt19937(1));
  for (const std::int64_t k : wanted) EXPECT_EQ(path.after(k), 7 + 3 * k);
  for (const std::int64_t k : wanted) EXPECT_EQ(path.after(k), 7 + 3 * k);
}

TEST(Checkpoints, RevisitsAreCheapAlsoAfterThinning) {
  std::int64_t steps = 0;
  const Counter path(0, single([&steps](std::int64_t y) {
                       ++steps;
                       return y + 1;
                     }),
                     always);
  const std::int64_t far = 5 * Counter::kFirstSpacing * static_cast<std::int64_t>(Counter::kMaxSaved);
  EXPECT_EQ(path.after(far), far);
  EXPECT_LE(steps, far + far / 8192 + 16);
  for (const std::int64_t k : {far, far / 2, far / 3, std::int64_t{0}, std::int64_t{100'000}}) {
    steps = 0;
    EXPECT_EQ(path.after(k), k);
    EXPECT_LE(steps, far / 8192 + 16) << k;
  }
}

TEST(Checkpoints, EndWhereTheStateDiesAndDoNotStepOn) {
  std::int64_t steps = 0;
  const Counter path(0, single([&steps](std::int64_t y) {
                       ++steps;
                       return y + 1;
                     }),
                     [](const std::int64_t& y) { return y < 1000; });
  EXPECT_EQ(path.after(999), 999);
  EXPECT_EQ(path.after(1000), std::nullopt);
  EXPECT_EQ(path.after(1'000'000'000'000), std::nullopt);
  EXPECT_LE(steps, 3000);
  EXPECT_EQ(path.after(998), 998);
}

TEST(Checkpoints, FindTheLastStateBefore) {
  const auto triple = single([](std::int64_t y) { return y + 3; });
  const Counter path(0, triple, always);
  std::vector<std::int64_t> wanted{0, 1, 2, 3, 47, 48, 49, 50, 2999, 3000, 3001};
  std::shuffle(wanted.begin(), wanted.end(), std::mt19937(2));
  for (const std::int64_t x : wanted) {
    const auto at_or_before = [x](std::int64_t y) { return y <= x; };
    EXPECT_EQ(path.last_before(at_or_before, 10'000), x / 3 * 3) << x;
  }
}

// The limit is a number of steps, to the step, whatever was computed before.
TEST(Checkpoints, LookNoFurtherThanAsked) {
  const auto next = single([](std::int64_t y) { return y + 1; });
  const auto last_up_to = [](const Counter& path, std::int64_t x, std::int64_t k_end) {
    return path.last_before([x](std::int64_t y) { return y <= x; }, k_end);
  };
  const Counter fresh(0, next, always), used(0, next, always);
  used.after(5 * Counter::kFirstSpacing * static_cast<std::int64_t>(Counter::kMaxSaved));
  for (const Counter* path : {&fresh, &used}) {
    EXPECT_EQ(last_up_to(*path, 99, 100), 99);
    EXPECT_EQ(last_up_to(*path, 100, 100), std::nullopt);
    EXPECT_EQ(last_up_to(*path, 1'000'000'000'000, 100), std::nullopt);
    EXPECT_EQ(last_up_to(*path, 0, 1), 0);
    EXPECT_EQ(last_up_to(*path, 0, 0), std::nullopt);
  }
}

TEST(Checkpoints, HaveNothingBeforeWhatIsPastTheEnd) {
  const Counter path(0, single([](std::int64_t y) { return y + 1; }),
                     [](const std::int64_t& y) { return y < 1000; });
  const auto last_up_to = [&path](std::int64_t x) {
    return path.last_before([x](std::int64_t y) { return y <= x; }, 1'000'000'000);
  };
  EXPECT_EQ(last_up_to(998), 998);
  EXPECT_EQ(last_up_to(999), std::nullopt);  // no one knows what comes after it
  EXPECT_EQ(last_up_to(5000), std::nullopt);
  EXPECT_EQ(last_up_to(0), 0);
}

TEST(Checkpoints, ServeManyThreadsTheSame) {
  const Counter path(1, single([](std::int64_t y) { return (y * 48271) % 2147483647; }), always);
  const Counter alone(1, single([](std::int64_t y) { return (y * 48271) % 2147483647; }), always);
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (unsigned seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      std::mt19937 engine(seed);
      for (int i = 0; i < 200; ++i) {
        const std::int64_t k = engine() % 20000;
        if (path.after(k) != alone.after(k)) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace polhode

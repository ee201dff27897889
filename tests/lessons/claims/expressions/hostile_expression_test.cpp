// SPDX-License-Identifier: MIT
// Expressions that are meant to break what reads or proves them.
#include "lessons/claims/proof/proof.h"
#include "lessons/reader/claim_lines.h"
#include "tests/fuzz/mutate.h"
#include "tests/lessons/peak_memory.h"
#include "tests/lessons/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

namespace polhode {
namespace {

using testing::equality;

const Prover& prover() {
  static const Prover one;
  return one;
}

constexpr std::size_t kMebibyte = std::size_t{1} << 20;
constexpr double kMaxMilliseconds = 10;
constexpr long kMaxKilobytes = 16 * 1024;

std::string repeated(const std::string& unit, std::size_t count) {
  std::string text;
  text.reserve(unit.size() * count);
  for (std::size_t i = 0; i < count; ++i) text += unit;
  return text;
}
std::string filled(const std::string& unit) { return repeated(unit, kMebibyte / unit.size()); }

/// As `polhode answer` and a claim read it, report included.
bool is_read(const std::string& text) {
  const SourceText source(text);
  Report report(source, "text");
  return read_expression(text, {1, 1}, report).has_value();
}

/// Processor time; the least of some runs, for a machine with other things to do.
template <class Work>
double milliseconds(const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 3; ++run) {
    const std::clock_t start = std::clock();
    work();
    least = std::min(least, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return least;
}

struct Hostile {
  const char* name;
  std::string text;
};

std::vector<Hostile> hostile_expressions() {
  return {
      {"ten thousand brackets", repeated("(", 10000) + "w1" + repeated(")", 10000)},
      {"brackets that fit and are too deep", repeated("(", 2000) + "w1" + repeated(")", 2000)},
      {"brackets that never close", repeated("(", 4000)},
      {"calls in calls", repeated("inertia(", 400) + "L" + repeated(")", 400)},
      {"ten thousand minus signs", repeated("-", 10000) + "w1"},
      {"minus signs and nothing", repeated("-", 4000)},
      {"a power of a power of a power", "(((w1^16)^16)^16)^16"},
      {"2^(10^9)", "2^(10^9)"},
      {"2^1000000000", "2^1000000000"},
      {"2^99999999999999999999", "2^99999999999999999999"},
      {"powers of powers", "w1" + repeated("^16", 1000)},
      {"1e999999", "1e999999"},
      {"1e-999999", "1e-999999"},
      {"1e99999999999999999999", "1e99999999999999999999"},
      {"sixteen digits", "1234567890123456"},
      {"digits behind zeros", repeated("0", 4000) + "1.5e-19"},
      {"fractions of fractions", repeated("(1/", 65) + "w1" + repeated(")", 65)},
      {"products of sums", repeated("(T/I1+", 64) + "w1" + repeated(")/w2", 64) + "^2" + repeated("*L", 300)},
      {"a mebibyte of digits", filled("7")},
      {"a mebibyte of names", filled("omega")},
      {"a mebibyte of names and spaces", filled("omega ")},
      {"a mebibyte of plus signs", filled("+")},
      {"a mebibyte of sums", filled("L+")},
      {"a mebibyte of brackets", filled("(")},
      {"a mebibyte of commas", filled(",")},
      {"a mebibyte of unicode", filled("ω×")},
      {"a mebibyte of broken unicode", filled("\xE2\x83")},
      {"a mebibyte of high bytes", filled("\xFF")},
      {"a mebibyte of NUL", filled(std::string(1, '\0'))},
      {"a mebibyte of spaces", filled(" ")},
      {"a mebibyte of line ends", filled("\n")},
      {"NUL", std::string("w1\0+ w2", 7)},
      {"a long unknown name", repeated("w", 4000)},
      {"a long unknown function", repeated("c", 4000) + "(L)"},
      {"broken unicode", "L + \xE2\x83"},
      {"nothing", ""},
  };
}

TEST(HostileExpression, IsRefusedAtOnceAndInLittleMemory) {
  double slowest = 0;
  long largest = 0;
  for (const auto& [name, text] : hostile_expressions()) {
    EXPECT_FALSE(is_read(text)) << name;
    if (testing::kSanitized) continue;
    const std::string& bytes = text;
    const double took = milliseconds([&bytes] { is_read(bytes); });
    const long kilobytes = testing::peak_kilobytes([&bytes] { return is_read(bytes) ? 1U : 0U; });
    EXPECT_LT(took, kMaxMilliseconds) << name;
    EXPECT_GE(kilobytes, 0) << name;
    EXPECT_LT(kilobytes, kMaxKilobytes) << name;
    slowest = std::max(slowest, took);
    largest = std::max(largest, kilobytes);
  }
  std::printf("%zu hostile expressions: refused in at most %.2f ms and %ld KiB\n",
              hostile_expressions().size(), slowest, largest);
}

/// As large as can be read.
std::vector<Hostile> largest_expressions() {
  const auto fit = [](const std::string& unit, const std::string& last) {
    constexpr std::size_t kRoomForAFactor = 64;
    return repeated(unit, (kMaxExpressionBytes - kRoomForAFactor - last.size()) / unit.size()) + last;
  };
  return {
      {"minus signs", fit("-", "w1")},
      {"a sum", fit("L+", "L")},
      {"a sum of powers", fit("w1^16+", "T")},
      {"a product", fit("2*", "w1")},
      {"the tensors", fit("inertia(A)+", "A")},
      {"components", fit("comp(A,1)+", "T")},
      {"divisors", fit("1/T+", "T")},
      {"a lap of honour", repeated("inertia(", 60) + "L" + repeated(")", 60)},
      {"a large power", "((w1^16)^16)^15"},
  };
}

// What can be read can be proved, in bounded time, too: what fails costs the search for a counterexample,
// which the factor in front hides from all small whole numbers.
TEST(HostileExpression, WhatCanBeReadIsSettledAndRefutedInBoundedTime) {
  const std::string hidden = "w1*(w1 - 1)*(w1 - 2)*(N1 + dw1 + I1 + m)";
  double longest_proof = 0, longest_search = 0;
  for (const auto& [name, text] : largest_expressions()) {
    ASSERT_TRUE(is_read(text)) << name;
    const Equality self = {equality(text, "0").left, equality(text, "0").left};
    EXPECT_NE(prover().settle(self, LawsAssumed::free), Verdict::fails) << name;
    const double proof = milliseconds([&] { prover().settle(self, LawsAssumed::free); });
    const Equality search = equality(hidden + "*(" + text + ")", "0");
    EXPECT_FALSE(prover().refute(search, LawsAssumed::identity)) << name;
    const double look = milliseconds([&] { (void)prover().refute(search, LawsAssumed::identity); });
    if (testing::kSanitized) continue;
    EXPECT_LT(proof, 200) << name;
    EXPECT_LT(look, 1000) << name;
    longest_proof = std::max(longest_proof, proof);
    longest_search = std::max(longest_search, look);
  }
  std::printf("expressions of %zu bytes: settled in at most %.1f ms, searched in at most %.0f ms\n",
              kMaxExpressionBytes, longest_proof, longest_search);
}

/// base^(p − 1) with p = 2⁶¹ − 1: by Fermat 1 modulo p.
std::string power_of_fermat(std::string text) {
  const auto power = [](const std::string& base, int n) { return "(" + base + ")^" + std::to_string(n); };
  // x^(ab + 1) = (x^a)^b x, for what no exponent reaches: 1321, 331, 151, 61, 41, 31.
  for (const auto& factors :
       std::vector<std::vector<int>>{{12, 11, 10}, {15, 11, 2}, {15, 10}, {15, 4}, {10, 4}, {15, 2}}) {
    std::string high = text;
    for (const int n : factors) high = power(high, n);
    text = high + "*(" + text + ")";
  }
  for (const int n : {2, 9, 5, 5, 7, 11, 13}) text = power(text, n);
  return text;
}

// 2⁶¹ − 1 is 0 in the field, and no zero; neither large terms beside it nor what leaves the range of doubles
// may hide that.
TEST(HostileExpression, TheProverIsNotDeceivedByThePrime) {
  const std::string p = "((2^15)^4*2 - 1)", wide_p = "(((2^15)^8)*2^7 - 1)";
  for (const std::string& zero_in_the_field :
       {p + "*T", p + "*T + 1e18*1e18*w1 - 1e18*1e18*w1", p + "*T*(1e18^16)^2", p + "*(1e18^16)^16*T",
        p + "*T/1e18", p + "*" + p + "*T", p + "*" + wide_p + "*T", p + "*" + wide_p + "*T*1e18^16",
        "(1 + T)*" + p, power_of_fermat("3") + " - 1"})
    for (const LawsAssumed laws : {LawsAssumed::identity, LawsAssumed::motion, LawsAssumed::free}) {
      ASSERT_LE(zero_in_the_field.size(), kMaxExpressionBytes);
      EXPECT_NE(prover().settle(equality(zero_in_the_field, "0"), laws), Verdict::holds) << zero_in_the_field;
    }
  EXPECT_NE(prover().settle(equality("T/" + p, "0"), LawsAssumed::identity), Verdict::holds);
  EXPECT_NE(prover().settle(equality("(" + p + "*T)^2", p + "*T"), LawsAssumed::identity), Verdict::holds);
}

TEST(HostileExpression, LargeNumbersAndPowersAreStillProved) {
  for (const auto& [left, right] : std::vector<std::pair<const char*, const char*>>{
           {"123456789012345*T + 100000000000000*T", "223456789012345*T"},
           {"6.674e-11*m*5.972e17*w1", "39857128*m*w1"},
           {"(w1 + w2)^16", "((w1 + w2)^2)^8"},
           {"norm2(L)^8", "dot(L, L)^8"},
           {"0.1*T + 0.2*T + 0.3*T + 0.4*T + 0.5*T + 0.6*T", "2.1*T"},
           {"1e18*T/1e18", "T"}})
    EXPECT_EQ(prover().settle(equality(left, right), LawsAssumed::identity), Verdict::holds) << left;
  EXPECT_EQ(prover().settle(equality("T^16", "T^16*1.00000000000001"), LawsAssumed::identity),
            Verdict::fails);
}

TEST(HostileExpression, MutatedClaimsAreReadOrRefusedAndSettled) {
  fuzz::Mutator lines(
      {"ddt(L) = star(L) + cross(omega, L)", "I1*dw1 + w2*w3*(I3 - I2) = N1",
       "norm2(cross(omega, L)) + dot(omega, L)^2 = norm2(omega)*norm2(L)",
       "T = (I1*w1^2 + I2*w2^2 + I3*w3^2)/2", "comp(apply(J, A), 2)/1.5e-3 = trace(J)^(-2)",
       "dot(L, ddt(L)) = 0 => ddt(L) = 0"},
      {"(",     ")",  "+",    "-",      "*",     "/",         "^",  "=",    "=>",          ",",   " ",
       "omega", "L",  "ddt(", "cross(", "J",     "apply(J, ", "1e", "^16",  "0",           "1/0", ".",
       "\n",    "w1", "dw2",  "N",      "comp(", ", 3)",      "ω",  "\xFF", "within 1e-9", "-("},
      2026);
  int read = 0, refused = 0;
  for (int n = 0; n < 3000; ++n) {
    const std::string line = lines.next();
    const SourceText source(line);
    Report report(source, "text");
    const auto claims = read_claim_lines(source, 1, source.line_count(), ClaimKind::motion, report);
    for (const ClaimLine& claim : claims) {
      ++read;
      const Verdict verdict = prover().settle(claim.equality, LawsAssumed::motion);
      const bool refuted = verdict == Verdict::holds && prover().refute(claim.equality, LawsAssumed::motion);
      EXPECT_FALSE(refuted) << line;
    }
    for (const Diagnostic& d : report.take()) {
      ++refused;
      EXPECT_FALSE(d.message.empty()) << line;
      EXPECT_EQ(source.clamp(d.place), d.place) << line;
    }
  }
  std::printf("mutated claims: %d read and settled, %d refused\n", read, refused);
  EXPECT_GT(read, 300);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace polhode

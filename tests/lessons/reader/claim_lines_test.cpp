// SPDX-License-Identifier: MIT
#include "lessons/reader/claim_lines.h"

#include "tests/lessons/support.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace polhode {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::TextReport;

std::vector<ClaimLine> lines_from(TextReport& at, ClaimKind kind) {
  return read_claim_lines(at.source, 1, at.source.line_count(), kind, at.report);
}

TEST(ClaimKind, NamesGoBothWays) {
  for (const std::string& name : claim_kind_names()) EXPECT_EQ(name_of(*claim_kind_from(name)), name);
  EXPECT_EQ(claim_kind_from("theorem"), std::nullopt);
  EXPECT_EQ(name_of(ClaimKind::non_sequitur), "non-sequitur");
  EXPECT_EQ(name_of(ClaimKind::is_false), "false");
}

TEST(ClaimLines, SplitAtTheEqualsSign) {
  TextReport at("  ddt(L) = star(L) + cross(omega, L)\n\nddt(L)=N");
  const auto claims = lines_from(at, ClaimKind::motion);
  EXPECT_THAT(at.lines(), IsEmpty());
  ASSERT_THAT(claims, SizeIs(2));
  EXPECT_EQ(claims[0].equality.left.text, "ddt(L)");
  EXPECT_EQ(claims[0].equality.right.text, "star(L) + cross(omega, L)");
  EXPECT_EQ(claims[0].place, (SourcePlace{1, 3}));
  EXPECT_EQ(claims[1].equality.right.text, "N");
  EXPECT_EQ(claims[1].place, (SourcePlace{3, 1}));
  EXPECT_FALSE(claims[1].within);
}

TEST(ClaimLines, TakeATolerance) {
  TextReport at("T = dot(omega, L)/2 within 1e-9");
  const auto claims = lines_from(at, ClaimKind::measured);
  ASSERT_THAT(claims, SizeIs(1));
  EXPECT_EQ(claims[0].within, 1e-9);
  EXPECT_EQ(claims[0].equality.right.text, "dot(omega, L)/2");
}

TEST(ClaimLines, ReadPremiseAndConclusion) {
  TextReport at("dot(L, ddt(L)) = 0 => ddt(L) = 0");
  const auto claims = lines_from(at, ClaimKind::non_sequitur);
  ASSERT_THAT(claims, SizeIs(1));
  EXPECT_EQ(claims[0].equality.left.text, "dot(L, ddt(L))");
  EXPECT_EQ(claims[0].equality.right.text, "0");
  ASSERT_TRUE(claims[0].conclusion);
  EXPECT_EQ(claims[0].conclusion->left.text, "ddt(L)");
}

struct Wrong {
  ClaimKind kind;
  const char* line;
  const char* begins;
};
class ClaimLinesReport : public ::testing::TestWithParam<Wrong> {};
TEST_P(ClaimLinesReport, AndLeaveOut) {
  TextReport at(GetParam().line);
  EXPECT_THAT(lines_from(at, GetParam().kind), IsEmpty());
  const auto lines = at.lines();
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_EQ(lines[0].substr(0, std::string(GetParam().begins).size()), GetParam().begins);
}
INSTANTIATE_TEST_SUITE_P(
    All, ClaimLinesReport,
    ::testing::Values(
        Wrong{ClaimKind::law, "L", "1:1: error: a claim reads left = right"},
        Wrong{ClaimKind::law, "L =", "1:4: error: an expression is missing"},
        Wrong{ClaimKind::law, "= L", "1:1: error: an expression is missing"},
        Wrong{ClaimKind::law, "L = N = 0", "1:7: error: unknown character \"=\""},
        Wrong{ClaimKind::is_false, "L = N => T = 0", "1:7: error: what follows is neither"},
        Wrong{ClaimKind::law, "L = N within 1", "1:7: error: \"within\" is for"},
        Wrong{ClaimKind::law, "T = norm(L)", "1:1: error: a length is a root"},
        Wrong{ClaimKind::law, "w1*norm(L) = norm(N)", "1:1: error: a length is a root"},
        Wrong{ClaimKind::law, "norm(norm(N)*L) = norm(N)", "1:1: error: a length is a root"},
        Wrong{ClaimKind::non_sequitur, "T = 0 => norm(L) = 1", "1:10: error: a length is a root"},
        Wrong{ClaimKind::measured, "L = N within", "1:13: error: \"within\" takes"},
        Wrong{ClaimKind::measured, "L = N within 0", "1:14: error: \"within\" takes"},
        Wrong{ClaimKind::measured, "L = N within inf", "1:14: error: \"within\" takes"},
        Wrong{ClaimKind::non_sequitur, "L = N", "1:1: error: a non-sequitur reads"},
        Wrong{ClaimKind::non_sequitur, "L = N => L", "1:10: error: a claim reads left = right"}));

TEST(ClaimLines, ReportBothSides) {
  TextReport at("foo = bar");
  lines_from(at, ClaimKind::law);
  EXPECT_THAT(at.lines(), SizeIs(2));
}

TEST(ClaimLines, EndAtTheLimit) {
  std::string text;
  for (std::size_t i = 0; i < kMaxClaimLines; ++i) text += "L = L\n";
  TextReport good(text);
  EXPECT_THAT(lines_from(good, ClaimKind::law), SizeIs(kMaxClaimLines));
  EXPECT_THAT(good.lines(), IsEmpty());
  TextReport bad(text + "L = L\n");
  lines_from(bad, ClaimKind::law);
  EXPECT_THAT(bad.lines(), ElementsAre("65:1: error: a claim has at most 64 lines"));
}

TEST(ClaimLines, TakeLengthsWhereTheyCanBeSettled) {
  TextReport whole("norm(ddt(omega)) = norm(star(omega))");
  EXPECT_THAT(lines_from(whole, ClaimKind::identity), SizeIs(1));
  TextReport anywhere("dot(omega, L)/norm(L) = 2*T/norm(L)");
  EXPECT_THAT(lines_from(anywhere, ClaimKind::measured), SizeIs(1));
  EXPECT_THAT(whole.lines(), IsEmpty());
  EXPECT_THAT(anywhere.lines(), IsEmpty());
}

}  // namespace
}  // namespace polhode

// SPDX-License-Identifier: MIT
// What the programs of examples/ print is true. Expectations are computed here, from other formulas than the
// library's where there are any.
#include "tests/support/paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace polhode {
namespace {

using std::numbers::pi;
using Triple = std::array<double, 3>;

constexpr double kEps = 0x1p-53;

struct Outcome {
  int code;
  std::string out;
};

Outcome run(const std::string& program) {
  Outcome run{-1, {}};
  FILE* pipe = popen((POLHODE_EXAMPLES "/" + program).c_str(), "r");
  if (!pipe) return run;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    run.out.append(buffer.data(), count);
  run.code = pclose(pipe);
  return run;
}

std::vector<std::string> lines_of(const std::string& program) {
  const Outcome done = run(program);
  EXPECT_EQ(done.code, 0) << program;
  std::vector<std::string> lines;
  std::istringstream in(done.out);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The numbers of a line, in order; whatever stands between them is passed over.
std::vector<double> numbers_in(const std::string& line) {
  std::vector<double> numbers;
  const char *at = line.c_str(), *end = at + line.size();
  while (at < end) {
    const bool begins = at == line.c_str() || std::string_view(" ,(").find(at[-1]) != std::string_view::npos;
    char* past = nullptr;
    const double number = begins ? std::strtod(at, &past) : 0;
    if (past && past != at) {
      numbers.push_back(number);
      at = past;
    } else {
      ++at;
    }
  }
  return numbers;
}

double two_T(const Triple& I, const Triple& w) {
  return I[0] * w[0] * w[0] + I[1] * w[1] * w[1] + I[2] * w[2] * w[2];
}
double L2(const Triple& I, const Triple& w) {
  return std::pow(I[0] * w[0], 2) + std::pow(I[1] * w[1], 2) + std::pow(I[2] * w[2], 2);
}

Triple box(double a, double b, double c, double mass) {
  return {mass * (b * b + c * c) / 12, mass * (c * c + a * a) / 12, mass * (a * a + b * b) / 12};
}

// Landau & Lifshitz, Mechanics, §37 (37.8)-(37.11), which take I1 < I2 < I3 and L² > 2T I2; otherwise 1 and 3
// change places.
double period_by_landau(Triple I, Triple w) {
  if (L2(I, w) < two_T(I, w) * I[1]) {
    std::swap(I[0], I[2]);
    std::swap(w[0], w[2]);
  }
  const double E2 = two_T(I, w), M2 = L2(I, w);
  const double rate2 = (I[2] - I[1]) * (M2 - E2 * I[0]) / (I[0] * I[1] * I[2]);
  const double k2 = (I[1] - I[0]) * (E2 * I[2] - M2) / ((I[2] - I[1]) * (M2 - E2 * I[0]));
  return 4 * std::comp_ellint_1(std::sqrt(k2)) / std::sqrt(rate2);
}

TEST(TumblingPhone, TurnsOverTwiceAPeriod) {
  const std::vector<std::string> lines = lines_of("tumbling_phone");
  ASSERT_EQ(lines.size(), 5U);
  const double printed = 1e-9;  // the last digit that is printed

  const double period_s = numbers_in(lines[0]).at(0);
  EXPECT_NEAR(period_s, period_by_landau(box(0.147, 0.0715, 0.0078, 0.174), {0.05, 5, 0.05}), 2 * printed);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<double> flip = numbers_in(lines[i]);
    ASSERT_EQ(flip.size(), 4U) << lines[i];
    EXPECT_NEAR(flip[2], 0, 1e-4);
    if (i == 1) continue;
    const std::vector<double> before = numbers_in(lines[i - 1]);
    EXPECT_NEAR(flip[0] - before[0], period_s / 2, 2 * printed);
    EXPECT_EQ(flip[1], -before[1]) << "from one end of the intermediate axis to the other and back";
  }
}

TEST(WorkPrecision, FallsByTheOrderOfTheMethod) {
  const std::vector<std::string> lines = lines_of("work_precision");
  ASSERT_GT(lines.size(), 10U);
  EXPECT_EQ(lines.back(), "cheapest within 1e-6: exact");

  double rk4_before = 0;
  int halvings = 0;
  for (const std::string& line : lines) {
    const std::string method = line.substr(0, line.find(' '));
    if (method != "rk4" && method != "moser-veselov-10" && method != "exact") continue;
    const std::vector<double> row = numbers_in(line);  // step, cost, error, drift of T
    ASSERT_EQ(row.size(), 4U) << line;
    EXPECT_GT(row[1], 0);
    // Moser-Veselov solves its equation to rounding in each step: 100 periods are some thousand of them.
    if (method == "moser-veselov-10") {
      EXPECT_LT(row[3], 2000 * kEps) << line;
    }
    if (method == "exact") {
      EXPECT_LT(row[3], 4e-15) << line;  // asymmetric_motion.h
    }
    if (method != "rk4") continue;
    // Order 4: 2⁴ for each halving; 2⁵ while the drift of T, of order 5, is the larger part.
    if (rk4_before > 0 && rk4_before < 1e-2 && row[2] > 1e-9) {
      EXPECT_GT(rk4_before / row[2], 12) << line;
      EXPECT_LT(rk4_before / row[2], 40) << line;
      ++halvings;
    }
    rk4_before = row[2];
  }
  EXPECT_GE(halvings, 3);
}

TEST(Asteroids, KeepTheirMomentumAndStayIsotropic) {
  const std::vector<std::string> lines = lines_of("asteroids");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[0], testing::StartsWith("1000000 asteroids, 100 days: "));
  // |L| within 4e-15 and its direction within 1e-14 at any time: asymmetric_motion.h.
  EXPECT_LT(numbers_in(lines[1]).back(), 1.4e-14);
  EXPECT_GT(numbers_in(lines[1]).back(), 0);
  const double deviation = std::sqrt(4.0 / 45) / 1000;  // of the mean of cos² over 10⁶ directions
  EXPECT_NEAR(numbers_in(lines[2]).back(), 1.0 / 3, 4 * deviation);
}

TEST(HeavyTop, PrecessesSteadily) {
  const std::vector<std::string> lines = lines_of("heavy_top");
  ASSERT_EQ(lines.size(), 8U);
  const double I1 = 0.0013, I3 = 0.0005, w3 = 200, mgr = 0.5 * 9.81 * 0.04, cosine = std::sqrt(0.75);
  const std::vector<double> head = numbers_in(lines[0]);
  ASSERT_EQ(head.size(), 2U);
  const double W = head[0];
  // W is rounded to 1e-9, which moves the left side by I3 w3 times that.
  EXPECT_NEAR(I1 * W * W * cosine - I3 * w3 * W + mgr, 0, I3 * w3 * 1e-9);
  EXPECT_LT(W, I3 * w3 / (2 * I1 * cosine)) << "the slow root";
  // ω's part across the axis is that of the precession, W sin(tilt).
  const double energy = 0.5 * I1 * W * W * (1 - cosine * cosine) + 0.5 * I3 * w3 * w3 + mgr * cosine;
  EXPECT_NEAR(head[1], energy, 1e-9);

  // What each step adds, 1e-12, grows with the square of the angle turned; the energy's share by that angle.
  const double turned = 5 * w3;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const std::vector<double> now = numbers_in(lines[i]);  // t, azimuth, tilt in degrees, energy
    ASSERT_EQ(now.size(), 4U) << lines[i];
    EXPECT_NEAR(std::remainder(now[1] - (W * now[0] - pi / 2), 2 * pi), 0, 1e-12 * turned * turned);
    EXPECT_NEAR(now[2] * pi / 180, pi / 6, 1e-12 * turned * turned);
    EXPECT_NEAR(now[3], 0, 1e-12 * turned);
  }
}

double distance_to_chord(const Triple& p, const Triple& a, const Triple& b) {
  double along = 0, length2 = 0, distance2 = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    along += (p[i] - a[i]) * (b[i] - a[i]);
    length2 += (b[i] - a[i]) * (b[i] - a[i]);
  }
  const double s = std::clamp(along / length2, 0.0, 1.0);
  for (std::size_t i = 0; i < 3; ++i) distance2 += std::pow(p[i] - std::lerp(a[i], b[i], s), 2);
  return std::sqrt(distance2);
}

TEST(PolhodeCsv, KeepsEnergyAndMomentumAndPassesItsStart) {
  const std::vector<std::string> lines = lines_of("polhode_csv");
  ASSERT_GT(lines.size(), 16U);
  EXPECT_EQ(lines[0], "omega_1_rad_s,omega_2_rad_s,omega_3_rad_s");
  const Triple I = box(0.24, 0.17, 0.03, 0.8), start = {0.4, 5, 0.3};

  std::vector<Triple> points;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<double> row = numbers_in(lines[i]);
    ASSERT_EQ(row.size(), 3U) << lines[i];
    points.push_back({row[0], row[1], row[2]});
    // A sum of three squares of numbers that are some ε wrong.
    EXPECT_NEAR(two_T(I, points.back()) / two_T(I, start), 1, 32 * kEps);
    EXPECT_NEAR(L2(I, points.back()) / L2(I, start), 1, 32 * kEps);
  }
  double nearest = 1;
  for (std::size_t i = 0; i < points.size(); ++i)
    nearest = std::min(nearest, distance_to_chord(start, points[i], points[(i + 1) % points.size()]));
  EXPECT_LT(nearest, 0.01) << "the chord tolerance, rad/s";
}

/// What stands in docs/interface.md between ```text and ```.
std::string output_on_the_page() {
  std::ifstream file(test::source_dir() / "docs/interface.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::string open = "```text\n";
  const std::size_t begin = page.find(open);
  if (begin == page.npos) return "no output on the page";
  return page.substr(begin + open.size(), page.find("```", begin + open.size()) - begin - open.size());
}

TEST(InterfacePage, PrintsWhatItSaysByEitherWay) {
  for (const char* program : {"thrown_book", "thrown_book_by_pkg_config"}) {
    const Outcome done = run(program);
    EXPECT_EQ(done.code, 0);
    EXPECT_EQ(done.out, output_on_the_page()) << program;
  }
}

class PublicHeader : public testing::TestWithParam<const char*> {};

TEST_P(PublicHeader, SufficesForItsExample) { EXPECT_EQ(run("header_" + std::string(GetParam())).code, 0); }

INSTANTIATE_TEST_SUITE_P(All, PublicHeader, testing::Values("body", "motion", "method", "poinsot", "errors"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace polhode

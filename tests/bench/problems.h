// SPDX-License-Identifier: MIT
// The two problems that all benchmarks are run on, with the true states long after the start.
#pragma once

#include "tests/bench/rigid_body_ode.h"

#include <array>
#include <string_view>

namespace polhode::bench {

struct Truth {
  double t_s;
  State y;
};

struct BenchProblem {
  std::string_view name;
  std::array<double, 3> I;  ///< kg m²
  State start;              ///< at t = 0
  double period_s;          ///< of the polhode
  std::array<Truth, 2> truth;

  double periods() const { return truth.back().t_s / period_s; }
};

// The truth is the closed form (Jacobi elliptic functions, Legendre's integral of the third kind) evaluated
// with mpmath in 60 digits for the doubles I, ω0 and t as they are written here. At 1000 periods alone the
// part of an error that comes back with every period would go unseen, hence the second time.
inline constexpr std::array<BenchProblem, 2> kProblems = {
    BenchProblem{"generic",
                 {1, 2, 3},
                 {0.1, 1.5, 0.2, 1, 0, 0, 0},
                 13.250024724900129621,
                 {Truth{13250.02472490013,
                        {0.10000000000003246746, 1.4999999999999978359, 0.20000000000000542142,
                         -0.005647308558095628853, 0.032668055080444072421, 0.98004165241316188284,
                         0.19600833048263514946}},
                  Truth{13254.927234,
                        {-0.88498815188095292956, -1.2152349447865360783, 0.54565069075666122612,
                         -0.16414400680675446883, 0.058394213511696467362, 0.17446404103194883672,
                         0.96912804068635689281}}}},
    BenchProblem{
        "near-separatrix",
        {1, 2, 3},
        {0.34641, 1.5, 0.2, 1, 0, 0, 0},
        44.196015939611114612,
        {Truth{44196.01593961111,
               {0.34641000000074863515, 1.4999999999998271092, 0.20000000000043223809, -0.3266776830686652058,
                -0.1063360370309621597, -0.92089752343389390257, -0.18417950468702918406}},
         Truth{44212.368466,
               {-0.16314668436651860087, 1.5308112383570390917, 0.094192980134382380183,
                -0.31039527051152806328, -0.044764680021636190657, -0.94301794292577450366,
                -0.11121177449657272489}}}}};

}  // namespace polhode::bench

// SPDX-License-Identifier: MIT
#include "physics/integrators/moser_veselov_modification.h"

#include <algorithm>
#include <vector>

namespace polhode {
namespace {

// A polynomial in ρ; no product here has a degree beyond kDegree.
class Polynomial {
 public:
  static constexpr std::size_t kDegree = 8;

  Polynomial(double constant) { c_[0] = constant; }
  Polynomial(double constant, double linear) {
    c_[0] = constant;
    c_[1] = linear;
  }

  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    for (std::size_t i = 0; i <= kDegree; ++i) a.c_[i] += b.c_[i];
    return a;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(0.0);
    for (std::size_t i = 0; i <= kDegree; ++i)
      for (std::size_t j = 0; i + j <= kDegree; ++j) product.c_[i + j] += a.c_[i] * b.c_[j];
    return product;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + Polynomial(-1.0) * b; }

  // This over ρ^p, at ρ; the powers below p vanish.
  double over_power(std::size_t p, double rho) const {
    double sum = 0;
    for (std::size_t i = kDegree + 1; i-- > p;) sum = sum * rho + c_[i];
    return sum;
  }

 private:
  std::array<double, kDegree + 1> c_{};
};

Polynomial power(const Polynomial& a, int n) { return n == 0 ? Polynomial(1.0) : a * power(a, n - 1); }

// S_p = Σ I_i^p; X_p = Σ I_i^−p as XD(p) = X_p D^p; M_ab = Σ (I_i^a + I_j^a) I_k^−b as MD(a, b) = M_ab D^b.
struct SymmetricSums {
  Polynomial I1, I2, I3, D;

  explicit SymmetricSums(double gamma) : I1(0.0, 1.0), I2(1.0, -gamma), I3(1.0), D(I1 * I2 * I3) {}

  Polynomial S(int p) const { return power(I1, p) + power(I2, p) + power(I3, p); }
  Polynomial XD(int p) const { return power(I2 * I3, p) + power(I3 * I1, p) + power(I1 * I2, p); }
  Polynomial MD(int a, int b) const {
    return (power(I1, a) + power(I2, a)) * power(I1 * I2, b) +
           (power(I2, a) + power(I3, a)) * power(I2 * I3, b) +
           (power(I3, a) + power(I1, a)) * power(I3 * I1, b);
  }
};

// Numerators over D^p of N^p, N^(p−1)H, ..., H^p, and the number that divides them all.
struct Term {
  double divisor;
  std::vector<Polynomial> s, e;
};

std::vector<Term> published_terms(const SymmetricSums& f) {
  const auto S = [&f](int p) { return f.S(p); };
  const auto X = [&f](int p) { return f.XD(p); };
  const auto M = [&f](int a, int b) { return f.MD(a, b); };
  const Polynomial& D = f.D;
  return {
      {6, {S(1), -2 * X(1)}, {-2, S(1)}},
      {60,
       {2 * (S(2) - X(1)), 2 * (D - M(1, 1)), 3 * S(1) * D + 2 * X(2)},
       {-1 * S(1), 6 * X(1) - S(2), -9 * D - M(1, 1)}},
      {2520,
       {4 * D + 17 * S(3) - 15 * M(1, 1), 6 * (9 * D * S(1) + 10 * X(2) - 6 * M(2, 1)),
        6 * M(1, 2) - 100 * D * X(1) + 53 * D * S(2), 4 * (15 * D * D - X(3) - 2 * D * M(1, 1))},
       {34 * X(1) - 19 * S(2), 2 * (S(3) + 2 * M(1, 1) - 85 * D), 47 * D * S(1) + 13 * M(2, 1) - 38 * X(2),
        2 * (9 * D * X(1) + M(1, 2) - 11 * D * S(2))}},
      {45360,
       {62 * S(4) - 94 * M(2, 1) + 66 * X(2) + 81 * D * S(1),
        2 * (75 * M(1, 2) - 77 * M(3, 1) + 214 * D * S(2) - 240 * D * X(1)),
        6 * (26 * M(2, 2) + 55 * D * S(3) + 204 * D * D - 50 * X(3) - 59 * D * M(1, 1)),
        4 * (137 * D * X(2) - M(1, 3) + 3 * D * D * S(1) - 69 * D * M(2, 1)),
        2 * X(4) + 5 * D * M(1, 2) - 171 * D * D * X(1) + 159 * D * D * S(2)},
       {60 * M(1, 1) - 61 * S(3) - 247 * D, 54 * D * S(1) - S(4) + 218 * M(2, 1) - 426 * X(2),
        6 * (125 * D * X(1) - 5 * M(3, 1) - 130 * D * S(2) + 4 * M(1, 2)),
        2 * (67 * D * S(3) - 735 * D * D - 15 * M(2, 2) + 87 * D * M(1, 1) + 34 * X(3)),
        165 * D * D * S(1) - M(1, 3) - 9 * D * M(2, 1) - 145 * D * X(2)}},
  };
}

// The same in powers M^a H^(p−a) of N = H + ρM, at ρ: ρ^a Σ_n binomial(n, a) numerator(N^n), divided by
// D^p = ρ^p I_2^p.
double coefficient(const std::vector<Polynomial>& from_N_down, std::size_t a, double divisor, double rho,
                   double I2) {
  const std::size_t p = from_N_down.size() - 1;
  Polynomial sum(0.0);
  double binomial = 1;
  double denominator = divisor;
  for (std::size_t n = a; n <= p; ++n) {
    sum = sum + binomial * from_N_down[p - n];
    binomial *= static_cast<double>(n + 1) / static_cast<double>(n + 1 - a);
  }
  for (std::size_t i = 0; i < p; ++i) denominator *= I2;
  return sum.over_power(p - a, rho) / denominator;
}

}  // namespace

MoserVeselovModification::MoserVeselovModification(const PrincipalMoments& I, int order)
    : terms_(order / 2 - 1) {
  std::array<int, 3> axis{0, 1, 2};
  std::sort(axis.begin(), axis.end(), [&I](int i, int j) { return I[i] < I[j]; });
  const double I1 = I[axis[0]], I2 = I[axis[1]], I3 = I[axis[2]];
  const double rho = I1 / I3, gamma = (I3 - I2) / I1;

  Vec3 H, M;
  H[axis[0]] = 0.5 * rho;
  H[axis[1]] = 0.5 * (I2 / I3);
  H[axis[2]] = 0.5;
  M[axis[0]] = -0.5 * ((I3 - I1) / I3);
  M[axis[1]] = -0.5 * gamma * (I2 / I3);
  M[axis[2]] = 0;
  H_ = triple(H);
  M_ = triple(M);
  relative_I_ = triple(I.vector() / I3);

  const std::vector<Term> terms = published_terms(SymmetricSums(gamma));
  for (std::size_t k = 0; k < static_cast<std::size_t>(terms_); ++k)
    for (std::size_t a = 0; a <= k + 1; ++a) {
      s_[k][a] = coefficient(terms[k].s, a, terms[k].divisor, rho, I2 / I3);
      e_[k][a] = coefficient(terms[k].e, a, terms[k].divisor, rho, I2 / I3);
    }
}

MoserVeselovModification::Factors MoserVeselovModification::operator()(double h, const Triple& w_B) const {
  const Triple turned = h * w_B;
  const Triple squares = times(turned, turned);
  const double H = dot(H_, squares), M = dot(M_, squares);
  double s = 0, e = 0;
  std::array<double, kMostTerms + 1> monomials{1};  // M^a H^(k−a)
  for (std::size_t k = 0; k < static_cast<std::size_t>(terms_); ++k) {
    monomials[k + 1] = M * monomials[k];
    for (std::size_t a = 0; a <= k; ++a) monomials[a] *= H;
    for (std::size_t a = 0; a <= k + 1; ++a) {
      s += s_[k][a] * monomials[a];
      e += e_[k][a] * monomials[a];
    }
  }
  s += 1;
  return {s, {s + e * relative_I_.x, s + e * relative_I_.y, s + e * relative_I_.z}};
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
// Every condition of order, one for each rooted tree: Hairer, Nørsett & Wanner I, §II.2.
#include "physics/integrators/dormand_prince_coefficients.h"

#include "tests/physics/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace polhode {
namespace {

using test::kEps;

struct Tree {
  std::vector<int> subtrees;  // of the root, places in the list, in falling order
  int size;
  double gamma;  // HNW Definition II.2.10
};

void add_trees(std::vector<Tree>& trees, const Tree& tree, int missing) {
  if (missing == 0) {
    Tree whole = tree;
    whole.gamma *= whole.size;
    trees.push_back(whole);
    return;
  }
  const int last = tree.subtrees.empty() ? static_cast<int>(trees.size()) - 1 : tree.subtrees.back();
  for (int i = last; i >= 0; --i) {
    const Tree subtree = trees[static_cast<std::size_t>(i)];
    if (subtree.size > missing) continue;
    Tree larger = tree;
    larger.subtrees.push_back(i);
    larger.gamma *= subtree.gamma;
    add_trees(trees, larger, missing - subtree.size);
  }
}

// All rooted trees of at most `largest` vertices, small ones first.
std::vector<Tree> trees_up_to(int largest) {
  std::vector<Tree> trees;
  for (int size = 1; size <= largest; ++size) add_trees(trees, {{}, size, 1.0}, size - 1);
  return trees;
}

// Worst Σ_i b_i Φ_i(tree) γ(tree) θ^−size − 1 over the trees of each size, in units of what rounding allows
// (Theorem II.2.13).
template <class Pair>
std::vector<double> defects(const std::vector<double>& b, int largest_size, double theta = 1) {
  const std::size_t stages = b.size();
  const std::vector<Tree> trees = trees_up_to(largest_size);
  std::vector<std::vector<double>> phi, phi_size;
  std::vector<double> worst(static_cast<std::size_t>(largest_size) + 1, 0.0);
  for (const Tree& tree : trees) {
    std::vector<double> value(stages, 1.0), size(stages, 1.0);
    for (const int subtree : tree.subtrees) {
      const auto place = static_cast<std::size_t>(subtree);
      for (std::size_t i = 0; i < stages; ++i) {
        double sum = 0, sum_of_sizes = 0;
        for (std::size_t j = 0; j < i; ++j) {
          sum += Pair::a[i][j] * phi[place][j];
          sum_of_sizes += std::abs(Pair::a[i][j]) * phi_size[place][j];
        }
        value[i] *= sum;
        size[i] *= sum_of_sizes;
      }
    }
    phi.push_back(value);
    phi_size.push_back(size);
    double sum = 0, sum_of_sizes = 0;
    for (std::size_t i = 0; i < stages; ++i) {
      sum += b[i] * value[i];
      sum_of_sizes += std::abs(b[i]) * size[i];
    }
    const double defect = std::abs(sum - std::pow(theta, tree.size) / tree.gamma);
    double& of_size = worst[static_cast<std::size_t>(tree.size)];
    of_size = std::max(of_size, defect / (16 * kEps * sum_of_sizes));
  }
  return worst;
}

// All conditions up to `order` hold to rounding; one of the next order is missed by far.
template <class Pair>
void expect_order(const std::vector<double>& b, int order, double theta = 1) {
  const std::vector<double> worst = defects<Pair>(b, order + 1, theta);
  for (int n = 1; n <= order; ++n)
    EXPECT_LE(worst[static_cast<std::size_t>(n)], 1) << "order " << n << " at " << theta;
  EXPECT_GE(worst[static_cast<std::size_t>(order) + 1], 1e6) << theta;
}

template <class Pair>
std::vector<double> solution_weights() {
  std::vector<double> b(Pair::kStages, 0.0);
  for (int j = 0; j < Pair::kStages - 1; ++j) b[static_cast<std::size_t>(j)] = Pair::a[Pair::kStages - 1][j];
  return b;
}

template <class Pair>
std::vector<double> without(const double (&e)[Pair::kStages]) {
  std::vector<double> b = solution_weights<Pair>();
  for (int j = 0; j < Pair::kStages; ++j) b[static_cast<std::size_t>(j)] -= e[j];
  return b;
}

// The nested polynomial of the dense output, of each k_j by itself.
template <class Pair>
std::vector<double> dense_weights(double theta) {
  std::vector<double> b = solution_weights<Pair>();
  b.resize(Pair::kDenseStages, 0.0);
  for (int j = 0; j < Pair::kDenseStages; ++j) {
    const double start = j == 0, end = j == Pair::kStages - 1;
    double& weight = b[static_cast<std::size_t>(j)];
    const double c1 = weight, c2 = start - c1, c3 = c1 - end - c2;
    double upper = 0;
    for (int i = Pair::kDenseTerms - 1; i >= 0; --i)
      upper = Pair::d[i][j] + (i % 2 == 0 ? theta : 1 - theta) * upper;
    weight = theta * (c1 + (1 - theta) * (c2 + theta * (c3 + (1 - theta) * upper)));
  }
  return b;
}

template <class Pair>
void expect_rows_to_sum_to_c() {
  for (int i = 0; i < Pair::kDenseStages; ++i) {
    double sum = 0, sizes = 0;
    for (int j = 0; j < i; ++j) {
      sum += Pair::a[i][j];
      sizes += std::abs(Pair::a[i][j]);
    }
    EXPECT_NEAR(sum, Pair::c[i], 16 * kEps * sizes) << i;
  }
}

TEST(DormandPrinceCoefficients, TreesAreCountedRight) {
  EXPECT_EQ(trees_up_to(5).size(), 17u);  // HNW Table II.2.3
  EXPECT_EQ(trees_up_to(8).size(), 200u);
}

TEST(DormandPrinceCoefficients, CoefficientsOf54MeetTheConditionsOfOrder) {
  using P = DormandPrince54;
  expect_rows_to_sum_to_c<P>();
  expect_order<P>(solution_weights<P>(), 5);
  expect_order<P>(without<P>(P::e), 4);
  for (const double theta : {0.1, 0.3, 0.5, 0.75, 0.9}) expect_order<P>(dense_weights<P>(theta), 4, theta);
}

TEST(DormandPrinceCoefficients, CoefficientsOf853MeetTheConditionsOfOrder) {
  using P = DormandPrince853;
  expect_rows_to_sum_to_c<P>();
  expect_order<P>(solution_weights<P>(), 8);
  expect_order<P>(without<P>(P::e5), 5);
  expect_order<P>(without<P>(P::e3), 3);
  for (const double theta : {0.1, 0.3, 0.5, 0.75, 0.9}) expect_order<P>(dense_weights<P>(theta), 7, theta);
}

}  // namespace
}  // namespace polhode

// SPDX-License-Identifier: MIT
#include "physics/analysis/batch.h"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace polhode {

void states_at(const Motion& motion, std::span<const double> t_s, std::span<RigidBodyState> states,
               unsigned threads) {
  const std::size_t pieces = std::clamp<std::size_t>(threads, 1, std::max<std::size_t>(1, t_s.size()));
  const auto begin_of = [&](std::size_t piece) {
    return t_s.size() / pieces * piece + std::min(piece, t_s.size() % pieces);
  };
  const auto serve = [&](std::size_t piece) {
    const std::size_t begin = begin_of(piece), count = begin_of(piece + 1) - begin;
    motion.at(t_s.subspan(begin, count), states.subspan(begin, count));
  };
  // What leaves a thread ends the program; here it leaves the call, once all threads are done.
  std::vector<std::exception_ptr> thrown(pieces);
  const auto try_to_serve = [&](std::size_t piece) {
    try {
      serve(piece);
    } catch (...) {
      thrown[piece] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t piece = 1; piece < pieces; ++piece) others.emplace_back(try_to_serve, piece);
    try_to_serve(0);
  }
  for (const std::exception_ptr& one : thrown)
    if (one) std::rethrow_exception(one);
}

}  // namespace polhode

// SPDX-License-Identifier: MIT
// The polhode of a tumbling book as CSV: the curve on which the tip of ω runs, seen from the book.
#include <polhode/body.h>
#include <polhode/poinsot.h>

#include <cstdio>

int main() {
  using namespace polhode;
  const Body book = find_body("book").value();
  const Vec3 w_B(0.4, 5, 0.3);  // rad/s: mostly about axis 2, the intermediate one

  // A closed curve; no chord of this polyline is further than 0.01 rad/s from it.
  const Curve curve = polhode_curve(book.moments, w_B, 0.01);
  std::puts("omega_1_rad_s,omega_2_rad_s,omega_3_rad_s");
  for (const Vec3& w : curve.points) std::printf("%.17g,%.17g,%.17g\n", w[0], w[1], w[2]);
}

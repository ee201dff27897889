// SPDX-License-Identifier: MIT
// A phone tossed with a spin about its intermediate axis turns over and over (the Dzhanibekov effect).
#include <polhode/body.h>
#include <polhode/method.h>
#include <polhode/poinsot.h>

#include <cstdio>

int main() {
  using namespace polhode;
  // Axes 1, 2, 3: along the height, the width, the thickness. Axis 2 has the moment between the others, and
  // 5 rad/s about it are disturbed by a hundredth of that.
  const Body phone = find_body("phone").value();
  const Problem toss{phone.moments, {.w_B = {0.05, 5, 0.05}}, {}};
  const auto motion = make_motion(toss, {Method::exact});

  const double period_s = polhode_period(toss.I, toss.start.w_B).value();
  std::printf("period of the polhode %.9f s\n", period_s);
  for (const double t_s : flip_times(*motion, toss.I, 0, 2 * period_s)) {
    const Vec3 w_B = motion->w_B_at(t_s);
    std::printf("flip at %.9f s, where omega_B = (%+.4f, %+.4f, %+.4f) rad/s\n", t_s, w_B[0], w_B[1], w_B[2]);
  }
}

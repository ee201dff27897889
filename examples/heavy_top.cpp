// SPDX-License-Identifier: MIT
// A gyroscope on its stand, set going so that it precesses without nodding.
#include <polhode/body.h>
#include <polhode/method.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main() {
  using namespace polhode;
  // 0.5 kg, the centre of mass 4 cm above the pivot, axis 30° from the vertical, 200 rad/s of spin.
  const PrincipalMoments I(0.0013, 0.0013, 0.0005);  // about the pivot, kg m²
  const double mgr = 0.5 * 9.81 * 0.04, cos_tilt = std::cos(std::acos(-1) / 6), w3 = 200;
  const Quat q_SB(Eigen::AngleAxisd(std::acos(cos_tilt), Vec3::UnitX()));
  // Steady precession at the rate W: I1 W² cos(tilt) - I3 w3 W + mgr = 0 (Goldstein §5.7), the slow root.
  const double L3 = I[2] * w3;
  const double W = 2 * mgr / (L3 + std::sqrt(L3 * L3 - 4 * I[0] * mgr * cos_tilt));
  const Vec3 up_B = q_SB.conjugate() * Vec3::UnitZ();
  const Vec3 w_B = W * up_B + (w3 - W * cos_tilt) * Vec3::UnitZ();

  const Problem top{I, {q_SB, w_B}, {HeavyTop{mgr, Vec3::UnitZ()}}};
  const auto motion = make_motion(top, {Method::dormand_prince_8, {}, 1e-12});
  const auto energy = [&](const RigidBodyState& s) {
    return kinetic_energy(I, s.w_B) + potential_energy(top.torque, s);
  };
  std::printf("precession %.9f rad/s, energy %.9f J\n", W, energy(top.start));
  std::puts("t s   azimuth rad   tilt deg      energy/start - 1");
  for (int t_s = 0; t_s <= 5; ++t_s) {
    const RigidBodyState now = motion->at(t_s);
    const Vec3 axis_S = now.q_SB * Vec3::UnitZ();
    std::printf("%d  %+.9f  %.9f  %+.1e\n", t_s, std::atan2(axis_S.y(), axis_S.x()),
                std::acos(axis_S.z()) * 180 / std::acos(-1), energy(now) / energy(top.start) - 1);
  }
}

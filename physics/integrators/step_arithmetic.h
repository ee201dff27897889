// SPDX-License-Identifier: MIT
// Three and four plain doubles, for the inner loops of the steppers: the compiler keeps them in registers,
// which it does not do with Eigen's vectors (an RK4 step of 7 states took 200 ns with them, 30 without). The
// copies are spelt out because GCC 12 keeps what is copied whole, as a block, in memory (120 ns). Internal to
// physics/.
#pragma once

#include "physics/body/principal_moments.h"
#include "physics/body/state.h"

#include <cmath>

namespace polhode {

struct Triple {
  Triple() = default;
  Triple(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
  Triple(const Triple& other) : x(other.x), y(other.y), z(other.z) {}
  Triple& operator=(const Triple& other) {
    x = other.x, y = other.y, z = other.z;
    return *this;
  }

  double x = 0, y = 0, z = 0;
};
inline Triple operator+(const Triple& a, const Triple& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Triple operator-(const Triple& a, const Triple& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Triple operator*(double f, const Triple& a) { return {f * a.x, f * a.y, f * a.z}; }
inline Triple times(const Triple& a, const Triple& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
inline Triple over(const Triple& a, const Triple& b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
inline double dot(const Triple& a, const Triple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// (a_y b_z, a_z b_x, a_x b_y). Of a with itself these are the products in Euler's equations.
inline Triple pairs(const Triple& a, const Triple& b) { return {a.y * b.z, a.z * b.x, a.x * b.y}; }
/// |x| + |y| + |z|, which is NaN if one of them is; a maximum would hide it.
inline double size(const Triple& a) { return std::abs(a.x) + std::abs(a.y) + std::abs(a.z); }

/// A quaternion s + x i + y j + z k of any length.
struct Quadruple {
  Quadruple() = default;
  Quadruple(double s_, double x_, double y_, double z_) : s(s_), x(x_), y(y_), z(z_) {}
  Quadruple(const Quadruple& other) : s(other.s), x(other.x), y(other.y), z(other.z) {}
  Quadruple& operator=(const Quadruple& other) {
    s = other.s, x = other.x, y = other.y, z = other.z;
    return *this;
  }

  double s = 0, x = 0, y = 0, z = 0;
};
inline Quadruple operator+(const Quadruple& a, const Quadruple& b) {
  return {a.s + b.s, a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Quadruple operator*(double f, const Quadruple& a) { return {f * a.s, f * a.x, f * a.y, f * a.z}; }
inline double dot(const Quadruple& a, const Quadruple& b) {
  return a.s * b.s + a.x * b.x + a.y * b.y + a.z * b.z;
}
/// q ⊗ (c, v).
inline Quadruple product(const Quadruple& q, double c, const Triple& v) {
  return {c * q.s - (q.x * v.x + q.y * v.y + q.z * v.z), c * q.x + (q.s * v.x + (q.y * v.z - q.z * v.y)),
          c * q.y + (q.s * v.y + (q.z * v.x - q.x * v.z)), c * q.z + (q.s * v.z + (q.x * v.y - q.y * v.x))};
}

/// q ⊗ (0, v).
inline Quadruple product(const Quadruple& q, const Triple& v) {
  return {-(q.x * v.x + q.y * v.y + q.z * v.z), q.s * v.x + (q.y * v.z - q.z * v.y),
          q.s * v.y + (q.z * v.x - q.x * v.z), q.s * v.z + (q.x * v.y - q.y * v.x)};
}

inline Triple triple(const Vec3& v) { return {v[0], v[1], v[2]}; }
inline Vec3 vec3(const Triple& v) { return {v.x, v.y, v.z}; }
inline Quadruple quadruple(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }
inline Quat quat(const Quadruple& q) { return {q.s, q.x, q.y, q.z}; }

inline bool is_finite(const Triple& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_finite(const Quadruple& q) {
  return std::isfinite(q.s) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

/// g_i = (I_j − I_k)/I_i, cyclic: ω̇_i = g_i ω_j ω_k. |g_i| ≤ 1 for every body (bodies: I_i ≥ |I_j − I_k|).
inline Triple euler_coefficients(const PrincipalMoments& I) {
  return {(I[1] - I[2]) / I[0], (I[2] - I[0]) / I[1], (I[0] - I[1]) / I[2]};
}

}  // namespace polhode

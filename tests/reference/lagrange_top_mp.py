# SPDX-License-Identifier: MIT
"""The heavy symmetric top by two ways that share nothing, for the reference values of the exact motion:

`Closed`: the roots of the cubic, am(u) by descending Landen steps, and the two angles by Carlson's R_J, in mpmath
(docs/numerics.md §2.6 has theta functions instead). Its start is moved by 1e-55 of its smallest component, so that no
root meets another and the axis never passes through the vertical: no case has to be told apart, at `digits_for` of them.
`taylor`: series of the equations of motion themselves, in gmpy2, which know nothing of elliptic functions.

Axis 3 is that of symmetry, the weight acts on its positive side (mgl >= 0) along -z."""
import gmpy2
import mpmath as mp
from gmpy2 import mpfr
from mpmath import mpc, mpf

MOVE = mpf(10) ** -55


def smallest(q0, w0):
    rate = max((abs(x) for x in w0 if x), default=1)
    return min([abs(x) for x in q0 if x] + [abs(x) / rate for x in w0 if x])


def digits_for(q0, w0):
    """A small difference of roots is of the square of a move, and a root near another has half the digits."""
    return 300 + int(-4 * mp.log10(min(1, smallest(q0, w0))))


def agm_ladder(kp):
    a, b, steps = mpf(1), kp, []
    while True:
        c = (a - b) / 2
        a, b = (a + b) / 2, mp.sqrt(a * b)
        steps.append((a, c))
        if abs(c) < mp.eps * a:
            return steps


def am(u, steps):
    phi = mp.ldexp(steps[-1][0] * u, len(steps))
    for a, c in reversed(steps):
        phi = (phi + mp.asin(c * mp.sin(phi) / a)) / 2
    return phi


class Closed:
    """I1, I3, mgl, q0 = (w, x, y, z), w0: state at any t, and what the header of lagrange_top.h calls its facts."""

    def __init__(self, I1, I3, mgl, q0, w0):
        I1, I3, mgl = mpf(I1), mpf(I3), mpf(mgl)
        move = MOVE * smallest(q0, w0)
        q = [mpf(x) + move * d for x, d in zip(q0, (3, -1, 4, 2))]
        norm = mp.sqrt(sum(x * x for x in q))
        q = [x / norm for x in q]
        rate = max(max(abs(mpf(x)) for x in w0), mp.sqrt(mgl / I1))
        w = [mpf(x) + move * rate * d for x, d in zip(w0, (2, 5, -3))]
        self.w3, a = w[2], I3 * w[2] / I1
        gamma = 2 * mgl / I1 + move * rate**2
        alpha, beta, omega = mpc(q[0], q[3]), mpc(q[1], q[2]), mpc(w[0], w[1])
        u0 = abs(alpha) ** 2 - abs(beta) ** 2
        pu = omega * mp.conj(2j * mp.conj(alpha) * beta)
        b, E = pu.real + a * u0, abs(omega) ** 2 + gamma * u0
        u1, u2, u3 = self.roots(gamma, -(E + a * a), 2 * a * b - gamma, E - b * b)
        self.a, self.b, self.gamma = a, b, gamma
        self.u1, self.d21, self.u2, self.u3 = u1, u2 - u1, u2, u3
        self.lam = mp.sqrt(gamma * (u3 - u1)) / 2
        self.kp = mp.sqrt((u3 - u2) / (u3 - u1))
        self.steps = agm_ladder(self.kp)
        self.K = mp.pi / (2 * self.steps[-1][0])
        self.period = 2 * self.K / self.lam
        self.arg_alpha, self.arg_beta = mp.arg(alpha), mp.arg(beta)
        s2 = (u0 - u1) / self.d21
        s, c = mp.sqrt(max(s2, 0)), mp.sqrt(max(1 - s2, 0))
        s = s if pu.imag >= 0 else -s
        self.U0 = s * mp.elliprf(c * c, c * c + (self.kp * s) ** 2, 1)
        self.h = (self.d21 / (1 + u1), -self.d21 / (1 - u1))
        self.J_K = [self.third(mpf(0), mpf(1), h) for h in self.h]
        self.start = self.integrals(mpf(0))[2]

    @staticmethod
    def roots(c3, c2, c1, c0):
        m = -c2 / (3 * c3)
        p, q = c1 / c3 - 3 * m * m, c0 / c3 + m * (c1 / c3 - 2 * m * m)
        r = 2 * mp.sqrt(-p / 3)
        third = mp.acos(3 * q / (p * r)) / 3
        return sorted(m + r * mp.cos(third - 2 * mp.pi * k / 3) for k in range(3))

    def third(self, c, s, h):
        """The integral of du/(1 + h sn^2 u) from 0 to am = asin s."""
        d2 = c * c + (self.kp * s) ** 2
        return s * mp.elliprf(c * c, d2, 1) - h * s**3 / 3 * mp.elliprj(c * c, d2, 1, 1 + h * s * s)

    def integrals(self, t):
        u = self.U0 + self.lam * t
        j = mp.nint(u / (2 * self.K))
        phi = am(u - 2 * self.K * j, self.steps)
        s, c = mp.sin(phi), mp.cos(phi)
        return s, c, [2 * j * J + self.third(c, s, h) for J, h in zip(self.J_K, self.h)]

    def at(self, t):
        t = mpf(t)
        s, c, J = self.integrals(t)
        u = self.u1 + self.d21 * s * s
        u_rate = 2 * self.lam * self.d21 * s * c * mp.sqrt(c * c + (self.kp * s) ** 2)
        turned = [(x - y) / self.lam for x, y in zip(J, self.start)]
        spin = (self.w3 - self.a) * t
        arg_a = self.arg_alpha + (spin + (self.b + self.a) * turned[0] / (1 + self.u1)) / 2
        arg_b = self.arg_beta + (-spin + (self.b - self.a) * turned[1] / (1 - self.u1)) / 2
        alpha = mp.sqrt((1 + u) / 2) * mp.expj(arg_a)
        beta = mp.sqrt((1 - u) / 2) * mp.expj(arg_b)
        omega = mpc(self.b - self.a * u, u_rate) / mp.conj(2j * mp.conj(alpha) * beta)
        return [omega.real, omega.imag, self.w3], [alpha.real, beta.real, beta.imag, alpha.imag]


def taylor(I1, I3, mgl, q0, w0, t, digits=60):
    """The state at t by steps of Taylor's series."""
    gmpy2.get_context().precision = int(digits * 3.33) + 16
    gmpy2.get_context().emax, gmpy2.get_context().emin = gmpy2.get_emax_max(), gmpy2.get_emin_min()
    f = lambda x: mpfr(mp.nstr(mpf(x), digits + 5))
    I1, I3, mgl, left = f(I1), f(I3), f(mgl), f(t)
    q, w = [f(x) for x in q0], [f(x) for x in w0]
    norm = gmpy2.sqrt(sum(x * x for x in q))
    q = [x / norm for x in q]
    g, n = mgl / I1, (I1 - I3) / I1
    rate = max(gmpy2.sqrt(sum(x * x for x in w)), gmpy2.sqrt(g))
    N = digits + 4
    while left != 0:
        W = [[x] for x in w]
        Q = [[x] for x in q]
        Z = [[2 * (q[1] * q[3] - q[0] * q[2])], [2 * (q[2] * q[3] + q[0] * q[1])],
             [1 - 2 * (q[1] * q[1] + q[2] * q[2])]]
        for k in range(N):
            R = [x[::-1] for x in W]
            S = lambda x, i: sum(map(gmpy2.mul, x, R[i])) / (k + 1)
            # e3 x (-z) mgl; dz/dt = z x w; 2 dq/dt = q (0, w)
            rates = [n * S(W[1], 2) + g * Z[1][k] / (k + 1), -n * S(W[0], 2) - g * Z[0][k] / (k + 1), mpfr(0)]
            z_rates = [S(Z[1], 2) - S(Z[2], 1), S(Z[2], 0) - S(Z[0], 2), S(Z[0], 1) - S(Z[1], 0)]
            q_rates = [-S(Q[1], 0) - S(Q[2], 1) - S(Q[3], 2), S(Q[0], 0) + S(Q[2], 2) - S(Q[3], 1),
                       S(Q[0], 1) + S(Q[3], 0) - S(Q[1], 2), S(Q[0], 2) + S(Q[1], 1) - S(Q[2], 0)]
            for x, y in zip(W + Z + Q, rates + z_rates + [y / 2 for y in q_rates]):
                x.append(y)
        last = max([abs(x[N]) / rate for x in W] + [abs(x[N]) for x in Q + Z])
        h = gmpy2.exp((-(digits - 3) * gmpy2.log(mpfr(10)) - gmpy2.log(last)) / N) if last else abs(left)
        h = left if abs(left) <= h else (h if left > 0 else -h)
        at = lambda x: sum(c * h**i for i, c in enumerate(x))
        w, q, left = [at(x) for x in W], [at(x) for x in Q], left - h
    back = lambda v: [mpf(str(x)) for x in v]
    return back(w), back(q)

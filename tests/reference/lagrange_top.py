# SPDX-License-Identifier: MIT
"""Heavy symmetric tops with their motion to 40 digits, for the accuracy bar of the exact motion:

    /usr/bin/python3 tests/reference/lagrange_top.py 1788 tests/reference/lagrange_top.json

Truth: lagrange_top_mp.py, evaluated at the exact values of the given doubles, by its closed form; at the first time of each
top held against its Taylor series. cond_omega, cond_q: sums over I1, I3, mgl, the q0, the w0 and t of |x d/dx| of
omega, relative to |omega|, and of q, by central differences. Needs mpmath and gmpy2."""
import json
import math
import os
import random
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import lagrange_top_mp as top_mp
import mpmath as mp
from mpmath import mpf


def tilted(theta, phi=0.3, psi=-0.8):
    c, s = math.cos(theta / 2), math.sin(theta / 2)
    return [c * math.cos((phi + psi) / 2), s * math.cos((phi - psi) / 2), s * math.sin((phi - psi) / 2),
            c * math.sin((phi + psi) / 2)]


def rates(theta, phi_rate, theta_rate, w3, psi=-0.8):
    across = phi_rate * math.sin(theta)
    return [across * math.sin(psi) + theta_rate * math.cos(psi), across * math.cos(psi) - theta_rate * math.sin(psi), w3]


def steady(I1, I3, mgl, theta, w3, fast):
    a, b = I1 * math.cos(theta), I3 * w3
    larger = b + math.copysign(math.sqrt(b * b - 4 * a * mgl), b)
    return larger / (2 * a) if fast else 2 * mgl / larger


def tops():
    """name, I1, I3, mgl, q0, w0: I1 across the axis, I3 along it."""
    r = random.uniform

    def some():
        I1 = r(0.5, 1.5)
        return I1, I1 * r(0.1, 1.9), r(0.3, 3)

    quat = lambda: [random.gauss(0, 1) for _ in range(4)]
    for i in range(12):
        yield f"generic_{i}", *some(), quat(), [random.gauss(0, 3) for _ in range(3)]
    for i in range(4):
        yield f"fast_{i}", *some(), quat(), [random.gauss(0, 1), random.gauss(0, 1), random.choice([-1, 1]) * 10 ** r(1.5, 4)]
    for i in range(4):
        yield f"slow_{i}", *some(), quat(), [10 ** r(-4, -1) * random.gauss(0, 1) for _ in range(3)]
    for i, theta in enumerate((0.02, 0.8, 1.6, 2.7)):  # released with the axis at rest: cusps
        I1, I3, mgl = some()
        yield f"cusp_{i}", I1, I3, mgl, tilted(theta), [0.0, 0.0, random.choice([-1, 1]) * 10 ** r(0.3, 1.3)]
    for i, theta in enumerate((0.01, 1.0, 2.0, 3.1)):
        yield f"released_at_rest_{i}", *some(), tilted(theta), [0.0, 0.0, 0.0]
    for i, (theta, fast, w3) in enumerate(((0.4, False, 9.0), (1.2, True, -8.0), (2.2, False, 0.0), (2.9, True, 3.0))):
        rate = steady(1.0, 0.75, 1.5, theta, w3, fast) if w3 else math.sqrt(-1.5 / math.cos(theta))
        yield f"steady_{i}", 1.0, 0.75, 1.5, tilted(theta), rates(theta, rate, 0.0, w3)
        yield f"almost_steady_{i}", 1.0, 0.75, 1.5, tilted(theta), rates(theta, rate, 10.0 ** (-4 * i - 2), w3)
    yield "sleeping_barely", 1.0, 0.5, 1.0, [1.0, 1e-6, 0.0, 0.0], [0.0, 0.0, 4.001]
    for i, small in enumerate((1e-3, 1e-8, 1e-15, 1e-100)):
        yield f"sleeping_almost_{i}", 1.0, 0.5, 1.0, [0.8, small, -2 * small, 0.6], [small, 0.0, 7.0]
        yield f"waking_{i}", 1.0, 0.5, 1.0, [0.8, small, -2 * small, 0.6], [small, 0.0, 1.5]
        yield f"balanced_{i}", 1.0, 0.5, 1.0, [1.0, small, small, 0.0], [0.0, 0.0, 0.0]
        yield f"hanging_almost_{i}", 1.0, 0.5, 1.0, [small, 0.8, 0.6, -3 * small], [small, -small, 2.0 if i % 2 else 0.0]
    yield "upright_pushed", 1.0, 0.5, 1.0, [0.8, 0.0, 0.0, 0.6], [0.3, 0.1, 2.0]
    yield "upright_pushed_spinning", 1.0, 0.5, 1.0, [1.0, 0.0, 0.0, 0.0], [0.3, 0.1, -9.0]
    yield "hanging_pushed", 1.0, 0.5, 1.0, [0.0, 0.8, 0.6, 0.0], [0.3, 0.1, 2.0]
    yield "pendulum_over_the_top", 1.0, 0.5, 1.0, [1.0, 0.0, 0.0, 0.0], [0.7, 0.0, 0.0]
    yield "pendulum", 1.0, 0.5, 1.0, [0.0, 1.0, 0.0, 0.0], [1.3, 0.0, 0.0]
    yield "separatrix_exact", 1.0, 1.0, 1.0, [0.0, 1.0, 0.0, 0.0], [2.0, 0.0, 0.0]
    for i, off in enumerate((1e-3, -1e-6, 1e-9, -1e-12, 1e-15)):
        yield f"near_separatrix_{i}", 1.0, 0.7, 1.0, [0.0, 1.0, 0.0, 0.0], [2.0 * (1 + off), 0.0, 0.0]
    for i, near in enumerate((1e-4, 1e-9)):  # L_z = I3 w3 almost: close by the top, and by the bottom
        theta, w3 = 1.1, 1.2
        rate = 0.7 * w3 * (1 - math.cos(theta)) / math.sin(theta) ** 2
        yield f"near_the_top_{i}", 1.0, 0.7, 1.0, tilted(theta), rates(theta, rate * (1 + near), 2.0, w3)
        rate = -0.7 * w3 * (1 + math.cos(theta)) / math.sin(theta) ** 2
        yield f"near_the_bottom_{i}", 1.0, 0.7, 1.0, tilted(theta), rates(theta, rate * (1 + near), -1.0, w3)
    yield "no_gravity", 1.0, 1.7, 0.0, [0.1, 0.7, -0.5, 0.3], [0.4, -0.7, 1.1]
    for i, mgl in enumerate((1e-3, 1e-20, 1e-200)):
        yield f"little_gravity_{i}", 1.0, 1.7, mgl, [0.1, 0.7, -0.5, 0.3], [0.4, -0.7, 1.1]
    yield "sphere", 1.25, 1.25, 2.0, [0.1, 0.7, -0.5, 0.3], [0.4, -0.7, 3.1]
    for i, thin in enumerate((1e-3, 1e-8, 1e-15)):  # a rod, whose spin carries next to nothing
        yield f"rod_{i}", 1.0, thin, 1.3, tilted(0.7), [0.4, 0.2, 5.0]
        yield f"rod_spun_{i}", 1.0, thin, 1.3, tilted(0.7), [0.4, 0.2, 6.0 / thin]
    yield "coin", 0.5, 1.0, 1.3, tilted(0.7), [0.4, 0.2, 5.0]
    for i, (e_I, e_w) in enumerate(((1e120, 1e90), (1e-120, 1e-90), (1e-140, 1e140), (1e140, 1e-140))):
        yield f"scale_{i}", e_I, 0.6 * e_I, (1.1 * e_I * e_w) * e_w, tilted(1.0), [0.9 * e_w, -0.2 * e_w, 3.0 * e_w]


def difference(x, y):
    return mp.norm([a - b for a, b in zip(x, y)])


def state(given, t):
    I1, I3, mgl, q0, w0 = given
    at = [mpf(x) for x in (I1, I3, mgl, *q0, *w0, t)]
    motion = lambda x: top_mp.Closed(x[0], x[1], x[2], x[3:7], x[7:10]).at(x[10])
    w_t, q_t = motion(at)
    cond_w = cond_q = mpf(0)
    h = mpf(10) ** -27
    for i in range(11):
        if at[i] == 0:
            continue
        (w_1, q_1), (w_2, q_2) = (motion([x * (1 + s * h) if j == i else x for j, x in enumerate(at)]) for s in (-1, 1))
        if sum(x * y for x, y in zip(q_1, q_2)) < 0:
            q_1 = [-x for x in q_1]
        cond_w += difference(w_1, w_2) / (2 * h) / mp.norm(w_t)
        cond_q += difference(q_1, q_2) / (2 * h)
    text = lambda v: [mp.nstr(x, 40) for x in v]
    return dict(t_hex=float(t).hex(), omega=text(w_t), q=text(q_t), cond_omega=float(mp.nstr(cond_w, 6)),
                cond_q=float(mp.nstr(cond_q, 6))), w_t, q_t


def case(name, *given):
    I1, I3, mgl, q0, w0 = given
    mp.mp.dps = top_mp.digits_for(q0, w0)
    top = top_mp.Closed(*given)
    unit = min(float(top.period), 60 / float(max(abs(x) for x in (*w0, math.sqrt(mgl / I1)))))
    times = [unit * random.uniform(0.05, 0.9), unit * random.uniform(-4, 4), unit * random.uniform(30, 90)]
    if name.startswith("released") or name.startswith("cusp"):
        times.append(unit * 1e-9)
    if name.startswith("fast"):
        times.append(unit * 3e6)
    states = []
    agreement = None
    for t in times:
        s, w_t, q_t = state(given, t)
        if agreement is None:
            w, q = top_mp.taylor(*given, t)
            q = q if sum(x * y for x, y in zip(q, q_t)) > 0 else [-x for x in q]
            error = max(difference(w, w_t) / mp.norm(w_t), difference(q, q_t))
            agreement = float(mp.nstr(-mp.log10(error), 3))
            print(name, agreement, [s["cond_q"]], flush=True)
        states.append(s)
    return dict(name=name, I1_hex=float(I1).hex(), I3_hex=float(I3).hex(), mgl_hex=float(mgl).hex(),
                q0_hex=[float(x).hex() for x in q0], omega0_hex=[float(x).hex() for x in w0],
                period=mp.nstr(top.period, 40), agreement_digits=agreement, states=states)


def main():
    seed, path = int(sys.argv[1]), sys.argv[2]
    random.seed(seed)
    cases = [case(*given) for given in list(tops())]
    rows = ",\n".join(json.dumps(c, separators=(",", ":")) for c in cases)
    with open(path, "w") as file:
        file.write(f'{{"seed":{seed},"cases":[\n{rows}\n]}}\n')
    print(len(cases), "tops; digits in which the two ways agree, at least:", min(c["agreement_digits"] for c in cases))


main()

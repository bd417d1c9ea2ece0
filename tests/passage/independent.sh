# SPDX-License-Identifier: LGPL-2.1-or-later
# The same answers by some lines of Python: the best speed by brute force and scipy's minimiser, its
# integrals along random profiles, the share of fish by its root finder, Franke's formula in numbers.
. "$CAUDAL_SOURCE_DIR/tests/functions.sh"

cat >check.py <<'PY'
import csv
import subprocess
import sys

import numpy as np
from scipy import integrate, optimize, stats

g, random = 9.81, np.random.default_rng(7)


def power_law(k, b, l, spread):
    u, t = np.sqrt(g * l), np.sqrt(l / g)
    return lambda U, z: t * (U / (k * np.exp(spread * z) * u))**(1 / b)


# name, species, length, T(U, z), largest water velocity
sigma = np.log(7.744 / 2.070) / (2 * stats.norm.ppf(0.975))
LAWS = (
    ("Katopodis-Gervais", "Salmon & Walleye", 0.5, power_law(4.004, -0.25, 0.5, sigma), 2.5),
    ("Castro-Santos", "American shad", 0.4, lambda U, z: np.maximum(
        np.exp(10.7 - U / 0.4), np.exp(6.16 - 0.33 * U / 0.4)), 4.),
    ("Hunter-Mayor", "coho salmon", 0.5, lambda U, z: np.maximum(
        (13.3 * 0.5**0.52 / U)**(1 / 0.65), (3.02 * 0.5**0.52 / U)**(1 / 0.1)), 2.5),
)


def compute_cost(T, V, z, slowest):
    """The least fatigue a metre of all speeds."""
    def cost(U):
        return 1 / ((U - V) * T(U, z))

    low, high = max(slowest, V * (1 + 1e-9)), 8 * V + 10
    U = low + (high - low) * np.linspace(0, 1, 1500)[1:]**2
    best = np.argmin(cost(U))
    bounds = (U[best - 1] if best else low, U[min(best + 1, len(U) - 1)])
    return min(optimize.minimize_scalar(cost, bounds=bounds, method="bounded",
                                        options={"xatol": 1e-10}).fun, cost(low))


def find_slowest(T, z):
    return optimize.brentq(lambda U: np.log(T(U, z) / 1800), 1e-2, 20, xtol=1e-13)


def compute_fatigue(T, s, V, z):
    slowest, fatigue = find_slowest(T, z), 0.
    for k in range(len(s) - 1):
        fatigue += integrate.quad(
            lambda x: compute_cost(T, np.interp(x, s[k:k + 2], V[k:k + 2]), z, slowest), s[k],
            s[k + 1], epsabs=0, epsrel=1e-8, limit=200)[0]
    return fatigue


for law, species, length, T, largest in LAWS:
    profiles = []
    with open("profiles.csv", "w") as file:
        file.write("discharge,distance,velocity\n")
        for q in range(1, 5):
            s = np.cumsum(np.r_[0, random.uniform(0.5, 3, 4)])
            V = random.uniform(0.1, largest, len(s))
            profiles.append((s, V))
            file.writelines(f"{q},{x:.17g},{v:.17g}\n" for x, v in zip(s, V))
    subprocess.run([*sys.argv[1:], "-D", f"Endurance/Law={law}", "-D", f"Fish/Species={species}",
                    "-D", f"Fish/Length={length}"], check=True, stdout=subprocess.DEVNULL)
    rows = list(csv.reader(open("results/summary.csv")))
    error = 0.
    for (s, V), row in zip(profiles, rows[1:], strict=True):
        answer = dict(zip(rows[0], map(float, row)))
        for name, z in (("median", 0.), ("lower limit of 75 %", stats.norm.ppf(0.125))):
            ours = compute_fatigue(T, s, V, z)
            error = max(error, abs(answer[f"fatigue of the {name} [1]"] / ours - 1))
    print(f"{law}: fatigue on {len(profiles)} random profiles agrees within 1e-6:", error < 1e-6,
          "" if error < 1e-6 else error)

# The share of a population of several lengths in uniform water.
V, L = 1.5, 12.
with open("profiles.csv", "w") as file:
    file.write(f"discharge,distance,velocity\n1,0,{V}\n1,{L},{V}\n")
subprocess.run([*sys.argv[1:], "-D", "Fish/Species=Salmon & Walleye", "-D", "Fish/Length=0.5",
                "-D", "Fish/Standard deviation of length=0.08", "-D", "Turbine/Discharge=60",
                "-D", "Turbine/Head=8", "-D", "Turbine/Diameter=3.5", "-D", "Turbine/Speed=120",
                "-D", "Turbine/Blades=5"], check=True, stdout=subprocess.DEVNULL)
header, row = csv.reader(open("results/summary.csv"))
answer = dict(zip(header, map(float, row)))


def find_ability(l):
    T = power_law(4.004, -0.25, l, sigma)
    return optimize.brentq(
        lambda z: np.log(L * compute_cost(T, V, z, find_slowest(T, z))), -6, 6, xtol=1e-10)


lengths = stats.norm.ppf((np.arange(40) + 0.5) / 40, 0.5, 0.08)
share = np.mean([stats.norm.sf(find_ability(l)) for l in lengths])
exact = integrate.quad(lambda l: stats.norm.pdf(l, 0.5, 0.08) * stats.norm.sf(find_ability(l)), 0.1, 0.9,
                       epsrel=1e-6)[0]
print("share of the classes of lengths within 1e-6:", abs(answer["share that passes [1]"] - share) < 1e-6,
      "- of the whole distribution within 1e-3:", abs(share - exact) < 1e-3)

omega = 2 * np.pi * 120 / 60
E, Q = g * 8 / (omega * 3.5)**2, 60 / (omega * 3.5**3)
alpha = np.arctan(np.pi * 0.9 * E / (2 * Q))
strike = 0.2 * 5 * 0.5 / 3.5 * (np.cos(alpha) / (8 * Q) + np.sin(alpha) / np.pi)
print("Franke's formula:", abs(answer["strike at the tip of the blades [1]"] / strike - 1) < 1e-9)
PY

cat >case.prm <<'PRM'
set Model = passage
subsection Passage
  set Type = profile
  subsection Profile
    set File = profiles.csv
  end
end
subsection Output
  set Folder           = results
  set Existing results = replace
end
PRM
/usr/bin/python3 check.py "$CAUDAL" case.prm

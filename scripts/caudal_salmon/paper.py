# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the paper prints: W. Yao, X. Li, S. Du and Z. Zhan, Hydraulic Project Development and
Corresponding Ecological Factor Analysis."""

# (shape, frequency [Hz]) -> distance in 20 s [cm], mean speed [cm/s], "energy" [W]
RESULTS = {
    ("fish_one", 0.64): (25.84, 1.292, 0.61e-4),
    ("fish_one", 0.95): (35.02, 1.750, 1.49e-4),
    ("fish_one", 1.43): (49.12, 2.456, 1.49e-4),
    ("fish_two", 0.95): (14.91, 0.746, 1.73e-4),
}

# Table 2: empirical relations of speed V and tail-beat frequency F [Hz], as V(F). The units of V
# are by source, as far as it says: body lengths/s, and cm/s for the last one.
RELATIONS_IN_LENGTHS = (
    ("salmon, He and Wardle: V = 0.95 F − 0.46", lambda F: 0.95 * F - 0.46),
    ("shortfin mako, Sepulveda: F = 0.94 + 0.14 V", lambda F: (F - 0.94) / 0.14),
    ("lemon shark, Sepulveda: F = 1.5 V^0.48", lambda F: (F / 1.5)**(1 / 0.48)),
    ("cyprinoid, Ohlberger: F = 1.31 V + 0.35", lambda F: (F - 0.35) / 1.31),
)
RELATION_IN_CM = ("salmon, Li et al.: V = 20.65 F − 34.80", lambda F: 20.65 * F - 34.80)

REASONS = """
Why the figures differ:
- Shape. Table 1 gives half-axes in mm for a fish of 1 dm without saying where they stand. Read
  literally (fish_*_literal) they are two bulges of 10 mm behind a thread; fish_one and fish_two
  have the columns in an order that makes a fish, which is our choice, and `salmon` is ours.
- Gait. The paper defines the angles as "the tangent angle of sin" without amplitude or phase
  lag. Here each joint turns by arctan(sin(psi - 2 pi s/L)); without a lag nothing would swim.
- Frequency. In an ideal fluid that starts at rest the path depends on the phase of the stroke
  only, so that distance is in proportion to frequency. The paper's distances, 25.84, 35.02 and
  49.12 cm, lie on the line 7.00 cm + 29.46 cm/Hz f: no ideal fluid does that.
- Energy. The paper gives "energy" in W and prints 1.49e-4 for both 0.95 and 1.43 Hz; energy
  grows as f^2 and power as f^3. Here J and W are given apart. Net work of a stroke is zero in an
  ideal fluid, so that a mean power can only be the gross or the positive one.
- The bias angle of 5 degrees steers; it is 0 here (prm/salmon/turning.prm has it).
What holds in every reading: fish one swims farther than fish two with less energy, and distance
and energy grow with the frequency.
""".strip()

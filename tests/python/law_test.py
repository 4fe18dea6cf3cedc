"""Reads the exported law of a potential as another code would and holds it against the lattice's own answers."""
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
try:
    import tomllib
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)

validate, reference = sys.argv[1:3]
folder = os.path.join(tempfile.mkdtemp(), "card")
subprocess.run([validate, "potential", "airebo", "--out", folder], check=True, stdout=subprocess.DEVNULL)
with open(os.path.join(folder, "law.toml"), "rb") as file:
    law = tomllib.load(file)
with open(os.path.join(folder, "card.json"), encoding="utf-8") as file:
    card = json.load(file)


def forces(C11, C12, terms, E1, E2):
    """Principal second Piola-Kirchhoff membrane forces."""
    I, q = E1 + E2, abs(E1 - E2) / 2
    W_I, W_q = (C11 + C12) / 2 * I, 2 * (C11 - C12) * q
    for a, b, c in terms:
        W_I += c * a * I ** (a - 1) * q**b if a else 0
        W_q += c * b * I**a * q ** (b - 1) if b else 0
    return W_I + W_q / 2, W_I - W_q / 2


def bond(E1, E2):
    I, q = E1 + E2, abs(E1 - E2) / 2
    return law["longest_bond"]["rest_A"] + sum(c * I**a * q**b for a, b, c in law["longest_bond"]["terms_A"])


here = law["C11_eV_per_A2"], law["C12_eV_per_A2"], law["terms_eV_per_A2"]
columns = card["states"]
all_states = [dict(zip(columns, values)) for values in zip(*columns.values())]
states = [s for s in all_states if s["orientation_deg"] == 15 and s["longest_bond_A"] <= 1.66]
assert len(states) >= 15
for s in states:
    S1, S2 = forces(*here, s["E11"], s["E22"])
    size = (s["S11_eV_per_A2"] ** 2 + s["S22_eV_per_A2"] ** 2 + 0.01) ** 0.5
    assert abs(S1 - s["S11_eV_per_A2"]) < 0.005 * size and abs(S2 - s["S22_eV_per_A2"]) < 0.005 * size, s
for s in all_states:
    assert s["longest_bond_A"] > 1.70 or s["longest_bond_A"] < bond(s["E11"], s["E22"]) + 0.01, s

# A law of the same form that was fitted to AIREBO by codes written separately.
with open(reference, encoding="utf-8") as file:
    rows = [line.split(",") for line in file if line.strip()][1:]
modulus, nu = map(float, rows[0][:2])
C11 = modulus / (1 - nu**2)
theirs = C11, nu * C11, [(int(a), int(b), float(c)) for a, b, c in rows[1:]]
worst = 0
for i in range(-2, 15):
    for k in range(-2, i + 1):
        E1, E2 = 0.01 * i, 0.01 * k
        S, T = forces(*here, E1, E2), forces(*theirs, E1, E2)
        size = (T[0] ** 2 + T[1] ** 2 + 0.01) ** 0.5
        worst = max(worst, abs(S[0] - T[0]) / size, abs(S[1] - T[1]) / size)
assert worst < 0.01, worst
print(f"the law gives the lattice's forces, and those of a separate fit within {100 * worst:.2f} %")

"""Force curves of suspended sheets as a microscope would record them, made by nothing of the program: forces of sheets that were
solved by shooting (sheet_curves.json, see tests/reference), scaled to other drums, pressed through a cantilever, seen as V over
the piezo's height with a tilted baseline, snap-in, pull-off, drift and noise."""
import bisect
import dataclasses
import json
import math
import pathlib
import random

REFERENCE = pathlib.Path(__file__).resolve().parents[2] / "compare/verify_fit/sheet_curves.json"


class Sheet:
    """F in nN at a depth in nm. F/(E h a) is a function of d/a and sigma h/(E h) for a tip of the same share of a."""

    def __init__(self, tip="sphere", share=0.033, pretension=0.34, radius_nm=500.0, modulus=342.0):
        table = json.loads(REFERENCE.read_text())
        curve = next(c for c in table["curves"] if c["tip"] == tip and math.isclose(c["pretension_N_per_m"], pretension)
                     and math.isclose(c["tip_radius_nm"], share * table["radius_nm"]))
        length = radius_nm / table["radius_nm"]
        self.radius_nm, self.tip, self.tip_radius_nm, self.nu = radius_nm, tip, share * radius_nm, table["nu"]
        self.modulus, self.pretension = modulus, pretension * modulus / table["Eh_N_per_m"]
        force = length * modulus / table["Eh_N_per_m"]
        # ln F over ln d by Hermite's cubics: the curves are smooth there.
        self.x = [math.log(d * length) for d in curve["depth_nm"]]
        self.y = [math.log(f * force) for f in curve["force_nN"]]
        self.slope = [self._slope(i) for i in range(len(self.x))]

    def _slope(self, i):
        """Of the quartic's or lower polynomial through the neighbours."""
        lo, hi = max(0, i - 2), min(len(self.x), i + 3)
        total = 0.0
        for j in range(lo, hi):
            for m in range(lo, hi):
                if m == j:
                    continue
                term = self.y[j] / (self.x[j] - self.x[m])
                for k in range(lo, hi):
                    if k not in (j, m):
                        term *= (self.x[i] - self.x[k]) / (self.x[j] - self.x[k])
                total += term
        return total

    def force(self, depth):
        if depth == 0:
            return 0.0
        x = math.log(abs(depth))
        if x <= self.x[0]:
            return math.copysign(math.exp(self.y[0] + x - self.x[0]), depth)
        i = min(bisect.bisect_right(self.x, x), len(self.x) - 1) - 1
        h = self.x[i + 1] - self.x[i]
        t = (x - self.x[i]) / h
        value = ((1 + 2 * t) * (1 - t) ** 2 * self.y[i] + t * (1 - t) ** 2 * h * self.slope[i]
                 + t * t * (3 - 2 * t) * self.y[i + 1] - t * t * (1 - t) * h * self.slope[i + 1])
        return math.copysign(math.exp(value), depth)

    def depth_under(self, z, k):
        """z = d + F(d)/k, by bisection and the rule of false position."""
        low, high = (0.0, z) if z > 0 else (z, 0.0)
        for _ in range(200):
            middle = (low + high) / 2
            if middle + self.force(middle) / k > z:
                high = middle
            else:
                low = middle
            if high - low < 1e-12 * abs(z):
                break
        return (low + high) / 2


@dataclasses.dataclass
class Microscope:
    k: float = 3.0                # N/m, true
    k_told: float = 3.0           # N/m, what the file says
    sensitivity: float = 60.0     # nm/V
    noise_V: float = 0.002        # of the deflection
    height_noise_nm: float = 0.0
    tilt_V_per_nm: float = 2e-6
    offset_V: float = 0.3
    drift_V: float = 0.0          # of the deflection over the way there, as a parabola beside the tilt
    adhesion_nN: float = 0.0      # snap-in at a third of it, pull-off at all of it
    points: int = 500
    before_nm: float = 150.0      # of the way without contact
    depth_nm: float = 90.0        # at the deepest point


def record(sheet, scope, rng):
    """Heights (nm, falling towards the sample) and deflections (V) of the way there and back."""
    deepest = scope.depth_nm + sheet.force(scope.depth_nm) / scope.k
    start = rng.uniform(1000, 2000)

    def segment(heights, hold):
        z_out, v_out = [], []
        for i, z in enumerate(heights):
            pulled = hold / scope.k
            if z >= 0 or (hold > 0 and z > -pulled - sheet_gap(sheet, hold)):
                deflection = (z - sheet.depth_under(z, scope.k)) if z != 0 else 0.0
            else:
                deflection = 0.0
            share = i / (len(heights) - 1)
            volts = (deflection / scope.sensitivity + scope.offset_V + scope.tilt_V_per_nm * z
                     + scope.drift_V * (4 * share * (1 - share)) + rng.gauss(0, scope.noise_V))
            z_out.append(start - z + rng.gauss(0, scope.height_noise_nm))
            v_out.append(volts)
        return z_out, v_out

    ramp = [-scope.before_nm + (scope.before_nm + deepest) * i / (scope.points - 1) for i in range(scope.points)]
    there = segment(ramp, scope.adhesion_nN / 3)
    back = segment(ramp[::-1], scope.adhesion_nN)
    return there, back


def sheet_gap(sheet, force):
    """Depth by which a sheet is pulled up by a force in nN."""
    low, high = 0.0, math.exp(sheet.x[-1])
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if sheet.force(middle) < force else (low, middle)
    return high


def write_map(path, curves, scope, columns=None):
    """One HDF5 file of (there, back) with places on a grid in m."""
    import h5py
    columns = columns or math.ceil(math.sqrt(len(curves)))
    with h5py.File(path, "w") as file:
        for index, (there, back) in enumerate(curves):
            group = file.create_group(f"curves/{index}")
            group.attrs["spring constant"] = scope.k_told
            group.attrs["sensitivity"] = scope.sensitivity * 1e-9
            group.attrs["position x"] = 1e-6 * (index % columns)
            group.attrs["position y"] = 1e-6 * (index // columns)
            for name, unit, at in (("height (piezo)", "nm", 0), ("deflection", "V", 1)):
                group.create_dataset(name, data=there[at] + back[at]).attrs["unit"] = unit
            group.create_dataset("segment", data=[0] * len(there[0]) + [1] * len(back[0]))


def draw_map(path, sheet, scope, count, seed):
    rng = random.Random(seed)
    write_map(path, [record(sheet, scope, rng) for _ in range(count)], scope)

#!/usr/bin/env python3
"""`validate fit` on maps of suspended_curves.py: intervals hold the truth, the joint E h is right, what is wrong is skipped with its
reason, an interrupted run goes on. usage: suspended_test.py VALIDATE [--full], the latter many curves of every tip and drum."""
import csv
import json
import math
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

try:
    import h5py
except ImportError:
    sys.exit(77)

import suspended_curves as made

program, full = os.path.abspath(sys.argv[1]), "--full" in sys.argv
faults = []


def check(good, what):
    if not good:
        faults.append(what)


def flags(sheet, k="3 N/m"):
    return ["--radius", f"{sheet.radius_nm} nm", "--nu", str(sheet.nu), "--tip", sheet.tip, "--tip-radius",
            f"{sheet.tip_radius_nm} nm", "--spring-constant", k, "--quiet"]


def fit(files, sheet, *more, k="3 N/m"):
    """The document, or nothing where the program failed, which is a fault."""
    done = subprocess.run([program, "fit", *map(str, files), *flags(sheet, k), *map(str, more), "--json", "-"],
                          capture_output=True, text=True)
    if done.returncode != 0:
        faults.append(f"{files} {more}: exit code {done.returncode}: {done.stderr.strip()[-500:]}")
        return None
    return json.loads(done.stdout)


def tally(rows, key, truth):
    """Share of the intervals that hold the truth, and the mean error over the mean stated one."""
    held = sum(r[f"{key}_low_N_per_m"] <= truth <= r[f"{key}_high_N_per_m"] for r in rows)
    error = sum(r[f"{key}_N_per_m"] - truth for r in rows) / len(rows)
    stated = sum(r[f"{key}_stderr_N_per_m"] for r in rows) / len(rows)
    return held / len(rows), error / stated


def check_campaign(folder, name, sheet, scope, count, seed, k="3 N/m", drawn_k=None):
    """Coverage of 93 to 97 % and a bias below 0.2 of the stated error, and what chance adds to that in 99.9 %."""
    file = folder / f"{name}.h5"
    made.draw_map(file, sheet, scope, count, seed)
    document = fit([file], sheet, k=k)
    if document is None:
        return
    rows = [r for r in document["many"]["rows"] if not r.get("skipped")]
    check(len(rows) >= 0.98 * count, f"{name}: {len(rows)} of {count} used: "
          + str({r["skipped"] for r in document["many"]["rows"] if r.get("skipped")}))
    if len(rows) < 2:
        return
    chance = 3.3 * math.sqrt(0.95 * 0.05 / len(rows))
    for key, truth in (("Eh", sheet.modulus), ("pretension", sheet.pretension)):
        held, bias = tally(rows, key, truth)
        print(f"{name}: {key}: {len(rows)} curves, intervals hold the truth in {100 * held:.1f} %, bias {bias:+.2f} of the error")
        check(0.93 - chance <= held <= min(1, 0.97 + chance), f"{name}: {key}: intervals hold the truth in {100 * held:.1f} %")
        check(abs(bias) < 0.2 + 3.3 / math.sqrt(len(rows)), f"{name}: {key}: bias {bias:.2f} of the stated error")
    joint = document["many"]["joint"][0]
    off, error = joint["Eh_N_per_m"] / sheet.modulus - 1, joint["Eh_stderr_N_per_m"] / sheet.modulus
    print(f"{name}: joint E h {100 * off:+.2f} ± {100 * error:.2f} %")
    check(abs(off) < max(0.005, 3 * error), f"{name}: the joint E h is {100 * off:.2f} % off")


def check_what_is_skipped(folder):
    sheet, scope, rng = made.Sheet(), made.Microscope(), random.Random(4)
    good = lambda: made.record(sheet, scope, rng)
    curves = [good() for _ in range(18)]
    (z, v), back = good()
    curves.append((([*z], [0.3 + rng.gauss(0, scope.noise_V) for _ in z]), back))                       # no contact
    curves.append((([*z], [0.3 + max(0.0, a - 1500) * 0 + (max(0.0, max(z) - 150 - a) / scope.sensitivity)
                           + rng.gauss(0, scope.noise_V) for a in z]), back))                              # substrate
    (z, v), back = good()
    deep = len(v) * 4 // 5
    curves.append(((z, v[:deep] + [x - 2.0 for x in v[deep:]]), back))                                     # break
    bent = made.Microscope(drift_V=0.1)
    curves.append(made.record(sheet, bent, rng))                                                           # drift
    file = folder / "wrong.h5"
    made.write_map(file, curves, scope)
    with h5py.File(file, "a") as content:                                                                  # cannot be read
        del content["curves/3/deflection"]
        content.create_dataset("curves/3/colour", data=[1.0] * len(content["curves/3/height (piezo)"]))
    document = fit([file], sheet)
    if document is None:
        return
    skipped = {r["index"]: r["skipped"] for r in document["many"]["rows"] if r.get("skipped")}
    for index, word in ((3, "no column"), (18, "no contact"), (19, "substrate"), (20, "slip or break"), (21, "drift")):
        check(word in skipped.get(index, ""), f"curve {index} should be skipped with '{word}': {skipped.get(index)}")
    check(len(skipped) == 5, f"skipped: {skipped}")
    check(len(document["many"]["rows"]) == 22, "a row for each curve")
    check(any("curve 3" in u["file"] for u in document["unfitted"]), f"unfitted: {document['unfitted']}")


def check_resuming(folder):
    sheet = made.Sheet("disc")
    file, out = folder / "resumed.h5", folder / "resumed"
    made.draw_map(file, sheet, made.Microscope(points=200), 40, 5)
    partial = folder / "resumed.partial.csv"
    command = [program, "fit", str(file), *flags(sheet), "--out", str(out)]
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    while run.poll() is None and not (partial.exists() and partial.read_text().count("\n") > 8):
        time.sleep(0.01)
    run.send_signal(signal.SIGINT)
    check(run.wait() == 130, f"interrupted: exit code {run.returncode}")
    check(partial.exists(), "an interrupted run leaves its rows")
    if not partial.exists():
        return
    kept = partial.read_text().splitlines()[2:10]
    other = subprocess.run([*command, "--weights", "uniform", "--resume"], capture_output=True, text=True)
    check(other.returncode == 2 and "other settings" in other.stderr, f"--resume with other settings: {other.stderr}")
    done = subprocess.run([*command, "--resume"], capture_output=True, text=True)
    check(done.returncode == 0, f"--resume: {done.stderr}")
    check(not partial.exists(), "a finished run leaves no rows behind")
    if done.returncode == 0:
        lines = (out / "curves.csv").read_text().splitlines()
        check(len(lines) == 41 and all(line in lines for line in kept), "a resumed run keeps the rows it had")
        check([int(r["index"]) for r in csv.DictReader(lines)] == list(range(40)), "rows are in the order of the file")
        check((out / "map.svg").exists() and (out / "report.html").exists(), "map and page")


def check_settings(folder):
    sheet = made.Sheet("disc")
    made.draw_map(folder / "one.h5", sheet, made.Microscope(points=200), 2, 6)
    toml = folder / "fit.toml"
    toml.write_text(f'[hole]\nradius = "{sheet.radius_nm} nm"\n[tip]\ntip = "disc"\ntip-radius = "{sheet.tip_radius_nm} nm"\n'
                    f'[cantilever]\nspring-constant = "3 N/m"\n[sheet]\nnu = "{sheet.nu}"\n[fit]\nbaseline = "level"\n')
    said = subprocess.run([program, "fit", folder / "one.h5", "--settings", toml, "--json", "-"], capture_output=True, text=True)
    check(said.returncode == 0, f"--settings: {said.stderr}")
    typed = fit([folder / "one.h5"], sheet, "--baseline", "level")
    if said.returncode == 0 and typed:
        curves = json.loads(said.stdout)["curves"]
        check([c["fits"] for c in curves] == [c["fits"] for c in typed["curves"]], "settings and flags say the same")
        check(curves[0]["preparation"]["baseline"] == "level", "the baseline is the one asked for")
    toml.write_text('[hole]\nradios = "1 um"\n')
    wrong = subprocess.run([program, "fit", folder / "one.h5", "--settings", toml], capture_output=True, text=True)
    check(wrong.returncode == 2 and "radius" in wrong.stderr and ":2" in wrong.stderr, f"a wrong key: {wrong.stderr}")


def comma(value):
    return f"{value:.7g}".replace(".", ",")


def texts(there, back, k, sensitivity):
    """The same curve as the tables that people export: name, content, flags that say what the text does not."""
    heights, volts = there[0] + back[0], there[1] + back[1]
    deflections = [sensitivity * v for v in volts]
    forces = [k * d for d in deflections]
    rows = list(zip(heights, volts, deflections, forces))
    sense = ["--sensitivity", f"{sensitivity} nm/V"]
    yield "volts.csv", "Height (nm),Deflection (V)\n" + "".join(f"{z:.7g},{v:.9g}\n" for z, v, _, _ in rows), sense
    yield ("bom.csv", "\ufeffHeight [nm];Deflection [V]\r\n" + "".join(f"{comma(z)};{v:.9g}\r\n".replace(".", ",") for z, v, _, _ in rows),
           sense)
    yield ("units.txt", "Instrument: X-1\nheight\tdeflection\nµm\tnm\n"
           + "".join(f"{1e-3 * z:.9g}\t{d:.9g}\n" for z, _, d, _ in rows), [])
    yield ("force.dat", "# height_nm force_nN\n" + "".join(f"{z:.7g} {f:.9g}\n" for z, _, _, f in rows) + "nan nan\n",
           ["--baseline", "tilt", "--contact", "fit"])
    head = {"spring constant": k, "sensitivity": 1e-9 * sensitivity, "imaging mode": "force-distance"}
    yield ("afmformats.tab", "\n".join(["# afmformats 0.18.0", "#", "# BEGIN METADATA",
                                       *("# " + line for line in json.dumps(head, indent=2).splitlines()), "# END METADATA",
                                       "#", "# force\theight (piezo)\tsegment"]) + "\n"
           + "".join(f"{1e-9 * f:.9g}\t{1e-9 * z:.9g}\t{int(i >= len(there[0]))}\n" for i, (z, _, _, f) in enumerate(rows)), [])


def check_texts(folder):
    sheet, scope = made.Sheet("disc"), made.Microscope(points=300)
    there, back = made.record(sheet, scope, random.Random(11))
    for name, content, more in texts(there, back, scope.k, scope.sensitivity):
        (folder / name).write_bytes(content.encode("latin-1" if name == "units.txt" else "utf-8"))
        document = fit([folder / name], sheet, *more)
        if document is None:
            continue
        best = next(f for f in document["curves"][0]["fits"] if f["recommended"])
        away = (best["Eh_N_per_m"] - sheet.modulus) / best["Eh_stderr_N_per_m"]
        check(abs(away) < 4 and best["Eh_stderr_N_per_m"] < 15, f"{name}: E h {best['Eh_N_per_m']:.1f} N/m, {away:.1f} errors off")


def check_lee(folder):
    """Lee et al., Science 321 (2008) 385: 23 sheets, 67 curves, 342 N/m with a standard deviation of 30 N/m, pretensions
    from 0.07 to 0.74 N/m: sheets drawn so are read as they were drawn."""
    rng, moduli, files = random.Random(2008), [], []
    for drum in range(23):
        moduli.append(rng.gauss(342, 30))
        sheet = made.Sheet("sphere", 0.033, rng.choice((0.1, 0.34, 0.7)), 500.0, moduli[-1])
        files.append(folder / f"lee{drum:02}.h5")
        made.draw_map(files[-1], sheet, made.Microscope(k=1.77, k_told=1.77, depth_nm=70), 3 if drum < 21 else 2, drum)
    document = fit(files, made.Sheet(), k="1.77 N/m")
    if document is None:
        return
    mean = sum(moduli) / 23
    spread = math.sqrt(sum((m - mean) ** 2 for m in moduli) / 22)
    found = next(m for m in document["many"]["means"] if m["of"] == "drums")
    print(f"Lee: drawn {mean:.1f} ± {spread:.1f} N/m, read {found['Eh_N_per_m']:.1f} ± {found['Eh_between_N_per_m']:.1f} N/m "
          f"from {found['count']} drums")
    check(found["count"] == 23, f"Lee: {found['count']} drums")
    check(abs(found["Eh_N_per_m"] - mean) < 2, f"Lee: the mean is read {found['Eh_N_per_m']:.1f} for {mean:.1f} N/m")
    check(abs(found["Eh_between_N_per_m"] - spread) < 3, f"Lee: the spread is read {found['Eh_between_N_per_m']:.1f} for {spread:.1f}")


def campaigns(folder):
    if not full:
        check_campaign(folder, "disc", made.Sheet("disc"), made.Microscope(points=250, adhesion_nN=6), 60, 1)
        return
    count = int(os.environ.get("VALIDATE_CURVES", "1000"))
    for tip, share in (("sphere", 0.033), ("disc", 0.033), ("disc", 0.004)):
        for radius in (250.0, 375.0, 500.0, 750.0, 1000.0):
            pretension = {250.0: 0.1, 375.0: 0.7}.get(radius, 0.34)
            sheet = made.Sheet(tip, share, pretension, radius)
            deep = made.Microscope(adhesion_nN=6, depth_nm=0.18 * radius, before_nm=0.3 * radius)
            check_campaign(folder, f"{tip}-{share}-{radius:g}", sheet, deep, count, int(radius) + len(tip))
    # k is wrong within its error: the same for a whole map, told with that error.
    rng, held = random.Random(9), 0
    for trial in range(20):
        sheet, true = made.Sheet("disc"), 3.0 * (1 + 0.05 * rng.gauss(0, 1))
        wrong = made.Microscope(k=true, k_told=3.0)
        file = folder / f"k{trial}.h5"
        made.draw_map(file, sheet, wrong, 21, 100 + trial)
        document = fit([file], sheet, k="3.00 ± 0.15 N/m")
        if document:
            low, high = document["many"]["joint"][0]["Eh_interval_N_per_m"]
            held += low <= sheet.modulus <= high
    print(f"joint intervals with k wrong within its error hold the truth in {held} of 20")
    check(held >= 16, f"joint intervals with k wrong within its error hold the truth in {held} of 20 only")


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    os.chdir(folder)
    campaigns(folder)
    if not full:
        check_what_is_skipped(folder)
        check_resuming(folder)
        check_settings(folder)
        check_texts(folder)
    else:
        check_lee(folder)
for fault in faults:
    print(fault)
sys.exit(1 if faults else 0)

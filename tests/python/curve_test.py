#!/usr/bin/env python3
"""`validate curve` reads files of an independent writer, and what it writes itself. usage: curve_test.py VALIDATE"""
import json
import pathlib
import subprocess
import sys
import tempfile

import instrument_files as files

program = sys.argv[1]
faults = []


def run(*arguments):
    return subprocess.run([program, "curve", *map(str, arguments)], capture_output=True, text=True)


def curves_of(*arguments):
    answer = run(*arguments, "--json", "-")
    if answer.returncode != 0:
        faults.append(f"{arguments}: exit code {answer.returncode}: {answer.stderr.strip()}")
        return []
    return json.loads(answer.stdout)["curves"]


def check(name, curve, segments, columns):
    found = [[s["kind"], s["points"]] for s in curve["segments"]]
    if found != segments:
        faults.append(f"{name}: segments {found} for {segments}")
    for key, wanted in columns.items():
        column = curve["columns"].get(key)
        if column is None or column["unit"] != wanted["unit"]:
            faults.append(f"{name}: {key}: {'no column' if column is None else column['unit']}; there are {list(curve['columns'])}")
            continue
        values = column["values"]
        for what, value in (("first", values[0]), ("last", values[-1]), ("mean", sum(values) / len(values))):
            if not files.close(value, wanted[what]):
                faults.append(f"{name}: {key}: {what}: {value} for {wanted[what]}")


def check_way_round(folder, name, curve, segments, columns):
    """What is written as CSV and HDF5 is read again as the same."""
    out = folder / (name + "-out")
    written = run(folder / name, "--out", out, "--as", "csv,h5")
    if written.returncode != 0:
        faults.append(f"{name}: --out: {written.stderr.strip()}")
    for file in [*out.glob("*.csv"), out / "curves.h5"]:
        again = curves_of(file)
        if again:
            check(f"{name} as {file.name}", again[0], segments, {k: v for k, v in columns.items() if k in curve["columns"]})


def check_files(folder):
    for name, (make, calibration, segments, columns) in files.FILES.items():
        (folder / name).write_bytes(make())
        curves = curves_of(folder / name, *[text for pair in calibration.items() for text in pair])
        if len(curves) != 1:
            faults.append(f"{name}: {len(curves)} curves")
            continue
        check(name, curves[0], segments, columns)
        if not calibration:
            check_way_round(folder, name, curves[0], segments, columns)


def check_several(folder):
    for name, make in files.SEVERAL.items():
        (folder / name).write_bytes(make())
        curves = curves_of(folder / name)
        for factor, curve in zip((2, 10), curves):
            force = curve["columns"]["force"]["values"]
            wanted = factor * files.FORCE_AND_HEIGHT["force"]["first"]
            if not files.close(force[0], wanted):
                faults.append(f"{name}: force {force[0]} for {wanted}")
        if len(curves) != 2:
            faults.append(f"{name}: {len(curves)} curves for 2")
    (folder / "volume.spm").write_bytes(files.nanoscope(2, curves=3))
    if [c["index"] for c in curves_of(folder / "volume.spm")] != [0, 1, 2]:
        faults.append("volume.spm: not three curves")


def check_gaps(folder):
    """Cells without a value are null; a line that is no row is refused with its number."""
    (folder / "gap.csv").write_text("depth_nm,force_nN\n1,2\nNaN,3\n3,\n4,5\n")
    values = curves_of(folder / "gap.csv")[0]["columns"]
    if values["depth"]["values"][1] is not None or values["force"]["values"][2] is not None:
        faults.append("gap.csv: a missing value is not null")
    refusals = {"word.csv": ("depth_nm,force_nN\n1,2\n2,abc\n", ":3: 'abc' in column 'force_nN' is not a number"),
                "short.csv": ("depth_nm,force_nN\n1,2\n2\n", ":3: 1 cells where the header has 2"),
                "noise.bin": ("\x01\x02\x00\x1b[31m" * 50, "no format that is read here"),
                "empty.csv": ("", "the file is empty")}
    for name, (content, message) in refusals.items():
        (folder / name).write_text(content)
        answer = run(folder / name)
        if answer.returncode != 2 or message not in answer.stderr or name not in answer.stderr or "\x1b" in answer.stderr:
            faults.append(f"{name}: exit code {answer.returncode}: {answer.stderr!r}")


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    try:
        import h5py  # noqa: F401
    except ImportError:
        print("no h5py")
        sys.exit(77)
    check_files(folder)
    check_several(folder)
    check_gaps(folder)
print("\n".join(faults) or f"{len(files.FILES)} files")
sys.exit(bool(faults))

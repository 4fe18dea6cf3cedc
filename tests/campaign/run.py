#!/usr/bin/env python3
"""Tries what may go wrong around a run, for as long as it is given, and adds up what it found.

usage: tests/campaign/run.py [--build DIR] [--minutes N] [--state FILE] [--seed N] [PART...]

Parts: kills, calls, memory, readers, steps, cards (default: all, in turn). The state holds the tallies of all runs and
where each part goes on; the same build and seed draw the same trials. Exit code 1 where something did not hold.
"""
import argparse
import json
import random
import shutil
import sys
import tempfile
import time
from pathlib import Path

import calls
import hostile
import kills
from programs import Laboratory

PARTS = {"kills": kills.trials, "calls": calls.file_trials, "memory": calls.memory_trials,
         "readers": hostile.reader_trials, "steps": hostile.step_trials, "cards": hostile.card_trials}
KEPT_FAILURES = 200


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default="build", help="folder of validate and validate-atoms")
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--state", default="build/campaign.json")
    parser.add_argument("--seed", type=int, default=None, help="default: drawn, and printed")
    parser.add_argument("parts", nargs="*", metavar="PART")
    chosen = parser.parse_args()
    unknown = [part for part in chosen.parts if part not in PARTS]
    if unknown:
        parser.error(f"no part '{unknown[0]}'; allowed: {', '.join(PARTS)}")
    return chosen


def read_state(file):
    try:
        return json.loads(Path(file).read_text())
    except (OSError, ValueError):
        return {"tally": {}, "failures": []}


def write_state(file, state):
    half = Path(str(file) + ".half")
    half.write_text(json.dumps(state, indent=1))
    half.replace(file)


def note(state, kind, met, faults, seed):
    tally = state["tally"].setdefault(kind, {"tried": 0, "met": 0, "failed": 0})
    tally["tried"] += 1
    tally["met"] += bool(met)
    tally["failed"] += bool(faults)
    if faults:
        print(f"campaign: FAILED {kind}, seed or call {seed}: {'; '.join(faults)}", flush=True)
        state["failures"] = [*state["failures"], {"kind": kind, "seed": seed, "faults": faults}][-KEPT_FAILURES:]


def table(state):
    lines = [f"{'trial':44} {'tried':>8} {'met it':>8} {'failed':>8}"]
    for kind, tally in sorted(state["tally"].items()):
        lines.append(f"{kind:44} {tally['tried']:8} {tally['met']:8} {tally['failed']:8}")
    sums = [sum(tally[key] for tally in state["tally"].values()) for key in ("tried", "met", "failed")]
    return "\n".join([*lines, f"{'all':44} {sums[0]:8} {sums[1]:8} {sums[2]:8}"])


def main():
    chosen = arguments()
    seed = chosen.seed if chosen.seed is not None else random.SystemRandom().randrange(1 << 32)
    print(f"campaign: seed {seed}", flush=True)
    state, folder = read_state(chosen.state), tempfile.mkdtemp(prefix="validate-campaign-")
    before = sum(tally["failed"] for tally in state["tally"].values())
    try:
        parts = [(name, PARTS[name](Laboratory(chosen.build, Path(folder) / name), random.Random(f"{seed} {name}"),
                                    state.setdefault(name, {}))) for name in chosen.parts or PARTS]
        end = time.monotonic() + 60 * chosen.minutes
        while time.monotonic() < end:
            for _name, trials in parts:  # each part for some seconds in turn
                turn = time.monotonic() + 20
                while time.monotonic() < min(turn, end):
                    note(state, *next(trials))
                write_state(chosen.state, state)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    print(table(state))
    return 1 if sum(tally["failed"] for tally in state["tally"].values()) > before else 0


if __name__ == "__main__":
    sys.exit(main())

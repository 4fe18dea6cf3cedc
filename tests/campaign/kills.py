"""SIGKILL at random instants: to the program, its launcher, a rank, a drawing; then the run goes on and has to end with
the numbers of one that nobody disturbed."""
import os
import random
import signal
import time

from programs import ATOMS, MEMBRANE, descendants, first_difference, half_written, numbers_of, wait_until_gone

CURVE = "".join(f"{d},{3 * d + 0.02 * d**3:.6f}\n" for d in range(1, 40))

# Name: command, whether --resume continues it.
CASES = {
    "membrane": (MEMBRANE, True),
    "atoms": (ATOMS, True),
    "atoms, two ranks": ([*ATOMS, "--ranks", "2"], True),
    "bulge": (["bulge", "--cells", "16"], True),
    "batch": ([word.replace("60", "50,60") for word in MEMBRANE], True),
    "potential": (["potential", "tersoff", "--refresh"], False),
    "fit": (["fit", "curve.csv", "--radius", "0.5 um", "--nu", "0.165", "--tip-radius", "16.5 nm"], False),
}


def place_of(laboratory):
    place = laboratory.trial()
    (place / "curve.csv").write_text("depth_nm,force_nN\n" + CURVE)
    return place


def reference(laboratory, name):
    """Numbers and duration of a run that nobody disturbs: of the second, when the card is kept already."""
    for _ in range(2):
        place, start = place_of(laboratory), time.monotonic()
        code, said = laboratory.run([*CASES[name][0], "--out", "run"], place)
    if code not in (0, 3, 4):
        raise SystemExit(f"campaign: {name}: exit code {code} without a fault: {said}")
    return {"numbers": numbers_of(place / "run"), "seconds": time.monotonic() - start, "code": code}


def finish(laboratory, name, place):
    """Goes on as the folder asks for; the exit code and what was said."""
    words, resumes = CASES[name]
    if not resumes or not (place / "run").exists():
        return laboratory.run([*words, "--out", "run"], place)
    code, said = laboratory.run([*words, "--out", "run", "--resume"], place)
    if code == 2 and "holds a finished run" in said:
        return 0, ""
    return code, said


def one(laboratory, name, ours, seed):
    """Whether it met a live run, and what did not hold (empty: all did)."""
    dice = random.Random(seed)
    place = place_of(laboratory)
    child = laboratory.start([*CASES[name][0], "--out", "run"], place)
    time.sleep(dice.uniform(0, ours["seconds"]))
    below = descendants(child.pid)
    victim = dice.choice([child.pid, *below])
    met = child.poll() is None
    if met:
        try:
            os.kill(victim, signal.SIGKILL)
        except ProcessLookupError:
            met = False
    child.communicate()
    faults = [f"still alive: {pid}" for pid in wait_until_gone(below)]
    if met and victim != child.pid and child.returncode not in (0, 3, 4, 5, 6, 128 + signal.SIGKILL):  # last: a batch's
        faults.append(f"a part was killed, exit code {child.returncode}")
    code, said = finish(laboratory, name, place)
    if code != ours["code"] and not (code == 0 and not said):
        faults.append(f"went on with exit code {code}: {said[-300:]}")
    elif other := first_difference(ours["numbers"], numbers_of(place / "run")):
        faults.append(f"other numbers: {other}")
    faults += [f"left: {path}" for path in half_written(place / "run")]
    return met, faults


def trials(laboratory, dice, state):
    """Endless; each yields what was tried and how it went."""
    references = {}
    while True:
        name = dice.choice(list(CASES))
        if name not in references:
            references[name] = reference(laboratory, name)
        seed = dice.randrange(1 << 32)
        met, faults = one(laboratory, name, references[name], seed)
        yield f"kill: {name}", met, faults, seed

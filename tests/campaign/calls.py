"""Every call that can fail does, one a run: the n-th write, fsync, rename, open or mkdir for n = 1, 2, 3, …, and
allocations drawn at random."""
import errno
import subprocess
from pathlib import Path

from kills import CASES, finish, place_of, reference
from programs import first_difference, half_written, numbers_of

ERRNO = {"write": errno.ENOSPC, "fsync": errno.EIO, "rename": errno.EACCES, "open": errno.ENOSPC, "mkdir": errno.ENOSPC,
         "malloc": errno.ENOMEM}
FILE_CALLS = ["write", "fsync", "rename", "open", "mkdir"]
# Those before the first belong to the libraries' own start, before main().
FIRST_ALLOCATION, MOST_ALLOCATIONS = 1000, 300000
# CHOLMOD does without some allocations and orders its matrix in another way: last digits differ.
SAME = 1e-9


def built(laboratory):
    """The library that is preloaded."""
    library = laboratory.folder / "failing_call.so"
    source = Path(__file__).with_name("failing_call.c")
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", library, source], check=True)
    return library


def one(laboratory, library, program, name, call, at, ours):
    """Whether the call came, and what did not hold."""
    place = place_of(laboratory)
    report = place / "failed"
    code, said = laboratory.run([*CASES[name][0], "--out", "run"], place, {
        "LD_PRELOAD": str(library), "FAIL_PROGRAM": program, "FAIL_CALL": call, "FAIL_AT": str(at),
        "FAIL_ERRNO": str(ERRNO[call]), "FAIL_REPORT": str(report)})
    if not report.exists():
        return False, []
    faults = []
    allowed = {0, 3, 4, 6} | ({5} if program == "validate-atoms" or call == "malloc" else set())
    if code not in allowed:
        faults.append(f"exit code {code}: {said[-300:]}")
    other = first_difference(ours["numbers"], numbers_of(place / "run"), SAME if call == "malloc" else 0)
    if code in (0, 3, 4) and other:
        faults.append(f"good exit code, other numbers: {other}")
    if code not in (0, 3, 4):
        code, said = finish(laboratory, name, place)
        if code != ours["code"] and not (code == 0 and not said):
            faults.append(f"went on with exit code {code}: {said[-300:]}")
        elif other := first_difference(ours["numbers"], numbers_of(place / "run")):
            faults.append(f"other numbers after going on: {other}")
    return True, faults + [f"left: {path}" for path in half_written(place / "run")]


def file_trials(laboratory, _dice, state):
    """n is kept between the runs of the campaign; after the last call it begins again."""
    library, references = built(laboratory), {}
    kinds = [(program, name, call) for name, programs in (("membrane", ["validate"]),
                                                          ("atoms", ["validate", "validate-atoms"]))
             for program in programs for call in FILE_CALLS]
    while True:
        for program, name, call in kinds:
            if name not in references:
                references[name] = reference(laboratory, name)
            key = f"{program} {name} {call}"
            at = state.setdefault("next", {}).get(key, 1)
            met, faults = one(laboratory, library, program, name, call, at, references[name])
            state["next"][key] = at + 1 if met else 1
            yield f"{call}: {program}, {name}", met, faults, at


def memory_trials(laboratory, dice, state):
    library, ours = built(laboratory), reference(laboratory, "membrane")
    while True:
        at = int(FIRST_ALLOCATION * (MOST_ALLOCATIONS / FIRST_ALLOCATION) ** dice.uniform(0, 1))
        met, faults = one(laboratory, library, "validate", "membrane", "malloc", at, ours)
        yield "malloc: validate, membrane", met, faults, at

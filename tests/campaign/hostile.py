"""Files from others: bytes of good ones changed, cut, doubled, or put in from a list of bad ones. A reader may refuse
them or take them; it may not crash, hang or call it its own mistake."""
import random
import shutil

from kills import CURVE
from programs import ATOMS, first_difference, numbers_of

TIME_LIMIT_S = 30
WORDS = [b"nan", b"inf", b"-1", b"1e308", b"1e-320", b"99999999999999999999", b"\0", b"\xff\xfe", b"[", b"\"", b"{",
         b"=", b"\n", b",", b"2147483648", b"/dev/zero", b"../", b"%s%n", b"'''", b"true"]


def mutated(content, dice):
    data = bytearray(content)
    for _ in range(dice.choice([1, 1, 2, 4, 16])):
        at = dice.randrange(len(data) + 1)
        action = dice.randrange(6)
        if action == 0 and data:
            data[at % len(data)] ^= 1 << dice.randrange(8)
        elif action == 1 and data:
            data[at % len(data)] = dice.randrange(256)
        elif action == 2:
            del data[at:at + dice.choice([1, 2, 8, 64])]
        elif action == 3:
            data[at:at] = dice.choice(WORDS)
        elif action == 4:
            data[at:at] = data[at:at + dice.choice([1, 8, 64])]
        else:
            word = dice.choice(WORDS)
            data[at:at + len(word)] = word
    return bytes(data)


def readers(laboratory):
    """Name: a good file, its name, the command that reads it."""
    inputs = laboratory.build.parent / "inputs"
    place = laboratory.folder / "good"
    if not (place / "run/run.h5").exists():
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        laboratory.run(["bulge", "--cells", "8", "--out", "run"], place)
    return {
        "case": ((inputs / "indentation.toml").read_bytes(), "case.toml",
                 ["indentation", "--dry-run", "--case", "case.toml"]),
        "potential": ((inputs / "potentials/tersoff.toml").read_bytes(), "mine.toml",
                      ["indentation", "--dry-run", "--potential", "mine.toml"]),
        "measured": (("# radius: 0.5 um\ndepth_nm,force_nN\n" + CURVE).encode(), "curve.csv",
                     ["fit", "curve.csv", "--nu", "0.165", "--tip-radius", "16.5 nm"]),
        "run.h5": ((place / "run/run.h5").read_bytes(), "run.h5", ["report", "run.h5", "--out", "page.html"]),
    }


def verdict(code, said):
    if code is None:
        return [f"not ended after {TIME_LIMIT_S} s"]
    if "Sanitizer" in said or "runtime error:" in said:
        return [said[-600:]]
    return [] if code in (0, 2, 3, 4, 6) else [f"exit code {code}: {said[-300:]}"]


def reader_trials(laboratory, dice, _state):
    all_readers = readers(laboratory)
    while True:
        for name, (content, file, words) in all_readers.items():
            seed = dice.randrange(1 << 32)
            place = laboratory.trial()
            (place / file).write_bytes(mutated(content, random.Random(seed)))
            code, said = laboratory.run(words, place, {"PATH": ""} if name == "run.h5" else None, TIME_LIMIT_S)
            yield f"hostile: {name}", True, verdict(code, said), seed


def interrupted_run(laboratory):
    """An unfinished run of atoms with its steps, and its numbers when it is finished."""
    place = laboratory.folder / "unfinished"
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir()
    code, said = laboratory.run([*ATOMS, "--out", "run"], place)
    numbers = numbers_of(place / "run")
    shutil.rmtree(place / "run")
    child = laboratory.start([*ATOMS, "--out", "run"], place)
    steps = place / "run/work/disc/steps"
    while child.poll() is None and not (steps / "step-0002.bin").exists():
        pass
    child.kill()
    child.communicate()
    return place / "run", numbers, code


def step_trials(laboratory, dice, _state):
    """A damaged step is computed again: the numbers stay."""
    run, numbers, code_alone = interrupted_run(laboratory)
    while True:
        seed = dice.randrange(1 << 32)
        own_dice, place = random.Random(seed), laboratory.trial()
        shutil.copytree(run, place / "run")
        steps = sorted(place.glob("run/work/disc/steps/step-*.bin"))
        if not steps:
            raise SystemExit("campaign: the unfinished run has no steps")
        step = own_dice.choice(steps)
        step.write_bytes(mutated(step.read_bytes(), own_dice))
        code, said = laboratory.run([*ATOMS, "--out", "run", "--resume"], place)
        faults = verdict(code, said)
        other = first_difference(numbers, numbers_of(place / "run"))
        if not faults and (code != code_alone or other):
            faults = [f"exit code {code}, other numbers: {other}"]
        yield "hostile: step", True, faults, seed


def card_trials(laboratory, dice, _state):
    """A damaged card is computed again."""
    words = ["potential", "tersoff", "--out", "run"]
    place = laboratory.trial()
    laboratory.run(words, place)
    numbers = numbers_of(place / "run")
    cards = sorted((laboratory.folder / "home/cache/validate/cards").glob("*.json"))
    good = {card: card.read_bytes() for card in cards}
    while True:
        seed = dice.randrange(1 << 32)
        place = laboratory.trial()
        for card, content in good.items():
            card.write_bytes(mutated(content, random.Random(seed)))
        code, said = laboratory.run(words, place)
        faults = verdict(code, said)
        other = first_difference(numbers, numbers_of(place / "run"))
        if not faults and other:
            faults = [f"other numbers: {other}"]
        yield "hostile: card", True, faults, seed

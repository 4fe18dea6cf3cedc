#!/usr/bin/env python3
"""Runs every command of the READMEs' sh blocks, one after the other in an empty folder, as a reader would: they must end with 0
(agreement, or nothing to judge) or 3 (the comparison ran and disagrees).
usage: commands.py SOURCE_FOLDER [--list | --short]   --list only shows them, --short leaves out those marked (minutes)

`build` is the checkout's, `curve.csv` one of its measured curves. Setting up and ctest are what .ci/run does; here they are
left out, what follows them in a line is not."""
import pathlib
import re
import subprocess
import sys
import tempfile

DONE_BEFORE = re.compile(r"(\./bootstrap\.sh|ctest|cmake|git)\b")


def commands(readme):
    """(number of the line, command) of each; a backslash at the end joins a line with the next."""
    inside, begun, text = False, 0, ""
    for number, line in enumerate(readme.read_text().splitlines(), 1):
        if line.startswith("```"):
            inside, text = line == "```sh", ""
        elif inside:
            begun = begun if text else number
            text += line.strip()
            if text.endswith("\\"):
                text = text[:-1]
            elif text:
                yield begun, text
                text = ""


def to_run(command):
    """Without the parts that were done before, and without the comment."""
    parts = command.split(" #")[0].split("&&")
    return " && ".join(part.strip() for part in parts if not DONE_BEFORE.match(part.strip()))


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    options = sys.argv[2:]
    found = [(readme, number, command) for readme in sorted(source.rglob("README.md"))
             if not any(part.startswith("build") for part in readme.relative_to(source).parts)
             for number, command in commands(readme)]
    if not found:
        sys.exit("no README has a command")
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "build").symlink_to(source / "build")
        (pathlib.Path(folder) / "inputs").symlink_to(source / "inputs")
        measured = sorted((source / "inputs/measured").glob("*.csv"))
        (pathlib.Path(folder) / "curve.csv").write_bytes(measured[0].read_bytes())
        for readme, number, command in found:
            line = to_run(command)
            if not line or ("--short" in options and "(minutes)" in command):
                continue
            print(f"{readme.relative_to(source)}:{number}: {line}", flush=True)
            if "--list" in options:
                continue
            run = subprocess.run(["sh", "-c", line], cwd=folder, capture_output=True, text=True)
            if run.returncode not in (0, 3):
                failed += 1
                print(f"  ended with {run.returncode}:\n{run.stderr}", flush=True)
    sys.exit(f"{failed} commands failed" if failed else 0)


main()

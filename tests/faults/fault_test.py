#!/usr/bin/env python3
"""A fault planted in the membrane makes `validate verify membrane` fail. usage: fault_test.py SOURCE BUILD NINJA FOLDER PATCH...

Each PATCH is applied to a copy of the sources in FOLDER; what includes a file that it changes is compiled again with the
build's own commands and linked before the build's libraries, which so give only the rest. The lines before the patch say what
it breaks, which group of the verification must see it, and a row that must fail. Without a PATCH everything is compiled from
an untouched copy, and every group named by a patch of this folder must pass: a copy is not what makes the others fail."""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

COPIED = ("membrane", "compare/verify")  # what a fault may touch, and what includes it on the way to a verdict
HEADERS = ("compare/base/paper.hpp", "compare/base/units.hpp")  # what these include of other rooms


def head_of(patch):
    """The lines `key: value` before the patch."""
    return dict(re.findall(r"^(\w+): (.*)$", patch.read_text().split("\n---")[0], re.MULTILINE))


def fresh_copy(source, tree):
    shutil.rmtree(tree, ignore_errors=True)
    for folder in COPIED:
        shutil.copytree(source / folder, tree / folder)
    for header in HEADERS:
        (tree / header).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source / header, tree / header)


def apply(patch, tree):
    """The files that it changed; fuzz is refused, since a fault in a wrong place shows nothing."""
    with patch.open() as text:
        subprocess.run(["patch", "--strip=1", "--fuzz=0", "--forward"], stdin=text, cwd=tree, check=True)
    return set(re.findall(r"^\+\+\+ b/(\S+)", patch.read_text(), re.MULTILINE))


def included(tree, file, seen):
    """Every file of the tree that `file` includes, itself among them."""
    if file not in seen and (tree / file).is_file():
        seen.add(file)
        for other in re.findall(r'^#include "(.*)"', (tree / file).read_text(), re.MULTILINE):
            included(tree, other, seen)
    return seen


def compilations(source, build, tree):
    """(what to compile from the tree, command, files of the tree that it reads) for each object that the build made of them."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        compiled = pathlib.Path(entry["file"])
        inner = [compiled]
        if "/Unity/" in entry["file"]:
            inner = [pathlib.Path(name) for name in re.findall(r'^#include "(.*)"', compiled.read_text(), re.MULTILINE)]
        inside = [str(path.relative_to(source)) for path in inner if path.is_relative_to(source)]
        if all(name.startswith(tuple(folder + "/" for folder in COPIED)) for name in inside) and inside:
            reads = set()
            for name in inside:
                included(tree, name, reads)
            yield inside, shlex.split(entry["command"]), reads


def compile_copy(tree, build, number, inside, command, source):
    """The object of the tree's files: the build's command with other files, include folder and output."""
    unit, compiled = tree / f"{number}.cpp", tree / f"{number}.o"
    unit.write_text("".join(f'#include "{tree / name}"\n' for name in inside))
    words = [f"-I{tree}" if word == f"-I{source}" else word for word in command]
    words[words.index("-o") + 1], words[words.index("-c") + 1] = str(compiled), str(unit)
    subprocess.run([*words, "-w"], cwd=build, check=True)
    return str(compiled)


def link(build, ninja, objects, program):
    """The build's own link line, with the objects before its libraries."""
    lines = subprocess.run([ninja, "-C", build, "-t", "commands", "validate"], capture_output=True, text=True, check=True).stdout
    line = re.search(r"^: && (.* -o validate .*) && :$", lines, re.MULTILINE)[1]
    words = shlex.split(line)
    at = words.index("-o")
    subprocess.run([*words[:at], *objects, "-o", str(program), *words[at + 2:]], cwd=build, check=True)


def faulty_program(source, build, ninja, folder, patch):
    tree = folder / "tree"
    fresh_copy(source, tree)
    changed = apply(patch, tree) if patch else None
    wanted = [(inside, command) for inside, command, reads in compilations(source, build, tree)
              if changed is None or reads & changed]
    if not wanted:
        sys.exit(f"nothing that is compiled includes {changed}")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(lambda job: compile_copy(tree, build, job[0], *job[1], source), enumerate(wanted)))
    program = folder / "validate"
    link(build, ninja, objects, program)
    return program


def verify(program, groups):
    run = subprocess.run([program, "verify", "membrane", "--quiet", "--group", ",".join(groups)], capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def main():
    source, build, ninja, folder, *patches = sys.argv[1:]
    source, build, folder = (pathlib.Path(path).resolve() for path in (source, build, folder))
    here = pathlib.Path(__file__).parent
    if not patches:
        groups = sorted({head_of(patch)["group"] for patch in here.glob("*.patch")})
        code, text = verify(faulty_program(source, build, ninja, folder / "untouched", None), groups)
        if code != 0:
            sys.exit(f"the untouched copy ends with {code}, not 0:\n{text}")
    for patch in map(pathlib.Path, patches):
        head = head_of(patch)
        code, text = verify(faulty_program(source, build, ninja, folder / patch.stem, patch), [head["group"]])
        failed = [line for line in text.splitlines() if "FAIL" in line and head["row"] in line.split("FAIL", 1)[1]]
        if code != 3 or not failed:
            sys.exit(f"{patch.name}: exit code {code}, not 3 with a failing row '{head['row']}':\n{text}")
        print(f"{patch.name}: {failed[0].strip()}")


main()

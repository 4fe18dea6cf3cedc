#!/usr/bin/env python3
"""Every #include from room to room must be an arrow, that is: stand in the link line of the room's target, and every arrow must
be used. usage: include_lint.py SOURCE_FOLDER ROOMS_FILE   (rooms.txt of the build folder, written by cmake/room.cmake)"""
import pathlib
import re
import sys

source, rooms_file = map(pathlib.Path, sys.argv[1:3])
arrows = {}
for line in rooms_file.read_text().splitlines():
    room, seen = line.split(":")
    arrows[room] = set(seen.split())
used = {room: set() for room in arrows}
faults = []
for leaf in ("membrane", "atomistic", "compare"):
    for path in sorted((source / leaf).rglob("*.[ch]pp")):
        file = path.relative_to(source)
        room = str(file.parent)
        if room not in arrows:
            faults.append(f"{file}: its folder is no room: it has no CMakeLists.txt that calls room()")
            continue
        for number, text in enumerate(path.read_text().splitlines(), 1):
            included = re.match(r'\s*#include "((?:membrane|atomistic|compare)/.*)"', text)
            if not included:
                continue
            other = str(pathlib.PurePosixPath(included[1]).parent)
            used[room].add(other)
            if other != room and other not in arrows[room]:
                faults.append(f"{file}:{number}: {room} may not include from {other}; it sees: {' '.join(sorted(arrows[room]))}")
for room, seen in arrows.items():
    faults += [f"{room}/CMakeLists.txt: the arrow to {other} is not used" for other in sorted(seen - used[room])]

# The arrows have no way back: a room is below another, or beside it.
order, waiting = [], dict(arrows)
while waiting:
    free = [room for room, seen in waiting.items() if not seen & waiting.keys()]
    if not free:
        faults.append("arrows in a ring among: " + " ".join(sorted(waiting)))
        break
    order += free
    for room in free:
        del waiting[room]
print("\n".join(faults) or f"{len(arrows)} rooms, {sum(map(len, arrows.values()))} arrows, none upwards")
sys.exit(bool(faults))

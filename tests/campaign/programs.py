"""The programs under trial: started in a world of their own, watched, and what they leave compared."""
import json
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

TIME_LIMIT_S = 300

MEMBRANE = ["indentation", "--models", "membrane", "--loads", "disc", "--E", "5", "--thickness", "1", "--nu", "0.2",
            "--radius", "60", "--tip-radius", "6", "--depth-step", "4"]
ATOMS = ["indentation", "--radius", "15", "--potential", "tersoff", "--tip-radius", "5", "--depth-step", "1",
         "--depth-max", "4", "--loads", "disc"]


class Laboratory:
    """A folder that holds everything a trial may touch: cache, temporary files and runs."""

    def __init__(self, build, folder):
        self.build, self.folder = Path(build).resolve(), Path(folder).resolve()
        for name in ("home", "tmp", "trial"):
            (self.folder / name).mkdir(parents=True, exist_ok=True)
        self.environment = {**os.environ, "HOME": str(self.folder / "home"), "TMPDIR": str(self.folder / "tmp"),
                            "XDG_CACHE_HOME": str(self.folder / "home/cache")}

    def trial(self):
        """An empty folder."""
        place = self.folder / "trial"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        return place

    def start(self, words, place, more_environment=None):
        return subprocess.Popen([str(self.build / "validate"), *words], cwd=place, stdin=subprocess.DEVNULL,
                                stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                env={**self.environment, **(more_environment or {})})

    def run(self, words, place, more_environment=None, time_limit_s=TIME_LIMIT_S):
        """Exit code (negative: signal; None: it did not end) and what it said."""
        child = self.start(words, place, more_environment)
        try:
            said = child.communicate(timeout=time_limit_s)[1]
        except subprocess.TimeoutExpired:
            child.kill()
            return None, child.communicate()[1].decode(errors="replace")
        return child.returncode, said.decode(errors="replace")


def words_of(pid):
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes().split(b"\0")
    except OSError:
        return []


def is_alive(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def descendants(pid):
    """Living processes below one, parents first."""
    found = []
    for task in Path(f"/proc/{pid}/task").glob("*"):
        try:
            children = (task / "children").read_text().split()
        except OSError:
            continue
        for child in map(int, children):
            found += [child, *descendants(child)]
    return found


def wait_until_gone(pids, seconds=20):
    """Those that still live after it; they are ended."""
    end = time.monotonic() + seconds
    while any(map(is_alive, pids)) and time.monotonic() < end:
        time.sleep(0.02)
    left = [pid for pid in pids if is_alive(pid)]
    for pid in left:
        os.kill(pid, signal.SIGKILL)
    return left


def without_times(node):
    """A document without what differs from run to run: times, paths, command lines."""
    if isinstance(node, dict):
        return {key: without_times(value) for key, value in node.items()
                if not key.endswith("_s") and key not in ("provenance", "command_line", "elapsed", "force_calls",
                                                          "from_cache", "relaxation_evaluations")}
    if isinstance(node, list):
        return [without_times(value) for value in node]
    return node


def numbers_of(folder):
    """What a run has found, to be compared bit for bit; None where it has left nothing."""
    try:
        found = {}
        for name in ("summary.json", "fit.json", "card.json", "batch.json"):
            if (folder / name).exists():
                found[name] = without_times(json.loads((folder / name).read_text()))
        if (folder / "curves.csv").exists():
            lines = (folder / "curves.csv").read_text().splitlines(keepends=True)
            found["curves.csv"] = "".join(line for line in lines if not line.startswith("#"))  # remarks: how it was made
        return found or None
    except (OSError, ValueError):
        return None


def first_difference(ours, theirs, same=0, path=""):
    """Where two documents differ first, numbers by more than `same` of theirs (then counts of iterations may
    differ too); empty: nowhere."""
    if isinstance(ours, float) and isinstance(theirs, float) and abs(ours - theirs) <= same * abs(ours):
        return ""
    if type(ours) is not type(theirs):
        return f"{path}: {str(ours)[:40]} and {str(theirs)[:40]}"
    if isinstance(ours, dict):
        pairs = [(key, ours.get(key), theirs.get(key)) for key in dict.fromkeys([*ours, *theirs])
                 if not same or not key.startswith(("newton_iterations", "factorisations"))]
    elif isinstance(ours, str) and "\n" in ours and not same:
        pairs = list(enumerate_pairs(ours.splitlines(), theirs.splitlines()))
    elif isinstance(ours, str) and "\n" in ours:
        return ""  # the numbers of a document that is compared as well
    elif isinstance(ours, list):
        pairs = list(enumerate_pairs(ours, theirs))
    else:
        return "" if ours == theirs else f"{path}: {ours} and {theirs}"
    return next(filter(None, (first_difference(a, b, same, f"{path}/{key}") for key, a, b in pairs)), "")


def enumerate_pairs(ours, theirs):
    for i in range(max(len(ours), len(theirs))):
        yield i, ours[i] if i < len(ours) else None, theirs[i] if i < len(theirs) else None


def half_written(folder):
    """Names that only a program at work may leave."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*")
                  if path.name.endswith((".tmp", ".part")) or path.name in ("work", ".validate-work"))

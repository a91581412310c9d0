"""What all scripts here share: which packages there are, what work takes, and where they begin."""

import importlib.metadata
import json
import resource
import sys
import time


def versions(packages):
    """Tells the version of each package, or None; without numpy there is none."""
    found = {}
    for package in packages:
        try:
            importlib.metadata.version("numpy")
            found[package] = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            found[package] = None
    return found


def status_bytes(key):
    try:
        with open("/proc/self/status") as status:
            lines = [line for line in status if line.startswith(key)]
        return int(lines[0].split()[1]) * 1024
    except (OSError, IndexError):
        return None


def under_the_clock(work):
    """Returns the result of `work`, and what it took in the words of the table maker."""
    try:
        with open("/proc/self/clear_refs", "w") as peak:
            peak.write("5")
    except OSError:
        pass
    before = status_bytes("VmRSS:")
    processor = resource.getrusage(resource.RUSAGE_SELF)
    start = time.perf_counter()
    result = work()
    seconds = time.perf_counter() - start
    spent = resource.getrusage(resource.RUSAGE_SELF)
    memory = {"before": before, "peak": status_bytes("VmHWM:"), "after": status_bytes("VmRSS:")}
    return result, {
        "seconds": seconds,
        "user": spent.ru_utime - processor.ru_utime,
        "system": spent.ru_stime - processor.ru_stime,
        "memory": None if None in memory.values() else memory,
    }


def begin(packages, main):
    """Does what the command line says, and prints the answer as JSON."""
    asked = sys.argv[1:]
    print(json.dumps(versions(packages) if asked == ["versions"] else main(*asked)))

#!/usr/bin/env python3
"""Tries a sample of mutants: see main.rs and docs/hardening.md.

    run.py TREE PACKAGE COUNT 'TESTS' GROUP...

TREE is a copy of the repository that may be spoilt, PACKAGE the directory in `crates`, GROUP a name and patterns of
files below `src`, `mesh=mesh/*.rs,mesh/**/*.rs`; TESTS are arguments of `cargo test`, `--lib --test builders`, and
`DELONE_FILTERS` names some of the library's own. A mutant is killed if any of these tests fails, takes 20 seconds more than
five times as long as without it, or more than 4 GiB. Prints the survivors and a table.
"""
import collections, glob, json, os, re, resource, subprocess, sys, time

tree, package, count, tests, *groups = sys.argv[1:]
os.chdir(tree)
tool = os.environ.get("DELONE_MUTANTS", "delone-mutants")
features = os.environ.get("DELONE_FEATURES", "").split()
root = f"crates/{package}/src"
names, files = [], []
for group in groups:
    name, patterns = group.split("=")
    found = sorted({f for p in patterns.split(",") for f in glob.glob(f"{root}/{p}", recursive=True) if "test" not in f})
    files += (["--"] if names else []) + found
    names.append(name)
clean = {f: open(f).read() for f in [*files, f"{root}/lib.rs"] if f != "--"}
skipped = set()
assert "pub fn mutant(" not in clean[f"{root}/lib.rs"], "TREE is spoilt already: copy it again"
# The same cases for every mutant, and none that a mutant before it left.
os.environ |= {"PROPTEST_RNG_SEED": "1", "PROPTEST_DISABLE_FAILURE_PERSISTENCE": "1"}

while True:
    for f, text in clean.items():
        open(f, "w").write(text)
    listed = subprocess.run([tool, f"{root}/lib.rs", count, ",".join(map(str, skipped)), *files], check=True, capture_output=True, text=True)
    mutants = [line.split("\t") for line in listed.stdout.splitlines()]
    command = ["cargo", "test", "-p", package, *features, *tests.split(), "--no-run", "--message-format=json"]
    build = subprocess.run(command, capture_output=True, text=True)
    messages = [json.loads(line) for line in build.stdout.splitlines() if line.startswith("{")]
    if build.returncode == 0:
        break
    before = len(skipped)
    for m in messages:
        if m["reason"] == "compiler-message" and m["message"]["level"] == "error":
            for span in (s for s in m["message"]["spans"] if s["is_primary"] and s["file_name"] in clean):
                # Spans count bytes of the whole file; the mutant to blame begins before them.
                text = open(span["file_name"], "rb").read()[: span["byte_end"]]
                skipped |= {int(n) for n in re.findall(rb"mutant\((\d+)\)", text)[-1:]}
    print(f"{len(skipped)} do not compile", flush=True)
    if len(skipped) == before:
        sys.exit(build.stderr[-3000:] + "".join(m["message"]["rendered"] for m in messages if m["reason"] == "compiler-message")[:6000])
# The library's own tests, among which the filters choose, are quick, and come first.
filters = {"lib": os.environ.get("DELONE_FILTERS", "").split()}
built = [m for m in messages if m["reason"] == "compiler-artifact" and m.get("executable") and m["profile"]["test"]]
built.sort(key=lambda m: m["target"]["kind"] != ["lib"])
programs = [(m["executable"], filters.get(m["target"]["kind"][0], [])) for m in built]
longest = 600


def limited():
    """A mutant may run, and take memory, for ever."""
    resource.setrlimit(resource.RLIMIT_CPU, (longest, longest))
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))


def killer(number, programs):
    """Returns the first of the programs in which a test fails."""
    for program in programs:
        environment = {**os.environ, "DELONE_MUTANT": number}
        child = subprocess.Popen([program[0], *program[1]], env=environment, cwd=f"crates/{package}", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=limited)
        # The first test that fails is enough.
        if any(line.endswith("FAILED\n") for line in child.stdout):
            child.kill()
        if child.wait():
            return program
    return None


def used():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


start, before = time.time(), used()
assert not killer("0", programs), "the tests fail without a mutant"
# Of processor time, so that a busy machine kills none.
longest = 20 + int(5 * (used() - before))
print(f"{len(mutants) - len(skipped)} mutants, {time.time() - start:.1f} s for the tests", flush=True)
limit = float(os.environ.get("DELONE_SECONDS", "1e9"))
table = collections.defaultdict(collections.Counter)
# In turns, so that a limit of time leaves a sample of each group.
order = sorted((m for m in mutants if int(m[0]) not in skipped), key=lambda m: (int(m[0]) - min(int(n[0]) for n in mutants if n[1] == m[1])))
# What has killed one mutant of a group is tried first on the next.
tried = collections.defaultdict(lambda: list(programs))
for number, group, place, kind in order:
    if time.time() - start > limit:
        break
    found = killer(number, tried[group])
    table[names[int(group)]]["killed" if found else "survived"] += 1
    if found:
        tried[group].sort(key=lambda program: program != found)
    else:
        print(f"survived: {number} {place} {kind}", flush=True)
for name, counts in table.items():
    print(f"| {name} | {counts.total()} | {counts['killed']} | {100 * counts['killed'] / counts.total():.0f} % |", flush=True)

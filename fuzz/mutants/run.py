#!/usr/bin/env python3
"""Tries a sample of mutants: see main.rs and docs/hardening.md.

    run.py TREE PACKAGE COUNT 'TESTS' GROUP...

TREE is a copy of the repository that may be spoilt, PACKAGE the directory in `crates`, GROUP a name and patterns of
files below `src`, `mesh=mesh/*.rs,mesh/**/*.rs`; TESTS are arguments of `cargo test`, `--lib --test builders`. A mutant
is killed if any of these tests fails, or takes ten times as long as all of them without a mutant (ten seconds at least).
Prints the survivors and a table.
"""
import collections, glob, json, os, re, subprocess, sys, time

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


def cargo(command, *more):
    ran = subprocess.run(["cargo", command, "-p", package, *features, *more, "--message-format=json"], capture_output=True, text=True)
    return ran, [json.loads(line) for line in ran.stdout.splitlines() if line.startswith("{")]


while True:
    for f, text in clean.items():
        open(f, "w").write(text)
    listed = subprocess.run([tool, f"{root}/lib.rs", count, ",".join(map(str, skipped)), *files], check=True, capture_output=True, text=True)
    mutants = [line.split("\t") for line in listed.stdout.splitlines()]
    build, messages = cargo("test", *tests.split(), "--no-run")
    if build.returncode == 0:
        break
    before = len(skipped)
    for m in messages:
        if m["reason"] == "compiler-message" and m["message"]["level"] == "error":
            for span in filter(lambda span: span["is_primary"], m["message"]["spans"]):
                # Spans count bytes of the whole file; the mutant to blame begins before them.
                text = open(span["file_name"], "rb").read()[: span["byte_end"]]
                skipped |= {int(n) for n in re.findall(rb"mutant\((\d+)\)", text)[-1:]}
    print(f"{len(skipped)} do not compile", flush=True)
    if len(skipped) == before:
        sys.exit(build.stderr[-3000:] + "".join(m["message"]["rendered"] for m in messages if m["reason"] == "compiler-message")[:6000])
programs = [m["executable"] for m in messages if m["reason"] == "compiler-artifact" and m.get("executable") and m["profile"]["test"]]
filters = os.environ.get("DELONE_FILTERS", "").split()


def killer(number, programs, limit=None):
    for program in programs:
        try:
            ran = subprocess.run([program, "-q", *filters], env={**os.environ, "DELONE_MUTANT": number}, cwd=f"crates/{package}", capture_output=True, timeout=limit)
        except subprocess.TimeoutExpired:
            print(f"too long: {number}", flush=True)
            return program
        if ran.returncode:
            return program
    return None


start = time.time()
assert not killer("0", programs), "the tests fail without a mutant"
taken = time.time() - start
print(f"{len(mutants) - len(skipped)} mutants, {taken:.1f} s for the tests", flush=True)
limit = float(os.environ.get("DELONE_SECONDS", "1e9"))
table = collections.defaultdict(collections.Counter)
# In turns, so that a limit of time leaves a sample of each group.
order = sorted((m for m in mutants if int(m[0]) not in skipped), key=lambda m: (int(m[0]) - min(int(n[0]) for n in mutants if n[1] == m[1])))
# What has killed one mutant of a group is tried first on the next.
tried = collections.defaultdict(lambda: list(programs))
for number, group, place, kind in order:
    if time.time() - start > limit:
        break
    found = killer(number, tried[group], max(10, 10 * taken))
    table[names[int(group)]]["killed" if found else "survived"] += 1
    if found:
        tried[group].sort(key=lambda program: program != found)
    else:
        print(f"survived: {number} {place} {kind}", flush=True)
for name, counts in table.items():
    print(f"| {name} | {counts.total()} | {counts['killed']} | {100 * counts['killed'] / counts.total():.0f} % |", flush=True)

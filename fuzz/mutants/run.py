#!/usr/bin/env python3
"""Tries a sample of mutants: see main.rs and docs/hardening.md.

    run.py TREE PACKAGE COUNT 'TESTS' GROUP...

TREE is a copy of the repository that may be spoilt, PACKAGE the directory in `crates`, GROUP a name and patterns of
files below `src`, `mesh=mesh/*.rs,mesh/**/*.rs`; TESTS are arguments of `cargo test`, `--lib --test builders`. A mutant
is killed if any of these tests fails, or takes a minute. Prints the survivors and a table.
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


def cargo(command, *more):
    ran = subprocess.run(["cargo", command, "-p", package, *features, *more, "--message-format=json"], capture_output=True, text=True)
    return ran, [json.loads(line) for line in ran.stdout.splitlines() if line.startswith("{")]


while True:
    for f, text in clean.items():
        open(f, "w").write(text)
    listed = subprocess.run([tool, f"{root}/lib.rs", count, ",".join(map(str, skipped)), *files], check=True, capture_output=True, text=True)
    mutants = [line.split("\t") for line in listed.stdout.splitlines()]
    # What does not compile is found sooner without making code.
    build, messages = cargo("check", "--lib")
    if build.returncode == 0:
        break
    before = len(skipped)
    for m in messages:
        if m["reason"] == "compiler-message" and m["message"]["level"] == "error":
            for span in m["message"]["spans"]:
                lines = open(span["file_name"]).read().splitlines()
                text = "\n".join(lines[max(0, span["line_start"] - 3) : span["line_end"] + 2])
                skipped |= {int(n) for n in re.findall(r"mutant\((\d+)\)", text)}
    print(f"{len(skipped)} do not compile", flush=True)
    if len(skipped) == before:
        sys.exit(build.stderr[-3000:] + "".join(m["message"]["rendered"] for m in messages if m["reason"] == "compiler-message")[:6000])
build, messages = cargo("test", *tests.split(), "--no-run")
if build.returncode:
    sys.exit(build.stderr[-3000:])
programs = [m["executable"] for m in messages if m["reason"] == "compiler-artifact" and m.get("executable") and m["profile"]["test"]]
filters = os.environ.get("DELONE_FILTERS", "").split()


def outcome(number):
    for program in programs:
        try:
            ran = subprocess.run([program, "-q", *filters], env={**os.environ, "DELONE_MUTANT": number}, cwd=f"crates/{package}", capture_output=True, timeout=60)
        except subprocess.TimeoutExpired:
            return "killed"
        if ran.returncode:
            return "killed"
    return "survived"


start = time.time()
assert outcome("0") == "survived", "the tests fail without a mutant"
print(f"{len(mutants) - len(skipped)} mutants, {time.time() - start:.1f} s for the tests", flush=True)
limit = float(os.environ.get("DELONE_SECONDS", "1e9"))
table = collections.defaultdict(collections.Counter)
# In turns, so that a limit of time leaves a sample of each group.
order = sorted((m for m in mutants if int(m[0]) not in skipped), key=lambda m: (int(m[0]) - min(int(n[0]) for n in mutants if n[1] == m[1])))
for number, group, place, kind in order:
    if time.time() - start > limit:
        break
    what = outcome(number)
    table[names[int(group)]][what] += 1
    if what == "survived":
        print(f"survived: {number} {place} {kind}", flush=True)
for name, counts in table.items():
    print(f"| {name} | {counts.total()} | {counts['killed']} | {100 * counts['killed'] / counts.total():.0f} % |", flush=True)

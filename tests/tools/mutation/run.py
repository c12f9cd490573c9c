#!/usr/bin/env python3
"""Seeds the faults of mutants.py into a copy of the sources, all in one build behind a switch that the environment
variable SANDBOX_MUTANT sets, and asks of each whether the processor's tests of reference and metrics catch it.

usage: run.py BUILD_FOLDER [FIRST [LAST]]
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
from mutants import MUTANTS

ROOT = pathlib.Path(__file__).resolve().parents[3]
SECONDS_A_MUTANT = 60
SWITCH = """#pragma once
#include <cstdlib>
namespace sandbox {
inline bool mutant(int number) {
    static const int chosen = [] {
        const char *const text = std::getenv("SANDBOX_MUTANT");
        return text != nullptr ? std::atoi(text) : 0;
    }();
    return chosen == number;
}
} // namespace sandbox
"""


def switched(expression, becomes, number):
    """An operator at the front ("/ 3.0") stays outside the choice."""
    operator = re.match(r"[/>] ", expression)
    front = operator.group() if operator else ""
    return f"{front}(::sandbox::mutant({number}) ? ({becomes[len(front):]}) : ({expression[len(front):]}))"


def seed(sources):
    """Nested choices are allowed: a later fault finds its context by the text before any was seeded."""
    edits = {}
    for number, (file, context, expression, becomes) in enumerate(MUTANTS, 1):
        text = (sources / "sandbox" / file).read_text()
        if text.count(context) != 1 or context.count(expression) != 1:
            sys.exit(f"mutants.py: fault {number}, {file}: '{context}' must occur once, and hold '{expression}' once")
        at = text.index(context) + context.index(expression)
        edits.setdefault(file, []).append((at, expression, switched(expression, becomes, number)))
    for file, changes in edits.items():
        path = sources / "sandbox" / file
        text = path.read_text()
        spans = {}
        for at, expression, choice in changes:  # two faults of one expression: the second in the arm of the first
            key = (at, expression)
            spans[key] = choice if key not in spans else choice.replace(f": ({expression}))", f": {spans[key]})")
        for (at, expression), choice in sorted(spans.items(), reverse=True):
            text = text[:at] + choice + text[at + len(expression):]
        path.write_text('#include "mutant.h"\n' + text)
    (sources / "sandbox" / "mutant.h").write_text(SWITCH)


def build(folder):
    sources = folder / "src"
    shutil.rmtree(sources, ignore_errors=True)
    files = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    for file in filter(None, files):
        target = sources / file
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / file, target)
    seed(sources)
    options = ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1", "-DSANDBOX_TESTS=ON"]
    subprocess.run(["cmake", "-S", sources, "-B", folder / "build", "-G", "Ninja", *options], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder / "build", "--target", "sandbox_cpu_tests"], check=True)
    return folder / "build" / "tests" / "sandbox_cpu_tests"


def suites():
    """Those of the reference and of the metrics."""
    names = set()
    for folder in ("reference", "measure/metrics"):
        for path in (ROOT / "tests" / folder).glob("*_test.cpp"):
            names.update(re.findall(r"^TEST(?:_F|_P)?\((\w+),", path.read_text(), re.MULTILINE))
    return ":".join(sorted(f"{name}.*" for name in names))


def catches(tests, number):
    environment = {**os.environ, "SANDBOX_MUTANT": str(number)}
    command = [tests, f"--gtest_filter={suites()}", "--gtest_brief=1", "--gtest_fail_fast"]
    try:
        return subprocess.run(command, env=environment, capture_output=True, timeout=SECONDS_A_MUTANT).returncode != 0
    except subprocess.TimeoutExpired:
        return True


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    last = int(sys.argv[3]) if len(sys.argv) > 3 else len(MUTANTS)
    tests = build(folder)
    if catches(tests, 0):
        sys.exit("the tests fail without a fault")
    missed = []
    for number in range(first, last + 1):
        file, _, expression, becomes = MUTANTS[number - 1]
        if not catches(tests, number):
            missed.append(number)
            print(f"not caught: {number}  {file}: {expression}  ->  {becomes}", flush=True)
    count = last - first + 1
    print(f"{count - len(missed)} of {count} caught")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Frames of shading-sandbox against hand-written programs, from outside: other processes, taking turns.

usage: frame_turns.py BUILD_FOLDER [TURNS [FRAMES]]

Every contender runs by itself and draws FRAMES frames when it is told to; who begins a turn alternates. A frame is:
clear, draw, finish. Three attenuated point lights, a sphere of 64 x 128, 800x600. Printed are medians and the quartiles
of the paired ratios; then the time from a process's start to its first finished frame.
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

LIGHT = {"type": "point", "ambient": 0.2, "diffuse": 0.8, "specular": 0.8,
         "attenuation": {"constant": 0.2, "linear": 0.1, "quadratic": 0.1}}
SCENE = {"lights": [LIGHT | {"color": [0.8, 0, 0], "position": [0, 0, 3]},
                    LIGHT | {"color": [0, 0.8, 0], "position": [-4, 0, -1.5]},
                    LIGHT | {"color": [0.8, 0.8, 0.8], "position": [0, 6, 3]}],
         "objects": [{"name": "ball", "mesh": {"shape": "sphere", "radius": 1, "rings": 64, "segments": 128}}]}
DUELS = [  # ours: technique, target; the program that it meets
    ("per-pixel/blinn-phong:program=baked", "display", "lean/per-pixel/bytes"),
    ("per-pixel/blinn-phong:program=baked", "display", "plain/per-pixel/bytes"),
    ("per-pixel/blinn-phong", "display", "plain/per-pixel/bytes"),
    ("per-pixel/blinn-phong", "float", "plain/per-pixel/light"),
    ("per-pixel/blinn-phong", "float", "textbook/per-pixel/light"),
    ("per-vertex/blinn-phong:program=baked", "display", "lean/per-vertex/bytes"),
    ("per-vertex/blinn-phong", "display", "plain/per-vertex/bytes"),
    ("per-vertex/blinn-phong", "float", "textbook/per-vertex/light"),
]


class Contender:
    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        json.loads(self.process.stdout.readline())

    def frame_time(self, frames):
        self.process.stdin.write(f"{frames}\n")
        self.process.stdin.flush()
        return statistics.fmean(json.loads(self.process.stdout.readline())["ms"])

    def end(self):
        self.process.stdin.close()
        self.process.wait()


def start_time(command, _):
    begin = time.monotonic_ns()
    process = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=True)
    return (json.loads(process.stdout.splitlines()[0])["first_ns"] - begin) / 1e6


def take_turns(measure, turns, frames):
    """`measure`: of ours, of theirs. Returns two lists."""
    times = ([], [])
    for turn in range(-3, turns):
        for side in ((0, 1) if turn % 2 else (1, 0)):
            took = measure[side](frames)
            if turn >= 0:
                times[side].append(took)
    return times


def report(ours, theirs, times):
    low, median, high = statistics.quantiles([a / b for a, b in zip(*times)], n=4)
    print(f"{ours:52} {statistics.median(times[0]):8.3f} ms | {theirs:26} {statistics.median(times[1]):8.3f} ms | "
          f"ratio {median:.3f} [{low:.3f} {high:.3f}]", flush=True)


def main():
    build = pathlib.Path(sys.argv[1])
    turns, frames = (int(word) for word in (sys.argv[2:] + ["31", "10"][len(sys.argv) - 2:])[:2])
    with tempfile.NamedTemporaryFile("w", suffix=".json") as scene:
        json.dump(SCENE, scene)
        scene.flush()

        def ours(technique, target, count="-"):
            return [build / "shading-sandbox", "time", scene.name, "--technique", technique, "--target", target,
                    "--size", "800x600", "--frames", count]

        def theirs(kind):
            return [build / "tests/bench/bare_frames", kind]

        print(f"load {os.getloadavg()[0]:.2f}, {turns} turns of {frames} frames")
        for technique, target, kind in DUELS:
            pair = [Contender(ours(technique, target)), Contender(theirs(kind))]
            report(f"{technique}, {target}", kind, take_turns([side.frame_time for side in pair], turns, frames))
            for side in pair:
                side.end()
        print("from a process's start to its first finished frame:")
        for technique in ("per-pixel/blinn-phong", "per-pixel/blinn-phong:program=baked"):
            starts = [(lambda _, command=command: start_time(command, _))
                      for command in (ours(technique, "display"), theirs("lean/per-pixel/bytes"))]
            report(f"{technique}, display", "lean/per-pixel/bytes", take_turns(starts, turns, frames))


if __name__ == "__main__":
    main()

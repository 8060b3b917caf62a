"""Times the package beside Rust: `measure.py PROGRAM SCENE`, where PROGRAM is the same map in Rust."""

import statistics
import subprocess
import sys
import time

import numpy as np

import frictiongen

ROUNDS = 15


def timed(ask):
    start = time.perf_counter()
    answer = ask()
    return time.perf_counter() - start, answer


def main() -> None:
    program, scene = sys.argv[1:]
    frame = frictiongen.System.from_file(scene)
    r, beta = np.linspace(0.2, 2.5, 200), np.linspace(0.01, 1.5, 200)
    ours, theirs = [], []
    for _ in range(ROUNDS):
        done = subprocess.run([program, scene], capture_output=True, text=True, check=True)
        seconds, stuck = done.stdout.split()
        theirs.append(float(seconds))
        frame.map(r=r, beta=beta)
        seconds, found = timed(lambda: frame.map(r=r, beta=beta))
        ours.append(seconds)
        if int(stuck) != int((found.regime == "stuck").sum()):
            raise SystemExit("the two maps differ")
    for name, choose in (("median", statistics.median), ("least", min)):
        python, rust = choose(ours), choose(theirs)
        print(
            f"map of 200 x 200, {name} of {ROUNDS} in turn: Python {1e3 * python:.1f} ms, Rust {1e3 * rust:.1f} ms, "
            f"ratio {python / rust:.3f}"
        )
    r = np.linspace(0.05, 5.0, 10**6)
    for name, ask in (("exact", frame.limits), ("without search", frame.limits_without_search)):
        seconds = [timed(lambda ask=ask: ask(r=r))[0] for _ in range(3)]
        print(f"10^6 pairs of limits in one call, {name}, least of 3: {min(seconds):.3f} s")


if __name__ == "__main__":
    main()

"""A parameter study of ten thousand scenes in several processes.

    python cluster.py [SCENES [PROCESSES]]    10000 scenes in 2 processes by default

Masses, springs, damping and static friction of a frame scatter at random.  The study asks for the peak of the upper
floor over a band.  It prints the median and the upper twentieth of the peaks, and the times in one process and in
several.  The same function runs on a cluster: give its address to `Client` in place of a `LocalCluster`.
"""

import os
import sys
import time

# A call computes on all cores.  Here each process has one thread, so that the processes do not compete for the cores.
os.environ.setdefault("RAYON_NUM_THREADS", "1")

import numpy as np
from dask.distributed import Client, LocalCluster

import frictiongen

FRAME = frictiongen.System(frictiongen.FRAME)
#: Scenes of one task.  A task takes some tenths of a second, so that its overhead of about a millisecond is small.
PORTION = 200


def peaks(seed: int, count: int) -> list[float]:
    """Returns the largest amplitude of the upper floor, in m, of `count` scenes."""
    random = np.random.default_rng(seed)
    found = []
    for _ in range(count):
        scatter = random.normal(1.0, 0.05, 4)
        scene = FRAME.replace(
            m={"lower": 3.27 * scatter[0], "upper": 3.25 * scatter[1]},
            k={"base - lower": 1190.0 * scatter[2], "lower - upper": 1323.0 * scatter[3]},
            zeta=random.uniform(0.005, 0.02, 2),
            stiction=random.uniform(1.0, 1.3),
        )
        answer = scene.response(hz=np.linspace(1.0, 7.0, 40), friction=0.5, base=0.001, of="upper")
        # A point without an answer has the amplitude NaN.
        found.append(float(np.nanmax(answer.masses["upper"].amplitude_m)))
    return found


def study(client: Client, scenes: int) -> tuple[float, list[float]]:
    """Returns the time in s, and the peaks of all scenes in the order of their seeds."""
    start = time.perf_counter()
    seeds = range(-(-scenes // PORTION))
    tasks = client.map(peaks, seeds, [min(PORTION, scenes - PORTION * seed) for seed in seeds], pure=False)
    found = [peak for portion in client.gather(tasks) for peak in portion]
    return time.perf_counter() - start, found


def main(scenes: int = 10000, processes: int = 2) -> None:
    times, answers = [], []
    for workers in (1, processes):
        with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
            client.gather(client.map(lambda _: frictiongen.__version__, range(workers), pure=False))
            taken, found = study(client, scenes)
            times.append(taken)
            answers.append(found)
    assert answers[0] == answers[1], "the number of processes has changed an answer"
    median, upper = 1e3 * np.quantile(answers[0], [0.5, 0.95])
    print(f"{scenes} scenes: the median of the peaks is {median:.3f} mm, one in twenty is above {upper:.3f} mm")
    print(f"1 process: {times[0]:.1f} s; {processes} processes: {times[1]:.1f} s; ratio {times[0] / times[1]:.2f}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))

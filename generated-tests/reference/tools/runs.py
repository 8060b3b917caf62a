"""Makes ../runs.json from runs_points.json: motions in time, segment by segment.

    env/bin/python generated-tests/reference/tools/runs.py

A point has a scene, r, beta, how many events, and how it starts: from rest, from `state`, or with the
contact at rest under a force of `force` beta, displaced along `state`.
"""

import json
import sys
from pathlib import Path

import numpy as np

from integrate import TAU, Integrator, Lost
from orbits import of, plain

HERE = Path(__file__).parent
# Least length of a segment, and least minimum of a function before its zero, that the reference accepts.
CLEAR = 1e-5


def started(it, point):
    state = np.array(point.get("state", [0.0] * (2 * it.n)))
    if "force" in point:
        # The holding force is linear in the displacements.
        state[it.n :] = 0.0
        none, one = it.holding(0.0, np.zeros(2 * it.n)), it.holding(0.0, state)
        state = state * ((point["force"] * it.beta - none) / (one - none))
    return state


def run(point, name):
    scene = of(point)
    it = Integrator(scene, point["r"], point["beta"])
    state = started(it, point)
    answer = {
        "description": scene.text(name), "mu": scene.mu, "r": it.r, "beta": it.beta,
        "start": state.tolist() if np.any(state) else None,
    }
    contact = it.start(0.0, state)
    tau, segments = 0.0, []
    while len(segments) < point["events"]:
        segment, state, contact = it.advance(tau, state, contact, 40 * TAU)
        if segment.event is None:
            raise Lost("nothing happens")
        if segment.length < CLEAR or segment.nearest < CLEAR:
            raise Lost("two events in one")
        tau += segment.length
        between = segment.event == "stop" and abs(segment.force) > it.beta
        segments.append([segment.contact, segment.length, segment.event, bool(between)])
    answer["segments"] = segments
    answer["x"], answer["v"] = state[: it.n].tolist(), state[it.n :].tolist()
    # The contact force at the end, from which the state of the contact follows.
    answer["friction"] = float(it.holding(tau, state)) if contact == 0 else contact * it.beta
    return answer


def main():
    points = json.loads((HERE / "runs_points.json").read_text())
    answers = []
    for index, point in enumerate(points):
        answers.append(plain(run(point, f"Run{index + 1:03}")))
        print(index + 1, len(answers[-1]["segments"]), file=sys.stderr)
    (HERE.parent / "runs.json").write_text(json.dumps(answers) + "\n")


if __name__ == "__main__":
    main()

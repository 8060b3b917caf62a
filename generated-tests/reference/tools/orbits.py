"""Makes ../orbits_more.json from points.json.

    python3 -m venv env && env/bin/pip install numpy scipy
    env/bin/python generated-tests/reference/tools/orbits.py

Each motion is followed from rest until it repeats after 1 to 64 cycles, then brought to rounding by
Newton's method with finite differences on the map of its own period.  One that does not repeat gets a
fixed point of the map of one cycle, with its multipliers.  One that comes to rest on a continuum, ever more
slowly, is followed for thousands of cycles and continued to infinitely many.
"""

import json
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from integrate import TAU, Integrator, Lost, Scene

HERE = Path(__file__).parent
MOST_PERIOD = 64
# Relative difference of two maxima below which they count as equal, so that no phase is recorded.
TWINS = 1e-7


def of(point):
    scene = point["scene"]
    springs = [tuple(spring) for spring in scene["springs"]]
    return Scene(
        scene["masses"], springs, tuple(scene["contact"]), scene["excitation"],
        scene.get("zeta"), scene.get("mu", 1),
    )


def cycle(it, state, contact):
    return it.run(state, 1, contact=contact)


def follow(it, most):
    """Follows motion from rest until a cycle repeats. Returns the period or None, and the states and contacts."""
    state, contact = np.zeros(2 * it.n), None
    states, contacts, segments = [], [], []
    for count in range(most):
        segments, state, contact = cycle(it, state, contact)
        states.append(state)
        contacts.append(contact)
        if count % 16 == 15 and count > 30:
            scale = np.abs(state).max()
            for period in range(1, min(MOST_PERIOD, count // 2) + 1):
                apart = [np.abs(states[-1 - i] - states[-1 - i - period]).max() for i in range(period)]
                if max(apart) < 1e-7 * scale:
                    return period, state, contact, states, contacts
    return None, state, contact, states, contacts


def longest_slide(it, state, contact, period):
    """Returns the instant, the state and the contact in the middle of the longest slide of a period."""
    segments, _, _ = it.run(state, period, contact=contact)
    slides = [segment for segment in segments if segment.contact]
    if not slides:
        return None
    best = max(slides, key=lambda segment: segment.length)
    middle = best.length / 2
    return best.start + middle, best.motion.at(middle), best.contact


def newton(it, tau, state, contact, period, steps=12):
    """Returns the fixed point near a state of the map of a period, the map's derivative, and the last step."""
    image = lambda x: it.run(x, tau=tau, length=period * TAU, contact=contact)[1]
    size, last = len(state), np.inf
    for _ in range(steps):
        scale = np.abs(state).max()
        h = 1e-6 * scale
        ends = [(image(state + h * e), image(state - h * e)) for e in np.eye(size)]
        jacobian = np.column_stack([(a - b) / (2 * h) for a, b in ends])
        try:
            step = np.linalg.solve(np.eye(size) - jacobian, image(state) - state)
        except np.linalg.LinAlgError:
            return None
        length = np.abs(step).max() / scale
        state = state + step
        # The step has reached rounding, or rounding keeps it from becoming smaller.
        if length < 1e-14 or (length < 1e-10 and length > last / 4):
            return state, jacobian, length
        if length > 1e3:
            return None
        last = length
    return None


def coordinate(it, segment, which):
    """Returns the columns of a mass's motion, or of z for the contact."""
    columns = segment.motion.columns
    if which is not None:
        return columns[which]
    row = it.scene.w @ columns[: it.n]
    row[-2] -= it.scene.s * np.exp(1j * segment.start)
    return row


def harmonic(segments, rows, n, period):
    total = 0
    for segment, row in zip(segments, rows):
        for sign in (1, -1):
            # x = (sum + its conjugate)/2.
            coefficients = row if sign > 0 else row.conj()
            rates = segment.motion.rates if sign > 0 else segment.motion.rates.conj()
            s, t = rates - 1j * n, segment.length
            small = np.abs(s * t) < 1e-9
            parts = np.where(small, t, np.expm1(s * t) / np.where(small, 1, s))
            total += (coefficients @ parts) * np.exp(-1j * n * segment.start) / 2
    return total / (np.pi * period) / (2 if n == 0 else 1)


def extremes(segments, rows, held):
    """Yields value and instant of every local extreme of x. A stop counts with the instant at which it begins."""
    for before, segment, row in zip([None, *segments], segments, rows):
        rates, length = segment.motion.rates, segment.length
        value = lambda t: float((row @ np.exp(rates * t)).real)
        # Where a slide and a stop meet, only the stop yields the value.
        started = held and before is not None and before.contact == 0
        stopped = held and segment.event == "stop"
        if held and segment.contact == 0:
            yield value(0), segment.start
            continue
        slope = lambda t: float(((row * rates) @ np.exp(rates * t)).real)
        count = int(24 * length / TAU * max(1, np.abs(rates).max())) + 8
        grid = np.linspace(0, length, count)
        slopes = [slope(t) for t in grid]
        # Both ends of a segment count, because the slope may vanish at an end.
        for i, t in enumerate(grid):
            if (i == 0 and not started) or (i == count - 1 and not stopped):
                yield value(t), segment.start + t
            if i and slopes[i - 1] * slopes[i] < 0:
                t = brentq(slope, grid[i - 1], t, xtol=1e-15)
                yield value(t), segment.start + t


def lag(value, start):
    """Returns the lag of an extreme, with half a turn added if the extreme is negative."""
    turned = start + (np.pi if value < 0 else 0)
    return np.pi - (np.pi - turned) % TAU


def motion(it, segments, which, period):
    rows = [coordinate(it, segment, which) for segment in segments]
    scene = it.scene
    held = which is None or (scene.s == 0 and not isinstance(scene.contact[1], int) and which == scene.contact[0] - 1)
    found = list(extremes(segments, rows, held))
    amplitude = max(abs(value) for value, _ in found)
    near = [lag(*one) for one in found if abs(one[0]) > amplitude * (1 - TWINS)]
    best = [lag(*one) for one in found if abs(one[0]) > amplitude * (1 - 1e-13)]
    spread = max(abs((one - near[0] + np.pi) % TAU - np.pi) for one in near)
    first = harmonic(segments, rows, 1, period)
    third = harmonic(segments, rows, 3, period)
    return {
        "amplitude": amplitude,
        # The instant of a nearly flat maximum has only half of the digits.
        "phase": min(best, key=abs) if spread < 1e-3 else None,
        "mean": harmonic(segments, rows, 0, period).real,
        "fundamental": [first.real, first.imag],
        "third": [third.real, third.imag],
    }


def origin(it, segments):
    """Returns the instant at which z leaves its largest maximum, or None if two maxima are equal."""
    leaving = []
    for segment in segments:
        if segment.contact < 0:
            z = float(coordinate(it, segment, None).sum().real)
            leaving.append((z, segment.start % TAU))
    if not leaving:
        return None, None
    leaving.sort(reverse=True)
    size = abs(leaving[0][0]) + abs(leaving[-1][0])
    if len(leaving) > 1 and leaving[0][0] - leaving[1][0] < 1e-6 * size:
        return None, None
    # The second result is the distance from the largest to the least of these maxima, divided by their size.
    return leaving[0][1], (leaving[0][0] - leaving[-1][0]) / size


def record(it, tau, state, contact, period):
    segments, after, _ = it.run(state, tau=tau, length=period * TAU, contact=contact)
    count = lambda event: sum(segment.event == event for segment in segments)
    half = it.run(state, tau=tau, length=period * np.pi, contact=contact)[1]
    scale = np.abs(state).max()
    forces = [abs(s.force) / it.beta for s in segments if s.event == "stop"]
    start, below = origin(it, segments)
    return {
        "period": period,
        # The first and the last segment are parts of one segment.
        "segments": len(segments) - 1,
        "stops": count("stop"),
        "reversals": count("reversal"),
        "symmetric": bool(period % 2 and np.abs(half + state).max() < 1e-8 * scale),
        "stuck_fraction": sum(s.length for s in segments if s.contact == 0) / (TAU * period),
        "shortest": min(s.length for s in segments),
        "graze": min(s.nearest for s in segments),
        "held_between": sum(1 < force <= it.scene.mu for force in forces),
        "repeats_to": np.abs(after - state).max() / scale,
        "origin": start,
        "others_below": below,
        "contact": motion(it, segments, None, period),
        "masses": [motion(it, segments, mass, period) for mass in range(it.n)],
    }


def at_maximum(it, tau, state, contact):
    """Returns the state at the next maximum of the load."""
    return it.run(state, tau=tau, length=(-tau) % TAU, contact=contact)[1]


def settled(it, most):
    """Returns the steady state that motion from rest reaches, or None."""
    period, state, contact, states, contacts = follow(it, most)
    if period is None:
        return None, states, contacts
    middle = longest_slide(it, state, contact, period)
    if middle is None:
        return {"period": 1, "stops": 0, "stuck_fraction": 1.0}, states, contacts
    tau, start, side = middle
    found = newton(it, tau, start, side, period)
    if found is None:
        raise Lost("no fixed point where the motion repeats")
    fixed, jacobian, step = found
    scale = np.abs(fixed).max()
    if np.abs(fixed - start).max() > 1e-4 * scale:
        raise Lost("the fixed point is elsewhere")
    # If the approach alternates, the steady state has a shorter period than the motion on the way to it.
    for fewer in (cycles for cycles in range(1, period) if period % cycles == 0):
        again = it.run(fixed, tau=tau, length=fewer * TAU, contact=side)[1]
        if np.abs(again - fixed).max() < 1e-9 * scale:
            period = fewer
            fixed, jacobian, step = newton(it, tau, fixed, side, period)
            break
    answer = record(it, tau, fixed, side, period)
    answer["multiplier"] = float(np.abs(np.linalg.eigvals(jacobian)).max())
    answer["newton"] = step
    return answer, states, contacts


def left_alone(it, states, contacts):
    """Returns an unstable fixed point of the map of one cycle, near which the motion passes."""
    order = sorted(range(30, len(states) - 1), key=lambda k: np.abs(states[k + 1] - states[k]).max())
    for k in order[:12]:
        middle = longest_slide(it, states[k], contacts[k], 1)
        if middle is None:
            continue
        tau, start, side = middle
        try:
            found = newton(it, tau, start, side, 1)
            if found is None:
                continue
            fixed, jacobian, step = found
            multiplier = float(np.abs(np.linalg.eigvals(jacobian)).max())
            answer = record(it, tau, fixed, side, 1)
        except Lost:
            continue
        if multiplier > 1.01 and answer["repeats_to"] < 1e-9:
            answer["multiplier"], answer["newton"] = multiplier, step
            answer["state"] = at_maximum(it, tau, fixed, side).tolist()
            return answer
    return None


def tending(it, most):
    """Extrapolates a motion whose stops shrink as n^(-1/2) after n cycles to infinitely many cycles."""
    state, contact, counts, values, shares = np.zeros(2 * it.n), None, [], [], []
    for count in range(1, most + 1):
        segments, state, contact = cycle(it, state, contact)
        if count % (most // 16) == 0 and count >= most // 4:
            moved = [motion(it, segments, which, 1) for which in [None, *range(it.n)]]
            counts.append(count)
            values.append([x for m in moved for x in (m["amplitude"], m["mean"], *m["fundamental"])])
            shares.append(sum(s.length for s in segments if s.contact == 0) / TAU)
    powers = np.array(counts, float)[:, None] ** (-0.5 * np.arange(6))
    limits, fewer = (np.linalg.lstsq(powers[:, :k], np.array(values), rcond=None)[0][0] for k in (6, 5))
    rest = np.linalg.lstsq(powers, np.array(shares), rcond=None)[0][0]
    named = [
        {"amplitude": row[0], "mean": row[1], "fundamental": [row[2], row[3]]}
        for row in limits.reshape(-1, 4)
    ]
    return {
        "kind": "marginal", "period": 1, "cycles": most,
        "stuck_fraction": rest, "stuck_fraction_then": shares[-1],
        # Change of the limits by the sixth term of the fit.
        "known_to": np.abs(limits - fewer).max(),
        "contact": named[0], "masses": named[1:],
    }


def by_beta(it, scene, r, beta, most):
    """Returns the motion under the wrong rule that the contact stops if its force is at most beta."""
    try:
        wrong, _, _ = settled(Integrator(scene, r, beta, rule=beta), most)
    except Lost:
        return None
    if wrong is None or "contact" not in wrong:
        return None
    return {
        "stops": wrong["stops"],
        "reversals": wrong["reversals"],
        "period": wrong["period"],
        "contact_amplitude": wrong["contact"]["amplitude"],
    }


def reference(point, name):
    scene, r, beta = of(point), point["r"], point["beta"]
    it = Integrator(scene, r, beta)
    most = point.get("cycles", 400)
    answer = {"description": scene.text(name), "mu": scene.mu, "r": r, "beta": beta}
    if "tends" in point:
        return answer | tending(it, point["tends"])
    steady, states, contacts = settled(it, most)
    answer["cycles"] = len(states)
    if steady is None:
        steady = left_alone(it, states, contacts)
        if steady is None:
            raise Lost("no fixed point, no repetition")
        answer["kind"] = "unstable"
    else:
        answer["kind"] = "steady"
        if steady.get("held_between"):
            answer["by_beta"] = by_beta(it, scene, r, beta, most)
    return answer | steady


def plain(value):
    if isinstance(value, dict):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and not np.isfinite(value) else value


def main():
    points = json.loads((HERE / "points.json").read_text())
    answers = []
    for index, point in enumerate(points):
        answers.append(plain(reference(point, f"Point{index + 1:03}")))
        print(index + 1, answers[-1]["kind"], answers[-1]["period"], file=sys.stderr)
    lines = ",\n".join(" " + json.dumps(answer) for answer in answers)
    (HERE.parent / "orbits_more.json").write_text(f"[\n{lines}\n]\n")


if __name__ == "__main__":
    main()

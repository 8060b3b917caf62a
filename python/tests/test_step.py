"""The motion under any load, against the exact run under a harmonic one, and bad input."""

import math
import re

import numpy as np
import pytest

from frictiongen import DomainError, System


@pytest.mark.parametrize("friction", [0.0, 3.0])
def test_a_harmonic_force_by_steps_is_the_exact_run(block, friction):
    """Straight lines between 2000 samples a cycle leave (2 pi/2000)^2/8 of the force out, 1.2e-6; the response to it is of
    that order times the amplification, and over three cycles adds up to no more than some times that."""
    hz, force, samples = 0.6, 10.0, 2000
    run = block.simulate(hz=hz, friction=friction, force=force, cycles=3, samples=samples)
    dt = 1 / (hz * samples)
    load = force * np.cos(2 * math.pi * np.arange(len(run.time_s)) / samples)
    steps = block.step(dt, force=load, friction=friction)
    np.testing.assert_allclose(steps.time_s, run.time_s, rtol=1e-13)
    size = np.abs(run["block"].displacement_m).max()
    np.testing.assert_allclose(steps["block"].displacement_m, run["block"].displacement_m, atol=1e-5 * size)
    same = steps["contact"].state[1:] == run["contact"].state[1:]
    # But beside an event, whose instant differs by a step at most.
    assert (~same).sum() <= 2 * len(run.events.tau)
    assert friction == 0.0 or steps.events.sum() > 5
    work = steps.work
    assert work.load == pytest.approx(work.friction + work.damping + work.stored, rel=1e-12)
    assert work.friction == pytest.approx(friction * np.abs(np.diff(run["block"].displacement_m)).sum(), rel=1e-3, abs=1e-12)


def test_forces_on_further_masses_and_the_base(frame):
    t = 1e-3 * np.arange(500)
    base = {"base": 0.001 * np.sin(12 * t), "base_velocity": 0.012 * np.cos(12 * t)}
    alone = frame.step(1e-3, friction=0.2, **base)
    pushed = frame.step(1e-3, friction=0.2, on={"upper": 0.5}, **base)
    assert pushed["upper"].displacement_m[-1] != alone["upper"].displacement_m[-1]
    again = frame.step(1e-3, friction=np.full(500, 0.2), on={"upper": np.full(500, 0.5)}, **base)
    assert (again["upper"].displacement_m == pushed["upper"].displacement_m).all()
    assert len(pushed.to_frame()) == 500 and pushed.plot().has_data()


def test_what_cannot_be_stepped(block, frame):
    for system, asked, said in [
        (block, {"base": [1.0], "base_velocity": [0.0]}, "a force drives the scene: give force"),
        (block, {}, "a force drives the scene: give force"),
        (frame, {"force": [1.0]}, "the base moves: give base"),
        (frame, {"base": [1.0]}, "the base moves: give base"),
        (frame, {"base": [1.0, 2.0], "base_velocity": [0.0]}, "base_velocity: 2 numbers are needed"),
        (block, {"force": 1.0}, "force: a row of numbers is needed"),
        (block, {"force": [1.0, math.nan]}, "force[1] is NaN: it must be finite"),
        (block, {"force": [1.0], "friction": -1.0}, "friction is -1.0"),
        (block, {"force": [1.0], "friction": [1.0, 2.0]}, "friction: 1 numbers are needed"),
        (block, {"force": [1.0], "dt": 0.0}, "dt = 0.0"),
        (block, {"force": [1.0], "dt": math.nan}, "dt = NaN"),
        (block, {"force": [1.0], "dt": 1e9}, "dt = 1000000000.0"),
        (block, {"force": [1.0], "on": {"roof": 1.0}}, "on: there is no mass `roof`"),
        (block, {"force": [1.0], "on": {"contact": 1.0}}, "not on the contact"),
        (block, {"force": [1e300], "dt": 0.01}, "outside the domain"),
    ]:
        with pytest.raises(DomainError, match=re.escape(said)):
            system.step(**({"dt": 0.01, "friction": 1.0} | asked))
    for asked in [{"on": [1.0]}, {"on": {3: 1.0}}, {"friction": "1 N"}, {"dt": "1 ms"}, {"force": "1"}]:
        with pytest.raises(TypeError):
            block.step(**({"dt": 0.01, "friction": 1.0, "force": [1.0, 2.0]} | asked))


def test_the_contact_of_two_masses_is_that_of_the_description():
    """`a - b` is b relative to a, whichever is listed first."""
    def system(masses):
        return System(
            f"struct Pair {{ masses: {{ {masses} }}, springs: {{ base - a: 30, a - b: 20 }}, contact: a - b, excitation: a }}"
        )

    force = np.cos(0.1 * np.arange(400))
    one, other = (system(masses).step(0.02, force=force, friction=0.1) for masses in ("a: 1, b: 2", "b: 2, a: 1"))
    for steps in (one, other):
        np.testing.assert_allclose(
            steps["contact"].velocity_m_s, steps["b"].velocity_m_s - steps["a"].velocity_m_s, atol=1e-12
        )
    np.testing.assert_allclose(one["contact"].displacement_m, other["contact"].displacement_m, atol=1e-12)

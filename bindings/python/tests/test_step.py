"""Tests the motion under any load against the exact run under a harmonic load, and bad input."""

import math
import re

import numpy as np
import pytest
from conftest import hold

import frictiongen
from frictiongen import DomainError, Recording, System


@pytest.mark.parametrize("friction", [0.0, 3.0])
def test_a_harmonic_force_by_steps_is_the_exact_run(block, friction):
    """Checks that steps under a harmonic force equal the exact run.  Straight lines between 2000 samples a cycle have an
    error of (2 pi/2000)^2/8 = 1.2e-6 of the force.  The error of the response is this number times the amplification,
    and over three cycles adds up to a few times that."""
    hz, force, samples = 0.6, 10.0, 2000
    run = block.simulate(hz=hz, friction=friction, force=force, cycles=3, samples=samples)
    dt = 1 / (hz * samples)
    load = force * np.cos(2 * math.pi * np.arange(len(run.time_s)) / samples)
    steps = block.step(dt, force=load, friction=friction)
    np.testing.assert_allclose(steps.time_s, run.time_s, rtol=1e-13)
    size = np.abs(run["block"].displacement_m).max()
    np.testing.assert_allclose(steps["block"].displacement_m, run["block"].displacement_m, atol=1e-5 * size)
    same = steps["contact"].state[1:] == run["contact"].state[1:]
    # The states differ only next to an event, whose instant differs by at most one step.
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
        (frame, {"base": [1.0, 2.0], "dt": -0.01}, "dt = -0.01: the step dt is negative; it must be greater than zero"),
        (block, {"force": [1.0], "dt": 0.0}, "dt = 0.0"),
        (block, {"force": [1.0], "dt": math.nan}, "dt = NaN"),
        (block, {"force": [1.0], "dt": 1e9}, "dt = 1000000000.0"),
        (block, {"force": [1.0], "on": {"roof": 1.0}}, "on: there is no mass `roof`"),
        (block, {"force": [1.0], "on": {"contact": 1.0}}, "acts on a mass"),
        (block, {"force": [1e300], "dt": 0.01}, "its square within the range"),
    ]:
        with pytest.raises(DomainError, match=re.escape(said)):
            system.step(**({"dt": 0.01, "friction": 1.0} | asked))
    for asked in [{"on": [1.0]}, {"on": {3: 1.0}}, {"friction": "1 N"}, {"dt": "1 ms"}, {"force": "1"}]:
        with pytest.raises(TypeError):
            block.step(**({"dt": 0.01, "friction": 1.0, "force": [1.0, 2.0]} | asked))


def test_the_contact_of_two_masses_is_that_of_the_description():
    """Checks that the contact `a - b` is the motion of b relative to a, whichever mass is listed first."""
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


def halves(asked, at):
    """Returns the same run, computed in two parts."""
    parts = {}
    for name, values in asked.items():
        parts[name] = (values[:at], values[at:]) if np.ndim(values) else (values, values)
    return [{name: both[place] for name, both in parts.items()} for place in (0, 1)]


@pytest.mark.parametrize("law", ["linear", "hold"])
@pytest.mark.parametrize("at", [1, 700, 1999])
def test_a_run_in_two_parts_is_the_run(law, at):
    """Checks that a run in two parts equals the whole run to the last bit, with changing friction and a force on
    another mass, for each kind of input."""
    text = frictiongen.FRAME.replace("excitation: base", "excitation: lower").replace("stiction: 1.2", f"stiction: 1.2, input: {law}")
    frame = System(text)
    t = 1e-3 * np.arange(2000)
    asked = {"force": 3 * np.sin(12 * t), "friction": 0.3 + 0.2 * np.cos(7 * t)}
    whole = frame.step(1e-3, **asked, on={"upper": np.cos(31 * t)})
    assert whole.events.sum() > 3 and whole.exceeded == 0
    first, rest = halves(asked, at)
    one = frame.step(1e-3, **first, on={"upper": np.cos(31 * t[:at])})
    other = frame.step(1e-3, **rest, on={"upper": np.cos(31 * t[at:])}, start=one)
    for name in whole:
        np.testing.assert_array_equal(np.concatenate([one[name], other[name]]), whole[name], err_msg=name)
    assert other.work == whole.work
    # A saved state can start more than one run.
    again = frame.step(1e-3, **rest, on={"upper": np.cos(31 * t[at:])}, start=one)
    assert (again["upper"].velocity_m_s == other["upper"].velocity_m_s).all()


def test_from_a_state_without_a_load_energy_goes_into_friction(block):
    """Checks a mass that is pulled by 0.5 m and released.  Its amplitude falls by exactly 2F/k in each half cycle
    (thesis 4.2)."""
    k, m, friction = 50.0, 2.0, 3.0
    dt = math.pi * math.sqrt(m / k) / 500
    steps = block.step(dt, force=np.zeros(1501), friction=friction, start=([0.5], [0.0]))
    ends = steps["block"].displacement_m[::500]
    np.testing.assert_allclose(np.abs(ends), 0.5 - 2 * friction / k * np.arange(4), rtol=1e-12)
    assert steps.work.friction == pytest.approx(k / 2 * (ends[0] ** 2 - ends[-1] ** 2), rel=1e-12)


def test_another_stiction_holds_longer(block):
    """Checks that under a growing force the contact breaks away at mu F."""
    force = np.linspace(0.0, 10.0, 1001)
    for mu in (None, 1.0, 1.5, 3.0):
        steps = block.step(1e-3, force=force, friction=2.0, stiction=mu)
        departed = force[np.argmax(steps["contact"].state != "stuck")]
        assert departed == pytest.approx(2.0 * (mu or 1.0), abs=0.011)
    held = block.step(1e-3, force=force[:300], friction=2.0, stiction=3.0)
    later = block.step(1e-3, force=force[300:], friction=2.0, start=held)
    assert force[300:][np.argmax(later["contact"].state != "stuck")] == pytest.approx(6.0, abs=0.011)


def test_an_event_budget(block):
    """Checks that a budget changes nothing while it is not exceeded, and that no energy appears where it is."""
    t = 0.2 * np.arange(400)
    force = 10 * np.cos(1.7 * t) + 6 * np.cos(2.9 * t)
    free = block.step(0.2, force=force, friction=2.0)
    assert free.events.max() == 2 and free.exceeded == 0
    enough = block.step(0.2, force=force, friction=2.0, budget=int(free.events.max()))
    np.testing.assert_array_equal(enough["block"].displacement_m, free["block"].displacement_m)
    tight = block.step(0.2, force=force, friction=2.0, budget=1)
    first = np.argmax(free.events > 1)
    np.testing.assert_array_equal(tight["block"].displacement_m[:first], free["block"].displacement_m[:first])
    assert 0 < tight.exceeded < 20
    # The stepper follows one event and stops its search at the second.
    assert tight.events.max() <= 2
    work = tight.work
    assert work.friction >= 0 and work.load == pytest.approx(work.friction + work.damping + work.stored, rel=1e-9)
    # A continued run keeps its budget, and another value replaces it.
    parts = [block.step(0.2, force=force[:200], friction=2.0, budget=1)]
    parts.append(block.step(0.2, force=force[200:], friction=2.0, start=parts[0]))
    assert parts[1]["block"].displacement_m[-1] == tight["block"].displacement_m[-1]
    assert parts[1].exceeded == tight.exceeded
    for budget, wrong in [(-1, DomainError), (256, DomainError), (1.5, TypeError), (True, TypeError)]:
        with pytest.raises(wrong, match="budget"):
            block.step(0.2, force=force, friction=2.0, budget=budget)


def test_a_recording_drives_as_steps_do(frame, block, command, tmp_path):
    t = np.arange(1000) / 500
    force = 10 * np.cos(7 * t)
    recording = Recording({"force": (force, "N"), "friction": (np.full(1000, 2e3), "mN")}, rate=500, drives=True)
    driven, steps = block.drive(recording), block.step(1 / 500, force=force, friction=2.0)
    # The two solvers share nothing but the description.
    for name in set(steps) - {"contact.state", "events"}:
        np.testing.assert_allclose(driven[name], steps[name], rtol=0, atol=1e-10 * np.abs(steps[name]).max(), err_msg=name)
    assert driven.contact.state.tolist() == steps.contact.state.tolist()
    path, scene = tmp_path / "quake.csv", tmp_path / "frame.friction"
    scene.write_text(frictiongen.FRAME, encoding="utf-8")
    path.write_text("time_s,base_m_s2\n" + "".join(f"{a!r},{b!r}\n" for a, b in zip(t.tolist(), np.sin(9 * t).tolist(), strict=True)))
    ours = frame.drive(Recording.from_file(path, drives=True), friction=0.4).to_frame()
    theirs = command("drive", scene, path, "--friction", 0.4)
    hold(ours, theirs)


def test_what_cannot_be_gone_on_from(block, frame):
    first = block.step(0.01, force=[0.0, 1.0], friction=1.0)
    other = System("struct B { masses: { block: 2.0 }, springs: { base - block: 50.0 }, contact: block - wall, excitation: block }")
    for system, asked, said in [
        (block, {"dt": 0.02, "start": first}, "dt = 0.02: the steps to continue are 0.01 s long"),
        (other, {"start": first}, "start: these steps are of another system"),
        (block, {"start": ([0.0, 1.0], [0.0])}, "start: 1 finite numbers are needed"),
        (block, {"start": ([math.nan], [0.0])}, "start: 1 finite numbers are needed"),
        (block, {"start": 3}, "start: two rows are needed"),
        (block, {"stiction": 0.9}, "stiction is 0.9: static over kinetic friction must be 1 or above"),
        (block, {"stiction": math.nan}, "stiction is NaN"),
    ]:
        with pytest.raises(DomainError, match=re.escape(said)):
            system.step(**({"dt": 0.01, "friction": 1.0, "force": [1.0, 2.0]} | asked))
    for wrong in [{"start": ("0", "0")}, {"stiction": "1.2"}]:
        with pytest.raises(TypeError):
            block.step(0.01, force=[1.0], friction=1.0, **wrong)
    forces = Recording({"force": ([0.0, 1.0, 2.0], "N")}, rate=100, drives=True)
    for system, recording, asked, said in [
        (block, forces, {}, "no friction force is given"),
        (block, forces, {"friction": -1.0}, "friction is -1.0"),
        (frame, forces, {"friction": 1.0}, "the channel `force` does not belong to this scene"),
        (block, Recording({"force": ([0.0, 1.0], "mm")}, rate=100, drives=True), {"friction": 1.0}, "`force` is in mm, but here it must be a force"),
        (block, Recording({"force": ([0.0, 1.0], "N")}, rate=1e-9, drives=True), {"friction": 1.0}, "too far for the fastest mode"),
    ]:
        with pytest.raises(DomainError, match=re.escape(said)):
            system.drive(recording, **asked)

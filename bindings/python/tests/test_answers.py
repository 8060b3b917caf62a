"""Tests answers against results that are known without this library, and their tables and pictures."""

import builtins
import math
import sys

import numpy as np
import pytest
from conftest import SCENES

import frictiongen


def test_the_example_is_the_commands():
    assert frictiongen.FRAME == (SCENES / "frame.friction").read_text(encoding="utf-8")


def test_without_friction_one_mass_is_a_textbook_oscillator(block):
    hz = np.array([0.2, 0.5, 1.1, 2.0])
    response = block.response(hz=hz, friction=0.0, force=10.0)
    stiffness, mass = 50.0, 2.0
    expected = 10.0 / np.abs(stiffness - mass * (2 * math.pi * hz) ** 2)
    # The tolerance is a few roundings of numbers near 1, because little cancels at these frequencies.
    np.testing.assert_allclose(response["block"].amplitude_m, expected, rtol=1e-13)
    assert block.natural_frequencies == pytest.approx(math.sqrt(stiffness / mass), rel=1e-15)
    assert (response.regime == "continuous").all()


def test_a_base_contact_departs_at_r_squared(block):
    """A block that rubs on its moving base, on a spring to it, moves with the base up to beta = r^2."""
    one = frictiongen.System.from_file(SCENES / "base.friction")
    r = np.linspace(0.1, 0.9, 9)
    np.testing.assert_allclose(one.limits(r=r).sliding_limit, r**2, rtol=1e-14)


def test_a_run_keeps_to_newtons_law(block):
    """Checks that m a = P cos wt - k x - friction.  The acceleration comes from differences of the exact
    velocities."""
    hz, force = 0.7, 10.0
    run = block.simulate(hz=hz, friction=3.0, force=force, cycles=2, samples=4000)
    motion, contact = run["block"], run["contact"]
    step = run.time_s[1] - run.time_s[0]
    acceleration = (motion.velocity_m_s[2:] - motion.velocity_m_s[:-2]) / (2 * step)
    load = force * np.cos(2 * math.pi * hz * run.time_s)
    rest = (load - 50.0 * motion.displacement_m - contact.friction_N)[1:-1]
    # Samples next to an event are left out.  Elsewhere the difference has an error of step^2/6 times the third
    # derivative, a relative 1e-5.
    state = contact.state
    calm = (state[2:] == state[1:-1]) & (state[:-2] == state[1:-1])
    np.testing.assert_allclose(2.0 * acceleration[calm], rest[calm], atol=1e-4 * force)
    assert calm.sum() > 7900 and (np.abs(contact.friction_N) <= 3.0 + 1e-12).all()


def test_shapes_are_those_of_the_arguments(frame):
    assert np.shape(frame.limits(r=0.9).continuous_limit) == ()
    assert frame.limits(r=[0.9]).continuous_limit.shape == (1,)
    assert frame.limits(r=[]).to_frame().shape == (0, 3)
    for r, beta, shape in [(0.9, 0.3, ()), ([0.9, 1.0], 0.3, (2,)), (0.9, [0.1, 0.2, 0.3], (3,)), ([0.9], [0.3], (1, 1))]:
        response, found = frame.response(r=r, beta=beta), frame.map(r=r, beta=beta)
        assert response.shape == found.shape == shape
        assert np.shape(response["lower"].amplitude) == np.shape(found.regime) == shape
        assert len(response.to_frame()) == len(found.to_frame()) == math.prod(shape)
    grid = frame.response(r=[0.8, 0.9], beta=[0.1, 0.7, 1.0])
    single = frame.response(r=0.9, beta=0.7)
    assert grid["lower"].amplitude[1, 1] == single["lower"].amplitude
    assert grid.regime[1, 1] == single.regime == "stick-slip"


def test_arguments_may_be_whatever_numpy_reads(frame):
    pandas = pytest.importorskip("pandas")
    expected = frame.limits(r=[1.0, 2.0]).continuous_limit
    strided = np.array([1.0, 9.0, 2.0, 9.0])[::2]
    single = np.array([1, 2], np.float32)
    for r in [[1, 2], np.array([1, 2]), range(1, 3), strided, single, pandas.Series([1.0, 2.0])]:
        assert (frame.limits(r=r).continuous_limit == expected).all()


def test_answers_are_the_callers_own(frame):
    r = np.array([0.5, 0.9])
    limits = frame.limits(r=r)
    r[:] = 7.0
    limits.continuous_limit[:] = 0.0
    assert frame.limits(r=[0.5]).r == 0.5 and (limits.r == [0.5, 0.9]).all()


def test_where_there_is_no_answer_the_answer_says_why():
    wall = frictiongen.System.from_file(SCENES / "wall.friction")
    response = wall.response(r=1.0, beta=[0.1, 0.9])
    assert response.regime.tolist() == ["unbounded", "continuous"] or response.answer[0] == "unbounded"
    assert math.isnan(response["block"].amplitude[0])
    orbit = wall.orbit(r=1.0, beta=0.1)
    assert orbit.state == "unbounded" and orbit.stops == -1 and math.isnan(orbit["block"].amplitude)
    assert orbit.multipliers.shape == (0,) and orbit.sticking_intervals.shape == (0, 2)
    found = wall.map(r=[1.0], beta=[0.1])
    assert found.region[0, 0] == "unbounded" and found.stops[0, 0] == -1 and found.regime[0, 0] == ""
    assert found.to_frame().stops.isna()[0]
    assert wall.limits(r=1.0).continuous_limit > 0


def test_a_name_with_another_unit_is_explained(frame):
    response = frame.response(r=0.9, beta=0.3)
    with pytest.raises(AttributeError, match="without a load .* it is 'amplitude'"):
        _ = response["lower"].amplitude_m
    with pytest.raises(AttributeError, match="with a load it is 'amplitude_m'"):
        _ = frame.response(hz=2.0, friction=0.3, base=0.001)["lower"].amplitude
    with pytest.raises(KeyError, match="Response has no 'roof'; it has r, beta"):
        _ = response["roof"]
    assert "regime" in dir(response) and "Response of shape ()" in repr(response)
    assert "Motion 'lower': amplitude, phase" in repr(response["lower"])


def test_what_a_system_is_made_of(frame):
    assert frame.masses == ["lower", "upper"] and frame.mass_values.tolist() == [3.27, 3.25]
    assert frame.springs == [("base", "lower", 1190.0), ("lower", "upper", 1323.0)]
    assert frame.contact == ("upper", "wall") and frame.excitation == "base"
    assert frame.damping_ratios.tolist() == [0.010, 0.012]
    masses = frame.mass_values / frame.mass_values[0]
    np.testing.assert_allclose(np.einsum("im,jm,m", frame.mode_shapes, frame.mode_shapes, masses), np.eye(2), atol=1e-15)


@pytest.mark.parametrize("library", ["pandas", "matplotlib"])
def test_without_pandas_and_matplotlib_the_rest_works(frame, monkeypatch, library):
    """Checks that neither library is imported before it is needed, and that the error names the missing one."""
    real = builtins.__import__

    def missing(name, *rest, **options):
        if name.split(".")[0] == library:
            raise ImportError(f"No module named {name!r}")
        return real(name, *rest, **options)

    monkeypatch.setattr(builtins, "__import__", missing)
    for known in [name for name in sys.modules if name.split(".")[0] == library]:
        monkeypatch.delitem(sys.modules, known)
    response = frame.response(r=[0.5, 0.9], beta=0.3)
    assert response["lower"].amplitude.shape == (2,)
    ask = response.to_frame if library == "pandas" else response.plot
    with pytest.raises(ImportError, match=f"needs {library}, which is not installed: pip install {library}"):
        ask()


def test_importing_the_package_imports_neither():
    import subprocess

    code = "import sys, frictiongen; print([name for name in ('pandas', 'matplotlib') if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_answer_that_can_be_drawn_is(frame):
    import matplotlib.pyplot as plt

    at = {"hz": np.linspace(0.5, 7, 8), "base": 0.001}
    friction = np.linspace(0, 2.4, 7)
    point = {"hz": 1.2, "friction": 0.4, "base": 0.001}
    map = frame.map(friction=friction, **at)
    curve = frame.curve(hz=(0.5, 7), friction=[0.1, 0.8], base=0.001, accuracy=1e-2)
    drawn = [
        frame.limits(**at).plot(),
        frame.limits(r=[0.5, 0.9], estimates=True).plot(),
        frame.response(friction=friction, **at).plot(of="upper"),
        frame.response(**point).plot(),
        curve.plot(),
        map.plot(),
        map.plot(shade="stuck"),
        map.plot(shade="lower"),
        frame.simulate(**point, cycles=2).plot(),
        frame.sensitivities("lower", **point).plot(),
    ]
    for ax in drawn:
        assert ax.get_xlabel() and ax.has_data()
        ax.figure.canvas.draw()
    assert drawn[4].get_ylabel() == "amplitude of lower (m)" and drawn[4].get_xlabel() == "frequency (Hz)"
    # Each piece of each friction has a line, and no line joins two pieces.
    pieces = {(force, piece) for force, piece in zip(curve.friction_N, curve.piece, strict=True) if piece > 0}
    assert len([line for line in drawn[4].lines if len(line.get_xdata())]) == len(pieces)
    ax = plt.subplots()[1]
    assert frame.limits(**at).plot(ax=ax) is ax
    with pytest.raises(ValueError, match="at least two frequencies"):
        frame.map(r=0.9, beta=[0.1, 0.2]).plot()
    plt.close("all")


def test_a_band_and_points_do_not_look_alike(frame):
    at = {"base": 0.001}
    band = frame.map(hz=(1, 7), friction=(0, 2.4), **at)
    assert band.shape == (161, 81)
    np.testing.assert_allclose(band.frequency_Hz, np.linspace(1, 7, 161), rtol=1e-15)
    np.testing.assert_allclose(band.friction_N, np.linspace(0, 2.4, 81), rtol=1e-15)
    assert band.frequency_Hz[-1] == 7 and band.friction_N[-1] == 2.4
    for points in ([1, 7], np.array([1.0, 7.0])):
        assert frame.map(hz=points, friction=[0, 2.4], **at).frequency_Hz.tolist() == [1, 7]
    assert frame.limits(hz=(1, 7)).r.shape == (161,)
    assert frame.response(hz=(1, 7), beta=(0.1, 0.2)).shape == (161, 81)


def test_pictures_do_not_reach_below_zero(frame):
    import matplotlib.pyplot as plt

    at = {"base": 0.001}
    two = frame.map(hz=[1, 7], friction=[0.4, 2.4], **at)
    for ax in (
        two.plot(),
        two.plot(shade="lower"),
        frame.map(hz=[0, 0.5, 4], friction=[0, 1.0, 4], **at).plot(shade="stuck"),
        frame.limits(r=np.linspace(0, 2, 50)).plot(),
        frame.response(hz=np.linspace(0, 7, 20), friction=[0.4], **at).plot(),
        frame.curve(hz=(0.05, 7), friction=0.4, **at).plot(),
    ):
        ax.figure.canvas.draw()
        assert ax.get_xlim()[0] >= 0 and ax.get_ylim()[0] >= 0
    # Cells have their points in the middle, so the axis ends half a step beyond the last point.
    assert two.plot().get_xlim()[1] == 10
    plt.close("all")


def test_an_elastic_contact_answers():
    """The stuck chain is linear with the spring of the contact, k1 + k: amplitude P/(k1 + k - m w^2), and it slides
    once its force k x exceeds F."""
    k1, k, m, force = 50.0, 150.0, 2.0, 10.0
    block = frictiongen.System.of({"block": m}, {"base - block": k1}, "block - wall", "block", stiffness=k)
    hz = np.array([0.3, 0.8])
    stuck = force / (k1 + k - m * (2 * math.pi * hz) ** 2)
    limits = block.limits(hz=hz, force=force)
    assert (limits.continuous_limit_N == 0).all()
    np.testing.assert_allclose(limits.sliding_limit_N, k * stuck, rtol=1e-13)
    response = block.response(hz=hz, friction=[1.0, 1.01 * k * stuck.max()], force=force)
    assert response.regime[:, 1].tolist() == ["stuck", "stuck"] and (response.regime[:, 0] == "stick-slip").all()
    np.testing.assert_allclose(response["block"].amplitude_m[:, 1], stuck, rtol=1e-13)
    # The slider takes 4 F (X - F/k) in a cycle in which it slides once each way (joint of a full-slip loop).
    curve = block.curve(hz=(0.3, 0.31), friction=1.0, force=force)
    swing = curve["block"].amplitude_m[0]
    period = 1 / 0.3
    np.testing.assert_allclose(curve.friction_power_W[0] * period, 4 * (swing - 1.0 / k), rtol=1e-9)
    steps = block.step(1e-2, force=np.full(2000, 1.0), friction=3.0)
    assert set(steps["contact"].state) == {"stuck"}
    damped = frictiongen.System.of({"block": m}, {"base - block": k1}, "block - wall", "block", damping=0.05, stiffness=k)
    best = damped.optimum("block", hz=(0.5, 1.5), force=force)
    around = damped.response(hz=(0.5, 1.5), friction=best.friction_N * np.array([0.9, 1.0, 1.1]), force=force)
    highest = around["block"].amplitude_m.max(axis=0)
    assert highest[1] <= best.amplitude_m * (1 + 1e-9) < min(highest[0], highest[2])

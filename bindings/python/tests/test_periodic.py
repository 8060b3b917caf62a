"""Tests of steady states under periodic loads."""

import math
import re

import matplotlib.pyplot
import numpy as np
import pytest
from conftest import SCENES, hold

import frictiongen
from frictiongen import DomainError

BLOCK = "struct Block { masses: { m: 2 }, springs: { base - m: 800 }, contact: m - wall, excitation: m, damping: modal(0.05) }"


@pytest.fixture
def pushed():
    """Returns a damped block of 2 kg under a force."""
    return frictiongen.System(BLOCK)


def same(ours, points):
    """Asserts that every number of the JSON is in the answer, to the last bit, and that the answer has no others."""
    assert set(ours.keys()) == {name for point in points for name in point}
    for place, point in enumerate(points):
        for name, value in point.items():
            found = ours[name][place] if np.ndim(ours.friction_N) else ours[name]
            if name == "multipliers":
                # NaN fills the rows of states with fewer multipliers.
                assert [[one.real, one.imag] for one in found[: len(value)]] == value
                assert np.isnan(found[len(value) :]).all()
            else:
                assert found == value, name


def test_harmonics_are_the_commands(command, command_json):
    frame = frictiongen.System.from_file(SCENES / "frame.friction")
    asked = {"load": {1: 0.001, 3: (0.0002, 45)}, "period": 1 / 1.25}
    options = ("--harmonics", "1:0.001, 3:0.0002@45", "--hz", 1.25)
    states = frame.periodic(**asked, friction=[0.2, 0.4, 5.0], motion=True)
    points = command_json("periodic", "frame.friction", *options, "--friction", "0.2,0.4,5")
    same(states, points)
    assert states.motions == ["contact", "lower-base", "upper-base"] and states.multipliers.shape == (3, 4)
    assert hold(states.to_frame(), command("periodic", "frame.friction", *options, "--friction", "0.2,0.4,5")) > 30
    # The motion over a period, which the command prints for one friction.
    theirs = command("periodic", "frame.friction", *options, "--friction", 0.4, "--motion")
    assert hold(states.histories[1].to_frame(), theirs) > 10_000
    one = frame.periodic(**asked, friction=0.4, of=["upper", "shear"])
    assert one.state == "stable" and one.largest_multiplier == states.largest_multiplier[1] and one.histories == []
    theirs = command_json("periodic", "frame.friction", *options, "--friction", 0.4, "--of", "upper", "--of", "shear")
    same(one, theirs)


@pytest.mark.parametrize("held", [False, True])
def test_samples_are_the_commands(command_json, tmp_path, pushed, held):
    scene, table = tmp_path / "block.friction", tmp_path / "square.csv"
    scene.write_text(BLOCK, encoding="utf-8")
    table.write_text("time_s,force_kN\n0,0.04\n0.25,0.04\n0.5,-0.04\n0.75,-0.04\n1,0.04\n", encoding="utf-8")
    # The command multiplies by 1000.
    force = [0.04, 0.04, -0.04, -0.04, 0.04]
    states = pushed.periodic((force, "kN"), period=1.0, friction=[4, 100], hold=held)
    options = ["--hold"] if held else []
    same(states, command_json("periodic", scene, table, "--friction", "4,100", *options))
    assert states.state.tolist() == ["stable", "marginal"] and states["m"].largest_m[1] == 0
    in_newton = pushed.periodic([40, 40, -40, -40, 40], period=1.0, friction=[4, 100], hold=held)
    np.testing.assert_allclose(in_newton["m"].largest_m, states["m"].largest_m, rtol=1e-9)


def test_records_of_the_base_are_the_commands(command_json, tmp_path, frame):
    table = tmp_path / "base.csv"
    table.write_text("time_s,base_g\n0,0\n0.25,0.05\n0.5,0\n0.75,-0.05\n1,0\n", encoding="utf-8")
    states = frame.periodic(([0, 0.05, 0, -0.05, 0], "g"), period=1.0, friction=0.3)
    same(states, command_json("periodic", "frame.friction", table, "--friction", 0.3))


@pytest.mark.parametrize(("hz", "friction", "regime"), [(1.2, 0.4, "stick-slip"), (2.5, 0.1, "continuous")])
def test_one_harmonic_is_the_closed_form(frame, hz, friction, regime):
    """Checks a single cosine against the response, which comes from a closed form and uses no stepper."""
    response = frame.response(hz=hz, friction=friction, base=0.001)
    state = frame.periodic({1: 0.001}, period=1 / hz, friction=friction, of=["lower", "upper", "contact"])
    assert response.regime == regime and state.period == 1
    for name in ["lower", "upper", "contact"]:
        amplitude = response[name].amplitude_m
        assert state[name].largest_m == pytest.approx(amplitude, rel=1e-9), name
        assert state[name].least_m == pytest.approx(-amplitude, rel=1e-9), name


def test_the_energy_balance_and_the_loop(pushed):
    """Checks that the load does the work of friction and damping, and that the loop of the contact has the area."""
    triangle = [0, 30, 0, -30, 0]
    states = pushed.periodic(triangle, period=0.8, friction=[4.0, 8.0], motion=True)
    balance = states.load_work_J - states.friction_work_J - states.damping_work_J
    assert (abs(balance) < 1e-10 * states.load_work_J).all()
    for friction, work, cycle in zip([4.0, 8.0], states.friction_work_J, states.histories, strict=True):
        # Coulomb friction takes 2 F times the way to and fro, as the motion has one maximum and one minimum.
        motion = cycle["contact"].displacement_m
        assert work == pytest.approx(2 * friction * (motion.max() - motion.min()), rel=1e-4)
        assert cycle.time_s[-1] - cycle.time_s[0] == pytest.approx(0.8, rel=1e-12)
        assert abs(cycle["contact"].friction_N).max() == friction
    ax = states.histories[0].plot()
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["contact", "m"]
    matplotlib.pyplot.close(ax.figure)
    assert "Periodic of 2 lines" in repr(states) and "multipliers" not in states.to_frame()


def test_bad_loads(frame, pushed):
    """Checks that every error is one line that names the argument."""
    storeys = frictiongen.System.from_file(SCENES / "storeys.friction")
    good = {"load": [0, 30, 0, -30, 0], "period": 0.8, "friction": 4.0}
    for kind, said, system, asked in [
        (DomainError, "load: one period needs at least three samples", pushed, {"load": []}),
        (DomainError, "load: one period needs at least three samples", pushed, {"load": [1.0, 1.0]}),
        (DomainError, "load: the period does not close", pushed, {"load": [0.0, 1.0, 0.5]}),
        (DomainError, "load[1] is NaN: it must be finite", pushed, {"load": [0.0, math.nan, 0.0]}),
        (DomainError, "load[2] is -inf: it must be finite", pushed, {"load": [0.0, 1.0, -math.inf]}),
        (DomainError, "load: the samples of one period are needed", pushed, {"load": 3.0}),
        (DomainError, "this has the shape (1, 3)", pushed, {"load": [[0.0, 1.0, 0.0]]}),
        (TypeError, "load: a number or an array of numbers is needed, not str", pushed, {"load": "1:30"}),
        (DomainError, "load: a sum of harmonics needs", pushed, {"load": {}}),
        (DomainError, "load: the order is 1001", pushed, {"load": {1001: 1.0}}),
        (DomainError, "load: the order is -1", pushed, {"load": {-1: 1.0}}),
        (TypeError, "load: the order: a whole number is needed, not float", pushed, {"load": {1.5: 1.0}}),
        (DomainError, "load[1] is NaN: it must be finite", pushed, {"load": {1: math.nan}}),
        (DomainError, "load[3][1] is inf: it must be finite", pushed, {"load": {3: (1.0, math.inf)}}),
        (TypeError, "load[3]: an amplitude is needed", pushed, {"load": {3: (1.0, 2.0, 3.0)}}),
        (TypeError, "load[3]: a number", pushed, {"load": {3: "1@45"}}),
        (DomainError, "load: `parsec` is not a known unit", pushed, {"load": ([0, 1, 0], "parsec")}),
        (DomainError, "load: the excitation of the scene is a mass", pushed, {"load": ([0, 1, 0], "mm")}),
        (DomainError, "load: the excitation of the scene is the base", frame, {"load": ([0, 1, 0], "N")}),
        (DomainError, "load: the period does not close: the mean acceleration", frame, {"load": ([0, 1, 0], "g")}),
        (DomainError, "period is 0.0: it must be above 0 and finite", pushed, {"period": 0}),
        (DomainError, "period is -1.0: it must be above 0", pushed, {"period": -1.0}),
        (DomainError, "period is NaN: it must be above 0", pushed, {"period": math.nan}),
        (DomainError, "more than 65536 steps", pushed, {"period": 1e6}),
        (TypeError, "period: a number", pushed, {"period": "0.8 s"}),
        (DomainError, "friction is -1.0", pushed, {"friction": -1.0}),
        (DomainError, "friction[1] is NaN", pushed, {"friction": [1.0, math.nan]}),
        (DomainError, "friction: a tuple is a band", pushed, {"friction": (1.0, 2.0)}),
        (TypeError, "friction: a number", pushed, {"friction": None}),
        (DomainError, "of: there is no mass `roof`", pushed, {"of": "roof"}),
        (DomainError, "of: `accel(m)`: write the motion alone", pushed, {"of": "accel(m)"}),
        (DomainError, "hold: harmonics are continuous", pushed, {"load": {1: 30.0}, "hold": True}),
        (DomainError, "hold: a motion of the base cannot be held", frame, {"load": [0, 1e-3, 0], "hold": True}),
        (DomainError, "contacts", storeys, {"load": {1: 1e-3}}),
    ]:
        with pytest.raises(kind, match=re.escape(said)) as raised:
            system.periodic(**(good | asked))
        assert "\n" not in str(raised.value), str(raised.value)


def test_a_constant_load_beside_a_harmonic(pushed):
    """Checks order 0, numpy arrays, and a mapping that is no dict.  Without friction a constant force P moves the mean
    by P/k."""
    from types import MappingProxyType

    state = pushed.periodic(MappingProxyType({np.int64(0): 8.0, 1: np.float64(10.0)}), period=0.5, friction=0.0, of="m")
    middle = 0.5 * (state["m"].largest_m + state["m"].least_m)
    assert middle == pytest.approx(8.0 / 800.0, rel=1e-9)

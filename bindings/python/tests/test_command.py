"""Tests that every column of every line equals the output of the command, to the last bit."""

import math

import numpy as np
import pytest
from conftest import SCENES, hold

import frictiongen

FRAME = ("frame.friction", {"base": 0.001}, ("--base", 0.001))
FIVE = ("thesis/five_m3_damped.friction", {"force": 2.0}, ("--force", 2.0))
BETWEEN = ("thesis/two_between.friction", {"force": 0.3}, ("--force", 0.3))
BASE = ("base.friction", {"base": 0.02}, ("--base", 0.02))
SCENES_AND_LOADS = [FRAME, FIVE, BETWEEN, BASE]


def system(scene):
    return frictiongen.System.from_file(SCENES / scene)


def listed(values):
    return ",".join(repr(float(value)) for value in values)


@pytest.mark.parametrize(("scene", "load", "option"), SCENES_AND_LOADS)
def test_limits(command, scene, load, option):
    hz = system(scene).hertz(1.0) * np.linspace(0.1, 3, 30)
    ours = system(scene).limits(hz=hz, estimates=True, **load).to_frame()
    hold(ours, command("limits", scene, "--hz", listed(hz), *option))


def test_limits_at_both_ends(command):
    r = [0.0, 1e-9, 0.7, 1e9, math.inf]
    ours = system("wall.friction").limits(r=r, estimates=True).to_frame()
    hold(ours, command("limits", "wall.friction", "--r", "0,1e-9,0.7,1e9,inf"))
    ours = system("frame.friction").limits(omega=[3.0, 20.0], estimates=True).to_frame()
    hold(ours, command("limits", "frame.friction", "--omega", "3,20"))


def hold_response(ours, theirs):
    """Compares responses.  Where the contact is stuck, the command leaves out the contact and all harmonics.  In Python
    the contact's amplitude is then 0."""
    stuck = ours.regime == "stuck"
    left_out = [name for name in theirs.columns if name.startswith("contact.") or ".X" in name]
    assert theirs.loc[stuck, left_out].isna().all().all()
    amplitude = next(name for name in left_out if name.startswith("contact.amplitude"))
    assert (ours.loc[stuck, amplitude] == 0).all()
    ours.loc[stuck, left_out] = np.nan
    # A contact or mass that does not move has no phase, but the command prints one.
    for name in [name for name in ours.columns if ".phase" in name and ".X" not in name]:
        part, _ = name.rsplit(".", 1)
        size = next(other for other in ours.columns if other.startswith(f"{part}.amplitude"))
        theirs.loc[ours[size] == 0, name] = np.nan
    assert hold(ours, theirs) > 10


@pytest.mark.parametrize(("scene", "load", "option"), SCENES_AND_LOADS)
def test_response(command, scene, load, option):
    one = system(scene)
    hz = one.hertz(1.0) * np.array([0.15, 0.4, 0.97, 1.3, 2.2])
    beta = np.array([0.05, 0.3, 0.8, 1.1, 3.0])
    ours = one.response(hz=hz, beta=beta, harmonics=5, **load)
    theirs = command("response", scene, "--hz", listed(hz), "--beta", listed(beta), "--harmonics", 5, *option)
    hold_response(ours.to_frame(), theirs)
    assert {"stick-slip", "stuck"} <= set(ours.regime.ravel())


def test_response_in_groups_and_at_infinity(command):
    scene = "thesis/two_between.friction"
    ours = system(scene).response(r=[0.4, 0.9], beta=[0.1, 0.6]).to_frame()
    hold_response(ours, command("response", scene, "--r", "0.4,0.9", "--beta", "0.1,0.6"))
    ours = system(scene).response(r=[0.0, math.inf], beta=[0.1, 0.6]).to_frame()
    hold_response(ours, command("response", scene, "--r", "0,inf", "--beta", "0.1,0.6"))


def test_the_contact_between_masses_in_another_order(command, tmp_path):
    """Checks that under a load the contact's motion is that of the second mass relative to the first, whatever their
    order."""
    text = """struct Pair {
        masses: { b: 2.0, a: 1.0 },
        springs: { base - a: 30.0, a - b: 20.0 },
        contact: a - b,
        excitation: a,
        damping: modal(0.02),
    }"""
    path = tmp_path / "pair.friction"
    path.write_text(text, encoding="utf-8")
    one = frictiongen.System(text)
    point = {"hz": one.hertz(0.35), "friction": 0.1, "force": 2.0}
    options = ("--hz", repr(point["hz"]), "--friction", 0.1, "--force", 2)
    assert one.response(**point).regime == "stick-slip"
    hold_response(one.response(**point).to_frame(), command("response", path, *options))
    hold(one.orbit(**point).to_frame(), command("orbit", path, *options))
    hold(one.simulate(**point, cycles=2).to_frame(), command("time", path, *options, "--cycles", 2))
    hold(one.simulate(**point, steady=True).events.to_frame(), command("time", path, *options, "--steady", "--events"))


@pytest.mark.parametrize(("scene", "load", "option"), SCENES_AND_LOADS)
@pytest.mark.parametrize("at", [(0.4, 0.5), (0.3, 0.1), (0.9, 1.3)])
def test_orbit(command, scene, load, option, at):
    ratio, beta = at
    hz = system(scene).hertz(ratio)
    ours = system(scene).orbit(hz=hz, beta=beta, harmonics=3, **load).to_frame()
    theirs = command("orbit", scene, "--hz", repr(hz), "--beta", beta, "--harmonics", 3, *option)
    hold(ours, theirs)


def test_ratios_under_a_load_have_their_hertz_beside_them(command):
    one = system("frame.friction")
    point, options = {"r": 0.4, "beta": 0.3, "base": 0.001}, ("--r", 0.4, "--beta", 0.3, "--base", 0.001)
    orbit = one.orbit(**point)
    hold(orbit.to_frame(), command("orbit", "frame.friction", *options))
    hold_response(one.response(**point).to_frame(), command("response", "frame.friction", *options))
    hold(one.map(**point).to_frame(), command("map", "frame.friction", *options))
    ours = one.limits(r=[0.4, 1.0], estimates=True, base=0.001).to_frame()
    hold(ours, command("limits", "frame.friction", "--r", "0.4,1", "--base", 0.001))
    # A time in seconds is the angle of the excitation divided by its angular frequency.
    seconds = orbit.sticking_intervals / (2 * math.pi * orbit.frequency_Hz)
    np.testing.assert_allclose(orbit.sticking_intervals_s, seconds, rtol=1e-14)
    assert orbit.longest_stop_s == orbit.sticking_intervals_s[:, 1].max() > 0


@pytest.mark.parametrize(("scene", "load", "option"), [FRAME, BETWEEN])
def test_curve(command, scene, load, option):
    one = system(scene)
    band = one.hertz(0.2), one.hertz(2.0)
    ours = one.curve(hz=band, beta=[0.2, 0.7], harmonics=2, rates=True, accuracy=5e-3, **load).to_frame()
    theirs = command(
        "curve", scene, "--hz", f"{band[0]!r}:{band[1]!r}", "--beta", "0.2,0.7", "--harmonics", 2, "--rates",
        "--accuracy", "5e-3", *option,
    )  # fmt: skip
    assert hold(ours, theirs) > 1000


@pytest.mark.parametrize(("scene", "load", "option"), SCENES_AND_LOADS)
def test_map(command, scene, load, option):
    hz = system(scene).hertz(1.0) * np.linspace(0.1, 2.5, 12)
    beta = np.linspace(0, 1.5, 11)
    ours = system(scene).map(hz=hz, beta=beta, **load)
    hold(ours.to_frame(), command("map", scene, "--hz", listed(hz), "--beta", listed(beta), *option))
    limits = system(scene).limits(hz=hz, **load)
    assert (ours.continuous_limit_N == limits.continuous_limit_N).all()
    assert (ours.sliding_limit_N == limits.sliding_limit_N).all()


@pytest.mark.parametrize(("scene", "load", "option"), SCENES_AND_LOADS)
def test_simulate(command, scene, load, option):
    one = system(scene)
    hz = one.hertz(0.45)
    point = ("--hz", repr(hz), "--beta", 0.4, *option)
    extent = {"cycles": 3, "skip": 5, "samples": 40}
    ours = one.simulate(hz=hz, beta=0.4, **extent, **load)
    options = [text for name, value in extent.items() for text in (f"--{name}", value)]
    hold(ours.to_frame(), command("time", scene, *point, *options))
    hold(ours.events.to_frame(), command("time", scene, *point, *options, "--events"))
    ours = one.simulate(hz=hz, beta=0.4, samples=40, steady=True, **load)
    hold(ours.to_frame(), command("time", scene, *point, "--steady", "--samples", 40))
    hold(ours.events.to_frame(), command("time", scene, *point, "--steady", "--samples", 40, "--events"))


@pytest.mark.parametrize("extent", [{"steady": True, "samples": 40}, {"cycles": 4, "samples": 40}])
def test_spectrum(command, extent):
    one = system("frame.friction")
    ours = one.simulate(hz=1.2, friction=0.4, base=0.001, spectrum=True, **extent)
    options = [text for name, value in extent.items() for text in ([f"--{name}"] if value is True else [f"--{name}", value])]
    theirs = command("time", "frame.friction", "--hz", 1.2, "--friction", 0.4, "--base", 0.001, "--spectrum", *options)
    hold(ours.spectrum.to_frame(), theirs)
    assert one.simulate(hz=1.2, friction=0.4, base=0.001, **extent).spectrum is None


def test_boundaries_of_a_map(command):
    one = system("frame.friction")
    hz, friction = [1.2, 2.5, 5.0], [0.0, 0.3, 0.6, 1.2, 2.4]
    ours = one.map(hz=hz, friction=friction, base=0.001, boundaries=6)
    options = ("--hz", listed(hz), "--friction", listed(friction), "--base", 0.001)
    hold(ours.boundaries.to_frame(), command("map", "frame.friction", *options, "--boundaries", 6))
    hold(ours.to_frame(), command("map", "frame.friction", *options))
    with pytest.raises(frictiongen.DomainError, match="boundaries is 13: a whole number from 1 to 12"):
        one.map(hz=hz, friction=friction, base=0.001, boundaries=13)


QUANTITIES = ["contact", "upper-base", "upper-lower", "vel(upper)", "accel(lower)", "spring(lower-upper)", "shear",
              "slip(contact)", "force(contact)", "energy(contact)", "zeta_eq"]  # fmt: skip


def test_quantities(command):
    one = system("frame.friction")
    asked = [text for name in QUANTITIES for text in ("--of", name)]
    point = ("--hz", 1.2, "--friction", 0.4, "--base", 0.001)
    ours = one.response(hz=1.2, friction=0.4, base=0.001, of=QUANTITIES).to_frame()
    hold_response(ours, command("response", "frame.friction", *point, *asked))
    ours = one.orbit(hz=1.2, friction=0.4, base=0.001, of=QUANTITIES).to_frame()
    hold(ours, command("orbit", "frame.friction", *point, *asked))
    ours = one.curve(hz=(1.1, 1.3), friction=0.4, base=0.001, of=QUANTITIES, accuracy=0.01).to_frame()
    band = ("--hz", "1.1:1.3", "--friction", 0.4, "--base", 0.001, "--accuracy", 0.01)
    hold(ours, command("curve", "frame.friction", *band, *asked))


def test_simulate_from_a_state(command):
    one = system("frame.friction")
    ours = one.simulate(hz=1.2, friction=0.4, base=0.001, start=([0.002, -0.001], [0.01, 0.02]), cycles=2)
    theirs = command(
        "time", "frame.friction", "--hz", 1.2, "--friction", 0.4, "--base", 0.001, "--from", "0.002,-0.001;0.01,0.02",
        "--cycles", 2,
    )  # fmt: skip
    hold(ours.to_frame(), theirs)
    # Without a load, the method gives times in seconds, as the command does.
    ours = one.simulate(r=0.4, beta=0.3, cycles=1).to_frame().drop(columns="time_s")
    hold(ours, command("time", "frame.friction", "--r", 0.4, "--beta", 0.3, "--cycles", 1), but=("time_s",))


def test_optimum(command):
    best = system("frame.friction").optimum("lower", hz=(4, 6), base=0.001)
    theirs = command("optimum", "frame.friction", "--of", "lower", "--hz", "4:6", "--base", 0.001)
    known = dict(zip(theirs.quantity, theirs.value, strict=True))
    for name, value in {
        "friction": best.friction_N,
        "beta": best.beta,
        "largest amplitude of lower": best.amplitude_m,
        "what limits it": best.kind,
        "how the search ended": best.end,
        "nothing sticks up to": best.free_of_sticking_N,
        "stuck over the whole band from": best.locked_N,
        "largest amplitude without friction": best.without_friction_m,
        "largest amplitude with the contact stuck": best.with_contact_locked_m,
        "peak at": best.peaks.frequency_Hz[0],
        "peak at r": best.peaks.r[0],
        "5 % above the best: friction from": best.tolerances.friction_from_N[1],
        "5 % above the best: friction to": best.tolerances.friction_to_N[1],
        "amplitudes computed": best.evaluations,
    }.items():
        assert str(value) == known[name] or float(value) == float(known[name]), name
    per_cent = [value for name, value in known.items() if name.startswith("change in per cent for 1 % more")]
    assert best.sensitivities.relative.tolist() == [float(value) for value in per_cent] and len(per_cent) > 5


@pytest.mark.parametrize(("scene", "load", "option"), [FRAME, FIVE])
@pytest.mark.parametrize("beta", [0.05, 0.3])
def test_sensitivities(command, scene, load, option, beta):
    one = system(scene)
    hz, mass = one.hertz(0.6), one.masses[0]
    ours = one.sensitivities(mass, hz=hz, beta=beta, **load)
    theirs = command("sensitivity", scene, "--of", mass, "--hz", repr(hz), "--beta", beta, *option)
    assert (theirs.regime == ours.regime).all()
    once = ("frequency_Hz", "r", "friction_N", "beta", "regime", "answer")
    assert hold(ours.to_frame(), theirs, but=once) > 100


def test_several_contacts_are_the_commands(command):
    storeys = frictiongen.System.from_file(SCENES / "storeys.friction")
    hz, friction = [0.9, 1.2, 2.5], [1e4, 1e5, 3e6]
    answer = storeys.by_contact(hz=hz, friction=friction, base="2 m/s2")
    theirs = command("map", "storeys.friction", "--hz", ",".join(map(str, hz)), "--friction", "1e4,1e5,3e6", "--base", "2 m/s2")
    assert hold(answer.to_frame(), theirs) > 500
    assert list(answer.contacts) == [f"damper_{floor}" for floor in range(1, 6)] == list(storeys.contacts)
    assert list(answer.masses) == storeys.masses and answer.masses["roof"].amplitude_m.shape == (3, 3)
    # In a state in which nothing slides, no contact takes energy.
    stuck = answer.regime == "stuck"
    assert stuck.any() and all((np.abs(contact.energy_J[stuck]) < 1e-9).all() for contact in answer.contacts.values())


@pytest.mark.parametrize(("start", "option"), [("rest", "rest"), (([0.01] * 5, [0.0] * 5), "0.01,0.01,0.01,0.01,0.01;0,0,0,0,0")])
def test_several_contacts_start_where_they_are_told(command, start, option):
    storeys = frictiongen.System.from_file(SCENES / "storeys.friction")
    asked = {"hz": 0.9, "friction": 3e6, "base": 0.001}
    answer = storeys.by_contact(**asked, start=start)
    theirs = command(
        "map", "storeys.friction", "--hz", "0.9", "--friction", "3e6", "--base", "0.001", "--from", option
    )
    assert hold(answer.to_frame(), theirs) > 50
    assert abs(answer["roof"].amplitude_m / storeys.by_contact(**asked)["roof"].amplitude_m - 1) > 0.01


def test_one_contact_has_the_same_answer_by_contact(frame):
    """The engine of several contacts shares nothing with that of one contact but the description."""
    asked = {"hz": [1.2, 2.5], "friction": [0.4, 0.6], "base": 0.001}
    several, one = frame.by_contact(**asked), frame.response(**asked)
    np.testing.assert_allclose(several["lower"].amplitude_m, one["lower"].amplitude_m, rtol=1e-9)
    assert several.regime.tolist() == one.regime.tolist()


def test_motions_of_several_contacts_are_those_of_masses(frame):
    drift = frame.by_contact(r=0.9, beta=0.3, of="upper-lower")["upper-lower"].amplitude
    assert drift == pytest.approx(frame.response(r=0.9, beta=0.3, of="upper-lower")["upper-lower"].amplitude)
    with pytest.raises(frictiongen.DomainError, match="of: there is no mass `roof`"):
        frame.by_contact(hz=1.0, beta=0.1, of="roof")
    with pytest.raises(frictiongen.DomainError, match="of several contacts, a quantity is"):
        frame.by_contact(hz=1.0, beta=0.1, of="contact")


def test_a_load_over_frequency_has_a_ratio_at_each_frequency(frame, command):
    answer = frame.response(hz=[1.2, 2.5], friction=[0.05, 0.1], base="0.1 m/s2")
    theirs = command("response", "frame.friction", "--hz", "1.2,2.5", "--friction", "0.05,0.1", "--base", "0.1 m/s2")
    assert answer.shape == answer.beta.shape == (2, 2) and answer.friction_N.shape == (2,)
    assert hold(answer.to_frame(), theirs) > 50
    # beta = F/(k1 Y) with the amplitude Y = a/w^2.
    amplitude = 0.1 / (2 * math.pi * np.array([[1.2], [2.5]])) ** 2
    np.testing.assert_allclose(answer.beta, answer.friction_N / (1190.0 * amplitude), rtol=1e-14)

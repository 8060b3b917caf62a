"""Tests that each kind of scene has the answers of the command, with its columns and to the last bit."""

import json

import numpy as np
import pytest
from conftest import hold

import frictiongen
from frictiongen import DomainError, Recording, System

FRAME = "masses: { lower: 3.27, upper: 3.25 }, springs: { base - lower: 1190.0, lower - upper: 1323.0 }, excitation: base,"
#: A description of each kind of scene, an operating point as arguments and as options, and a mass.
SCENES = {
    "one contact": (
        f"struct Frame {{ {FRAME} contact: upper - wall, damping: modal[0.010, 0.012], stiction: 1.2 }}",
        {"hz": 1.2, "friction": 0.4, "base": 0.001},
    ),
    "an elastic contact": (
        f"struct Frame {{ {FRAME} contacts: {{ pads: upper - wall {{ stiffness: 5000 }} }}, damping: modal(0.01) }}",
        {"hz": 1.2, "friction": 0.4, "base": 0.001},
    ),
    "a dashpot": (
        f"struct Frame {{ {FRAME} contact: upper - wall, dampers: {{ base - lower: 2.0 }} }}",
        {"hz": 1.2, "friction": 0.4, "base": 0.001},
    ),
    "three contacts": (
        """struct Frame { masses: { lower: 2000, upper: 2000 }, springs: { base - lower: 1.5e6, lower - upper: 1.5e6 },
        contacts: {
            brace: base - lower { stiffness: 5.0e6 },
            pads: lower - upper { share: 0.6, stiction: 1.2 },
            top: upper - wall { share: 0.3 },
        }, dampers: { lower - upper: 1200.0 }, excitation: base }""",
        {"hz": 3.0, "friction": 3e3, "base": 0.003},
    ),
    "a free chain": (
        """struct Train { masses: { a: 1, b: 2 }, springs: { a - b: 100 }, contacts: { pads: a - wall }, excitation: b,
        dampers: { a - wall: 0.5 } }""",
        {"hz": 1.2, "friction": 0.4, "force": 2.0},
    ),
    "a stop and a belt": (
        """struct Belt { masses: { block: 1, mass: 2 }, springs: { wall - block: 40, block - mass: 30 },
        contacts: { pads: block - wall { speed: 0.4, stiction: 1.5 } },
        stops: { bumper: mass - wall { gap: 0.05, stiffness: 1e3, damping: 2 } }, excitation: mass, damping: modal(0.05) }""",
        {"hz": 0.8, "friction": 0.7, "force": 2.0},
    ),
}


@pytest.fixture(params=SCENES)
def scene(request, tmp_path):
    """Returns a system, the file of its description, and an operating point."""
    text, point = SCENES[request.param]
    file = tmp_path / "scene.friction"
    file.write_text(text, encoding="utf-8")
    return System(text), file, point


def options(point, but=()):
    """Returns arguments as options of the command."""
    return [text for name, value in point.items() if name not in but for text in (f"--{name}", repr(value))]


def load(point):
    return {name: value for name, value in point.items() if name in ("force", "base")}


def test_orbit_and_states(scene, command):
    system, file, point = scene
    hold(system.orbit(**point, harmonics=2).to_frame(), command("orbit", file, *options(point), "--harmonics", "2"))
    found = system.states(**point)
    theirs = command("orbit", file, *options(point), "--states")
    assert len(found) == len(theirs)
    for index, state in enumerate(found):
        hold(state.to_frame(), theirs.iloc[[index]].reset_index(drop=True))
    started = system.orbit(**point, start="rest")
    hold(started.to_frame(), command("orbit", file, *options(point), "--from", "rest"))
    x = [0.002] * len(system.masses)
    started = system.orbit(**point, start=(x, [0.0] * len(x)))
    text = ",".join(map(repr, x)) + ";" + ",".join("0" for _ in x)
    hold(started.to_frame(), command("orbit", file, *options(point), "--from", text))


def test_single_values_are_plain(scene):
    system, _, point = scene
    orbit = system.orbit(**point)
    for name in orbit:
        assert isinstance(orbit[name], (bool, int, float, str, np.ndarray)), name
        assert not isinstance(orbit[name], np.generic), name
    assert len(orbit) == len(orbit.to_frame()) == 1 and json.dumps([orbit.period, orbit.state])
    assert f"{orbit.regime}, {orbit.state}" in repr(orbit) and list(orbit.contacts)[:1] == list(system.contacts)[:1]


def test_response_curve_and_map(scene, command):
    system, file, point = scene
    hz = [point["hz"], 1.1 * point["hz"]]
    friction = [point["friction"], 2 * point["friction"]]
    asked = {"hz": hz, "friction": friction, **load(point)}
    listed = ["--hz", ",".join(map(repr, hz)), "--friction", ",".join(map(repr, friction)), *options(load(point))]
    several = isinstance(system.response(**asked), frictiongen.ByContact)
    if several:
        response = system.response(**asked, harmonics=3)
        hold(response.to_frame(), command("response", file, *listed, "--harmonics", "3"))
        assert len(response) == 4 and response.plot().has_data()
        # These have amplitudes alone.
        theirs = command("map", file, *listed)
        answers = [system.map(**asked), system.curve(**asked), system.by_contact(**asked)]
        for answer in answers:
            hold(answer.to_frame(), theirs)
            assert answer == answers[0] and len(answer) == 4 and answer.plot().has_data()
    band = (0.98 * point["hz"], 1.02 * point["hz"])
    ours = system.curve(hz=band, friction=point["friction"], **load(point))
    theirs = command("curve", file, "--hz", f"{band[0]!r}:{band[1]!r}", *options(point, ("hz",)))
    hold(ours.to_frame(), theirs)
    assert not several or len(ours) == 200


def test_limits(scene, command):
    system, file, point = scene
    asked = {"hz": [point["hz"], 2 * point["hz"]], **load(point)}
    listed = ["--hz", ",".join(map(repr, asked["hz"])), *options(load(point))]
    if "bumper" in system.text:
        with pytest.raises(DomainError, match="stops"):
            system.limits(**asked)
        return
    joined = "dampers" in system.text
    ours = system.limits(**asked) if joined else system.limits(**asked, estimates=True)
    hold(ours.to_frame(), command("limits", file, *listed))
    if joined:
        with pytest.raises(DomainError, match="estimates has no answer for a scene with several"):
            system.limits(**asked, estimates=True)
        with pytest.raises(DomainError, match="limits_without_search has no answer"):
            system.limits_without_search(**asked)


@pytest.mark.parametrize("along", ["friction", "hz"])
def test_branch(scene, command, along):
    system, file, point = scene
    over = (point[along], 1.1 * point[along])
    fixed = {name: value for name, value in point.items() if name != along}
    ours = system.branch(along, over, **fixed, points=20)
    asked = ("--along", along, f"{over[0]!r}:{over[1]!r}", *options(fixed), "--points", 20)
    hold(ours.to_frame(), command("branch", file, *asked))
    assert (ours.value[0], ours.branch[0], ours.unit) == (over[0], 0, {"hz": "Hz", "friction": "N"}[along])
    assert ours.ends.points.tolist() == [len(ours)] and ours.ends.parent.tolist() == [-1]
    assert ours.plot().has_data()


def test_a_branch_follows_other_branches(command, tmp_path):
    text = "struct Block { masses: { m: 1 }, springs: { base - m: 1 }, contact: m - base, excitation: base, stiction: 1.5 }"
    file = tmp_path / "block.friction"
    file.write_text(text, encoding="utf-8")
    system = System(text)
    ours = system.branch(along="r", over=(0.8, 0.5), beta=0.1, switch=1, states=True, of="accel(m)")
    asked = ("--along", "r", "0.8:0.5", "--beta", 0.1, "--switch", 1, "--states", "--of", "accel(m)")
    hold(ours.to_frame(), command("branch", file, *asked))
    assert ours.ends.parent.tolist() == [-1, 0] and ours.along == "r" and ours.unit == ""
    for asked, said in [
        ({"along": "m roof", "r": 0.5}, "along: there is no parameter `m roof`; the parameters are m m"),
        ({"over": (1.0, 1.0)}, "over is .*: two finite numbers that differ are needed"),
        ({"r": 0.3}, "along: the frequency varies; leave r, hz, omega out"),
        ({"beta": None}, "the friction: give one of beta and friction"),
        ({"switch": -1}, "switch is -1: a whole number from 0"),
        ({"points": 0}, "points is 0: a whole number from 1"),
        ({"of": "slip(contact)"}, "the answer has displacement, slip, force and energy of every contact"),
    ]:
        with pytest.raises(DomainError, match=said):
            system.branch(**({"along": "r", "over": (0.8, 0.5), "beta": 0.1} | asked))


def test_limit_cycle(command, tmp_path):
    text = """struct Belt { masses: { block: 1 }, springs: { block - wall: 1 },
        contacts: { pads: block - wall { speed: 0.3, stiction: 2 } } }"""
    file = tmp_path / "belt.friction"
    file.write_text(text, encoding="utf-8")
    ours = System(text).limit_cycle(friction=[0.0, 1.0, 2.0])
    hold(ours.to_frame(), command("limit-cycle", file, "--friction", "0,1,2"))
    assert ours.without == [0.0] and ours["pads"].stops.tolist() == [1, 1]
    started = System(text).limit_cycle(friction=1.0, start=([0.5], [0.3]), of="vel(block)")
    theirs = command("limit-cycle", file, "--friction", 1, "--from", "0.5;0.3", "--of", "vel(block)")
    hold(started.to_frame(), theirs)


def test_simulate(scene, command):
    system, file, point = scene
    extent = {"cycles": 2, "skip": 1, "samples": 20}
    ours = system.simulate(**point, **extent)
    hold(ours.to_frame(), command("time", file, *options(point | extent)))
    hold(ours.events.to_frame(), command("time", file, *options(point | extent), "--events"))
    assert ours.plot().has_data()
    x = [0.002] * len(system.masses)
    state = ",".join(map(repr, x)) + ";" + ",".join("0" for _ in x)
    ours = system.simulate(**point, **extent, start=(x, [0.0] * len(x)))
    hold(ours.to_frame(), command("time", file, *options(point | extent), "--from", state))
    ours = system.simulate(**point, samples=20, steady=True)
    hold(ours.to_frame(), command("time", file, *options(point), "--samples", 20, "--steady"))
    ours = system.simulate(friction=point["friction"], start=(x, [0.0] * len(x)), until=1.5, samples=30)
    asked = ("--friction", point["friction"], "--from", state, "--until", 1.5, "--samples", 30)
    hold(ours.to_frame(), command("time", file, *asked))
    for asked in [point, {"friction": 1.0, "start": (x, x), "until": 1.0}]:
        with pytest.raises(DomainError, match="must be even"):
            system.simulate(**asked, samples=3)


def test_sensitivities(scene, command):
    system, file, point = scene
    names = [system.masses[0]] if "contact" in system.contacts and "dampers" not in system.text else []
    names = names or [system.masses[0], *system.contacts]
    for name in names:
        theirs = command("sensitivity", file, "--of", name, *options(point))
        if theirs.parameter.isna().all():
            with pytest.raises(DomainError, match=f"no derivative: {theirs.answer[0]}"):
                system.sensitivities(name, **point)
            continue
        ours = system.sensitivities(name, **point)
        once = ("frequency_Hz", "r", "friction_N", "beta", "regime", "answer")
        hold(ours.to_frame(), theirs, but=once)
        assert (theirs.regime == ours.regime).all()


@pytest.fixture
def record(scene, tmp_path):
    """Returns a recording of the excitation as an object and as a file."""
    _, _, point = scene
    times = np.arange(200) / 100
    name, unit, size = ("base", "m_s2", 0.3) if "base" in point else ("force", "N", 3.0)
    file = tmp_path / "record.csv"
    lines = zip(times.tolist(), (size * np.sin(9 * times)).tolist(), strict=True)
    text = f"time_s,{name}_{unit}\n" + "".join(f"{a!r},{b!r}\n" for a, b in lines)
    file.write_text(text, encoding="utf-8")
    return Recording.from_file(file, drives=True), file


def test_drive(scene, record, command):
    system, file, point = scene
    recording, path = record
    friction = point["friction"]
    ours = system.drive(recording, friction=friction, after=0.5)
    hold(ours.to_frame(), command("drive", file, path, "--friction", friction, "--after", 0.5))
    assert len(ours) == 250 and list(ours.friction_energy) == list(ours.contacts) and ours.plot().has_data()
    work = ours.work
    assert work.load == pytest.approx(work.friction + work.damping + work.stored, rel=1e-6, abs=1e-9)
    mass = system.masses[0]
    ours = system.drive(recording, friction=friction, of=[mass, *system.contacts])
    asked = [text for name in [mass, *system.contacts] for text in ("--of", name)]
    hold(ours.to_frame(), command("drive", file, path, "--friction", friction, *asked))
    peaks = system.drive(recording, friction=[friction, 2 * friction], peaks=True)
    theirs = command("drive", file, path, "--friction", f"{friction!r},{2 * friction!r}", "--peaks")
    hold(peaks.to_frame(), theirs)
    started = system.drive(recording, friction=friction, start=([0.0] * len(system.masses), [0.0] * len(system.masses)))
    assert len(started) == 200


def test_what_cannot_be_driven(scene, record):
    system, _, point = scene
    recording, _ = record
    for asked, said in [
        ({"friction": [1.0, 2.0]}, "friction: one number is needed here, not an array; peaks=True takes several"),
        ({"after": -1.0}, "after is -1.0: a time in s, 0 or above"),
        ({"of": "roof"}, "of: there is no mass `roof`; .*the contacts are"),
        ({"of": f"accel({system.masses[0]})"}, "of: `accel.*: a motion in time has displacements and spring forces"),
        ({"start": ([0.0], [0.0])}, "start: 2 finite numbers are needed, one for each mass"),
    ]:
        with pytest.raises(DomainError, match=said):
            system.drive(recording, **({"friction": point["friction"]} | asked))


def test_what_several_contacts_do_not_have():
    system = System(SCENES["three contacts"][0])
    point = SCENES["three contacts"][1]
    band = (2.9, 3.1)
    for name, ask in {
        "accuracy": lambda: system.curve(hz=band, friction=3e3, base=0.003, accuracy=0.1),
        "rates": lambda: system.curve(hz=band, friction=3e3, base=0.003, rates=True),
        'start="up"': lambda: system.curve(hz=band, friction=3e3, base=0.003, start="up"),
    }.items():
        with pytest.raises(DomainError, match=f"{name.strip()}.* has no answer for a scene with several `contacts`"):
            ask()
    for of, said in {
        "slip(pads)": "of `slip.pads.`: the answer has displacement, slip, force and energy of every contact",
        "roof": "of: there is no mass `roof`",
    }.items():
        with pytest.raises(DomainError, match=said):
            system.orbit(**point, of=of)
    with pytest.raises(DomainError, match="a motion in time of several contacts has masses and differences"):
        system.simulate(**point, of="shear")
    with pytest.raises(DomainError, match="of `roof`: it is neither a mass nor a contact"):
        system.sensitivities("roof", **point)
    shear = system.orbit(**point, of=["shear", "accel(upper)", "upper-lower", "spring(base-lower)"])
    assert shear["shear"].amplitude_N > 0 and shear["accel(upper)"].amplitude_m_s2 > 0


def test_features_of_several_contacts(command, tmp_path):
    text, _ = SCENES["three contacts"]
    file = tmp_path / "frame.friction"
    file.write_text(text, encoding="utf-8")
    features = System(text).features(base=0.003)
    # The derivatives, which such a scene does not have, are no columns here.
    theirs = command("features", file, "--base", "0.003").drop(columns=["per_cent_for_one", "parameter"])
    hold(features.to_frame(), theirs)
    assert features.keys() == ["lines"]
    with pytest.raises(ValueError, match="a single contact"):
        features.plot()


def test_labels_of_a_dataset(scene):
    system, _, point = scene
    asked = {"hz": [point["hz"], 1.1 * point["hz"]], "friction": [point["friction"], 2 * point["friction"]]}
    data = system.response(**asked, **load(point)).to_xarray()
    np.testing.assert_array_equal(data.frequency, asked["hz"])
    np.testing.assert_array_equal(data.friction, asked["friction"])
    assert data.frequency.attrs["units"] == "Hz" and data.friction.attrs["units"] == "N"
    chosen = data.sel(frequency=point["hz"], method="nearest").sel(friction=point["friction"])
    assert str(chosen.regime.values) == system.response(**point).regime


def test_equal_answers(scene):
    system, _, point = scene
    assert system.orbit(**point) == system.orbit(**point) != system.orbit(**(point | {"friction": 0.0}))
    run = system.simulate(**point, cycles=1, samples=20)
    assert run == system.simulate(**point, cycles=1, samples=20) and run != system.simulate(**point, cycles=2, samples=20)
    name, unit = ("force", "N") if "force" in point else ("base", "m")
    recording = Recording({name: ([0.0, 0.01, 0.0], unit)}, rate=100, drives=True)
    driven = [system.drive(recording, friction=friction) for friction in (0.0, 0.0, point["friction"])]
    assert driven[0] == driven[1] != driven[2]
    assert len(run) == 21 and run.contact == run[next(iter(run.contacts))]


def test_equal_answers_of_one_contact(frame):
    steps = [frame.step(0.01, base=[0.0, 0.001], base_velocity=[0.0, 0.1], friction=friction) for friction in (0.0, 0.0, 0.1)]
    assert steps[0] == steps[1] != steps[2] and steps[0] != frame.orbit(r=0.9, beta=0.3)
    features = [frame.features(base=0.001, friction=friction) for friction in (0.4, 0.4, 0.8)]
    assert features[0] == features[1] != features[2]
    grid = frame.response(r=[0.5, 0.9], beta=[0.1, 0.2, 0.3])
    assert len(grid) == 6 == len(grid.to_frame()) and len(frame.orbit(r=0.9, beta=0.3)) == 1


def test_best_shares(command, tmp_path):
    text = """struct Pair { masses: { m: 1 }, springs: { base - m: 100 }, excitation: base, damping: modal(0.02),
        contacts: { pads: m - wall { stiffness: 20 }, brace: base - m { stiffness: 50 } } }"""
    file = tmp_path / "pair.friction"
    file.write_text(text, encoding="utf-8")
    system = System(text)
    for vary in ("share", "share pads"):
        best = system.optimum("m", hz=(1.5, 1.8), base=0.01, vary=(vary, 0.8, 1.25))
        options = ("--of", "m", "--hz", "1.5:1.8", "--base", 0.01, "--vary", f"{vary}=0.8:1.25")
        theirs = command("optimum", file, *options)
        known = dict(zip(theirs.quantity, theirs.value, strict=True))
        assert list(best.shares) == ["pads", "brace"]
        for name, value in {
            "share of pads": best.shares["pads"],
            "share of brace": best.shares["brace"],
            "largest amplitude with the shares of the description": best.amplitude_before_m,
            "largest amplitude of m": best.amplitude_m,
            "friction": best.friction_N,
        }.items():
            assert float(known[name]) == value, name
    for vary, said in {"share roof": "vary: there is no number `share roof`", "mass": "vary: there is no number `mass`"}.items():
        with pytest.raises(DomainError, match=said):
            system.optimum("m", hz=(1.5, 1.8), base=0.01, vary=(vary, 0.8, 1.25))
    # A bound below the smallest drift at the best shares has no answer, and one above every drift has no effect.
    with pytest.raises(DomainError, match="no friction holds this bound"):
        system.optimum("m", hz=(1.5, 1.8), base=0.01, vary=("share", 0.8, 1.25), keep={"m-base": 1e-6})
    kept = system.optimum("m", hz=(1.5, 1.8), base=0.01, vary=("share pads", 0.8, 1.25), keep={"m-base": 1.0})
    assert kept.amplitude_m == pytest.approx(best.amplitude_m, rel=1e-2) and kept.largest["m-base"] < 1.0

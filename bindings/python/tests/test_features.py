"""Tests features against the output of the command, and against closed forms of two masses."""

import math
import re

import numpy as np
import pytest
from conftest import SCENES

import frictiongen
from frictiongen import DomainError, System

UPPER = "thesis/two_m2.friction"


@pytest.fixture
def chain():
    """Returns two equal masses on two equal springs, the first of which rubs.  The thesis has their features in closed form."""
    return System(
        """struct Chain {
            masses: { first: 1, second: 1 }, springs: { base - first: 1, first - second: 1 },
            contact: first - wall, excitation: first,
        }"""
    )


def same(ours, theirs):
    """Returns true if both have the same bits.  Missing values are NaN on both sides."""
    np.testing.assert_array_equal(np.asarray(ours, float), np.asarray(theirs, float))


def of(theirs, feature):
    return theirs[theirs.feature == feature].reset_index(drop=True)


CASES = [
    ("frame.friction", {"hz": (1.0, 7.0), "friction": [0.2, 0.8], "base": 0.001}, "--hz 1:7 --friction 0.2,0.8 --base 0.001"),
    ("frame.friction", {"beta": 0.3}, "--beta 0.3"),
    (UPPER, {"r": (0.3, 2.5), "beta": [0.1, 0.6]}, "--r 0.3:2.5 --beta 0.1,0.6"),
    (UPPER, {"beta": [0.1, 0.6], "force": 2.0}, "--beta 0.1,0.6 --force 2"),
    ("thesis/two_between.friction", {"r": (0.3, 2.5), "beta": 0.3}, "--r 0.3:2.5 --beta 0.3"),
]


@pytest.mark.parametrize(("scene", "asked", "options"), CASES)
def test_every_line_of_the_command_is_here(command, scene, asked, options):
    features = System.from_file(SCENES / scene).features(**asked)
    theirs = command("features", scene, *options.split())
    load = "force" in asked or "base" in asked
    n, m, force = ("_N", "_m", "friction_N") if load else ("", "", "beta")
    counted = 0

    def places(ours, lines, ends=False):
        nonlocal counted
        assert len(ours.r) == len(lines)
        same(ours.r, lines.r)
        if "frequency_Hz" in lines:
            same(ours.frequency_Hz, lines.frequency_Hz)
        if ends:
            same(ours.to_r, lines.to_r)
        counted += len(lines)

    lines = of(theirs, "resonance")
    places(features.resonances, lines)
    damped = (features.resonances.damping_ratio > 0).any()
    if not damped:
        same(features.resonances[f"threshold{n}"], lines[force])
    else:
        known = of(theirs, "threshold without damping")
        threshold = features.resonances[f"threshold{n}"]
        same(threshold[~np.isnan(threshold)], known[force])
    lines = of(theirs, "resonance if stuck")
    places(features.held_resonances, lines)
    new = features.held_resonances.new
    same(features.held_resonances[f"sliding_limit{n}"][new], lines[force][new])
    rest, infinity = of(theirs, "limit for r -> 0"), of(theirs, "limit for r -> inf")
    assert features.ends.r.tolist() == [0.0, math.inf]
    same(features.ends[f"sliding_limit{n}"], [*rest[force], *infinity[force][1:]])
    assert features.ends[f"continuous_limit{n}"][1] == infinity[force][0]
    places(features.antiresonances, of(theirs, "antiresonance"))
    lines = of(theirs, "invariant point")
    points = features.invariant_points
    places(points, lines)
    same(points[f"amplitude{m}"], lines[f"amplitude{m}"])
    same(points[f"continuous_limit{n}"], lines[force])
    said = [f"{measured}: {condition}" for measured, condition in zip(points.measured, points.condition, strict=True)]
    assert said == lines.detail.tolist() and points["of"].tolist() == lines["of"].tolist()
    lines, grows = of(theirs, "grows with friction"), features.inversions
    places(grows, lines, ends=True)
    said = [f"{a}: {b} to {c}" for a, b, c in zip(grows.measured, grows.edge, grows.to_edge, strict=True)]
    assert said == lines.detail.tolist()
    lines, starts = of(theirs, "quasi-static start"), features.starts
    slides = ~starts.stuck
    same(starts[f"amplitude{m}"][slides], lines[lines.detail.isna()][f"amplitude{m}"])
    places(features.sliding_ranges, of(theirs, "slides"), ends=True)
    lines = of(theirs, "regime")
    places(features.regimes, lines, ends=True)
    assert features.regimes.regime.tolist() == lines.detail.tolist()
    assert features.regimes.found.tolist() == lines.found.tolist()
    same(features.regimes[force], lines[force])
    lines, peaks = of(theirs, "peak"), features.peaks
    has = ~np.isnan(peaks.r)
    same(peaks.r[has], lines.r)
    same(peaks[f"amplitude{m}"][has], lines[f"amplitude{m}"])
    lines = of(theirs, "peak by estimate")
    has = ~np.isnan(peaks[f"estimate{m}"])
    same(peaks[f"estimate{m}"][has], lines[f"amplitude{m}"])
    same(peaks.resonance_r[has], lines.r)
    places(features.crossings, of(theirs, "same amplitude"))
    assert counted > 5

    # The strongest parameter of the first number of each line.
    lines = of(theirs, "resonance if stuck")
    held = features.held_resonances
    relative = held.relative(held.sensed[0])
    for place, (parameter, share) in enumerate(zip(lines.parameter, lines.per_cent_for_one, strict=True)):
        assert relative[parameter][place] == share
        assert abs(share) == max(abs(relative[name][place]) for name in relative if not math.isnan(relative[name][place]))


def test_places_that_are_known(chain):
    features = chain.features(r=(0.55, 3.0), beta=[0.2, 0.4])
    points = features.invariant_points
    own = points.r[(points["of"] == "contact") & (points.measured == "amplitude")]
    # In the thesis the points are at sqrt(5)/4 and sqrt(5)/2.  The stuck chain is one mass on one spring.
    np.testing.assert_allclose(own, [math.sqrt(5) / 4, math.sqrt(5) / 2], rtol=1e-14)
    np.testing.assert_allclose(features.held_resonances.r, [1.0], rtol=1e-14)
    # At an invariant point the amplitude is the same for every friction.
    response = chain.response(r=own, beta=[0.05, 0.2])
    contact = response["contact"].amplitude
    np.testing.assert_allclose(contact[:, 0], contact[:, 1], rtol=1e-12)
    # The resonances are the golden ratio and its inverse.
    golden = (1 + math.sqrt(5)) / 2
    np.testing.assert_allclose(features.resonances.r, [1 / golden, golden], rtol=1e-14)


def test_derivatives_are_differences(frame):
    """Checks derivatives of frequencies and forces by changed descriptions.  Central differences with a relative step
    of 1e-4 have an error of 1e-8."""

    def asked(stiffness):
        text = frictiongen.FRAME.replace("1323.0", repr(stiffness)).replace("damping: modal[0.010, 0.012],", "")
        return System(text).features(hz=(1, 7), friction=0.4, base=0.001)

    step = 0.1323
    low, middle, high = (asked(1323.0 + side * step) for side in (-1, 0, 1))
    for table, column in [
        ("held_resonances", "frequency_Hz"), ("resonances", "threshold_N"), ("resonances", "frequency_Hz"),
        ("invariant_points", "frequency_Hz"), ("sliding_ranges", "to_frequency_Hz"), ("starts", "amplitude_m"),
    ]:  # fmt: skip
        found = middle[table].derivatives(column)["k lower - upper"]
        known = ~np.isnan(found)
        differences = (high[table][column] - low[table][column]) / (2 * step)
        np.testing.assert_allclose(found[known], differences[known], rtol=1e-6, atol=1e-12)
        assert known.any(), table
        relative = middle[table].relative(column)["k lower - upper"]
        np.testing.assert_allclose(relative[known], (1323.0 * found / middle[table][column])[known], rtol=1e-12)
    with pytest.raises(KeyError, match="no derivatives of 'regime'; there are of to_frequency_Hz"):
        middle.regimes.derivatives("regime")


def test_regimes_are_those_of_the_responses(frame):
    features = frame.features(hz=(1, 7), friction=[0.2, 1.0], base=0.001)
    ranges = features.regimes
    for place, regime in enumerate(ranges.regime):
        middle = (ranges.frequency_Hz[place] + ranges.to_frequency_Hz[place]) / 2
        assert frame.response(hz=middle, friction=ranges.friction_N[place], base=0.001).regime == regime
    assert len(ranges.regime) > 6
    # Each peak must be the largest amplitude of the response close to it.
    for place, hz in enumerate(features.peaks.frequency_Hz):
        if not math.isnan(hz):
            name, friction = features.peaks["of"][place], features.peaks.friction_N[place]
            near = frame.response(hz=hz * np.linspace(0.99, 1.01, 41), friction=friction, base=0.001)
            amplitude = features.peaks.amplitude_m[place]
            assert near[str(name)].amplitude_m.max() == pytest.approx(amplitude, rel=1e-9)


def test_how_they_look(chain, frame):
    features = frame.features(friction=[0.2, 0.4], base=0.001, of="lower")
    assert set(features.peaks["of"]) == {"lower"} and "Features: 2 resonances, 1 held_resonances" in repr(features)
    whole = features.to_frame()
    assert whole.feature[0] == "resonances" and len(whole) == sum(len(features[name].to_frame()) for name in features)
    assert len(frame.features().invariant_points.to_frame()) == 0
    for drawn in (features.plot(), chain.features(beta=[0.2, 0.4]).plot(), frame.features().plot()):
        assert drawn.has_data() and drawn.get_xlabel()
        drawn.figure.canvas.draw()
    assert "regimes" in features.keys() and features["regimes"] is features.regimes


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ({"hz": 1.0}, "hz: a band is needed, a tuple"),
        ({"hz": (3, 1)}, "a band must begin above 0 and end above its start"),
        ({"hz": (math.nan, 1)}, "a band must begin above 0"),
        ({"hz": (1, 3), "r": (1, 3)}, "give one of r, hz and omega"),
        ({"beta": -0.1}, "beta is -0.1"),
        ({"friction": 0.3}, "needs the amplitude of the load: give base"),
        ({"beta": [math.nan]}, "beta[0] is NaN"),
        ({"beta": np.linspace(0.1, 1, 17)}, "at most 16 frictions are possible"),
        ({"force": 1.0}, "the scene is driven by its base"),
        ({"of": "roof"}, "there is no mass `roof`"),
    ],
)
def test_what_cannot_be_asked(frame, asked, said):
    with pytest.raises(DomainError, match=re.escape(said)):
        frame.features(**asked)


def test_of_the_wrong_type(frame):
    for asked in [{"hz": "1:7"}, {"beta": "0.3"}, {"of": 3}, {"base": object()}]:
        with pytest.raises(TypeError):
            frame.features(**asked)


def test_crowded(chain):
    with pytest.raises(DomainError, match="sub-harmonics, which crowd"):
        chain.features(r=(1e-9, 2.0))

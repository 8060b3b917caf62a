"""Tests of the best friction for several quantities."""

import numpy as np
import pytest

import frictiongen

ISOLATOR = """struct Isolator {
    masses: { block: 2 }, springs: { base - block: 800 }, contact: block - base, excitation: base, damping: modal(0.02),
}"""


@pytest.mark.parametrize(
    ("load", "option", "values", "texts"),
    [
        ({"base": 0.001}, ("--base", 0.001), {"block-base": 0.002, "accel(block)": 1.0}, ("2mm", "1 m/s2")),
        ({"base": "1 m/s2"}, ("--base", "1 m/s2"), {"block": 0.005, "force(contact)": 0.5}, ("5 mm", "0.5 N")),
        ({}, (), {"block-base": 2.0, "force(contact)": 0.5}, ("2", "0.5")),
    ],
)
def test_the_commands_answer(command_json, tmp_path, load, option, values, texts):
    """Checks that every number equals the command's, to the last bit."""
    scene = tmp_path / "isolator.friction"
    scene.write_text(ISOLATOR, encoding="utf-8")
    best = frictiongen.System(ISOLATOR).optimum(values, hz=(1, 9), **load)
    of = [text for name, value in zip(values, texts, strict=True) for text in ("--of", f"{name}/{value}")]
    lines = command_json("optimum", scene, *of, "--hz", "1:9", *option)
    once = {line["key"]: line["value"] for line in lines if line["list"] is None}
    shown = ("bracket", "beyond_jump", "unbounded_to", "unanswered", "unsettled")
    assert {name for name in best.keys() if not name.startswith(shown)} == {*once, "decisive", "quotient"} - {
        name for name in once if name.startswith(shown)
    }
    for name, value in once.items():
        assert best[name] == value, name
    told = [line for line in lines if line["list"] == "weighted"]
    assert len(told) == 3 * len(values)
    for line in told:
        place = line["row"] - 1
        assert best.weighted[line["key"]][place] == line["value"], line
        if line["key"] == "largest":
            assert line["quantity"] == f"largest value of {best.weighted.quantity[place]}"
            assert line["unit"] == best.weighted.unit[place] or not load
    ratios = dict(zip(best.weighted.quantity.tolist(), best.weighted.ratio.tolist(), strict=True))
    assert list(ratios) == list(values)
    assert best.decisive == max(ratios, key=ratios.get) and best.quotient == ratios[best.decisive]
    for line in lines:
        if line["list"] == "peaks":
            assert str(best.peaks[line["key"]][line["row"] - 1]) == str(line["value"])
    assert best.largest == dict(zip(values, best.weighted.largest.tolist(), strict=True))


def test_no_other_friction_is_better(frame):
    """Checks the largest quotient at frictions around the best one, on a grid of frequencies."""
    values, hz = {"upper-lower": 2e-3, "upper": 3e-3}, (1.0, 7.0)
    best = frame.optimum(values, hz=hz, base=0.001)
    # Between points of the grid a peak may be higher, by less than 1e-3 with a quarter of 1e-3 of the frequency.
    grid, friction = np.geomspace(*hz, 4000), best.friction_N * np.array([0.9, 0.97, 1.0, 1.03, 1.1])
    answer = frame.response(hz=grid, friction=friction, base=0.001, of=list(values))
    largest = np.max([answer[name].amplitude_m / value for name, value in values.items()], axis=0).max(axis=0)
    assert abs(largest[2] / best.quotient - 1) < 1e-3
    assert (largest[[0, 1, 3, 4]] > best.quotient).all(), largest


def test_one_quantity_of_several_is_that_quantity():
    """Checks that a dict with one entry gives the friction of this quantity alone."""
    isolator = frictiongen.System(ISOLATOR)
    several = isolator.optimum({"accel(block)": 2.0}, r=(0.5, 3.0), base=0.001)
    alone = isolator.optimum("accel(block)", r=(0.5, 3.0), base=0.001)
    # The value of the minimum is known to 1e-6, and so its place to the root of that.
    assert several.amplitude_m_s2 == pytest.approx(alone.amplitude_m_s2, rel=1e-6)
    assert several.friction_N == pytest.approx(alone.friction_N, rel=1e-3)
    assert several.quotient == pytest.approx(several.amplitude_m_s2 / 2.0, rel=1e-15)
    assert alone.largest == {} and "decisive" not in alone.keys() and len(alone.tolerances.excess) > 0


@pytest.mark.parametrize("vary", [None, ("k base - block", 500.0, 1500.0)])
def test_bounds_hold(command_json, tmp_path, vary):
    """Checks the best friction under a bound: every number equals the command's, and the bound decides."""
    scene = tmp_path / "isolator.friction"
    scene.write_text(ISOLATOR, encoding="utf-8")
    bound = 0.0015
    best = frictiongen.System(ISOLATOR).optimum(
        "accel(block)", hz=(1, 9), base=0.001, keep={"block-base": bound}, vary=vary
    )
    option = () if vary is None else ("--vary", f"{vary[0]}={vary[1]}:{vary[2]}")
    asked = ("--of", "accel(block)", "--keep", "block-base <= 1.5mm", "--hz", "1:9", "--base", 0.001, *option)
    lines = command_json("optimum", scene, *asked)
    kept = {line["key"]: line["value"] for line in lines if line["list"] == "kept"}
    assert {key: best.kept[key].tolist() for key in kept} == {key: [value] for key, value in kept.items()}
    once = {line["key"]: line["value"] for line in lines if line["list"] is None}
    assert best.friction_N == once["friction_N"] and best.amplitude_m_s2 == once["amplitude_m_s2"]
    if vary is not None:
        assert best.value == next(line["value"] for line in lines if line["list"] == "tuned")
    assert best.largest == {"block-base": kept["largest"]} and kept["largest"] <= kept["bound"] == bound
    free = frictiongen.System(ISOLATOR).optimum("accel(block)", hz=(1, 9), base=0.001, vary=vary)
    assert free.amplitude_m_s2 <= best.amplitude_m_s2 and not free.kept.quantity.size
    assert len(best.weighted.quantity) == 0

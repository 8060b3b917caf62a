"""Tests that the columns of answers are those of the library's tables, and that the classes and sources use the same
names."""

import re

import numpy as np
import pytest
from conftest import ROOT

import frictiongen

HZ, BETA = (1.0, 6.0), 0.3
#: Each question, as a function of system, frequency and load.  The tests ask it with a load, without one, and with
#: rad/s.
ASKED = {
    "Limits": lambda frame, at, load: frame.limits(**at, estimates=True, **load),
    "Response": lambda frame, at, load: frame.response(**at, beta=BETA, **load),
    "Map": lambda frame, at, load: frame.map(**at, beta=BETA, **load),
    "Orbit": lambda frame, at, load: frame.orbit(**at, beta=BETA, **load),
    "Curve": lambda frame, at, load: frame.curve(
        **{name: (0.9 * value, 1.1 * value) for name, value in at.items()},
        beta=BETA, accuracy=0.1, start=["rest", "up"], **load,
    ),
    "History": lambda frame, at, load: frame.simulate(**at, beta=BETA, cycles=1, **load),
}  # fmt: skip


#: Questions about scenes with several contacts, whose answers have further columns, or classes of their own.
SEVERAL = {
    "Limits": lambda pair, at, load: pair.limits(**at, **load),
    "Orbit": lambda pair, at, load: pair.orbit(**at, beta=BETA, **load),
    "ByContact": lambda pair, at, load: pair.response(**at, beta=BETA, **load),
    "Branches": lambda pair, at, load: pair.branch("beta", (BETA, 1.1 * BETA), **at, points=2, **load),
}


def several(name):
    pair = frictiongen.System(frictiongen.FRAME.replace("excitation", "dampers: { base - lower: 1.0 }, excitation"))
    for at in ({"r": 0.4}, {"omega": 2 * np.pi * pair.hertz(0.4)}):
        for load in ({}, {"base": 0.001}):
            yield SEVERAL[name](pair, at, load)


def answers(name):
    frame = frictiongen.System(frictiongen.FRAME)
    r = 0.4
    omega = 2 * np.pi * frame.hertz(r)
    for at in ({"r": r}, {"omega": omega}):
        for load in ({}, {"base": 0.001}):
            yield ASKED[name](frame, at, load)


def test_annotations_of_periodic():
    """Checks that the classes of periodic loads name every column that belongs to no contact or mass, and no other."""
    frame = frictiongen.System(frictiongen.FRAME)
    states = frame.periodic({1: 0.001}, period=0.8, friction=[0.2, 0.4], motion=True)
    for answer, but in [(states, {"histories"}), (states.histories[0], set())]:
        known = set(type(answer).__annotations__) - but
        assert known == {key for key in answer.keys() if "." not in key}


@pytest.mark.parametrize("name", [*ASKED, *(name for name in SEVERAL if name not in ASKED)])
def test_annotations(name):
    """Checks that a class names every column that belongs to no contact or mass, and no other column."""
    found = [*(answers(name) if name in ASKED else []), *(several(name) if name in SEVERAL else [])]
    keys = {key for answer in found for key in answer.keys() if "." not in key}
    known = {key for base in type(found[0]).__mro__ for key in base.__dict__.get("__annotations__", {})}
    known -= {key for key in known if key.startswith("_")} | {"events", "ends", "along", "unit", "spectrum", "boundaries"}
    # A class without times or angular frequencies may leave out their columns.
    assert keys - known <= {"r", "beta", "frequency_Hz", "omega_rad_s", "friction_N"}
    assert known <= keys | {"tau"}


def test_no_source_names_a_column():
    """Checks that no source names a column.  All columns come from the library, where a new column is one line."""
    columns = {part for name in ASKED for answer in answers(name) for key in answer.keys() for part in key.split(".")}
    frame = frictiongen.System(frictiongen.FRAME)
    isolator = frictiongen.System.of({"block": 2.0}, {"base - block": 800.0}, "block - base", "base", damping=0.02)
    best = isolator.optimum({"block-base": 2.0, "force(contact)": 0.5}, r=(0.5, 3.0))
    columns |= {*frame.optimum("lower", hz=(4, 6), base=0.001).keys(), *best.weighted.keys()}
    states = frame.periodic({1: 0.001}, period=0.8, friction=0.4, motion=True)
    columns |= {part for answer in (states, *states.histories) for key in answer.keys() for part in key.split(".")}
    # Some arguments, attributes and names of masses are also names of columns.
    columns -= {"r", "beta", "start", "contact", "lower", "upper", "of", "friction", "kind", "period"}
    named = []
    for path in sorted((ROOT / "bindings" / "python" / "src").rglob("*.rs")):
        text = path.read_text(encoding="utf-8")
        # These files contain names of arguments in messages, and names of channels of a recording.
        if path.name in ("observed.rs", "recording.rs"):
            continue
        literals = set(re.findall(r'"([^"\n]*)"', text))
        named += [(path.name, name) for name in sorted(literals & columns)]
    # Only `end` is named: it is a word of the answer, and not yet a column of the library.
    assert named == [("follow.rs", "end")] and len(columns) > 50, (named, len(columns))

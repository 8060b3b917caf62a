"""Tests that bad input gives a clear error of the right kind that names the wrong argument, and that nothing
crashes."""

import math
import re

import numpy as np
import pytest

import frictiongen
from frictiongen import DomainError, SceneError, System


def test_a_description_with_mistakes_says_where():
    text = frictiongen.FRAME.replace("lower: 3.27", "lower: -3.27").replace("upper - wall", "roof - wall")
    with pytest.raises(SceneError) as raised:
        System(text)
    first, second = raised.value.errors
    assert (first.line, second.line, second.column) == (3, 5, 14)
    assert isinstance(first, frictiongen.Mistake) and "roof" in second.message
    for line, column, message in raised.value.errors:
        assert f"{line}:{column}: {message}" in str(raised.value)


@pytest.mark.parametrize("text", ["", "struct", "}{", "\0", "struct A {" * 1000, "é" * 50, "struct Frame { masses: {} }"])
def test_what_is_no_description(text):
    with pytest.raises(SceneError) as raised:
        System(text)
    assert raised.value.errors and all(mistake.line >= 1 for mistake in raised.value.errors)


def test_the_name_of_a_file():
    with pytest.raises(SceneError, match=re.escape("System.from_file('frame.friction')")):
        System("frame.friction")


@pytest.mark.parametrize("text", [None, 3, b"struct", ["struct"]])
def test_what_is_no_text(text):
    with pytest.raises(TypeError, match="a description is a text, not"):
        System(text)


def test_half_a_surrogate_is_refused():
    with pytest.raises((UnicodeEncodeError, SceneError)):
        System("struct \ud800")


def test_files(tmp_path):
    path = tmp_path / "frame.friction"
    path.write_text(frictiongen.FRAME, encoding="utf-8")
    assert System.from_file(str(path)).masses == System.from_file(path).masses == ["lower", "upper"]
    with path.open(encoding="utf-8") as file:
        assert System.from_file(file).masses == ["lower", "upper"]
    with pytest.raises(ValueError, match="closed file"):
        System.from_file(file)
    with path.open("rb") as file, pytest.raises(TypeError, match="open it as text"):
        System.from_file(file)
    with pytest.raises(FileNotFoundError):
        System.from_file(tmp_path / "none")
    with pytest.raises(IsADirectoryError):
        System.from_file(tmp_path)
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(UnicodeDecodeError):
        System.from_file(path)
    for nothing in [None, 3, object()]:
        with pytest.raises(TypeError, match="a path or an open file is needed"):
            System.from_file(nothing)


# Arguments outside their domain, each with the message of its error.
OUTSIDE = [
    ({"hz": -1.0}, "hz is -1.0: a frequency must be a number, 0 or above"),
    ({"hz": [1.0, math.nan]}, "hz[1] is NaN: a frequency must be a number, 0 or above"),
    ({"r": [[0.9, 1.0], [1.1, 1.2]]}, "r: one number or a row of numbers is needed, but this has the shape (2, 2)"),
    ({"r": 0.9, "hz": 1.0}, "give one of r, hz and omega"),
    ({}, "give one of r, hz and omega"),
    ({"hz": 5e-324}, "hz is 5e-324: its frequency ratio is too small"),
    ({"r": 0.9, "beta": None}, "give one of beta and friction"),
    ({"r": 0.9, "friction": 0.1}, "give one of beta and friction"),
    ({"r": 0.9, "beta": -0.1}, "beta is -0.1: friction must be a finite number, 0 or above"),
    ({"r": 0.9, "beta": [0.1, math.inf]}, "beta[1] is inf"),
    ({"r": 0.9, "beta": [0.1, math.nan]}, "beta[1] is NaN"),
    ({"r": 0.9, "beta": None, "friction": 0.3}, "needs the amplitude of the load: give base"),
    ({"r": 0.9, "beta": None, "friction": -0.3, "base": 0.001}, "friction is -0.3"),
    ({"r": 0.9, "force": 1.0}, "force: the scene is driven by its base; its load is given by base"),
    ({"r": 0.9, "base": 0.0}, "base: the amplitude of a load must be above 0 and finite"),
    ({"r": 0.9, "base": math.nan}, "base: the amplitude of a load must be above 0 and finite"),
    ({"r": 0.9, "base": [0.1, 0.2]}, "base: one number is needed, but these are 2"),
    ({"r": 0.9, "base": 1.0, "force": 1.0}, "a scene has one load"),
    ({"r": 0.9, "base": 1e308}, "too small or too large to compute with"),
    ({"r": 0.9, "of": "roof"}, "of: there is no mass `roof`; the masses are lower, upper"),
    ({"r": 0.9, "of": ["lower", "lower"]}, "of: `lower` is given twice"),
]


@pytest.mark.parametrize(("asked", "said"), OUTSIDE)
@pytest.mark.parametrize("question", ["response", "map"])
def test_outside_the_domain(frame, question, asked, said):
    with pytest.raises(DomainError, match=re.escape(said)) as raised:
        getattr(frame, question)(**({"beta": 0.3} | asked))
    assert isinstance(raised.value, ValueError)


# Arguments that are not numbers, each with the message of its error.
OF_WRONG_TYPE = [
    ({"hz": "fast"}, "hz: a number or an array of numbers is needed, not str"),
    ({"hz": "1.0"}, "hz: a number or an array of numbers is needed, not str"),
    ({"hz": ["1", "2"]}, "hz: a number or an array of numbers is needed, not list"),
    ({"hz": True}, "hz: a number or an array of numbers is needed, not bool"),
    ({"hz": 1j}, "hz: a number or an array of numbers is needed, not complex"),
    ({"hz": [[1.0], [2.0, 3.0]]}, "hz: a number or an array of numbers is needed, not list"),
    ({"hz": object()}, "hz: a number or an array of numbers is needed, not object"),
    ({"hz": [1.0, None]}, "hz: a number or an array of numbers is needed, not list"),
    ({"hz": np.array(["2026-01-01"], "datetime64[D]")}, "hz: a number or an array of numbers is needed"),
    ({"hz": np.ma.array([1.0, 2.0], mask=[0, 1])}, "hz: the array has a mask"),
    ({"hz": 1.0, "of": 3}, "of: a name or a list of names is needed"),
    ({"hz": 1.0, "of": [3]}, "of: a name or a list of names is needed"),
]


@pytest.mark.parametrize(("asked", "said"), OF_WRONG_TYPE)
def test_of_the_wrong_type(frame, asked, said):
    with pytest.raises(TypeError, match=re.escape(said)):
        frame.response(**({"beta": 0.3} | asked))


def test_a_fault_in_an_argument_of_one_question(frame):
    point = {"hz": 1.2, "friction": 0.4, "base": 0.001}
    band = {"hz": (1.0, 5.0), "base": 0.001}
    for kind, said, ask in [
        (DomainError, "harmonics is 0: a whole number from 1 to 9999", lambda: frame.response(**point, harmonics=0)),
        (TypeError, "harmonics: a whole number is needed, not float", lambda: frame.response(**point, harmonics=3.0)),
        (TypeError, "harmonics: a whole number is needed, not bool", lambda: frame.response(**point, harmonics=True)),
        (DomainError, "harmonics is 1000000000000", lambda: frame.response(**point, harmonics=10**12)),
        (DomainError, "points of", lambda: frame.response(r=np.ones(10**5), beta=np.ones(10**4))),
        (DomainError, "points of", lambda: frame.map(r=np.ones(10**5), beta=np.ones(10**4))),
        (DomainError, "infinite, but a map needs finite frequencies", lambda: frame.map(r=math.inf, beta=0.1)),
        (DomainError, "hz is 0.0: a frequency must be above 0 and finite", lambda: frame.orbit(hz=0, beta=0.1)),
        (DomainError, "hz: one number is needed here", lambda: frame.orbit(hz=[1.0], beta=0.1)),
        (DomainError, "beta: one number is needed here", lambda: frame.orbit(hz=1.0, beta=[0.1])),
        (DomainError, "hz: a band is needed, a tuple (from, to)", lambda: frame.curve(hz=1.0, beta=0.1)),
        (DomainError, "hz is (2.0, 1.0): a band must begin above 0", lambda: frame.curve(hz=(2, 1), beta=0.1)),
        (DomainError, "hz is (NaN, 1.0): a band must begin above 0", lambda: frame.curve(hz=(math.nan, 1), beta=0.1)),
        (DomainError, "hz: a band is needed, a tuple", lambda: frame.curve(hz=[1, 2], beta=0.1)),
        (DomainError, "hz: a band is needed, a tuple", lambda: frame.optimum("lower", hz=[1, 2])),
        (DomainError, "hz: a band is needed, a tuple", lambda: frame.features(hz=[1, 2])),
        (DomainError, "hz: a tuple is a band", lambda: frame.map(hz=(1, 2, 3), beta=[0.1, 0.2])),
        (DomainError, "hz: a tuple is a band", lambda: frame.limits(hz=(1,))),
        (DomainError, "hz is (7.0, 1.0): a band must begin", lambda: frame.map(hz=(7, 1), beta=[0.1, 0.2])),
        (DomainError, "beta is (-1.0, 1.0): a band must begin", lambda: frame.map(hz=[1, 7], beta=(-1, 1))),
        (DomainError, "beta: a tuple is a band", lambda: frame.curve(hz=(1, 2), beta=(0.1, 0.2))),
        (DomainError, "friction: a tuple is a band", lambda: frame.features(hz=(1, 2), friction=(0.1, 0.2), base=1e-3)),
        (DomainError, "accuracy", lambda: frame.curve(hz=(1, 2), beta=0.1, accuracy=0)),
        (DomainError, "step is 0.0", lambda: frame.curve(hz=(1, 2), beta=0.1, step=0)),
        (DomainError, "step is 1e-30", lambda: frame.curve(hz=(1, 2), beta=0.1, step=1e-30)),
        (DomainError, "no mass `roof`", lambda: frame.optimum("roof", **band)),
        (TypeError, "of: the name of a mass", lambda: frame.optimum(None, **band)),
        (TypeError, "of: the name of a mass", lambda: frame.optimum(["lower", "upper"], **band)),
        (DomainError, "no mass `roof`", lambda: frame.optimum({"lower": 1e-3, "accel(roof)": 1.0}, **band)),
        (DomainError, "of: the dict is empty", lambda: frame.optimum({}, **band)),
        (DomainError, 'of["lower"] is 0.0: the value', lambda: frame.optimum({"lower": 0}, **band)),
        (DomainError, 'of["lower"] is -0.001: the value', lambda: frame.optimum({"lower": -1e-3}, **band)),
        (DomainError, 'of["lower"] is NaN: the value', lambda: frame.optimum({"lower": math.nan}, **band)),
        (DomainError, 'of["lower"] is inf: the value', lambda: frame.optimum({"lower": math.inf}, **band)),
        (DomainError, "too small or too large", lambda: frame.optimum({"lower": 1e308}, **band)),
        (TypeError, 'of["lower"]: a number', lambda: frame.optimum({"lower": "5mm"}, **band)),
        (TypeError, "of: the names of quantities", lambda: frame.optimum({3: 5.0}, **band)),
        (DomainError, "damping ratio has no upper bound", lambda: frame.optimum({"zeta_eq": 0.1}, **band)),
        (
            DomainError,
            "vary needs a single quantity",
            lambda: frame.optimum({"lower": 1e-3}, **band, vary=("k lower - upper", 1e3, 2e3)),
        ),
        (DomainError, "keep needs a single quantity", lambda: frame.optimum({"lower": 1e-3}, **band, keep={"upper": 1.0})),
        (DomainError, "keep: the dict is empty", lambda: frame.optimum("lower", **band, keep={})),
        (DomainError, "no mass `roof`", lambda: frame.optimum("lower", **band, keep={"roof": 1.0})),
        (
            DomainError,
            'keep["upper"] is 0.0: the bound of a quantity must be above 0',
            lambda: frame.optimum("lower", **band, keep={"upper": 0}),
        ),
        (
            DomainError,
            'keep["lower"] is 1e-9: no friction holds this bound; the least value is',
            lambda: frame.optimum("upper", **band, keep={"lower": 1e-9}),
        ),
        (
            DomainError,
            "vary: ",
            lambda: frame.optimum("lower", **band, keep={"upper": 1.0}, vary=("k lower - upper", 2e3, 1e3)),
        ),
        (DomainError, "no mass `roof`", lambda: frame.sensitivities("roof", **point)),
        (DomainError, "samples is 3|must be even", lambda: frame.simulate(**point, samples=3)),
        (DomainError, "cycles is 0", lambda: frame.simulate(**point, cycles=0)),
        (DomainError, "skip is -1", lambda: frame.simulate(**point, skip=-1)),
        (DomainError, "the largest possible number", lambda: frame.simulate(**point, cycles=10**6, samples=10**4)),
        (DomainError, "2 numbers are needed, one for each mass", lambda: frame.simulate(**point, start=([1], [1, 2]))),
        (DomainError, "every number must be finite", lambda: frame.simulate(**point, start=([1, math.nan], [1, 2]))),
        (DomainError, "start: two rows are needed", lambda: frame.simulate(**point, start=[1, 2, 3])),
        (DomainError, "start: two rows are needed", lambda: frame.simulate(**point, start=3)),
        (DomainError, "leave out cycles and skip", lambda: frame.simulate(**point, steady=True, cycles=3)),
    ]:
        with pytest.raises(kind, match=said if "|" in said else re.escape(said)):
            ask()


def test_positional_arguments_are_refused(frame):
    """Checks that positional arguments are refused, because they do not say whether a number is r or Hz."""
    with pytest.raises(TypeError, match="positional"):
        frame.limits(2.5)


def test_the_compiled_part_refuses_what_the_classes_would_not_pass(frame):
    from frictiongen import _native

    for wrong in [None, 3, (1,), "text"]:
        with pytest.raises((TypeError, ValueError)):
            _native.limits(frame._native, wrong, (None, None), False, True)
        with pytest.raises(TypeError):
            _native.limits(wrong, (0.9, None, None), (None, None), False, True)

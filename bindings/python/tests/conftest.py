"""Scenes, comparisons and calls of the command that the tests have in common."""

import io
import json
import os
import subprocess
from pathlib import Path

import matplotlib
import matplotlib.pyplot
import numpy as np
import pytest

import frictiongen

matplotlib.use("Agg")

ROOT = Path(__file__).resolve().parents[3]
SCENES = ROOT / "crates" / "cli" / "scenes"
#: The recordings of docs/guide.md.
PAGES = ROOT / "docs" / "measure"


@pytest.fixture(autouse=True)
def close():
    """Closes the pictures of a test."""
    yield
    matplotlib.pyplot.close("all")


@pytest.fixture
def frame():
    return frictiongen.System(frictiongen.FRAME)


@pytest.fixture
def block():
    """Returns one mass of 2 kg on a spring of 50 N/m, which is under a force and rubs on the wall."""
    return frictiongen.System(
        """struct Block {
            masses: { block: 2.0 },
            springs: { base - block: 50.0 },
            contact: block - wall,
            excitation: block,
        }"""
    )


def numbers(texts):
    """Returns a column of texts as numbers, or unchanged if a text is no number.  Python reads the numbers, because
    it rounds to the nearest."""
    try:
        return texts.map(float, na_action="ignore").astype(float)
    except ValueError:
        return texts


def hold(ours, theirs, but=()):
    """Asserts that every column of `theirs` is in `ours`, in the same order, with the same bits."""
    names = [name for name in theirs.columns if name not in but]
    assert [name for name in ours.columns if name not in but] == names
    assert len(ours) == len(theirs)
    compared = 0
    for name in names:
        left, right = ours[name], theirs[name]
        if left.dtype.kind == "b":
            # The command leaves a cell without an answer empty.
            told = right.notna().to_numpy()
            assert [str(value).lower() for value in left[told]] == [str(value).lower() for value in right[told]], name
        elif left.dtype.kind in "fi":
            # Missing values are NaN on both sides.  0 == -0, but neither side has -0.
            np.testing.assert_array_equal(left.to_numpy(float, na_value=np.nan), right.to_numpy(float), err_msg=name)
        else:
            left, right = (column.astype(object).fillna("").tolist() for column in (left, right))
            assert left == right, name
        compared += len(left)
    return compared


@pytest.fixture(scope="session")
def output():
    """Runs the command `frictiongen` and returns what it prints."""
    program = os.environ.get("FRICTIONGEN")
    if program is None:
        pytest.skip("FRICTIONGEN does not say where the command is; scripts/python sets it")

    def run(what, scene, *options):
        arguments = [program, what, str(SCENES / scene), *map(str, options)]
        return subprocess.run(arguments, capture_output=True, text=True, check=True).stdout

    return run


@pytest.fixture(scope="session")
def command(output):
    """Runs the command `frictiongen` and reads its CSV without losing a bit."""
    import pandas

    def run(what, scene, *options):
        texts = pandas.read_csv(io.StringIO(output(what, scene, "--csv", *options)), dtype=str)
        return texts.apply(numbers)

    return run


@pytest.fixture(scope="session")
def command_json(output):
    """Runs the command `frictiongen` and reads the points of its JSON, whose numbers Python reads to the last bit."""
    return lambda what, scene, *options: json.loads(output(what, scene, "--json", *options))["points"]

"""Tests systems and answers as Python objects: copies, pickles, equality, changes, other processes, frames."""

import copy
import math
import os
import pickle
import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from conftest import SCENES

import frictiongen
from frictiongen import FRAME, DomainError, SceneError, System


def same(one, other):
    """Asserts that both systems have the same answer to the last bit."""
    asked = {"r": [0.4, 0.9, 1.7], "beta": [0.1, 0.5]}
    ours, theirs = one.response(**asked), other.response(**asked)
    for name in ours:
        np.testing.assert_array_equal(ours[name], theirs[name], err_msg=name)


@pytest.mark.parametrize("file", ["frame.friction", "base.friction", "storeys.friction"])
def test_pickles_and_copies_are_equal(file):
    system = System.from_file(SCENES / file)
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(system, protocol))
        assert again == system and hash(again) == hash(system) and again.text == system.text
    assert copy.copy(system) is system and copy.deepcopy([system])[0] is system


def test_equality_is_that_of_names_and_numbers(frame):
    shorter = re.sub(r"//.*", "", FRAME).replace("1190.0", "1190")
    assert System(shorter) == frame and hash(System(shorter)) == hash(frame)
    for old, new in [("1190.0", "1190.0000000000002"), ("upper - wall", "upper - base"), ("1.2", "1.25"), ("Frame", "Other")]:
        assert System(FRAME.replace(old, new)) != frame
    assert frame != FRAME and frame is not None and {frame: 1}[System(FRAME)] == 1


def test_a_pickled_change_keeps_every_bit(frame):
    changed = frame.replace(m={"upper": 0.1 + 0.2}, k={"upper - lower": 1e3 / 7}, zeta=[1 / 3, 0.02])
    again = pickle.loads(pickle.dumps(changed))
    assert again == changed and again.springs[1] == ("lower", "upper", 1e3 / 7)
    assert again.mass_values.tolist() == [3.27, 0.1 + 0.2]
    same(again, changed)


def test_replaced_numbers_are_those_of_a_new_description(frame):
    text = FRAME.replace("1190.0", "1100").replace("3.25", "3").replace("0.010, 0.012", "0.02, 0.02").replace("1.2,", "1.5,")
    changed = frame.replace(k={"lower - base": np.float32(1100)}, m={"upper": np.int64(3)}, zeta=np.array([0.02, 0.02]), stiction=1.5)
    assert changed == System(text)
    same(changed, System(text))
    assert frame == System(FRAME), "the old system stays as it was"


def test_factors_of_damping_and_stiffness_are_replaced():
    text = "struct B {{ masses: {{ a: 2 }}, springs: {{ base - a: 50 }}, contact: a - wall, stiffness: {}, excitation: a, damping: rayleigh({}, {}) }}"
    assert System(text.format(5e4, 0.4, 1e-5)).replace(stiffness=7e4, a=0.3, b=2e-5) == System(text.format(7e4, 0.3, 2e-5))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"k": {"base - upper": 1.0}}, "there is no number `k base - upper` in the description; the numbers are m lower"),
        ({"m": {"roof": 1.0}}, "there is no number `m roof`"),
        ({"m": {"upper": -1.0}}, "m upper: "),
        ({"m": {"upper": math.nan}}, "m upper: "),
        ({"a": 1.0}, "there is no number `a`"),
        ({"stiffness": 1.0}, "there is no number `stiffness`"),
        ({"stiction": 0.5}, "mu: "),
        ({"zeta": [0.1]}, "zeta: 2 ratios are needed, one for each mode, but these are 1"),
    ],
)
def test_numbers_that_cannot_be_replaced(frame, given, said):
    with pytest.raises(DomainError, match=re.escape(said)):
        frame.replace(**given)


def test_a_system_of_dicts():
    parts = {"masses": {"a": 2}, "springs": {"base - a": np.float64(50), "a-wall": 3}, "contact": "a - wall", "excitation": "a"}
    text = "struct Scene { masses: { a: 2 }, springs: { base - a: 50, a - wall: 3 }, contact: a - wall, excitation: a"
    for more, added in [
        ({}, ""),
        ({"damping": 0.01}, ", damping: modal(0.01)"),
        ({"damping": [0.01], "stiction": 1.2}, ", damping: modal[0.01], stiction: 1.2"),
        ({"damping": {"a": 0.4, "b": 1e-5}, "stiffness": 1e5}, ", damping: rayleigh(0.4, 1e-5), stiffness: 1e5"),
    ]:
        assert System.of(**parts, **more) == System(f"{text}{added} }}")
    based = System.of(**(parts | {"excitation": "base"}), damping=0.1, damping_from="base")
    assert based == System(f"{text.replace('excitation: a', 'excitation: base')}, damping: modal(0.1), damping_from: base }}")


@pytest.mark.parametrize(
    ("change", "error", "said"),
    [
        ({"masses": {"a": -2.0}}, SceneError, "must be"),
        ({"masses": {"a }, springs: {": 2.0}}, DomainError, "masses: 'a }, springs: {' is no name"),
        ({"masses": {"a": math.inf}}, DomainError, "masses['a'] is inf: a finite number is needed"),
        ({"masses": {"a": "2"}}, TypeError, "masses['a']: a number is needed, not str"),
        ({"masses": [2.0]}, TypeError, "masses: numbers by their names are needed"),
        ({"contact": ("a", "wall")}, TypeError, "contact: a name is needed, not tuple"),
        ({"contact": "b - wall"}, SceneError, "there is no mass `b`"),
        ({"damping": {"a": 1.0}}, DomainError, "damping: give both factors"),
        ({"damping": "modal(0.1)"}, TypeError, "damping: a ratio, a list of ratios or the factors"),
    ],
)
def test_dicts_that_are_no_system(change, error, said):
    parts = {"masses": {"a": 2.0}, "springs": {"base - a": 50.0}, "contact": "a - wall", "excitation": "a"}
    with pytest.raises(error, match=re.escape(said)):
        System.of(**(parts | change))


def peak(system):
    """Returns the largest amplitude of the lower floor over three frequencies.  Other processes call this."""
    return float(system.response(r=[0.5, 0.9, 1.4], beta=0.3).masses["lower"].amplitude.max())


def test_other_processes_have_the_same_answers(frame):
    joblib = pytest.importorskip("joblib")
    systems = [frame.replace(k={"base - lower": float(k)}) for k in range(1000, 1400, 50)]
    found = joblib.Parallel(n_jobs=2, backend="loky")(joblib.delayed(peak)(system) for system in systems)
    assert found == [peak(system) for system in systems] and len(set(found)) == len(found)


def test_the_study_has_the_same_peaks_in_another_process():
    distributed = pytest.importorskip("distributed")
    path = Path(__file__).resolve().parents[1] / "study" / "cluster.py"
    study = runpy.run_path(str(path))
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster, distributed.Client(cluster) as client:
        process, found = client.submit(lambda: (os.getpid(), runpy.run_path(str(path))["peaks"](3, 4))).result()
    assert process != os.getpid() and found == study["peaks"](3, 4) and len(set(found)) == 4


def test_masses_of_an_answer_are_by_name(frame):
    answer = frame.response(hz=[1.0, 2.0], friction=0.4, base=0.001)
    assert list(answer.masses) == frame.masses
    assert answer.masses["upper"].amplitude_m is answer["upper"].amplitude_m
    assert answer.contact.phase_deg is answer["contact"].phase_deg
    run = frame.simulate(hz=1.2, friction=0.4, base=0.001, cycles=2)
    assert run.masses["lower"].displacement_m is run["lower"].displacement_m


def test_frames_have_nullable_counts():
    pandas = pytest.importorskip("pandas")
    # An undamped mass on its resonance: nothing bounds the motion at a friction that is too small.
    block = System.of({"block": 2.0}, {"base - block": 50.0}, "block - wall", "block")
    frame = block.map(r=[0.5, 1.0], beta=[0.1, 0.9]).to_frame()
    assert str(frame.stops.dtype) == "Int64" and frame.stops.isna().tolist() == [False, False, True, False]
    assert frame.stops[0] is not pandas.NA and frame.stops.sum() >= 0


def test_datasets_have_dimensions_and_units(frame):
    pytest.importorskip("xarray")
    found = frame.map(hz=[1.0, 2.0, 3.0], friction=[0.4, 0.6], base=0.001)
    data = found.to_xarray()
    assert dict(data.sizes) == {"frequency": 3, "friction": 2}
    np.testing.assert_array_equal(data["lower.amplitude_m"], found["lower"].amplitude_m)
    assert data["continuous_limit_N"].dims == ("frequency",) and data["stops"].dims == ("frequency", "friction")
    assert {name: data[name].attrs.get("units") for name in ("frequency_Hz", "r", "friction_N", "lower.amplitude_m")} == {
        "frequency_Hz": "Hz",
        "r": None,
        "friction_N": "N",
        "lower.amplitude_m": "m",
    }
    single = frame.response(r=0.9, beta=[0.1, 0.2]).to_xarray()
    assert dict(single.sizes) == {"friction": 2} and single["r"].dims == ()


def test_notebooks_show_tables(frame):
    shown = frame._repr_html_()
    assert "<th>lower</th><td>3.27 kg</td>" in shown and "1.907, 5.113 Hz" in shown
    assert "<table" in frame.limits(r=[0.5, 0.9])._repr_html_()


def test_the_version_is_the_packages():
    assert re.fullmatch(r"\d+\.\d+\.\d+", frictiongen.__version__)

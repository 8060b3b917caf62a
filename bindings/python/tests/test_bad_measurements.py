"""Tests that measurements that cannot be read or evaluated give a clear error at the wrong item."""

import math
import re

import numpy as np
import pytest
from conftest import PAGES

import frictiongen
from frictiongen import DomainError, MeasureError, Observation, Recording, System

T = np.arange(5000) / 500
BASE = 1.75 * np.cos(25 * T)
PLATE = 3.5 * np.cos(25 * T - 0.3)
GOOD = {"base": (BASE, "mm"), "plate": (PLATE, "mm")}


@pytest.fixture(scope="module")
def plate():
    return System.from_file(PAGES / "plate.friction")


def changed(samples, place, value):
    samples = samples.copy()
    samples[place] = value
    return samples


REFUSED = [
    ({"base": BASE}, {}, "the channel `base` has no unit: give one"),
    ({"base": (BASE, "inch")}, {}, "the channel `base`: `inch` is not a known unit; the units are m, cm, mm"),
    ({"base": (BASE, "")}, {}, "`` is not a known unit"),
    ({"base": (BASE, "s")}, {}, "the channel `base` is in s, but"),
    ({"base": (1.0, "mm")}, {}, "the channel `base`: a row of samples is needed, not one number"),
    ({"base": (np.ones((3, 3)), "mm")}, {}, "the channel `base`: one number or a row of numbers is needed, but this has the shape (3, 3)"),
    ({"base": (changed(BASE, 777, math.nan), "mm")}, {}, "sample 777 of `base` is not a finite number"),
    ({"base": (changed(BASE, 7, math.inf), "mm")}, {}, "sample 7 of `base` is not a finite number"),
    ({"base": (np.full(5000, 0.7), "mm")}, {}, "the channel `base` never changes"),
    ({"base": (BASE, "mm"), "plate": (np.clip(PLATE, -3, 3), "mm")}, {}, "the channel `plate` is clipped at 3"),
    ({"base": (BASE, "mm"), "plate": (PLATE[:-1], "mm")}, {}, "the channel `plate` does not have the same number of samples as the others"),
    ({"base": (BASE[:3], "mm")}, {}, "the recording is too short: 3 samples, but 16 are needed"),
    ({"base": ([], "mm")}, {}, "the recording is too short: no samples"),
    ({}, {}, "the recording is too short: it has no channel"),
    (GOOD, {"rate": None}, "the sampling rate is unknown: give rate"),
    (GOOD, {"rate": 0.0}, "rate is 0.0: the number of samples a second must be above 0 and finite"),
    (GOOD, {"rate": math.nan}, "rate is NaN"),
    (GOOD, {"rate": [500.0]}, "rate: one number is needed"),
    (GOOD, {"time_s": T}, "give either rate or time_s, not both"),
    (GOOD, {"rate": None, "time_s": T[:-1]}, "time_s: 4999 times are given, but `base` has 5000 samples"),
    (GOOD, {"rate": None, "time_s": changed(T, slice(2500, None), 2 * T[2500:])}, "time_s: the samples are not evenly spaced"),
    (GOOD, {"rate": None, "time_s": changed(T, 9, math.nan)}, "time_s: the samples are not evenly spaced"),
    (GOOD, {"rate": None, "time_s": T[::-1].copy()}, "time_s: the samples are not evenly spaced"),
]


@pytest.mark.parametrize(("channels", "options", "said"), REFUSED)
def test_arrays_that_are_no_recording(channels, options, said):
    with pytest.raises(DomainError, match=re.escape(said)):
        Recording(channels, **({"rate": 500} | options))


def test_what_is_of_the_wrong_type(plate):
    good = Recording(GOOD, rate=500)
    for wrong in [None, 3, "base", [("base", BASE)], {3: (BASE, "mm")}, {"base": ("1,2,3", "mm")}, {"base": (None, "mm")},
                  {"base": (BASE > 0, "mm")}, {"base": (BASE + 0j, "mm")}]:  # fmt: skip
        with pytest.raises(TypeError):
            Recording(wrong, rate=500)
    for options in [{"rate": "500"}, {"rate": True}, {"time_s": "0,1"}]:
        with pytest.raises(TypeError):
            Recording(GOOD, **options)
    for wrong in [None, 3, "above.csv", [good, "above.csv"], {"base": BASE}]:
        for ask in (plate.transmissibility, plate.identify, plate.free_decay, plate.drive):
            if ask == plate.drive and wrong == "above.csv":
                continue
            with pytest.raises(TypeError, match="is needed"):
                ask(wrong)
    with pytest.raises(DomainError, match="inputs need until="):
        plate.drive("step 1 mm", friction=1.0)
    with pytest.raises(DomainError, match="`leap` is no shape"):
        plate.drive("leap 1 mm", friction=1.0, until=1.0)
    with pytest.raises(ValueError, match="belong to inputs"):
        plate.drive(good, friction=1.0, until=1.0)
    with pytest.raises(DomainError, match="inputs= needs until="):
        plate.simulate(inputs="step 1 mm", friction=1.0, hz=1.0, base=1e-3)
    with pytest.raises(TypeError, match="a Recording is needed, not Observation"):
        plate.transmissibility([Observation(hz=1.0, base=1.0)])
    for ask in (plate.transmissibility, plate.identify):
        with pytest.raises(DomainError, match="at least one"):
            ask([])
    for options in [{"by": 3}, {"also": 3}, {"also": [3]}, {"between": "0:1"}, {"of": 3}, {"harmonics": 3.0}]:
        with pytest.raises(TypeError):
            plate.identify(good, **options)
    for wrong in [{"amplitude_m": [1.0]}, {"amplitude_m": {3: 1.0}}, {"phase_deg": "30"}]:
        with pytest.raises(TypeError, match="numbers by the names of masses are needed"):
            Observation(hz=1.0, base=1.0, **wrong)
    for wrong in [{"hz": 1.0, "transmissibility": [1.0]}, {"hz": "1", "transmissibility": {"plate": [1.0]}}]:
        with pytest.raises(TypeError):
            plate.fit(**wrong)
    with pytest.raises(KeyError, match="there is no channel 'roof'; there are base, plate"):
        good["roof"]


def test_files_that_are_no_recording(plate, tmp_path):
    path = tmp_path / "recording.csv"

    def wrong(text, said, line, **options):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(MeasureError, match=re.escape(said)) as raised:
            Recording.from_file(path, **options)
        assert str(raised.value).startswith(f"{path}: ") and raised.value.line == line
        # Without a file the message has no prefix.
        with pytest.raises(MeasureError) as raised:
            Recording.from_text(text, **options)
        assert not str(raised.value).startswith(str(path))

    wrong("", "the file is empty", 1)
    wrong("0,1,2\n", 'the columns have no names; write names in the first line, or give the column and the unit of each channel', 1)
    wrong("time_s,base_mm\n0,1\n0.1,x\n", "line 3: `x` of `base_mm` is not a finite number", 3)
    wrong("time_s,base_mm\n0,1\n0.1,inf\n", "line 3: `inf` of `base_mm`", 3)
    wrong("time_s,base_mm\n0,1\n0.1\n", "line 3: it has 1 cells, but there are 2 names", 3)
    wrong("time_s,base\n0,1\n", "the channel `base` has no unit: give one", None)
    wrong("base_mm,plate_mm\n1,2\n", "the sampling rate is unknown: give rate", None)
    wrong("time_s,base_mm\n0,1\n0.1,2\n0.3,3\n", "not evenly spaced", None)
    wrong("-1\n58\nx\n", "the file ends within a data set", 4)
    wrong("-1\n58b\nx\n", "data set 58 is binary", 2)
    wrong("t_s,A\n0,1\n", "there is no column `B`; the columns are t_s, A", 1, channels={"base": ("B", "mm")})
    for options, kind in [
        ({"channels": {"base": ("A", "inch")}}, DomainError), ({"channels": ["A"]}, TypeError), ({"channels": {"base": 1.5}}, TypeError),
        ({"channels": {"base": True}}, TypeError), ({"rate": -1}, DomainError), ({"rate": "1"}, TypeError),
    ]:  # fmt: skip
        with pytest.raises(kind):
            Recording.from_file(path, **options)
    for text in (None, b"time_s", 3):
        with pytest.raises(TypeError, match="a text is needed"):
            Recording.from_text(text)
    for read in (Recording.from_file, plate.fit):
        with path.open(encoding="utf-8") as file:
            pass
        with pytest.raises(ValueError, match="closed file"):
            read(file)
        with path.open("rb") as file, pytest.raises(TypeError, match="open it as text"):
            read(file)
        with pytest.raises(FileNotFoundError):
            read(tmp_path / "none.csv")
        with pytest.raises(TypeError, match="a path or an open file is needed"):
            read(3)
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(UnicodeDecodeError):
        Recording.from_file(path)


def test_recordings_that_do_not_fit_the_scene(plate, frame):
    def told(channels, said, ask=plate.transmissibility):
        recording = Recording(channels, rate=500)
        with pytest.raises(MeasureError, match=re.escape(said)) as raised:
            ask(recording)
        assert raised.value.line is None
        with pytest.raises(MeasureError, match="^recording 2: "):
            plate.transmissibility([Recording(GOOD, rate=500), recording])

    told({"base": (BASE, "mm"), "plat": (PLATE, "mm")}, "`plat` does not belong to this scene, which has base, plate")
    told({"base": (BASE, "mm"), "plate": (PLATE, "N")}, "the channel `plate` is in N, but here it must be a motion")
    told({"base": (BASE, "N"), "plate": (PLATE, "mm")}, "the channel `base` is in N, but here it must be a motion")
    told({"base": (BASE, "mm")}, "no motion of a mass was recorded")
    told({"plate": (PLATE, "mm")}, "a channel `base` is needed")
    told({"base": (BASE[:200], "mm"), "plate": (PLATE[:200], "mm")}, "too short")
    drifting = 1.75 * np.cos(25 * T + 0.3 * T**2)
    told({"base": (drifting, "mm"), "plate": (PLATE, "mm")}, "the frequency of the excitation drifts")
    told({"base": (BASE, "mm"), "plate": (PLATE * (1 + 0.05 * T), "mm")}, "`plate` goes on changing")


def test_what_no_friction_explains(plate):
    truth = plate.response(hz=3.9, friction=0.5, base=1.75e-3, harmonics=1)["plate"]["X1"]
    seen = {"hz": 3.9, "base": 1.75e-3, "deviation_m": 1e-6, "phase_deviation_deg": 0.1}
    amplitude, phase = float(truth.amplitude_m), float(truth.phase_deg)
    for told, said in [
        ({"amplitude_m": {"plate": 1e3 * amplitude}, "phase_deg": {"plate": phase}}, "a unit is wrong by this factor"),
        ({"amplitude_m": {"plate": 30 * amplitude}, "phase_deg": {"plate": phase}}, "no friction explains the motion of `plate`"),
        ({"phase_deg": {"plate": -phase}}, "no friction explains the phase of `plate`"),
    ]:
        with pytest.raises(MeasureError, match=said):
            plate.identify(Observation(**seen, **told))
    motion = {"amplitude_m": {"plate": amplitude}, "phase_deg": {"plate": phase}}
    with pytest.raises(MeasureError, match="2 measured numbers are too few to find 3 unknowns"):
        plate.identify(Observation(**seen, **motion), also=["damping", "frequency"])


TOLD = {"hz": 3.9, "base": 1.75e-3, "amplitude_m": {"plate": 2e-3}, "deviation_m": 1e-6}

UNTOLD = [
    ({"hz": -1.0}, {}, "hz is -1.0: a finite number above 0 is needed"),
    ({"hz": [3.9, math.nan], "amplitude_m": {"plate": 2e-3}}, {}, "hz[1] is NaN"),
    ({"base": None}, {}, "the base moves: give base"),
    ({"base": 0.0}, {}, "base is 0.0: a finite number above 0 is needed"),
    ({"base": None, "force": 1.0}, {}, "the base moves: give base"),
    ({"base": [1e-3, 1e-3]}, {}, "base: 1 numbers are needed, one for each frequency, but these are 2"),
    ({"amplitude_m": None}, {}, "no motion is given"),
    ({"amplitude_m": {"roof": 1.0}}, {}, "there is no mass `roof`"),
    ({"amplitude_m": {"contact": 1.0}}, {}, "that of a mass"),
    ({"amplitude_m": {"plate": [1.0, 2.0]}}, {}, 'amplitude_m["plate"]: 1 numbers are needed'),
    ({"amplitude_m": {"plate": math.nan}}, {}, 'amplitude_m["plate"] is NaN'),
    ({"amplitude_m": {"plate": -1.0}}, {}, 'amplitude_m["plate"] is -1.0'),
    ({"phase_deg": {"plate": math.inf}}, {}, 'phase_deg["plate"] is inf: a finite number is needed'),
    ({"deviation_m": None}, {}, "deviation_m: the standard deviation"),
    ({"deviation_m": 0.0}, {}, 'deviation_m["plate"] is 0.0'),
    ({"amplitude_m": None, "phase_deg": {"plate": 30.0}}, {}, "phase_deviation_deg: the standard deviation"),
    ({"load_deviation": -1.0}, {}, "load_deviation is -1.0"),
    ({}, {"by": "phase"}, "by is \"phase\", but some motion has no phase"),
    ({}, {"by": "both"}, "by is \"both\", but some motion has no phase"),
    ({}, {"by": "size"}, "by is \"size\": both, amplitude or phase is needed"),
    ({}, {"also": "mass"}, 'also: "mass" cannot be fitted'),
    ({}, {"between": (1.0,)}, "between: two friction forces"),
    ({}, {"between": (2.0, 1.0)}, "the range of friction forces must begin"),
    ({}, {"between": (0.0, math.nan)}, "the range of friction forces must begin"),
    ({}, {"of": "roof"}, "of: there is no mass `roof`"),
    ({}, {"of": "contact"}, "of: a measured motion must be that of a mass"),
    ({}, {"harmonics": 0}, "harmonics is 0"),
]


@pytest.mark.parametrize(("told", "asked", "said"), UNTOLD)
def test_observations_that_are_none(plate, told, asked, said):
    with pytest.raises(DomainError, match=re.escape(said)):
        plate.identify(Observation(**(TOLD | told)), **asked)


def test_masses_that_know_different_things(frame):
    seen = {"hz": 2.0, "base": 1e-3, "deviation_m": 1e-6, "phase_deviation_deg": 0.1}
    with pytest.raises(DomainError, match="give the same quantities for each mass"):
        frame.identify(Observation(**seen, amplitude_m={"lower": 1e-3}, phase_deg={"upper": 30.0}))
    one, other = Observation(**seen, amplitude_m={"lower": 1e-3}), Observation(**seen, phase_deg={"upper": 30.0})
    with pytest.raises(DomainError, match="no quantity can be compared for all"):
        frame.identify([one, other])


def test_sweeps_that_are_none(plate, frame, block, tmp_path):
    good = {"hz": [1.0, 2.0, 4.0], "transmissibility": {"plate": [1.1, 1.7, 1.5]}}
    for asked, said in [
        ({"transmissibility": None}, "a sweep is needed, or hz and transmissibility"),
        ({"hz": [1.0, 2.0]}, 'transmissibility["plate"]: 2 numbers are needed'),
        ({"hz": [1.0, 0.0, 4.0]}, "hz[1] is 0.0: frequencies, transmissibilities and deviations must be above 0"),
        ({"hz": [1.0, math.nan, 4.0]}, "hz[1] is NaN"),
        ({"transmissibility": {"plate": [1.1, math.nan, 1.5]}}, 'transmissibility["plate"][1] is NaN'),
        ({"transmissibility": {"roof": [1.1, 1.7, 1.5]}}, "there is no mass `roof`"),
        ({"transmissibility": {"contact": [1.1, 1.7, 1.5]}}, "masses only"),
        ({"deviation": {"plate": [0.1, 0.0, 0.1]}}, 'deviation["plate"][1] is 0.0'),
        ({"deviation": {"roof": [0.1, 0.1, 0.1]}}, "deviation: there is no transmissibility of 'roof'"),
        ({"sweep": tmp_path / "none.csv"}, "give either sweep, or hz and transmissibility"),
    ]:
        with pytest.raises(DomainError, match=re.escape(said)):
            plate.fit(**(good | asked))
    with pytest.raises(MeasureError, match="1 measured numbers are too few to find 3 unknowns"):
        frame.fit(hz=[1.0], transmissibility={"lower": [1.1]})
    with pytest.raises(MeasureError, match="driven by its base"):
        block.fit(hz=[1.0, 2.0], transmissibility={"block": [1.1, 1.2]})
    path = tmp_path / "sweep.csv"
    for text, said, line in [
        ("hz,a\n1,2\n", "there is no column `frequency_Hz`", 1),
        ("frequency_Hz,a\n1,2\n", "there is no column `NAME.transmissibility`", 1),
        ("frequency_Hz,plate.transmissibility\n1,-2\n", "line 2: frequencies, transmissibilities and deviations must be above 0", 2),
        ("frequency_Hz,roof.transmissibility\n1,2\n", "`roof` does not belong to this scene", None),
    ]:
        path.write_text(text, encoding="utf-8")
        with pytest.raises(MeasureError, match=re.escape(said)) as raised:
            plate.fit(path)
        assert raised.value.line == line and str(raised.value).startswith(f"{path}: ")


def test_free_vibrations_that_are_none(plate, frame):
    decay = Recording.from_file(PAGES / "decay.csv")
    for asked, said in [
        ({"damping": -0.1}, "damping is -0.1"), ({"damping": math.nan}, "damping is NaN"), ({"damping": 1.0}, "damping is 1.0"),
        ({"damping": 0.1, "find_damping": True}, "give either damping or find_damping"),
    ]:  # fmt: skip
        with pytest.raises(DomainError, match=re.escape(said)):
            plate.free_decay(decay, **asked)
    with pytest.raises(MeasureError, match="a scene with one mass"):
        frame.free_decay(decay)
    with pytest.raises(MeasureError, match="peaks of the free vibration do not fall"):
        plate.free_decay(Recording(GOOD, rate=500))
    with pytest.raises(MeasureError, match="`plate` is in m/s, but here it must be a displacement"):
        plate.free_decay(Recording({"plate": (PLATE, "m/s")}, rate=500))
    with pytest.raises(MeasureError, match="no motion of a mass was recorded"):
        plate.free_decay(Recording({"base": (BASE, "mm")}, rate=500))


def test_a_measurement_error_is_a_domain_error():
    assert issubclass(MeasureError, DomainError) and issubclass(MeasureError, ValueError)
    assert frictiongen.MeasureError is MeasureError

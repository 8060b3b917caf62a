"""Exact vibration of mass-spring chains with Coulomb friction contacts.

A :class:`System` reads a scene description. Its methods take and return numpy arrays.

>>> import frictiongen
>>> frame = frictiongen.System(frictiongen.FRAME)
>>> response = frame.response(hz=2.5, friction=[0.1, 0.6, 1.0], base=0.001)
>>> response.regime.tolist()
['continuous', 'stick-slip', 'stuck']
>>> (1e3 * response["lower"].amplitude_m).round(3).tolist()  # mm
[0.714, 0.539, 0.697]

Give frequencies as `r`, `hz` or `omega`, friction as `beta` or as `friction` in N, and the load as `force` in N or
`base` in m.  With a load, answers are in N, m and degrees, and the names of their attributes end in `_N`, `_m` and
`_deg`.  Without a load, answers are non-dimensional: forces over P (over k1 Y for base motion), displacements over P/k1
(over Y), phases in rad.
"""

from importlib.metadata import version as _version

from ._answers import (
    Branches,
    ByContact,
    Curve,
    Cycle,
    Driven,
    Estimate,
    Events,
    Features,
    FeatureTable,
    Fit,
    FreeDecay,
    History,
    Identification,
    LimitCycles,
    Limits,
    Map,
    Motion,
    MotionFit,
    Optimum,
    Orbit,
    Peaks,
    Periodic,
    Response,
    ResponseSpectrum,
    Sensitivities,
    Steps,
    Table,
    Transmissibilities,
    Work,
)
from ._native import DomainError, MeasureError, SceneError
from ._observation import Observation
from ._recording import Recording
from ._system import FRAME, Mistake, System

#: Version of the package.
__version__: str = _version("frictiongen")

__all__ = [
    "FRAME",
    "Branches",
    "ByContact",
    "Curve",
    "Cycle",
    "DomainError",
    "Driven",
    "Estimate",
    "Events",
    "FeatureTable",
    "Features",
    "Fit",
    "FreeDecay",
    "History",
    "Identification",
    "LimitCycles",
    "Limits",
    "Map",
    "MeasureError",
    "Mistake",
    "Motion",
    "MotionFit",
    "Observation",
    "Optimum",
    "Orbit",
    "Peaks",
    "Periodic",
    "Recording",
    "Response",
    "ResponseSpectrum",
    "SceneError",
    "Sensitivities",
    "Steps",
    "System",
    "Table",
    "Transmissibilities",
    "Work",
]

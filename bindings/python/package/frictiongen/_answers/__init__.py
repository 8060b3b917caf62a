"""The answers of a system: numpy arrays with the names of the command line's columns."""

from .branches import Branches, LimitCycles
from .design import Optimum, Sensitivities
from .features import Features, FeatureTable
from .in_time import Driven, Events, History, Peaks, ResponseSpectrum, Steps, Work
from .measuring import Estimate, Fit, FreeDecay, Identification, MotionFit, Transmissibilities
from .steady import ByContact, Curve, Cycle, Limits, Map, Orbit, Periodic, Response
from .table import Columns, Motion, Table

__all__ = [
    "Branches",
    "ByContact",
    "Columns",
    "Curve",
    "Cycle",
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
    "Motion",
    "MotionFit",
    "Optimum",
    "Orbit",
    "Peaks",
    "Periodic",
    "Response",
    "ResponseSpectrum",
    "Sensitivities",
    "Steps",
    "Table",
    "Transmissibilities",
    "Work",
]

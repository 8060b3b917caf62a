"""The answers of a system: numpy arrays with the names of the command line's columns."""

from .design import Optimum, Sensitivities
from .features import Features, FeatureTable
from .in_time import Events, History, Steps, Work
from .measuring import Estimate, Fit, FreeDecay, Identification, Transmissibilities
from .steady import ByContact, Curve, Cycle, Limits, Map, Orbit, Periodic, Response
from .table import Columns, Motion, Table

__all__ = [
    "ByContact",
    "Columns",
    "Curve",
    "Cycle",
    "Estimate",
    "Events",
    "FeatureTable",
    "Features",
    "Fit",
    "FreeDecay",
    "History",
    "Identification",
    "Limits",
    "Map",
    "Motion",
    "Optimum",
    "Orbit",
    "Periodic",
    "Response",
    "Sensitivities",
    "Steps",
    "Table",
    "Transmissibilities",
    "Work",
]

"""Features of a response."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _plot
from .table import Columns, Floats, Table, joined

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame

_Moved = dict[str, list[tuple[str, Floats, Floats]]]


class FeatureTable(Table):
    """One list of features, with the derivatives of its numbers with respect to every parameter.

    >>> import frictiongen
    >>> frame = frictiongen.System(frictiongen.FRAME)
    >>> held = frame.features(base=0.001).held_resonances
    >>> held.sensed
    ['frequency_Hz']
    >>> held.relative("frequency_Hz")["k lower - upper"].round(3).tolist()  # per cent for one per cent
    [0.263]
    """

    def __init__(self, columns: dict[str, Any], moved: _Moved) -> None:
        super().__init__(columns)
        self._moved = moved

    @property
    def sensed(self) -> list[str]:
        """Names of the columns that have derivatives."""
        return list(self._moved)

    def derivatives(self, name: str) -> Columns:
        """Returns the derivatives of a column, by the name of each parameter.

        Each array has one derivative for each line, NaN where there is none.
        """
        return Columns(name, {parameter: slope for parameter, slope, _ in self._found(name)})

    def relative(self, name: str) -> Columns:
        """Returns the change of a column in per cent for one per cent of each parameter, by the parameter's name."""
        return Columns(name, {parameter: share for parameter, _, share in self._found(name)})

    def _found(self, name: str) -> list[tuple[str, Floats, Floats]]:
        try:
            return self._moved[name]
        except KeyError:
            known = ", ".join(self._moved) or "nothing"
            raise KeyError(f"there are no derivatives of {name!r}; there are of {known}") from None


class Features:
    """Lists of features, each a :class:`FeatureTable`.

    With a load numbers are in Hz, N and m, otherwise non-dimensional.

    Lists that do not depend on friction:

    * `resonances`, with the `threshold` below which an undamped resonance is unbounded, and the limit of continuous
      motion.
    * `held_resonances`: resonances of the chain with its contact stuck.  `new` marks those that the chain does not
      have.
    * `ends`: both limits for r -> 0 and r -> inf.
    * `antiresonances`, `invariant_points`, and `inversions` (ranges in which friction enlarges a motion).  They are
      empty with damping.

    Lists for each friction:

    * `starts`: the amplitudes for r -> 0.
    * `sliding_ranges`: the ranges in which the contact slides.
    * `regimes`.  `found` tells whether all were found or only those that samples show.
    * `peaks`, with their estimates.
    * `crossings`: the frequencies at which two neighbouring frictions give the same amplitude.

    A scene with several contacts, dashpots or free masses has one list instead, `lines`: the damped resonances with each
    set of stuck contacts, antiresonances, and the friction from which no contact slides.
    """

    resonances: FeatureTable
    held_resonances: FeatureTable
    ends: FeatureTable
    antiresonances: FeatureTable
    invariant_points: FeatureTable
    inversions: FeatureTable
    starts: FeatureTable
    sliding_ranges: FeatureTable
    regimes: FeatureTable
    peaks: FeatureTable
    crossings: FeatureTable
    lines: FeatureTable

    def __init__(self, tables: dict[str, tuple[dict[str, Any], _Moved]]) -> None:
        self._tables = {name: FeatureTable(*table) for name, table in tables.items()}
        self.__dict__.update(self._tables)

    def keys(self) -> list[str]:
        """Returns the names of the lists."""
        return list(self._tables)

    def __getitem__(self, name: str) -> FeatureTable:
        return self._tables[name]

    def __eq__(self, other: object) -> bool:
        """Returns whether all lists are equal."""
        return self._tables == other._tables if isinstance(other, Features) else NotImplemented

    __hash__ = None  # type: ignore[assignment]

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables)

    def __repr__(self) -> str:
        counts = (f"{np.size(next(iter(table._columns.values())))} {name}" for name, table in self._tables.items())
        return f"Features: {', '.join(counts)}"

    def to_frame(self) -> DataFrame:
        """Returns all lists in one pandas frame, with the name of its list in each line.

        :raises ImportError: if pandas is not installed.
        """
        if "lines" in self._tables:
            return self.lines.to_frame()
        return joined({name: table._columns for name, table in self._tables.items()}, "feature")

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws regimes, resonances and invariant points over frequency and friction.

        :raises ImportError: if matplotlib is not installed.
        :raises ValueError: for a scene with several contacts, dashpots or free masses.
        """
        if "lines" in self._tables:
            raise ValueError("a picture of features needs a single contact without dashpots; plot a map or a curve")
        return _plot.features(self, ax)

"""Answers along a parameter, and limit cycles."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _plot
from .table import Counts, Floats, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Branches(Table):
    """Steady states, stable or not, along a parameter, one line for each point of each branch.

    * `branch`: index of the branch.  `value`: value of the parameter, in `unit`.
    * `state`: stable, marginal or unstable.  `symmetry`: symmetric or asymmetric.
    * `event`: bifurcations and other events at the point, such as fold, period doubling or symmetry breaking.
    * `period` in cycles of the excitation.  `largest_multiplier`: modulus of the largest Floquet multiplier.
    * `answer[name]` of a contact or of a mass, as in :class:`ByContact`.

    `ends` has a line for each branch: its number of `points`, the reason for its `end`, and its `parent`, which is the
    branch on which it begins, or -1.
    """

    branch: Counts
    value: Floats
    r: Floats
    frequency_Hz: Floats
    omega_rad_s: Floats
    beta: Floats
    friction_N: Floats
    state: Words
    event: Words
    symmetry: Words
    period: Counts
    largest_multiplier: Floats
    #: Points, end and parent of each branch.
    ends: Table
    #: Symbol of the parameter.
    along: str
    #: Unit of the parameter.  It is empty for a ratio.
    unit: str

    def __init__(self, columns: dict[str, Any], ends: dict[str, Any], parameter: tuple[str, str]) -> None:
        super().__init__(columns)
        self.ends = Table(ends)
        self.along, self.unit = parameter

    def plot(self, ax: Axes | None = None, of: str | None = None) -> Axes:
        """Draws the amplitude of one motion over the parameter: stable states solid, others dashed, events as dots.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.branches(self, ax, of)


class LimitCycles(Table):
    """Periodic motions that a moving surface keeps up without a load, one line for each friction with a cycle.

    * `period_s` and `frequency_hz` of the cycle.  `regime`: continuous, stick-slip or stuck.
    * `cycles[name]` of a contact or of a mass, as in :class:`ByContact`.
    * `without`: the frictions in N without a cycle: the motion comes to rest, slides steadily or does not repeat.
    """

    friction_N: Floats
    beta: Floats
    period_s: Floats
    frequency_hz: Floats
    regime: Words
    #: Frictions without a cycle, N.
    without: list[float]

    def __init__(self, columns: dict[str, Any], without: list[float]) -> None:
        super().__init__(columns)
        self.without = without

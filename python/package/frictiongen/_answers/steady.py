"""Answers over frequency and friction."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import _plot
from .table import Counts, Flags, Floats, Grid, Table, Words, frame

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame


class Limits(Table):
    """Both limits over frequency; a limit may be infinite.

    With less friction than `continuous_limit` the contact can slide all the time; from `sliding_limit` on it can be stuck.
    With stiction 1 it is, and below both limits it slides all the time; above 1 it depends on the start.  As ratios, F/P, for base motion F/(k1 Y); with a load also `continuous_limit_N` and
    `sliding_limit_N`, in N.
    """

    r: Floats
    frequency_Hz: Floats
    omega_rad_s: Floats
    continuous_limit: Floats
    sliding_limit: Floats
    continuous_limit_N: Floats
    sliding_limit_N: Floats
    continuous_limit_without_search: Floats
    continuous_limit_per_mode: Floats

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws both limits over frequency, in N if a load was given.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.limits(self, ax)


class Response(Grid):
    """Amplitudes and phases over frequency and friction.

    `regime` is continuous, stick-slip, stuck or unbounded; `margin` how far friction is beyond the lower limit, less 1;
    `answer` how the motion was found, or why there is none, and then amplitudes are NaN.  `response[name]` is the
    :class:`Motion` of a mass, or of the `contact`: `amplitude` (`amplitude_m`), the largest displacement; `phase`
    (`phase_deg`), by how much its maximum lags behind the load's, NaN for what does not move; `amplitude_monoharmonic`, the
    estimate from the fundamental alone.  `centred` is the amplitude about the motion's own middle, `fundamental_phase` the lag
    of X1, `offset` (`offset_m`) the middle of the contact's motion.  `marginal` marks one of a continuum of states,
    `from_rest` the state that motion from rest ends in.
    """

    regime: Words
    margin: Floats
    answer: Words
    offset: Floats
    offset_m: Floats
    marginal: Flags
    from_rest: Flags

    def plot(self, ax: Axes | None = None, of: str | None = None) -> Axes:
        """Draws the amplitude of one motion over frequency, a line for each friction.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.response(self, ax, of)


class Map(Grid):
    """What the contact does over frequency and friction.

    `regime` and `region` (how many stops); `period` in cycles, `stops` and `reversals` in a period, -1 where nothing
    repeats or there is no answer; `stuck_fraction` of the period; `map[name].amplitude` (`amplitude_m`).  Along frequency
    alone: `continuous_limit` and `sliding_limit`, with a load in N as `continuous_limit_N` and `sliding_limit_N`.
    """

    regime: Words
    region: Words
    period: Counts
    stops: Counts
    reversals: Counts
    stuck_fraction: Floats
    offset: Floats
    offset_m: Floats
    marginal: Flags
    from_rest: Flags
    continuous_limit: Floats
    continuous_limit_N: Floats
    sliding_limit: Floats
    sliding_limit_N: Floats

    _beside = ("continuous_limit", "continuous_limit_N", "sliding_limit", "sliding_limit_N")

    def plot(self, ax: Axes | None = None, shade: str = "region") -> Axes:
        """Draws the map with both limits.  `shade` is "region", "stuck" (the part of the period), or the name of a motion
        for its amplitude.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.map(self, ax, shade)


class Curve(Table):
    """Responses along frequency, a line for each point, as finely as they bend.

    Only points of the same friction, the same `start` (which a sweep has) and the same `piece` may be joined; `piece` is -1 where there is no response, and
    `answer` says why.  `contact_force` (`contact_force_N`) is the largest friction force of the period, `friction_work` the
    work of a cycle (`friction_power_W` the mean power).  `curve[name]` is the :class:`Motion` of a mass or of the `contact`.
    """

    r: Floats
    frequency_Hz: Floats
    omega_rad_s: Floats
    beta: Floats
    friction_N: Floats
    start: Words
    piece: Counts
    regime: Words
    answer: Words
    stops: Counts
    period: Counts
    offset: Floats
    offset_m: Floats
    marginal: Flags
    from_rest: Flags
    contact_force: Floats
    contact_force_N: Floats
    friction_work: Floats
    friction_power_W: Floats

    def plot(self, ax: Axes | None = None, of: str | None = None) -> Axes:
        """Draws the amplitude of one motion: a colour for each friction, a stroke for each regime.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.curve(self, ax, of)


class Orbit(Table):
    """The steady state at one point.

    `state` is stable, marginal, unstable or unsettled, or says why there is none; then numbers are NaN and counts -1.
    `multipliers` are its Floquet multipliers, `sticking_intervals` start and length in tau of each stop, a line for each.  With a load, or a frequency in a unit, also
    `longest_stop_s` and `sticking_intervals_s` in seconds.
    """

    regime: str
    state: str
    symmetry: str
    period: int
    stops: int
    reversals: int
    stuck_fraction: float
    largest_multiplier: float
    offset: float
    offset_m: float
    marginal: bool
    from_rest: bool
    multipliers: NDArray[np.complex128]
    sticking_intervals: Floats
    longest_stop_s: float
    sticking_intervals_s: Floats

    def to_frame(self) -> DataFrame:
        """One line with what the orbit says once.

        :raises ImportError: if pandas is not installed.
        """
        beside = ("multipliers", "sticking_intervals", "sticking_intervals_s")
        return frame({name: value for name, value in self._columns.items() if name not in beside})

    def __repr__(self) -> str:
        return f"Orbit: {self.regime}, {self.state}, {self.stops} stops in {self.period} cycles"

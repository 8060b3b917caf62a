"""Answers over frequency and friction."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import _plot
from .table import Counts, Flags, Floats, Grid, Single, Table, Words, frame

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame


class Limits(Table):
    """Both limits over frequency.  A limit may be infinite.

    Below `continuous_limit` the contact can slide all the time.  From `sliding_limit` on it can be stuck.

    With several contacts, all of them slide below `continuous_limit`, and none slides from `sliding_limit` on.
    `slides_first` is then the contact that slides first below `sliding_limit`.

    With stiction 1 the contact slides all the time below both limits, and is stuck from `sliding_limit` on.  With a
    larger stiction the regime may depend on the start.

    The limits are ratios F/P, or F/(k1 Y) for base motion.  With a load the answer also has `continuous_limit_N` and
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
    continuous_limit_without_search_N: Floats
    continuous_limit_per_mode_N: Floats
    slides_first: Words

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws both limits over frequency, in N if a load was given.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.limits(self, ax)


class Response(Grid):
    """Amplitudes and phases over frequency and friction.

    * `regime`: continuous, stick-slip, stuck or unbounded.
    * `margin`: friction over the lower of both limits, minus 1.
    * `answer`: the method that found the motion, or the reason why there is none.  Without a motion amplitudes are NaN.
    * `offset` (`offset_m`): mean of the contact's largest and smallest displacement.  Of a contact that never slides, the
      place where motion from the start leaves it.
    * `marginal`: whether the state belongs to a continuum of steady states.
    * `from_rest`: whether motion from rest, or from the given start, reaches the state.

    `response[name]` is the :class:`Motion` of a mass or of the `contact`:

    * `amplitude` (`amplitude_m`): largest displacement.
    * `phase` (`phase_deg`): lag of that maximum behind the load's.  It is NaN for a part that does not move.
    * `amplitude_monoharmonic`: estimate from the fundamental alone.
    * `fundamental_phase`: lag of X1.
    """

    regime: Words
    margin: Floats
    answer: Words
    offset: Floats
    offset_m: Floats
    marginal: Flags
    from_rest: Flags

    def plot(self, ax: Axes | None = None, of: str | None = None) -> Axes:
        """Draws the amplitude of one motion over frequency, one line for each friction.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.response(self, ax, of)


class ByContact(Grid):
    """Steady states over frequency and friction, with the numbers of each contact.

    * `regime`: continuous (all contacts slide), stuck (none slides) or stick-slip.  Empty without a steady state.
    * `state`: stable, marginal or unstable, or the reason why there is no steady state.  Without one, numbers are NaN and counts
      are -1.
    * `period` in cycles of the excitation.  `largest_multiplier`: modulus of the largest Floquet multiplier.
    * `stuck_from` (`stuck_from_N`): the common friction from which a state exists in which no contact slides.
      `slides_first`: the contact that slides first below it.
    * `found_by`: the start from which the search found the state.
    * `marginal`: names of the contacts whose place or force depends on the start.
    * `symmetry`: symmetric or asymmetric.
    * `from_rest`: whether motion from rest, or from the given start, reaches the state.
    * `cycles_followed`: number of cycles after which that motion has not settled, or -1 if it settles.

    `answer[name]` of a contact, or of a stop, has its `regime`, `stops`, `reversals`, `stuck_fraction`, and over the period the largest
    `slip` (`slip_m`), the largest `force` (`force_N`), the `energy` (`energy_J`) that it takes, and its `amplitude`.
    `answer[name]` of a mass has its `amplitude` (`amplitude_m`).
    """

    regime: Words
    state: Words
    period: Counts
    largest_multiplier: Floats
    stuck_from: Floats
    stuck_from_N: Floats
    slides_first: Words
    found_by: Words
    marginal: Words
    symmetry: Words
    from_rest: Flags
    cycles_followed: Counts

    def plot(self, ax: Axes | None = None, of: str | None = None) -> Axes:
        """Draws the amplitude of one motion over frequency, one line for each friction.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.response(self, ax, of)


class Map(Grid):
    """Regime of the contact over frequency and friction.

    * `regime`, and `region`, which also counts the stops.
    * `period` in cycles, `stops` and `reversals` in a period.  They are -1 where the motion does not repeat or there is
      no answer.
    * `stuck_fraction`: fraction of the period during which the contact sticks.
    * `map[name].amplitude` (`amplitude_m`): amplitude of the contact or of a mass.

    `continuous_limit` and `sliding_limit` depend on the frequency alone.  With a load they are also given in N, as
    `continuous_limit_N` and `sliding_limit_N`.
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

    #: Frictions at the boundaries between regions, with the regions `below` and `above`, if asked for.
    boundaries: Table | None

    _beside = ("continuous_limit", "continuous_limit_N", "sliding_limit", "sliding_limit_N")

    def __init__(self, columns: dict[str, Any], boundaries: dict[str, Any] | None = None) -> None:
        super().__init__(columns)
        self.boundaries = None if boundaries is None else Table(boundaries)

    def plot(self, ax: Axes | None = None, shade: str = "region") -> Axes:
        """Draws the map with both limits.

        :param shade: "region", "stuck" (the fraction of the period), or the name of a motion for its amplitude.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.map(self, ax, shade)


class Curve(Table):
    """Responses along frequency, one line for each point, with more points where a curve bends.

    Only points with the same friction, the same `start` (which a sweep has) and the same `piece` may be joined.  Where
    there is no response, `piece` is -1 and `answer` gives the reason.

    * `contact_force` (`contact_force_N`): largest friction force of the period.
    * `friction_work`: work of friction in a cycle.  `friction_power_W`: mean power.
    * `curve[name]`: the :class:`Motion` of a mass or of the `contact`.
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
        """Draws the amplitude of one motion, with a colour for each friction and a stroke for each regime.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.curve(self, ax, of)


class Orbit(Single):
    """The steady state at one point.

    * `state`: stable, marginal, unstable or unsettled, or the reason why there is no steady state.  Without one,
      numbers are NaN and counts are -1.
    * `cycles_followed`: number of cycles after which motion from rest has not settled, or -1 if it settles.  The state
      is then another stable one (`from_rest` is false), or unsettled.
    * `multipliers`: Floquet multipliers.
    * `sticking_intervals`: start and length of each stop in tau, one line for each.
    * `longest_stop_s`, `sticking_intervals_s`: in seconds, with a load or a frequency in a unit.

    With several contacts, the columns are those of :class:`ByContact`, each with one value.
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
    marginal: bool | str
    from_rest: bool
    cycles_followed: int
    multipliers: NDArray[np.complex128]
    sticking_intervals: Floats
    longest_stop_s: float
    sticking_intervals_s: Floats
    stuck_from: float
    stuck_from_N: float
    slides_first: str
    found_by: str

    def to_frame(self) -> DataFrame:
        """Returns a pandas frame of one line with the single values of the orbit.

        :raises ImportError: if pandas is not installed.
        """
        beside = ("multipliers", "sticking_intervals", "sticking_intervals_s")
        return frame({name: value for name, value in self._columns.items() if name not in beside})

    def __repr__(self) -> str:
        each = [self.stops] if "stops" in self else [contact.stops for contact in self.contacts.values()]
        return f"Orbit: {self.regime}, {self.state}, {sum(each)} stops in {self.period} cycles"


class Cycle(Table):
    """Motion over one period of a steady state.  The last sample repeats the first one.

    * `time_s`: time after the start of a period of the load.
    * `cycle[name].displacement_m`, `.velocity_m_s`: motion of the contact or of a mass.  `cycle[name].force_N`: force of
      a spring.
    * `cycle["contact"].friction_N`: friction force.
    """

    time_s: Floats

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)


class Periodic(Table):
    """Steady states under a periodic load.  The arrays have the shape of the frictions.

    * `state`: stable, or marginal if the position of the contact depends on the earlier motion.
    * `period`: number of periods of the load after which the motion repeats.
    * `events`: number of stops, break-aways and reversals in a period of the motion.
    * `stuck_fraction`: fraction of the period in which the contact sticks, with an error of about one step.
    * `multipliers`: Floquet multipliers, in the last dimension.  `largest_multiplier`: the largest modulus.
    * `load_work_J`: work of the load in a period of the motion.  `friction_work_J`, `damping_work_J`: the energies that
      friction and damping dissipate.
    * `answer[name].least_m`, `.largest_m` (`least_N`, `largest_N` of a spring): smallest and largest value.
    * `histories`: the motion of each state, in the order of the frictions, if `motion=True` was given.
    """

    friction_N: Floats
    state: Words
    period: Counts
    events: Counts
    stuck_fraction: Floats
    largest_multiplier: Floats
    load_work_J: Floats
    friction_work_J: Floats
    damping_work_J: Floats
    multipliers: NDArray[np.complex128]
    #: Motion over a period of each state.
    histories: list[Cycle]

    def __init__(self, columns: dict[str, Any], histories: list[dict[str, Any]]) -> None:
        super().__init__(columns)
        self.histories = [Cycle(history) for history in histories]

    def to_frame(self) -> DataFrame:
        """Returns a pandas frame with one line for each friction, without the list of all multipliers.

        :raises ImportError: if pandas is not installed.
        """
        return frame({name: value for name, value in self._columns.items() if name != "multipliers"})

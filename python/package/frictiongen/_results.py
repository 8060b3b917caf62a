"""What a system answers: numpy arrays by the names that the command line gives to its columns."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from pandas import DataFrame

Floats = NDArray[np.float64]
Counts = NDArray[np.int64]
Words = NDArray[np.str_]

#: The columns that belong to a frequency alone, and to a friction alone.
_FREQUENCY = ("frequency_Hz", "omega_rad_s", "r")
_FRICTION = ("friction_N", "beta")


def _frame(columns: dict[str, Any]) -> DataFrame:
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_frame() needs pandas, which is not installed: pip install pandas") from error
    return pandas.DataFrame({name: _cells(values) for name, values in columns.items()})


def _cells(values: Any) -> Any:
    """Counts that are not there, -1, as pandas marks them."""
    values = np.ravel(values)
    if values.dtype.kind == "i" and (values < 0).any():
        return np.where(values < 0, np.nan, values)
    return values


class _Columns:
    """Arrays by name, as attributes and as items."""

    def __init__(self, name: str, columns: dict[str, Any]) -> None:
        self._name = name
        self._columns = columns

    def keys(self) -> list[str]:
        """The names of what there is."""
        return list(self._columns)

    def __getattr__(self, name: str) -> Any:
        columns = self.__dict__.get("_columns", {})
        if name in columns:
            return columns[name]
        raise AttributeError(_missing(self, name, columns))

    def __getitem__(self, name: str) -> Any:
        """An array by its name; `["X3"]` is the third harmonic."""
        return _item(self, name, self._columns)

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name in self._columns if "." not in name)]

    def __repr__(self) -> str:
        return f"{type(self).__name__} {self._name!r}: {', '.join(self._columns)}"


class Motion(_Columns):
    """How the contact or a mass moves: the part of an answer that bears its name.

    >>> import frictiongen
    >>> frame = frictiongen.System(frictiongen.FRAME)
    >>> lower = frame.response(r=0.9, beta=0.3, harmonics=3)["lower"]
    >>> lower.keys()
    ['amplitude', 'phase', 'amplitude_monoharmonic', 'X1.amplitude', 'X1.phase', 'X3.amplitude', 'X3.phase']
    >>> bool(lower["X3"].amplitude < lower.amplitude)
    True
    """

    amplitude: Floats
    amplitude_m: Floats
    phase: Floats
    phase_deg: Floats


def _missing(answer: object, name: str, columns: dict[str, Any]) -> str:
    message = f"{type(answer).__name__} has no {name!r}"
    units = [known for known in columns if known.rsplit("_", 1)[0] == name]
    groups = [known for known in columns if name.rsplit("_", 1)[0] == known]
    if units:
        return f"{message}: with a load it is {units[0]!r}"
    if groups:
        return f"{message}: without a load (`force` or `base`) it is {groups[0]!r}"
    return f"{message}; it has {', '.join(columns)}"


def _item(answer: object, name: str, columns: dict[str, Any]) -> Any:
    if name in columns:
        return columns[name]
    inner = {known[len(name) + 1 :]: value for known, value in columns.items() if known.startswith(f"{name}.")}
    if not inner:
        raise KeyError(_missing(answer, name, columns))
    return Motion(name, inner)


class Table(_Columns):
    """Columns of one length, or single values: what every answer has in common."""

    def __init__(self, columns: dict[str, Any]) -> None:
        super().__init__("", columns)

    def to_frame(self) -> DataFrame:
        """The same as a pandas frame, a line for each point, with the command line's columns.

        :raises ImportError: if pandas is not installed.
        """
        return _frame(self._columns)

    @property
    def motions(self) -> list[str]:
        """The contact and the masses that it has: the names that `answer[name]` takes."""
        return list(dict.fromkeys(name.split(".")[0] for name in self._columns if "." in name))

    def _repr_size(self) -> str:
        first = next(iter(self._columns.values()), np.empty(0))
        return f"{np.size(first)} lines"

    def __repr__(self) -> str:
        names = [name for name in self._columns if "." not in name]
        return f"{type(self).__name__} of {self._repr_size()}: {', '.join([*names, *self.motions])}"


class _Grid(Table):
    """Frequencies by frictions: what belongs to both has the shape of the frequencies, then that of the frictions."""

    r: Floats
    frequency_Hz: Floats
    omega_rad_s: Floats
    beta: Floats
    friction_N: Floats

    #: Columns along frequency that the frame leaves out.
    _beside: tuple[str, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of the frequencies, followed by that of the frictions."""
        return np.shape(self.r) + np.shape(self.beta)

    def to_frame(self) -> DataFrame:
        """The same as a pandas frame, a line for each point, all frictions of the first frequency first.

        :raises ImportError: if pandas is not installed.
        """
        frequency = np.shape(self.r) + (1,) * np.ndim(self.beta)
        columns = {}
        for name, values in self._columns.items():
            if name not in self._beside:
                values = np.reshape(values, frequency) if name in _FREQUENCY else values
                columns[name] = np.broadcast_to(values, self.shape)
        return _frame(columns)

    def _repr_size(self) -> str:
        return f"shape {self.shape}"


class Limits(Table):
    """Both limits over frequency; a limit may be infinite.

    With less friction than `continuous_limit` and than `sliding_limit` the contact slides all the time; from
    `sliding_limit` on it is stuck.  As ratios, F/P, for base motion F/(k1 Y); with a load also `continuous_limit_N` and
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


class Response(_Grid):
    """Amplitudes and phases over frequency and friction.

    `regime` is continuous, stick-slip, stuck or unbounded; `margin` how far friction is beyond the lower limit, less 1;
    `answer` how the motion was found, or why there is none, and then amplitudes are NaN.  `response[name]` is the
    :class:`Motion` of a mass, or of the `contact`: `amplitude` (`amplitude_m`), the largest displacement; `phase`
    (`phase_deg`), by how much its maximum lags behind the load's, NaN for what does not move; `amplitude_monoharmonic`, the
    estimate from the fundamental alone.
    """

    regime: Words
    margin: Floats
    answer: Words

    def plot(self, ax: Axes | None = None, of: str | None = None) -> Axes:
        """Draws the amplitude of one motion over frequency, a line for each friction.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.response(self, ax, of)


class Map(_Grid):
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

    Only points of the same friction and the same `piece` may be joined; `piece` is -1 where there is no response, and
    `answer` says why.  `contact_force` (`contact_force_N`) is the largest friction force of the period, `friction_work` the
    work of a cycle (`friction_power_W` the mean power).  `curve[name]` is the :class:`Motion` of a mass or of the `contact`.
    """

    r: Floats
    frequency_Hz: Floats
    omega_rad_s: Floats
    beta: Floats
    friction_N: Floats
    piece: Counts
    regime: Words
    answer: Words
    stops: Counts
    period: Counts
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
    `multipliers` are its Floquet multipliers, `sticking_intervals` start and length in tau of each stop, a line for each.
    """

    regime: str
    state: str
    symmetry: str
    period: int
    stops: int
    reversals: int
    stuck_fraction: float
    largest_multiplier: float
    multipliers: NDArray[np.complex128]
    sticking_intervals: Floats

    def to_frame(self) -> DataFrame:
        """One line with what the orbit says once.

        :raises ImportError: if pandas is not installed.
        """
        beside = ("multipliers", "sticking_intervals")
        return _frame({name: value for name, value in self._columns.items() if name not in beside})

    def __repr__(self) -> str:
        return f"Orbit: {self.regime}, {self.state}, {self.stops} stops in {self.period} cycles"


class Events(Table):
    """Every stop, break-away and reversal: when, what, and what the contact does from then on (`["contact"].state`)."""

    time_s: Floats
    tau: Floats
    event: Words


class History(Table):
    """Motions over time, at even instants from a maximum of the excitation on.

    `history[name].displacement` and `.velocity` (`displacement_m`, `velocity_m_s`) of the contact and of masses;
    `history["contact"].friction` (`friction_N`) the friction force and `.state` what the contact does.  `events` are exact.
    """

    time_s: Floats
    tau: Floats
    #: The events between the first sample and the last.
    events: Events

    def __init__(self, columns: dict[str, Any], events: dict[str, Any]) -> None:
        super().__init__(columns)
        self.events = Events(events)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time; where the contact sticks, the ground is shaded.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)


class Steps(Table):
    """Motions under any load, at each of its samples.

    `steps[name].displacement_m` and `.velocity_m_s` of the contact and of masses; `steps["contact"].friction_N` the friction
    force and `.state` what the contact does; `events`, how many stops, break-aways and reversals the step to a sample had.
    `work` of the load, and where it went, in J.
    """

    time_s: Floats
    events: Counts
    #: The work of the `load`, what `friction` and `damping` took of it, and by how much more is `stored` than at the start.
    work: Work

    def __init__(self, columns: dict[str, Any]) -> None:
        columns = dict(columns)
        self.work = Work(*columns.pop("work"))
        super().__init__(columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time; where the contact sticks, the ground is shaded.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)


class Work(NamedTuple):
    """What a load has done and where it went, J: `load` is the sum of the others."""

    load: float
    friction: float
    damping: float
    stored: float


class Optimum(Table):
    """The friction that keeps the largest amplitude over a band smallest.

    `friction_N` and `beta`, and the `amplitude` (`amplitude_m`) there; `kind` says what limits it.  For comparison
    `without_friction` and `with_contact_locked`; `free_of_sticking`, up to which nothing sticks, and `locked`, from which on
    nothing slides.  Tables: `peaks`, the frequencies at which the largest amplitude is reached; `tolerances`, between which
    frictions it stays within a share of the best; `sensitivities`, per cent of it for one per cent of each parameter
    (empty without a load).
    """

    friction_N: float
    beta: float
    amplitude: float
    amplitude_m: float
    kind: str
    evaluations: int
    peaks: Table
    tolerances: Table
    sensitivities: Table

    def __init__(
        self,
        columns: dict[str, Any],
        peaks: dict[str, Any],
        tolerances: dict[str, Any],
        sensitivities: dict[str, Any],
    ) -> None:
        super().__init__(columns)
        self.peaks = Table(peaks)
        self.tolerances = Table(tolerances)
        self.sensitivities = Table(sensitivities)

    def __repr__(self) -> str:
        return f"Optimum: {', '.join(f'{name} = {value}' for name, value in self._columns.items())}"


class Sensitivities(Table):
    """Exact derivatives, a line for each parameter of the description and of the operating point.

    `parameter`, its `value` and `unit`; of `amplitude`, `phase`, `continuous_limit` and `sliding_limit` (with their units)
    the value itself, `["amplitude"].derivative`, and `["amplitude"].relative`: per cent of the answer for one per cent of
    the parameter; of a phase, its change.  NaN where there is none.
    """

    parameter: Words
    value: Floats
    unit: Words
    #: The regime at this point.
    regime: str

    def __init__(self, regime: str, columns: dict[str, Any]) -> None:
        super().__init__(columns)
        self.regime = regime

    def __getitem__(self, name: str) -> Any:
        """The derivatives of an answer, as `["amplitude_m"].derivative`, or a column by its full name."""
        inner = any(known.startswith(f"{name}.") for known in self._columns)
        columns = {known: value for known, value in self._columns.items() if known != name or not inner}
        return _item(self, name, columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws per cent of the amplitude for one per cent of each parameter.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.sensitivities(self, ax)

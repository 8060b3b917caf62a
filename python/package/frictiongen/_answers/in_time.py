"""Motions over time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from .. import _native, _plot
from .table import Counts, Floats, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes


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


class Work(NamedTuple):
    """What a load has done and where it went, J: `load` is the sum of the others."""

    load: float
    friction: float
    damping: float
    stored: float


class Steps(Table):
    """Motions under any load, at each of its samples.

    `steps[name].displacement_m` and `.velocity_m_s` of the contact and of masses; `steps["contact"].friction_N` the friction
    force and `.state` what the contact does; `events`, how many stops, break-aways and reversals the step to a sample had.
    `work` of the load since the start, and where it went, in J; `exceeded`, in how many steps more events happened than are
    followed.  `system.step(dt, start=steps, ...)` goes on where it ends, to the same bits as in one run.
    """

    time_s: Floats
    events: Counts
    #: The work of the `load`, what `friction` and `damping` took of it, and by how much more is `stored` than at the start.
    work: Work
    #: In how many steps more events happened than are followed.
    exceeded: int
    #: Where it ends: what another run goes on from.
    end: _native.StepState

    def __init__(self, columns: dict[str, Any]) -> None:
        columns = dict(columns)
        self.work = Work(*columns.pop("work"))
        self.exceeded = columns.pop("exceeded")
        self.end = columns.pop("end")
        super().__init__(columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time; where the contact sticks, the ground is shaded.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)

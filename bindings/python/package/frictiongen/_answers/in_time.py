"""Motions over time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from .. import _native, _plot
from .table import Counts, Floats, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Events(Table):
    """Every stop, break-away and reversal, with its time and the state after it (`["contact"].state`)."""

    time_s: Floats
    tau: Floats
    event: Words


class History(Table):
    """Motions over time, at evenly spaced instants from a maximum of the excitation on.

    * `history[name].displacement`, `.velocity` (`displacement_m`, `velocity_m_s`): motion of the contact or of a mass.
    * `history["contact"].friction` (`friction_N`): friction force.  `history["contact"].state`: state of the contact.
    * `events`: the exact events.
    """

    time_s: Floats
    tau: Floats
    #: Events between the first sample and the last.
    events: Events

    def __init__(self, columns: dict[str, Any], events: dict[str, Any]) -> None:
        super().__init__(columns)
        self.events = Events(events)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time.  The background is shaded where the contact sticks.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)


class Work(NamedTuple):
    """Energy balance in J: the work `load` of the load is the sum of the other three."""

    load: float
    friction: float
    damping: float
    stored: float


class Steps(Table):
    """Motions under any load, at each of its samples.

    * `steps[name].displacement_m`, `.velocity_m_s`: motion of the contact or of a mass.
    * `steps["contact"].friction_N`: friction force.  `steps["contact"].state`: state of the contact.
    * `events`: number of stops, break-aways and reversals in the step that ends at a sample.
    * `work`: energy balance since the start, in J.
    * `exceeded`: number of steps with more events than the stepper follows.

    `system.step(dt, start=steps, ...)` continues from the end of these steps.  The result equals
    that of a single run to the last bit.
    """

    time_s: Floats
    events: Counts
    #: Work of the `load`, the energy that `friction` and `damping` took of it, and the increase of the `stored` energy.
    work: Work
    #: Number of steps with more events than the stepper follows.
    exceeded: int
    #: End of the steps, from which another run can continue.
    end: _native.StepState

    def __init__(self, columns: dict[str, Any]) -> None:
        columns = dict(columns)
        self.work = Work(*columns.pop("work"))
        self.exceeded = columns.pop("exceeded")
        self.end = columns.pop("end")
        super().__init__(columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time.  The background is shaded where the contact sticks.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)

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

    With several contacts, `history[contact]` has `.displacement`, `.velocity`, `.force`, `.slip` and `.sticks`, and each
    event has the name of its `contact`.
    """

    time_s: Floats
    tau: Floats
    #: Events between the first sample and the last.
    events: Events
    #: Amplitude and phase of each motion over `frequency_Hz` and `order`, exact for a steady state, if asked for.
    spectrum: Table | None

    def __init__(
        self, columns: dict[str, Any], events: dict[str, Any], spectrum: dict[str, Any] | None = None
    ) -> None:
        super().__init__(columns)
        self.events = Events(events)
        self.spectrum = None if spectrum is None else Table(spectrum)

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

    def _compared(self) -> dict[str, Any]:
        # Two ends are only equal if they are the same object.
        return {name: value for name, value in vars(self).items() if name != "end"}

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time.  The background is shaded where the contact sticks.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)


class Driven(Table):
    """Motions under a recorded input, at each of its samples.

    * `driven[name].displacement_m`, `.velocity_m_s`: motion of a contact or of a mass.  `.force_N`: force of a spring.
    * `driven[contact].friction_N`: friction force.  `.state`: stuck, forward or backward.  `.slip_m`: distance of sliding
      since the start.  `.energy_J`: energy that friction has taken since the start.  A stop has its `force_N`, and its
      state is shut or open.
    * `events`: number of events of all contacts in the step that ends at a sample.
    * `work`: energy balance since the start, in J.  `friction_energy`: the energy that each contact took, in J.
    * `exceeded`: number of steps with more events than the stepper follows.
    """

    time_s: Floats
    events: Counts
    #: Work of the `load`, the energy that `friction` and `damping` took of it, and the increase of the `stored` energy.
    work: Work
    #: Energy that friction took in each contact, in J.
    friction_energy: dict[str, float]
    #: Number of steps with more events than the stepper follows.
    exceeded: int

    def __init__(self, columns: dict[str, Any]) -> None:
        columns = dict(columns)
        self.work = Work(*columns.pop("work"))
        self.friction_energy = columns.pop("friction_energy")
        self.exceeded = columns.pop("exceeded")
        super().__init__(columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all displacements over time.  The background is shaded where the first contact sticks.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.history(self, ax)


class Peaks(Table):
    """Largest absolute values of motions under a recorded input, one line for each friction and quantity.

    * `friction_N`: the friction force, if it was given.
    * `quantity`: slip, force and energy of each contact, displacements and accelerations of masses, and the base shear.
    * `peak`: the value with the largest absolute value, exact between samples.  `time_s`: its first instant.
    * `end`: the value at the end.  `unit`: the unit of both.
    """

    friction_N: Floats
    quantity: Words
    peak: Floats
    time_s: Floats
    end: Floats
    unit: Words


class ResponseSpectrum(Table):
    """Response spectrum of a recorded base motion: largest responses of oscillators with one damping ratio.

    * `mode`: number of the mode of the scene that has the `period_s` and the `frequency_Hz` of a line, or -1.
    * `displacement_m`: largest displacement relative to the base.  `pseudo_velocity_m_s`, `pseudo_acceleration_m_s2`.
    """

    mode: Counts
    period_s: Floats
    frequency_Hz: Floats
    displacement_m: Floats
    pseudo_velocity_m_s: Floats
    pseudo_acceleration_m_s2: Floats

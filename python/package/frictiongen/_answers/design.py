"""Answers for a choice: the best friction, and what matters most."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .. import _plot
from .table import Floats, Table, Words, item

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Optimum(Table):
    """The friction that keeps the largest amplitude over a band smallest.

    `friction_N` and `beta`, and the `amplitude` (`amplitude_m`) there; `kind` says what limits it,
    `end` how the search ended, `bracket_from` and `bracket_to` between which frictions the least lies.  For comparison
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
    end: str
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
        return item(self, name, columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws per cent of the amplitude for one per cent of each parameter.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.sensitivities(self, ax)

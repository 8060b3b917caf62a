"""Answers for design: the best friction, and derivatives."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _plot
from .table import Floats, Single, Table, Words, item

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Optimum(Single):
    """The friction that makes the largest amplitude over a frequency band as small as possible.

    * `friction_N` and `beta`: the best friction.  `amplitude` (`amplitude_m`): the largest amplitude at this friction.
    * `value`: the optimised number of the description, if `vary` was given.
    * `shares`: the best share of each contact, if `vary` named shares.  `amplitude_before` (`amplitude_before_m`): the
      largest amplitude with the shares of the description.
    * `decisive`: the quantity with the largest quotient, if several quantities were given.  `quotient`: its quotient.
      `amplitude` and `peaks` belong to this quantity.
    * `kind`: the reason that limits the amplitude.  `end`: the way the search ended.
    * `bracket_from`, `bracket_to`: the frictions between which the least amplitude lies.
    * `beyond_jump`: the largest amplitude beyond the jump at which the search ended.  NaN without a jump.
    * `without_friction`, `with_contact_locked`: the largest amplitudes in both extremes, for comparison.
    * `free_of_sticking`: the friction up to which nothing sticks.  `locked`: the friction from which on nothing slides.

    Tables:

    * `peaks`: the frequencies with the largest amplitude.
    * `tolerances`: the frictions between which the amplitude stays within a given ratio of the best.
    * `sensitivities`: change of the amplitude in per cent for one per cent of each parameter, while friction stays the
      best one.  Empty without a load, and for several quantities, as is `tolerances`.
    * `weighted`: each of several quantities with its `largest` value over the band, the value `over` which it is
      divided, the `unit` of both, and their `ratio`.
    * `kept`: each quantity of `keep` with its `largest` value over the band, its `bound`, and the `unit` of both.
    """

    friction_N: float
    beta: float
    amplitude: float
    amplitude_m: float
    amplitude_m_s: float
    amplitude_m_s2: float
    amplitude_N: float
    amplitude_J: float
    kind: str
    end: str
    evaluations: int
    decisive: str
    quotient: float
    shares: dict[str, float]
    peaks: Table
    tolerances: Table
    sensitivities: Table
    weighted: Table
    kept: Table

    def __init__(
        self,
        columns: dict[str, Any],
        peaks: dict[str, Any],
        tolerances: dict[str, Any],
        sensitivities: dict[str, Any],
        *,
        several: list[tuple[str, str, dict[str, float]]],
    ) -> None:
        columns = {name: value for name, value in columns.items() if value is not None}
        self.shares = columns.pop("shares", {})
        super().__init__(columns)
        self.peaks = Table(peaks)
        self.tolerances = Table(tolerances)
        self.sensitivities = Table(sensitivities)
        self.weighted = _quantities([entry for entry in several if "bound" not in entry[2]])
        self.kept = _quantities([entry for entry in several if "bound" in entry[2]])

    @property
    def largest(self) -> dict[str, float]:
        """Largest value over the band of each of several quantities, or of each quantity of `keep`, in m, m/s, m/s2, N or
        J.  Empty for a single quantity."""
        for table in (self.weighted, self.kept):
            if len(table.quantity):
                return dict(zip(table.quantity.tolist(), table.largest.tolist(), strict=True))
        return {}

    def __repr__(self) -> str:
        return f"Optimum: {', '.join(f'{name} = {value}' for name, value in self._columns.items())}"


def _quantities(entries: list[tuple[str, str, dict[str, float]]]) -> Table:
    """Returns a table of quantities, from the name, the unit and the numbers of each."""
    keys = dict.fromkeys(key for _, _, numbers in entries for key in numbers)
    return Table(
        {
            "quantity": np.array([name for name, _, _ in entries], str),
            **{key: np.array([numbers.get(key, np.nan) for _, _, numbers in entries], float) for key in keys},
            "unit": np.array([unit for _, unit, _ in entries], str),
        }
    )


class Sensitivities(Table):
    """Exact derivatives, one line for each parameter of the description and of the operating point.

    * `parameter`, with its `value` and `unit`.
    * `amplitude`, `phase`, `continuous_limit` and `sliding_limit`, with their units: the value itself.
    * `["amplitude"].derivative`, and alike for the others: the derivative with respect to the parameter.
    * `["amplitude"].relative`: per cent of the answer for one per cent of the parameter.  For a phase it is the change
      of the phase.

    With several contacts, the answer has the `amplitude` and the `phase` of a mass, or the `energy`, `force`, `slip`,
    `displacement` and `stuck_fraction` of a contact.  A derivative that does not exist is NaN.
    """

    parameter: Words
    value: Floats
    unit: Words
    #: Regime of the contact at this point.
    regime: str

    def __init__(self, regime: str, columns: dict[str, Any]) -> None:
        super().__init__(columns)
        self.regime = regime

    def __getitem__(self, name: str) -> Any:
        """Returns the derivatives of an answer, as in `["amplitude_m"].derivative`, or a column by its full name."""
        inner = any(known.startswith(f"{name}.") for known in self._columns)
        columns = {known: value for known, value in self._columns.items() if known != name or not inner}
        return item(self, name, columns)

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the change of the amplitude, or of the energy of one of several contacts, in per cent for one per cent of
        each parameter.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.sensitivities(self, ax)

"""The class `System`, which reads a scene description and answers questions about the scene."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from . import _native
from ._asked.design import Design
from ._asked.in_time import InTime
from ._asked.measuring import Measuring
from ._asked.steady import Steady
from ._files import File, text_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

#: The description of a two-storey frame with a friction contact between the upper floor and a wall.
FRAME = """/// Two-storey shear frame; a brass disc rubs on the upper floor.
pub struct Frame {
    masses: { lower: 3.27, upper: 3.25 },                      // kg; the first is m₁
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },  // N/m; the first is k₁
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    stiction: 1.2,
}
"""


class Mistake(NamedTuple):
    """A mistake in a description; `line` and `column` count from 1."""

    line: int
    column: int
    message: str


class System(Steady, InTime, Design, Measuring):
    """A chain of masses and springs with one friction contact.

    :param text: the description.
    :raises SceneError: if the description has mistakes; `errors` lists every :class:`Mistake`.

    >>> from frictiongen import FRAME, SceneError, System
    >>> System(FRAME)
    System(masses=['lower', 'upper'], contact='upper - wall', excitation='base')
    >>> try:
    ...     System(FRAME.replace("upper - wall", "roof - wall"))
    ... except SceneError as error:
    ...     print(error.errors[0].line, error.errors[0].column)
    5 14

    Methods take the frequency by one of three names: `r`, the ratio omega sqrt(m1/k1), `hz`, or `omega` in rad/s.  They
    take friction as `beta` or, with a load, as `friction` in N.  The load is `force` in N if a force drives a mass, or
    `base` in m if the base moves.  Methods raise :class:`DomainError` for numbers outside their domain, unknown names
    and loads that do not fit, and :class:`TypeError` for arguments that are not numbers.  Other threads can run during
    a computation.
    """

    __slots__ = ()

    def __init__(self, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(
                f"a description is a text, not {type(text).__name__}; a file is read by System.from_file(path)"
            )
        try:
            self._native = _native.System(text)
        except _native.SceneError as error:
            error.errors = [Mistake(*found) for found in error.errors]
            raise

    @classmethod
    def from_file(cls, file: File) -> System:
        """Reads the description of a system from a path, or from a file opened for reading text.

        :raises OSError: if the file cannot be read.
        """
        return cls(text_of(file))

    @classmethod
    def _of(cls, native: _native.System) -> System:
        """Returns a `System` for an existing object of the compiled module."""
        system = cls.__new__(cls)
        system._native = native
        return system

    def __repr__(self) -> str:
        return f"System(masses={self.masses}, contact={' - '.join(self.contact)!r}, excitation={self.excitation!r})"

    @property
    def masses(self) -> list[str]:
        """Names of the masses, in the order of the description."""
        return self._native.masses

    @property
    def mass_values(self) -> NDArray[np.float64]:
        """Masses, kg."""
        return self._native.mass_values

    @property
    def springs(self) -> list[tuple[str, str, float]]:
        """Names of both ends of each spring, and its stiffness in N/m."""
        return self._native.springs

    @property
    def contact(self) -> tuple[str, str]:
        """Names of the two nodes between which friction acts."""
        return self._native.contact

    @property
    def excitation(self) -> str:
        """Name of the mass on which the force acts, or `base` if the base moves."""
        return self._native.driven_mass or "base"

    @property
    def natural_frequencies(self) -> NDArray[np.float64]:
        """Natural frequencies without friction and damping, rad/s.

        >>> import frictiongen, math
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> (frame.natural_frequencies / (2 * math.pi)).round(2).tolist()
        [1.91, 5.11]
        """
        return self._native.natural_frequencies

    @property
    def resonances(self) -> NDArray[np.float64]:
        """Natural frequencies without friction and damping, as frequency ratios r."""
        return self._native.resonances

    @property
    def damping_ratios(self) -> NDArray[np.float64]:
        """Modal damping ratio of each mode."""
        return self._native.damping_ratios

    @property
    def mode_shapes(self) -> NDArray[np.float64]:
        """Mode shapes by mode and mass, normalised so that the sum of m phi**2 is the first mass m1."""
        return self._native.mode_shapes

    def hertz(self, r: float) -> float:
        """Converts a frequency ratio r to a frequency in Hz."""
        return self._native.hertz(r)

    def frequency_ratio(self, hz: float) -> float:
        """Converts a frequency in Hz to a frequency ratio r.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> round(frame.hertz(1.0), 2), frame.frequency_ratio(frame.hertz(1.0))
        (3.04, 1.0)
        """
        return self._native.frequency_ratio_at_hertz(hz)

"""The class `System`, which reads a scene description and answers questions about the scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from . import _native
from ._asked.branches import Branching
from ._asked.design import Design
from ._asked.in_time import InTime
from ._asked.measuring import Measuring
from ._asked.steady import Steady
from ._describe import Damping, described
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


class System(Steady, Branching, InTime, Design, Measuring):
    """A chain of masses and springs with friction contacts.

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

    A system does not change.  Two systems are equal if their descriptions have the same names and numbers.  Systems can
    be copied, pickled, sent to other processes and used as keys of a dict.
    """

    __slots__ = ("_text",)

    _text: str | None

    def __init__(self, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(
                f"a description is a text, not {type(text).__name__}; a file is read by System.from_file(path)"
            )
        if text and "{" not in text and "\n" not in text.strip():
            error = _native.SceneError(
                f"this text is no description, `struct Name {{ ... }}`; if it is the name of a file, read the file by "
                f"System.from_file({text.strip()!r})"
            )
            error.errors = [Mistake(1, 1, str(error))]
            raise error
        self._text = text
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
    def of(
        cls,
        masses: Mapping[str, float],
        springs: Mapping[str, float],
        contact: str,
        excitation: str,
        *,
        damping: Damping | None = None,
        damping_from: str | None = None,
        stiction: float | None = None,
        stiffness: float | None = None,
        name: str = "Scene",
    ) -> System:
        """Creates a system from names and numbers instead of a text.

        :param masses: masses in kg by their names; the first is m1.
        :param springs: stiffnesses in N/m by the two ends, such as `"base - lower"`; the first is k1.
        :param contact: the two nodes between which friction acts, such as `"upper - wall"`.
        :param excitation: name of the mass on which the force acts, or `"base"`.
        :param damping: the modal damping ratio of all modes, a list of them, or `{"a": ..., "b": ...}` for C = aM + bK.
        :param damping_from: `"rest"` for damping of absolute velocities, `"base"` for velocities relative to the base.
        :param stiction: static over kinetic friction, 1 or above.
        :param stiffness: stiffness in N/m of an elastic contact.
        :raises SceneError: if the description has mistakes.
        :raises DomainError: if a name or a number cannot be in a description.

        >>> import frictiongen
        >>> frame = frictiongen.System.of(
        ...     masses={"lower": 3.27, "upper": 3.25},
        ...     springs={"base - lower": 1190.0, "lower - upper": 1323.0},
        ...     contact="upper - wall", excitation="base", damping=[0.010, 0.012], stiction=1.2, name="Frame",
        ... )
        >>> frame == frictiongen.System(frictiongen.FRAME)
        True
        """
        fields: dict[str, float | str | None] = {
            "damping_from": damping_from,
            "stiction": stiction,
            "stiffness": stiffness,
        }
        return cls(described(name, masses, springs, contact, excitation, damping, **fields))

    @classmethod
    def _of(cls, native: _native.System) -> System:
        """Returns a `System` for an existing object of the compiled module."""
        system = cls.__new__(cls)
        system._native = native
        system._text = None
        return system

    @property
    def text(self) -> str:
        """The description.  A changed or fitted system has one without comments."""
        return self._native.description() if self._text is None else self._text

    def replace(
        self,
        *,
        m: Mapping[str, float] | None = None,
        k: Mapping[str, float] | None = None,
        zeta: float | Sequence[float] | None = None,
        a: float | None = None,
        b: float | None = None,
        stiction: float | None = None,
        stiffness: float | None = None,
    ) -> System:
        """Returns the same system with other values of some numbers.

        :param m: masses in kg by their names.
        :param k: stiffnesses in N/m by the two ends of the springs, in either order.
        :param zeta: the modal damping ratio of all modes, or a list with one for each mode.
        :param a: factor a of the damping C = aM + bK, in 1/s.
        :param b: factor b of it, in s.
        :param stiction: static over kinetic friction, 1 or above.
        :param stiffness: stiffness in N/m of an elastic contact.
        :raises DomainError: if the description has no such number, or if a value makes no sense.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> softer = frame.replace(k={"base - lower": 1100}, m={"upper": 3.0})
        >>> softer.springs[0], softer.mass_values.tolist()
        (('base', 'lower', 1100.0), [3.27, 3.0])
        >>> print(softer.text.splitlines()[2])
            springs: { base - lower: 1100.0, lower - upper: 1323.0 },
        """
        values: list[tuple[str, float]] = []
        for symbol, given in (("m", m), ("k", k)):
            if given is not None and not isinstance(given, Mapping):
                raise TypeError(f"{symbol}: numbers by names are needed, {{name: number}}, not {type(given).__name__}")
            values += [(f"{symbol} {name}", value) for name, value in (given or {}).items()]
        if zeta is not None:
            if hasattr(zeta, "__len__"):
                ratios, modes = cast("Sequence[float]", zeta), len(self.masses)
                if len(ratios) != modes:
                    raise _native.DomainError(
                        f"zeta: {modes} ratios are needed, one for each mode, but these are {len(ratios)}"
                    )
                values += [(f"zeta {mode}", ratio) for mode, ratio in enumerate(ratios, 1)]
            else:
                values.append(("zeta", zeta))
        single = {"a": a, "b": b, "mu": stiction, "stiffness": stiffness}
        values += [(symbol, value) for symbol, value in single.items() if value is not None]
        return self._of(self._native.with_values([(symbol, float(value)) for symbol, value in values]))

    def __eq__(self, other: object) -> bool:
        return self._native.equals(other._native) if isinstance(other, System) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._native.description())

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self.text,))

    def __copy__(self) -> System:
        return self

    def __deepcopy__(self, memo: object) -> System:
        return self

    def _repr_html_(self) -> str:
        """Returns what a notebook shows: the numbers of the scene."""
        hertz = self.natural_frequencies / 6.283185307179586
        rows = [
            *((name, f"{value:.6g} kg") for name, value in zip(self.masses, self.mass_values, strict=True)),
            *((f"{one} - {other}", f"{stiffness:.6g} N/m") for one, other, stiffness in self.springs),
            *((name, " - ".join(nodes)) for name, nodes in self.contacts.items()),
            ("excitation", self.excitation),
            ("natural frequencies", ", ".join(f"{value:.4g}" for value in hertz) + " Hz"),
            ("modal damping ratios", ", ".join(f"{value:.3g}" for value in self.damping_ratios)),
        ]
        cells = "".join(f"<tr><th>{escape(name)}</th><td>{escape(value)}</td></tr>" for name, value in rows)
        return f"<table>{cells}</table>"

    def __repr__(self) -> str:
        places = {name: " - ".join(nodes) for name, nodes in self.contacts.items()}
        contact = f"contact={places['contact']!r}" if "contact" in places else f"contacts={places!r}"
        return f"System(masses={self.masses}, {contact}, excitation={self.excitation!r})"

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
        """Names of the two nodes between which friction acts, of the first of several contacts."""
        return self._native.contact

    @property
    def contacts(self) -> dict[str, tuple[str, str]]:
        """Names of the two nodes of each contact, by the name of the contact."""
        return {name: (one, other) for name, one, other in self._native.contacts}

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

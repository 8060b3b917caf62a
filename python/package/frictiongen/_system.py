"""The system: a description and what can be asked of it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import IO, TYPE_CHECKING, NamedTuple

from . import _native
from ._results import Curve, History, Limits, Map, Optimum, Orbit, Response, Sensitivities, Steps

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

#: The description of a two-storey frame, whose upper floor rubs on a wall.
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


class System:
    """A chain of masses and springs with one friction contact.

    :param text: the description.
    :raises SceneError: if the description makes no scene; `errors` lists every :class:`Mistake`.

    >>> from frictiongen import FRAME, SceneError, System
    >>> System(FRAME)
    System(masses=['lower', 'upper'], contact='upper - wall', excitation='base')
    >>> try:
    ...     System(FRAME.replace("upper - wall", "roof - wall"))
    ... except SceneError as error:
    ...     print(error.errors[0].line, error.errors[0].column)
    5 14

    Every question takes the frequency in one of three ways, all by name: `r`, the ratio omega sqrt(m1/k1), `hz`, or `omega`
    in rad/s; friction as `beta` or, with a load, as `friction` in N; the load as `force` in N where a force drives a mass, or
    as `base` in m where the base moves.  :class:`DomainError` is raised for numbers outside their domain, unknown names and
    loads that do not fit, :class:`TypeError` for what is not a number.  While it computes, other threads can run.
    """

    __slots__ = ("_native",)

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
    def from_file(cls, file: str | os.PathLike[str] | IO[str]) -> System:
        """The system that a file describes: a path, or a file opened for reading text.

        :raises OSError: if it cannot be read.
        """
        if not isinstance(file, (str, os.PathLike)):
            if not hasattr(file, "read"):
                raise TypeError(f"a path or an open file is needed, not {type(file).__name__}")
            text = file.read()
            if not isinstance(text, str):
                raise TypeError("the file is open for bytes: open it as text")
            return cls(text)
        return cls(Path(file).read_text(encoding="utf-8"))

    def __repr__(self) -> str:
        return f"System(masses={self.masses}, contact={' - '.join(self.contact)!r}, excitation={self.excitation!r})"

    @property
    def masses(self) -> list[str]:
        """The names of the masses, in the order of the description."""
        return self._native.masses

    @property
    def mass_values(self) -> NDArray[np.float64]:
        """The masses, kg."""
        return self._native.mass_values

    @property
    def springs(self) -> list[tuple[str, str, float]]:
        """Both ends of each spring, and its stiffness in N/m."""
        return self._native.springs

    @property
    def contact(self) -> tuple[str, str]:
        """What rubs on what."""
        return self._native.contact

    @property
    def excitation(self) -> str:
        """The mass that a force drives, or `base`."""
        return self._native.driven_mass or "base"

    @property
    def natural_frequencies(self) -> NDArray[np.float64]:
        """The natural frequencies without friction and damping, rad/s.

        >>> import frictiongen, math
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> (frame.natural_frequencies / (2 * math.pi)).round(2).tolist()
        [1.91, 5.11]
        """
        return self._native.natural_frequencies

    @property
    def resonances(self) -> NDArray[np.float64]:
        """The same as frequency ratios r."""
        return self._native.resonances

    @property
    def damping_ratios(self) -> NDArray[np.float64]:
        """The damping ratio of each mode."""
        return self._native.damping_ratios

    @property
    def mode_shapes(self) -> NDArray[np.float64]:
        """Mode shapes by mode and mass, over the first mass: the sum of m phi**2 is m1."""
        return self._native.mode_shapes

    def hertz(self, r: float) -> float:
        """The frequency in Hz of a frequency ratio r."""
        return self._native.hertz(r)

    def frequency_ratio(self, hz: float) -> float:
        """The frequency ratio r of a frequency in Hz.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> round(frame.hertz(1.0), 2), frame.frequency_ratio(frame.hertz(1.0))
        (3.04, 1.0)
        """
        return self._native.frequency_ratio_at_hertz(hz)

    def limits(
        self,
        *,
        r: ArrayLike | None = None,
        hz: ArrayLike | None = None,
        omega: ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        estimates: bool = False,
    ) -> Limits:
        """The limits of continuous motion and of sliding over frequency, exact.

        :param estimates: also `continuous_limit_without_search`, never too small, and `continuous_limit_per_mode`, never
            too large.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> limits = frame.limits(hz=[1.0, 2.5], base=0.001)
        >>> limits.continuous_limit_N.round(4).tolist(), limits.sliding_limit_N.round(4).tolist()
        ([0.0947, 0.5432], [0.5503, 0.7689])
        """
        return Limits(_native.limits(self._native, (r, hz, omega), (force, base), bool(estimates), True))

    def limits_without_search(
        self,
        *,
        r: ArrayLike | None = None,
        hz: ArrayLike | None = None,
        omega: ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
    ) -> Limits:
        """The shortest way to both limits: `sliding_limit` is exact, `continuous_limit_without_search` never too small.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> fast, exact = frame.limits_without_search(r=0.9), frame.limits(r=0.9)
        >>> bool(fast.sliding_limit == exact.sliding_limit)
        True
        >>> bool(fast.continuous_limit_without_search >= exact.continuous_limit)
        True
        """
        return Limits(_native.limits(self._native, (r, hz, omega), (force, base), False, False))

    def response(
        self,
        *,
        r: ArrayLike | None = None,
        hz: ArrayLike | None = None,
        omega: ArrayLike | None = None,
        beta: ArrayLike | None = None,
        friction: ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
        harmonics: int | None = None,
    ) -> Response:
        """Regime, amplitudes and phases over frequency and friction: closed form, steady state with stops, or stuck.

        Frequencies and frictions may each be a number or an array; the answer has the shape of the frequencies followed by
        that of the frictions.

        :param of: only these motions: masses, or `contact`; all if left out.
        :param harmonics: also the harmonics X1, X3, ... up to this one.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> response = frame.response(r=0.9, beta=[0.3, 0.7, 1.0])
        >>> response.regime.tolist()
        ['continuous', 'stick-slip', 'stuck']
        >>> response["upper"].amplitude.round(3).tolist()
        [1.098, 0.07, 0.0]
        """
        return Response(
            _native.response(
                self._native, (r, hz, omega), (beta, friction), (force, base), _names(of), harmonics
            )
        )

    def orbit(
        self,
        *,
        r: float | None = None,
        hz: float | None = None,
        omega: float | None = None,
        beta: float | None = None,
        friction: float | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
        harmonics: int | None = None,
    ) -> Orbit:
        """The steady state that is reached from rest, at one frequency and one friction: its stops, its stability.

        :param harmonics: also the harmonics X0, X1, ... up to this one.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> orbit = frame.orbit(hz=1.2, friction=0.4, base=0.001)
        >>> orbit
        Orbit: stick-slip, stable, 2 stops in 1 cycles
        >>> orbit.sticking_intervals.shape
        (2, 2)
        """
        return Orbit(
            _native.orbit(self._native, (r, hz, omega), (beta, friction), (force, base), _names(of), harmonics)
        )

    def curve(
        self,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        beta: ArrayLike | None = None,
        friction: ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
        accuracy: float | None = None,
        step: float | None = None,
        harmonics: int | None = None,
        rates: bool = False,
    ) -> Curve:
        """Responses along frequency from one end of a band to the other, refined where they bend.

        :param accuracy: how far a straight line between neighbours may stray, relative to the curve; 5e-4 if left out.
        :param step: how far apart neighbours are at most, in the unit of the frequency.
        :param harmonics: also the harmonics X1, X2, ... up to this one.
        :param rates: also the largest velocities and accelerations.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> curve = frame.curve(hz=(0.5, 7), friction=0.4, base=0.001, of="lower")
        >>> round(float(1e3 * curve["lower"].amplitude_m.max()), 2)  # mm
        12.77
        """
        return Curve(
            _native.curve(
                self._native,
                (r, hz, omega),
                (beta, friction),
                (force, base),
                _names(of),
                (accuracy, step, harmonics, bool(rates)),
            )
        )

    def map(
        self,
        *,
        r: ArrayLike | None = None,
        hz: ArrayLike | None = None,
        omega: ArrayLike | None = None,
        beta: ArrayLike | None = None,
        friction: ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
    ) -> Map:
        """What the contact does at every pair of a frequency and a friction, on all cores.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> map = frame.map(hz=numpy.linspace(0.5, 7, 14), friction=numpy.linspace(0, 2.4, 7), base=0.001)
        >>> map.shape, int((map.regime == "stuck").sum())
        ((14, 7), 54)
        """
        return Map(
            _native.map(self._native, (r, hz, omega), (beta, friction), (force, base), _names(of)),
        )

    def simulate(
        self,
        *,
        r: float | None = None,
        hz: float | None = None,
        omega: float | None = None,
        beta: float | None = None,
        friction: float | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
        cycles: int | None = None,
        skip: int | None = None,
        samples: int | None = None,
        start: tuple[ArrayLike, ArrayLike] | None = None,
        steady: bool = False,
    ) -> History:
        """The exact motion over time, from rest or from a state, with every event; or one period of the steady state.

        :param cycles: how many cycles of the excitation; 10 if left out.
        :param skip: how many cycles pass before the first sample; none if left out.
        :param samples: how many samples a cycle has, an even number; 200 if left out.
        :param start: displacements and velocities of all masses to start from, in m and m/s with a load.
        :param steady: one period of the steady state instead of a run.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> history = frame.simulate(hz=1.2, friction=0.4, base=0.001, steady=True)
        >>> history.events.event.tolist()
        ['stop', 'break-away', 'stop', 'break-away']
        >>> len(history.time_s)
        201
        """
        halves = None
        if start is not None:
            try:
                displacements, velocities = start
            except (TypeError, ValueError):
                raise _native.DomainError(
                    "start: two rows are needed, the displacements of all masses and their velocities"
                ) from None
            halves = (displacements, velocities)
        return History(
            *_native.simulate(
                self._native,
                (r, hz, omega),
                (beta, friction),
                (force, base),
                _names(of),
                (cycles, skip, samples, halves, bool(steady)),
            )
        )

    def step(
        self,
        dt: float,
        *,
        force: ArrayLike | None = None,
        base: ArrayLike | None = None,
        base_velocity: ArrayLike | None = None,
        friction: ArrayLike,
        on: Mapping[str, ArrayLike] | None = None,
        of: str | Iterable[str] | None = None,
    ) -> Steps:
        """The motion from rest under any load, sample by sample, exact between events.

        :param dt: from one sample to the next, s.
        :param force: on the excited mass, N, at each sample, where a force drives the scene.
        :param base: displacement of the base, m, at each sample, where the base moves; with `base_velocity` in m/s.
        :param friction: the kinetic friction force, N: one, or one for each sample.
        :param on: forces on further masses, N, by their names.

        Between samples forces are straight lines, or steps where the description says `input: hold`.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> t = 1e-3 * numpy.arange(2001)
        >>> steps = frame.step(
        ...     1e-3, base=0.01 * numpy.sin(12 * t), base_velocity=0.12 * numpy.cos(12 * t), friction=2.0
        ... )
        >>> steps["upper"].displacement_m.shape, bool(steps.work.friction > 0)
        ((2001,), True)
        """
        if on is not None and not isinstance(on, Mapping):
            raise TypeError("on: forces by the names of masses are needed, {name: force}")
        forces = None if on is None else dict(on)
        return Steps(_native.step(self._native, dt, (force, base, base_velocity), friction, forces, _names(of)))

    def optimum(
        self,
        of: str,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
    ) -> Optimum:
        """The friction that keeps the largest amplitude of a motion over a band of frequencies smallest.

        :param of: a mass, or `contact`.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> best = frame.optimum("lower", hz=(1, 7), base=0.001)
        >>> round(float(best.friction_N), 2), round(1e3 * float(best.amplitude_m), 2)  # N, mm
        (1.54, 2.26)
        """
        return Optimum(*_native.optimum(self._native, of, (r, hz, omega), (force, base)))

    def sensitivities(
        self,
        of: str,
        *,
        r: float | None = None,
        hz: float | None = None,
        omega: float | None = None,
        beta: float | None = None,
        friction: float | None = None,
        force: float | None = None,
        base: float | None = None,
    ) -> Sensitivities:
        """The exact derivatives of amplitude, phase and both limits with respect to every parameter, in any regime.

        :param of: a mass, or `contact`.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> all = frame.sensitivities("lower", hz=1.7, friction=0.4, base=0.001)
        >>> all.parameter.tolist()[:4]
        ['m lower', 'm upper', 'k base - lower', 'k lower - upper']
        >>> all["amplitude_m"].relative.shape
        (10,)
        """
        return Sensitivities(*_native.sensitivities(self._native, of, (r, hz, omega), (beta, friction), (force, base)))


def _names(of: str | Iterable[str] | None) -> str | list[str] | None:
    """Names as the compiled part takes them; what is no iterable is its to refuse."""
    if of is None or isinstance(of, str):
        return of
    try:
        return list(of)
    except TypeError:
        raise TypeError("of: a name or a list of names is needed") from None

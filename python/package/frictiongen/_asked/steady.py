"""Questions over frequency and friction."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .. import _native
from .._answers.steady import Curve, Limits, Map, Orbit, Response
from .base import Base, names

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Steady(Base):
    """Limits, responses, steady states, curves and maps."""

    __slots__ = ()

    def limits(
        self,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        estimates: bool = False,
    ) -> Limits:
        """The limits of continuous motion and of sliding over frequency, exact.

        A tuple (from, to) is a band, which 161 frequencies cover; a list or an array has the frequencies.

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
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
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
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        beta: tuple[float, float] | ArrayLike | None = None,
        friction: tuple[float, float] | ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
        harmonics: int | None = None,
    ) -> Response:
        """Regime, amplitudes and phases over frequency and friction: closed form, steady state with stops, or stuck.

        Frequencies and frictions may each be a number, a list or an array, or a band (from, to), which 161 frequencies or 81
        frictions cover.  The answer has the shape of the frequencies followed by that of the frictions.

        :param of: only these motions: masses, or `contact`; all if left out.
        :param harmonics: also the harmonics X1, X3, ... up to this one.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> response = frame.response(r=0.9, beta=[0.3, 0.7, 1.0])
        >>> response.regime.tolist()
        ['continuous', 'stick-slip', 'stuck']
        >>> response["upper"].centred.round(3).tolist()
        [1.098, 0.07, 0.0]
        """
        return Response(
            _native.response(
                self._native, (r, hz, omega), (beta, friction), (force, base), names(of), harmonics
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
            _native.orbit(self._native, (r, hz, omega), (beta, friction), (force, base), names(of), harmonics)
        )

    def states(
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
    ) -> list[Orbit]:
        """Every steady state at one frequency and one friction that is found from a fixed list of starts.

        The starts are rest, the stuck contact, the closed form and motions at neighbouring frictions.  `from_rest` says
        which state motion from rest ends in.  With stiction 1 there is one state, or one continuum.

        :param harmonics: also the harmonics X0, X1, ... up to this one.

        >>> import frictiongen
        >>> block = frictiongen.System('''struct Block {
        ...     masses: { block: 1 }, springs: { base - block: 1 }, contact: block - base, excitation: base, stiction: 2,
        ... }''')
        >>> sorted(str(state.regime) for state in block.states(r=1.1, beta=0.65))
        ['continuous', 'stuck']
        """
        found = _native.states(self._native, (r, hz, omega), (beta, friction), (force, base), names(of), harmonics)
        return [Orbit(state) for state in found]

    def curve(
        self,
        *,
        r: tuple[float, float] | None = None,
        hz: tuple[float, float] | None = None,
        omega: tuple[float, float] | None = None,
        beta: ArrayLike | None = None,
        friction: ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
        accuracy: float | None = None,
        step: float | None = None,
        harmonics: int | None = None,
        rates: bool = False,
        start: str | Iterable[str] = "rest",
    ) -> Curve:
        """Responses along frequency from one end of a band (from, to) to the other, refined where they bend.

        :param accuracy: how far a straight line between neighbours may stray, relative to the curve; 5e-4 if left out.
        :param step: how far apart neighbours are at most, in the unit of the frequency.
        :param harmonics: also the harmonics X1, X2, ... up to this one.
        :param rates: also the largest velocities and accelerations.
        :param start: "rest", and each point starts from rest; "up" or "down", and each point starts from the state of the
            point before, as in a sweep of a laboratory; or several of the three.

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
                names(of),
                (accuracy, step, harmonics, bool(rates), [start] if isinstance(start, str) else list(start)),
            )
        )

    def map(
        self,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        beta: tuple[float, float] | ArrayLike | None = None,
        friction: tuple[float, float] | ArrayLike | None = None,
        force: float | None = None,
        base: float | None = None,
        of: str | Iterable[str] | None = None,
    ) -> Map:
        """What the contact does at every pair of a frequency and a friction, on all cores.

        A tuple (from, to) is a band, which 161 frequencies or 81 frictions cover; a list or an array has the points.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> map = frame.map(hz=numpy.linspace(0.5, 7, 14), friction=numpy.linspace(0, 2.4, 7), base=0.001)
        >>> map.shape, int((map.regime == "stuck").sum())
        ((14, 7), 53)
        >>> frame.map(hz=(1, 7), friction=[0.4, 0.8], base=0.001).shape
        (161, 2)
        """
        return Map(
            _native.map(self._native, (r, hz, omega), (beta, friction), (force, base), names(of)),
        )

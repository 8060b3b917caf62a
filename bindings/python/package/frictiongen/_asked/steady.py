"""Methods over frequency and friction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, cast

from .. import _native
from .._answers.steady import ByContact, Curve, Limits, Map, Orbit, Periodic, Response
from .base import Base, names, state

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Steady(Base):
    """Methods for limits, responses, steady states, curves and maps."""

    __slots__ = ()

    def limits(
        self,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        estimates: bool = False,
    ) -> Limits:
        """Computes the exact limits of continuous motion and of sliding over frequency.

        A tuple (from, to) is a band, which 161 frequencies cover.  A list or an array contains the frequencies
        themselves.

        :param estimates: whether to compute also `continuous_limit_without_search`, which is never too small, and
            `continuous_limit_per_mode`, which is never too large.

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
        force: float | str | None = None,
        base: float | str | None = None,
    ) -> Limits:
        """Computes both limits without a search, which takes the shortest time.

        `sliding_limit` is exact.  `continuous_limit_without_search` is never too small.

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
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        harmonics: int | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
    ) -> Response | ByContact:
        """Computes regime, amplitudes and phases over frequency and friction, in every regime.

        Frequencies and frictions may each be a number, a list or an array, or a band (from, to), which 161 frequencies
        or 81 frictions cover.  The shape of the answer is the shape of the frequencies, followed by the shape of the
        frictions.  With several contacts the answer is that of :meth:`by_contact`.

        :param of: names of the quantities to return: masses, `contact`, `roof-base`, `roof-first`, `vel(roof)`,
            `accel(roof)`, `spring(a-b)`, `shear`, `force(contact)`, `energy(contact)`, `zeta_eq`.  The default is the
            contact and all masses.
        :param harmonics: the order up to which the harmonics X1, X3, ... are returned too.
        :param start: the initial state, as for :meth:`orbit`.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> response = frame.response(r=0.9, beta=[0.3, 0.7, 1.0])
        >>> response.regime.tolist()
        ['continuous', 'stick-slip', 'stuck']
        >>> response["upper"].amplitude.round(3).tolist()
        [1.098, 0.07, 0.0]
        """
        columns = _native.response(
            self._native, (r, hz, omega), (beta, friction), ((force, base), state(start)), names(of), harmonics
        )
        return ByContact(columns) if self._native.is_joined else Response(columns)

    def by_contact(
        self,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        beta: tuple[float, float] | ArrayLike | None = None,
        friction: tuple[float, float] | ArrayLike | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
    ) -> ByContact:
        """Computes the steady states of a scene with any number of contacts, with the numbers of each contact.

        Frequencies and frictions are given as for :meth:`response`.  The friction is the common force F: each contact
        has its share of it.

        :param of: names of the motions to return besides all contacts: masses, `roof-first`, `vel(roof)`, `accel(roof)`,
            `spring(a-b)`, `shear`.  The default is all masses.
        :param start: the initial state, as for :meth:`orbit`.

        >>> import frictiongen
        >>> pair = frictiongen.System('''struct Pair {
        ...     masses: { lower: 2.0, upper: 1.0 }, springs: { base - lower: 800.0, lower - upper: 300.0 },
        ...     contacts: { pad: upper - wall, brace: base - lower { stiffness: 500.0, share: 0.5 } },
        ...     excitation: base, damping: modal(0.02),
        ... }''')
        >>> answer = pair.by_contact(hz=2.0, friction=[0.5, 2.0, 9.0], base=0.01)
        >>> answer.regime.tolist()
        ['stick-slip', 'stick-slip', 'stuck']
        >>> answer["brace"].stops.tolist(), bool(answer["pad"].energy_J[0] > 0)
        ([2, 2, 0], True)
        """
        return ByContact(
            _native.by_contact(
                self._native, (r, hz, omega), (beta, friction), ((force, base), state(start)), names(of)
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
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        harmonics: int | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
    ) -> Orbit:
        """Computes the steady state at one frequency and one friction.

        The answer contains the stops and the stability of the state, and with several contacts the numbers of each.  If
        several states exist, it is the state that motion from rest reaches.  A contact that never slides may rest at
        any place within an interval.  The answer is then the state in the middle of the interval, without a constant
        force in the contact.  `offset` is the place where motion from rest leaves the contact.

        :param of: names of the quantities to return, as for :meth:`response`.
        :param harmonics: the order up to which the harmonics X0, X1, ... are returned too.
        :param start: "rest", or displacements and velocities of all masses at a maximum of the excitation, in m and m/s
            with a load.  The answer is the state that motion reaches from there.  A contact that never slides then stays
            where that motion leaves it.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> orbit = frame.orbit(hz=1.2, friction=0.4, base=0.001)
        >>> orbit
        Orbit: stick-slip, stable, 2 stops in 1 cycles
        >>> orbit.sticking_intervals.shape
        (2, 2)
        """
        return Orbit(
            _native.orbit(
                self._native, (r, hz, omega), (beta, friction), ((force, base), state(start)), names(of), harmonics
            )
        )

    def states(
        self,
        *,
        r: float | None = None,
        hz: float | None = None,
        omega: float | None = None,
        beta: float | None = None,
        friction: float | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        harmonics: int | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
    ) -> list[Orbit]:
        """Finds steady states at one frequency and one friction, stable or not.

        The search starts from rest or `start`, the stuck contacts, the closed form and other states, and applies Newton's
        method where several states may exist.  It may miss states.  `from_rest` marks the state that motion from rest or
        from `start` reaches; with several contacts, `found_by` is the start from which the search found the state.  If
        the search finds no stable state, the first entry has the reason as its `state`.

        :param harmonics: the order up to which the harmonics X0, X1, ... are returned too.
        :param start: the initial state, as for :meth:`orbit`.

        >>> import frictiongen
        >>> block = frictiongen.System('''struct Block {
        ...     masses: { block: 1 }, springs: { base - block: 1 }, contact: block - base, excitation: base, stiction: 2,
        ... }''')
        >>> sorted(str(state.regime) for state in block.states(r=1.1, beta=0.65))
        ['continuous', 'stuck']
        """
        found = _native.states(
            self._native, (r, hz, omega), (beta, friction), ((force, base), state(start)), names(of), harmonics
        )
        return [Orbit(columns) for columns in found]

    def periodic(
        self,
        load: ArrayLike | tuple[ArrayLike, str] | Mapping[int, float | tuple[float, float]],
        *,
        period: float,
        friction: ArrayLike,
        of: str | Iterable[str] | None = None,
        hold: bool = False,
        motion: bool = False,
    ) -> Periodic:
        """Computes the steady states that motion from rest reaches under a periodic load that is no cosine.

        The arrays of the answer have the shape of the frictions.

        :param load: samples of one period, evenly spaced, or harmonics.  The last sample repeats the first one, one
            period later.  Samples are forces in N on the excited mass, or displacements in m of the base.  A tuple
            `(samples, unit)` gives another unit, such as `"kN"`, `"mm"`, `"m/s"`, `"m/s2"` or `"g"`.  Harmonics are a
            dict `{order: amplitude}` or `{order: (amplitude, lag in degrees)}`, in N or m.  Order 0 is a constant.
        :param period: period of the load, s.
        :param friction: kinetic friction force, N: a number, or a list or an array.
        :param of: names of the motions to return: masses, `contact`, `roof-base`, `roof-first`, `spring(a-b)` or
            `shear`.  The default is the contact and all masses, relative to the base if the base moves.
        :param hold: whether a force stays constant until the next sample, as in a square wave.  Otherwise it changes
            linearly.
        :param motion: whether to return also the motion over a period of each state.
        :raises DomainError: also if the motion from rest repeats neither after one period of the load nor after up to
            64.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> states = frame.periodic({1: 0.001, 3: (0.0002, 45)}, period=1 / 1.2, friction=[0.2, 0.4])
        >>> states.state.tolist(), states.period.tolist()
        (['stable', 'stable'], [1, 1])
        >>> bool(abs(states.load_work_J - states.friction_work_J - states.damping_work_J).max() < 1e-12)
        True
        >>> square = [0.5, 0.5, -0.5, -0.5, 0.5]  # m/s2
        >>> state = frame.periodic((square, "m/s2"), period=0.8, friction=0.4, of="upper-base", motion=True)
        >>> bool(state["upper-base"].largest_m >= state.histories[0]["upper-base"].displacement_m.max())
        True
        """
        asked = dict(load) if isinstance(load, Mapping) else load
        return Periodic(
            *_native.periodic(self._native, (asked, period, bool(hold)), friction, names(of), bool(motion))
        )

    def curve(
        self,
        *,
        r: tuple[float, float] | None = None,
        hz: tuple[float, float] | None = None,
        omega: tuple[float, float] | None = None,
        beta: ArrayLike | None = None,
        friction: ArrayLike | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        accuracy: float | None = None,
        step: float | None = None,
        harmonics: int | None = None,
        rates: bool = False,
        start: str | Iterable[str] | tuple[ArrayLike, ArrayLike] | None = None,
    ) -> Curve | ByContact:
        """Computes responses along frequency over a band (from, to), with more points where a curve bends.

        With several contacts the answer is that of :meth:`by_contact`, at 200 frequencies over the band, or at the
        frequencies of a list or an array.

        :param of: names of the quantities to return, as for :meth:`response`.
        :param accuracy: largest distance of the curve from straight lines between its points, relative to the curve.
            5e-4 by default.
        :param step: largest distance between neighbouring points, in the unit of the frequency.
        :param harmonics: the order up to which the harmonics X1, X2, ... are returned too.
        :param rates: whether to return also the largest velocities and accelerations.
        :param start: the initial state, as for :meth:`orbit`; or "rest", "up", "down" or several of these texts.  With
            "up" or "down" each point starts from the state of the previous point, as in a frequency sweep in a
            laboratory.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> curve = frame.curve(hz=(0.5, 7), friction=0.4, base=0.001, of="lower")
        >>> round(float(1e3 * curve["lower"].amplitude_m.max()), 2)  # mm
        12.77
        """
        words = [start] if isinstance(start, str) else start
        if isinstance(words, (list, tuple)) and all(isinstance(word, str) for word in words):
            start = "rest"
        else:
            words, start = ["rest"], state(cast("tuple[ArrayLike, ArrayLike] | None", start))
        columns = _native.curve(
            self._native,
            (r, hz, omega),
            (beta, friction),
            ((force, base), start),
            names(of),
            (accuracy, step, harmonics, bool(rates), list(words)),
        )
        return ByContact(columns) if self._native.is_joined else Curve(columns)

    def map(
        self,
        *,
        r: tuple[float, float] | ArrayLike | None = None,
        hz: tuple[float, float] | ArrayLike | None = None,
        omega: tuple[float, float] | ArrayLike | None = None,
        beta: tuple[float, float] | ArrayLike | None = None,
        friction: tuple[float, float] | ArrayLike | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        of: str | Iterable[str] | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
        boundaries: int | None = None,
    ) -> Map | ByContact:
        """Computes the regime of the contact at every pair of a frequency and a friction, on all cores.

        A tuple (from, to) is a band, which 161 frequencies or 81 frictions cover.  A list or an array has the points
        themselves.  With several contacts the answer is that of :meth:`by_contact`.

        :param start: the initial state, as for :meth:`orbit`.
        :param boundaries: number of significant digits, from 1 to 12, of the frictions at the boundaries between regions,
            which the answer then has too, for a scene with one contact.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> map = frame.map(hz=numpy.linspace(0.5, 7, 14), friction=numpy.linspace(0, 2.4, 7), base=0.001)
        >>> map.shape, int((map.regime == "stuck").sum())
        ((14, 7), 53)
        >>> frame.map(hz=(1, 7), friction=[0.4, 0.8], base=0.001).shape
        (161, 2)
        """
        columns, found = _native.map(
            self._native, (r, hz, omega), (beta, friction), ((force, base), state(start)), (names(of), boundaries)
        )
        return ByContact(columns) if self._native.is_joined else Map(columns, found)

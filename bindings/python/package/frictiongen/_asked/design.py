"""Methods for design."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from .. import _native
from .._answers.design import Optimum, Sensitivities
from .._answers.features import Features
from .base import Base, names, state

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Design(Base):
    """Methods for the best friction, for derivatives, and for the features of a response."""

    __slots__ = ()

    def optimum(
        self,
        of: str | Mapping[str, float],
        *,
        r: tuple[float, float] | None = None,
        hz: tuple[float, float] | None = None,
        omega: tuple[float, float] | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
        vary: tuple[str, float, float] | None = None,
        keep: Mapping[str, float] | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
    ) -> Optimum:
        """Finds the friction that minimises the largest value of a quantity over a frequency band.

        With several quantities, each quantity is divided by its value, and the largest of these quotients is minimised.

        :param of: quantity whose largest value is minimised: the name of a mass, `contact`, `roof-base`, `accel(roof)`,
            `shear`.  For several quantities, a dict of names and values above 0, in m, m/s, m/s2, N or J.  Without a
            load, the values are non-dimensional.
        :param base: amplitude of the base motion in m, or text such as `"0.2g"`, `"2 m/s2"`, `"0.1 m/s"`.
        :param force: amplitude of the force in N, or an unbalance such as `"0.02 kg m"`.
        :param vary: a second variable of the optimisation: the name of a number in the description, and its interval.
            It needs a single quantity.  With several contacts or dashpots, `c lower - upper` is a dashpot, `share pads`,
            `stiffness pads` and `mu pads` are numbers of one contact, and `share` are the shares of all contacts but the
            first.
        :param keep: upper bounds, as a dict of quantities and values above 0.  The result is the best friction with which
            no quantity exceeds its bound over the band.  It needs a single quantity as `of`.
        :param start: the initial state at each frequency and friction, as for :meth:`orbit`.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> best = frame.optimum("lower", hz=(1, 7), base=0.001)
        >>> round(float(best.friction_N), 2), round(1e3 * float(best.amplitude_m), 2)  # N, mm
        (1.54, 2.26)
        >>> isolator = frictiongen.System.of({"block": 2.0}, {"base - block": 800.0}, "block - base", "base", damping=0.02)
        >>> both = isolator.optimum({"block-base": 0.001, "accel(block)": 1.0}, hz=(1, 9), base=0.001)  # m, m/s2
        >>> round(float(both.friction_N), 3), round(both.quotient, 3)  # both quotients are equal here
        (1.328, 1.081)
        >>> {name: round(value, 5) for name, value in both.largest.items()}  # m, m/s2
        {'block-base': 0.00108, 'accel(block)': 1.08109}
        >>> bound = isolator.optimum("accel(block)", hz=(1, 9), base=0.001, keep={"block-base": 0.001})
        >>> str(bound.kind), {name: round(value, 5) for name, value in bound.largest.items()}
        ('a bound on another quantity', {'block-base': 0.001})
        """
        asked = dict(of) if isinstance(of, Mapping) else of
        bounds = None if keep is None else dict(keep)
        columns, quantities = _native.optimum(
            self._native, asked, (r, hz, omega), ((force, base), state(start)), (vary, bounds)
        )
        return Optimum(*columns, several=quantities)

    def sensitivities(
        self,
        of: str,
        *,
        r: float | None = None,
        hz: float | None = None,
        omega: float | None = None,
        beta: float | None = None,
        friction: float | None = None,
        force: float | str | None = None,
        base: float | str | None = None,
    ) -> Sensitivities:
        """Computes the exact derivatives of amplitude, phase and both limits with respect to every parameter.

        :param of: name of the mass whose amplitude and phase are differentiated, or `contact`.  With several contacts: a
            mass for its amplitude and phase, or a contact for its energy, force, slip, displacement and stuck fraction.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> all = frame.sensitivities("lower", hz=1.7, friction=0.4, base=0.001)
        >>> all.parameter.tolist()[:4]
        ['m lower', 'm upper', 'k base - lower', 'k lower - upper']
        >>> all["amplitude_m"].relative.shape
        (10,)
        """
        return Sensitivities(*_native.sensitivities(self._native, of, (r, hz, omega), (beta, friction), (force, base)))

    def features(
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
    ) -> Features:
        """Finds the features of the response over a frequency band, without a sweep.

        The features are thresholds, antiresonances, invariant points, ranges in which friction enlarges a motion, and
        resonances of the chain with its contact stuck.  For each friction, the method also finds the ranges in which
        the contact slides, the regimes and the peaks.  It returns the derivatives of all numbers that have derivatives.

        Without a band the method examines the range around the resonances.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> features = frame.features(hz=(1, 7), friction=0.4, base=0.001)
        >>> features.held_resonances.frequency_Hz.round(3).tolist()
        [4.412]
        >>> features.regimes.regime.tolist()
        ['stick-slip', 'continuous', 'stick-slip', 'continuous', 'stick-slip', 'stuck']
        >>> features.regimes.relative("to_frequency_Hz")["F"].round(2).tolist()[:2]  # per cent for one per cent
        [0.45, -0.09]
        """
        return Features(
            _native.features(self._native, (r, hz, omega), (beta, friction), (force, base), names(of))
        )

"""Questions about the motion over time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from .. import _native
from .._answers.in_time import History, Steps
from .._recording import Recording
from .base import Base, names

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class InTime(Base):
    """Motions under a harmonic load, and under any."""

    __slots__ = ()

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
        return History(
            *_native.simulate(
                self._native,
                (r, hz, omega),
                (beta, friction),
                (force, base),
                names(of),
                (cycles, skip, samples, None if start is None else _halves(start), bool(steady)),
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
        start: tuple[ArrayLike, ArrayLike] | Steps | None = None,
        stiction: float | None = None,
    ) -> Steps:
        """The motion under any load, sample by sample, exact between events.

        :param dt: from one sample to the next, s.
        :param force: on the excited mass, N, at each sample, where a force drives the scene.
        :param base: displacement of the base, m, at each sample, where the base moves; with `base_velocity` in m/s.
        :param friction: the kinetic friction force, N: one, or one for each sample.
        :param on: forces on further masses, N, by their names.
        :param start: displacements and velocities of all masses, m and m/s, instead of rest; or the answer of an earlier
            call, which this one goes on from: its first sample is then one `dt` after the last one before.
        :param stiction: static over kinetic friction from the start on; as the description says if left out.

        Between samples forces are straight lines, or steps where the description says `provide: [stepper], input: hold`.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> t = 1e-3 * numpy.arange(2001)
        >>> base = {"base": 0.01 * numpy.sin(12 * t), "base_velocity": 0.12 * numpy.cos(12 * t)}
        >>> steps = frame.step(1e-3, **base, friction=2.0)
        >>> steps["upper"].displacement_m.shape, bool(steps.work.friction > 0)
        ((2001,), True)
        >>> first = frame.step(1e-3, **{name: all[:1000] for name, all in base.items()}, friction=2.0)
        >>> rest = frame.step(1e-3, **{name: all[1000:] for name, all in base.items()}, friction=2.0, start=first)
        >>> bool(rest["upper"].displacement_m[-1] == steps["upper"].displacement_m[-1])
        True
        """
        if on is not None and not isinstance(on, Mapping):
            raise TypeError("on: forces by the names of masses are needed, {name: force}")
        forces = None if on is None else dict(on)
        return Steps(
            _native.step(
                self._native, dt, (force, base, base_velocity), (friction, forces), names(of), (_start(start), stiction)
            )
        )

    def drive(
        self,
        recording: Recording,
        *,
        friction: float | None = None,
        of: str | Iterable[str] | None = None,
        start: tuple[ArrayLike, ArrayLike] | Steps | None = None,
        stiction: float | None = None,
    ) -> Steps:
        """The motion under a recorded input: `base` as displacement, velocity or acceleration, `force`, names of masses for
        forces on them, and `friction` where it changes.

        :param recording: of the inputs; `Recording(..., drives=True)` takes one channel too, and a constant one.
        :param friction: the kinetic friction force, N; the channel `friction` if left out.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> shaking = 0.5 * numpy.sin(12 * 1e-3 * numpy.arange(2001))
        >>> recording = frictiongen.Recording({"base": (shaking, "m/s2")}, rate=1000, drives=True)
        >>> bool(frame.drive(recording, friction=0.2).work.friction > 0)
        True
        """
        if not isinstance(recording, Recording):
            raise TypeError(f"a Recording is needed, not {type(recording).__name__}")
        return Steps(
            _native.drive(self._native, recording._native, friction, names(of), (_start(start), stiction))
        )


def _halves(start: tuple[ArrayLike, ArrayLike]) -> tuple[ArrayLike, ArrayLike]:
    try:
        displacements, velocities = start
    except (TypeError, ValueError):
        raise _native.DomainError(
            "start: two rows are needed, the displacements of all masses and their velocities"
        ) from None
    return displacements, velocities


def _start(start: tuple[ArrayLike, ArrayLike] | Steps | None) -> tuple[ArrayLike, ArrayLike] | _native.StepState | None:
    if isinstance(start, Steps):
        return start.end
    return None if start is None else _halves(start)

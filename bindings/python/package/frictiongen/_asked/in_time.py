"""Methods for the motion over time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Literal, cast, overload

from .. import _native
from .._answers.in_time import Driven, History, Peaks, ResponseSpectrum, Steps
from .._recording import Recording
from .base import Base, names, state

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class InTime(Base):
    """Methods for motions under a harmonic load and under any load."""

    __slots__ = ()

    def simulate(
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
        cycles: int | None = None,
        skip: int | None = None,
        samples: int | None = None,
        start: str | tuple[ArrayLike, ArrayLike] | None = None,
        steady: bool = False,
        until: float | None = None,
        inputs: str | Iterable[str] | None = None,
        spectrum: bool = False,
    ) -> History:
        """Computes the exact motion and all events over time, from rest, from a state, or in the steady state.

        With `until`, no load acts: the motion is the free vibration from `start`, and `friction` is in N.  The scene then
        may have several contacts, and needs no `excitation`.  With `inputs`, forces or a motion of the base in closed form
        act until `until`, such as "step 5 N from 0.5 s" or "half-sine 10 g for 11 ms" (`frictiongen time --help`).

        :param cycles: number of cycles of the excitation, 10 by default.
        :param skip: number of cycles before the first sample, 0 by default.
        :param samples: number of samples in a cycle, an even number, 200 by default.  With `until`, the number of
            samples in all, 1000 by default.
        :param start: initial displacements and velocities of all masses, in m and m/s with a load and with `until`, or
            "rest".  A run starts from rest by default.  For a steady state, :meth:`orbit` describes the default.
        :param steady: whether to return one period of the steady state instead of a run.
        :param until: end of the free vibration, or of the motion under `inputs`, in s.
        :param inputs: one or several inputs over time, as texts.
        :param spectrum: whether to return also the spectrum of each motion, for a scene with one contact.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> history = frame.simulate(hz=1.2, friction=0.4, base=0.001, steady=True)
        >>> history.events.event.tolist()
        ['stop', 'break-away', 'stop', 'break-away']
        >>> len(history.time_s)
        201
        >>> free = frame.simulate(start=([0.004, 0.006], [0, 0]), friction=0.8, until=10)
        >>> str(free.events.event[-1])
        'stop'
        >>> shock = frame.simulate(inputs="half-sine 2 g for 11 ms", friction=0.8, until=2, samples=100)
        >>> shock.events.event[:2].tolist()
        ['slip', 'reversal']
        """
        return History(
            *_native.simulate(
                self._native,
                (r, hz, omega),
                (beta, friction),
                (force, base),
                names(of),
                (cycles, skip, samples, state(start), (until, _texts(inputs)), (bool(steady), bool(spectrum))),
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
        budget: int | None = None,
    ) -> Steps:
        """Computes the motion under a load that is given at evenly spaced instants.

        :param dt: time between two samples, s.
        :param force: force on the excited mass at each sample, N, if a force drives the scene.
        :param base: displacement of the base at each sample, m, if the base moves.
        :param base_velocity: velocity of the base at each sample, m/s, together with `base`.
        :param friction: kinetic friction force, N: one number, or one for each sample.
        :param on: forces on further masses, N, by the names of the masses.
        :param start: initial displacements and velocities of all masses, m and m/s, or the answer of an earlier call.
            The default is rest.  After an earlier call, the motion continues from the last sample of that call, and the
            first new sample is one `dt` later.
        :param stiction: ratio of static to kinetic friction.  The default is the ratio in the description.
        :param budget: event budget, the number of events that the stepper follows in a step.  A step with more events
            ends by a rule that creates no energy, and `exceeded` counts it.  0 means no budget.  The default is the
            budget of `start`, or else no budget.

        Between samples a force is linear in time.  It is constant over a step if the description has `input: hold`.

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
                self._native, dt, (force, base, base_velocity), (friction, forces), names(of), (_start(start), stiction, budget)
            )
        )

    @overload
    def drive(
        self,
        recording: Recording | str | Iterable[str],
        *,
        friction: float | None = None,
        of: str | Iterable[str] | None = None,
        start: tuple[ArrayLike, ArrayLike] | None = None,
        after: float | None = None,
        until: float | None = None,
        samples: int | None = None,
        peaks: Literal[False] = False,
    ) -> Driven: ...

    @overload
    def drive(
        self,
        recording: Recording | str | Iterable[str],
        *,
        friction: ArrayLike | None = None,
        of: str | Iterable[str] | None = None,
        start: tuple[ArrayLike, ArrayLike] | None = None,
        after: float | None = None,
        until: float | None = None,
        samples: int | None = None,
        peaks: Literal[True],
    ) -> Peaks: ...

    def drive(
        self,
        recording: Recording | str | Iterable[str],
        *,
        friction: ArrayLike | None = None,
        of: str | Iterable[str] | None = None,
        start: tuple[ArrayLike, ArrayLike] | None = None,
        after: float | None = None,
        until: float | None = None,
        samples: int | None = None,
        peaks: bool = False,
    ) -> Driven | Peaks:
        """Computes the motion of a scene with any number of contacts under a recorded input.

        The channel of the excitation is `base` (displacement, velocity or acceleration) or `force`.  A channel with the
        name of a mass is a force on this mass.  The channel `friction` is the friction force, if it changes.

        Between samples the base moves in straight lines through displacements, in parabolas under velocities, or in cubics
        under accelerations, so that nothing moves before its cause.  The motion starts at the first sample, with all masses
        at rest relative to the base.

        :param recording: recording of the inputs.  `Recording(..., drives=True)` also takes a single or a constant
            channel.  One or several texts are inputs in closed form, such as "step 5 N from 0.5 s", from rest at 0.
        :param friction: kinetic friction force, N, of which each contact has its share.  With `peaks` it may be a list or
            an array.  The default is the channel `friction`.
        :param of: names of the motions to return: masses, contacts, `roof-base`, `roof-first`, `spring(a-b)`, `shear`.  The
            default is all contacts and all masses, relative to the base if the base moves.  With `peaks` also `vel(roof)`,
            `accel(roof)`, `slip(pads)`, `force(pads)`, `energy(pads)`.
        :param start: initial displacements and velocities of all masses, m and m/s.  The default is rest relative to the
            base.
        :param after: time in s for which the motion goes on after the recording, without forces and with a base that
            keeps its last recorded displacement, or its last velocity under accelerations.
        :param until: end of the motion under inputs in closed form, in s.
        :param samples: number of sample intervals of this motion, 1000 by default.
        :param peaks: whether to return the largest values of quantities instead of the motion.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> shaking = 0.5 * numpy.sin(12 * 1e-3 * numpy.arange(2001))
        >>> recording = frictiongen.Recording({"base": (shaking, "m/s2")}, rate=1000, drives=True)
        >>> bool(frame.drive(recording, friction=0.2).work.friction > 0)
        True
        >>> frame.drive(recording, friction=[0.2, 0.4], peaks=True, of="upper-lower").unit.tolist()
        ['m', 'm']
        >>> float(frame.drive("step 0.1 m/s", friction=0.2, until=3, peaks=True, of="upper-base").time_s[0]) < 3
        True
        """
        if isinstance(start, Steps):
            raise TypeError("start: displacements and velocities are needed; `step` continues earlier steps")
        asked = self._native, _driver(recording, until, samples), (friction, names(of), after, state(start))
        return Peaks(_native.drive_peaks(*asked)) if peaks else Driven(_native.drive(*asked))

    def response_spectrum(self, recording: Recording, *, damping: float) -> ResponseSpectrum:
        """Computes the response spectrum of a recorded base motion, with the natural periods of the scene.

        :param recording: recording with the channel `base`.
        :param damping: damping ratio of the oscillators, such as 0.05.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> shaking = 0.5 * numpy.sin(12 * 1e-2 * numpy.arange(2001))
        >>> recording = frictiongen.Recording({"base": (shaking, "m/s2")}, rate=100, drives=True)
        >>> frame.response_spectrum(recording, damping=0.05).mode.tolist()[:3]
        [1, 2, -1]
        """
        if not isinstance(recording, Recording):
            raise TypeError(f"a Recording is needed, not {type(recording).__name__}")
        return ResponseSpectrum(_native.response_spectrum(self._native, recording._native, damping))


def _start(start: tuple[ArrayLike, ArrayLike] | Steps | None) -> tuple[ArrayLike, ArrayLike] | _native.StepState | None:
    if isinstance(start, Steps):
        return start.end
    return cast("tuple[ArrayLike, ArrayLike] | None", state(start))


def _driver(
    recording: Recording | str | Iterable[str], until: float | None, samples: int | None
) -> _native.Recording | tuple[list[str], float | None, int | None]:
    if isinstance(recording, Recording):
        if until is not None or samples is not None:
            raise ValueError("until and samples belong to inputs in closed form; leave them out, or give after")
        return recording._native
    is_listed = isinstance(recording, Iterable) and not isinstance(recording, Mapping)
    texts = _texts(recording) if is_listed else []
    if not is_listed or not all(isinstance(text, str) for text in texts):
        raise TypeError(f"a Recording is needed, or inputs as texts, not {type(recording).__name__}")
    return texts, until, samples


def _texts(inputs: str | Iterable[str] | None) -> list[str]:
    if inputs is None or isinstance(inputs, str):
        return [] if inputs is None else [inputs]
    return list(inputs)

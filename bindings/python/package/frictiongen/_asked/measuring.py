"""Methods for measurements."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import _native
from .._answers.measuring import Fit, FreeDecay, Identification, MotionFit, Transmissibilities
from .._files import File, name_of, text_of
from .._observation import Observation
from .._recording import Recording
from .base import Base, names

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Measuring(Base):
    """Methods that find properties of the system from recordings, amplitudes and phases."""

    __slots__ = ()

    def transmissibility(self, recordings: Recording | Iterable[Recording]) -> Transmissibilities:
        """Finds driving frequency, transmissibility and phase in recordings, each made at one frequency.

        :raises MeasureError: for a recording without excitation or without a mass, a driving frequency or amplitude
            that drifts, a motion that never becomes steady, and fewer than 8 cycles.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> t = numpy.arange(5000) / 500
        >>> base, lower = 1.75 * numpy.cos(25 * t), 3.5 * numpy.cos(25 * t - 0.3)
        >>> recording = frictiongen.Recording({"base": (base, "mm"), "lower": (lower, "mm")}, rate=500)
        >>> found = frame.transmissibility(recording)
        >>> round(float(found["lower"].transmissibility[0]), 6), round(float(found.frequency_Hz[0]), 6)
        (2.0, 3.978874)
        """
        return Transmissibilities(
            _native.transmissibility(self._native, [item._native for item in _listed(recordings, Recording)])
        )

    def identify(
        self,
        measured: Recording | Observation | Iterable[Recording | Observation],
        *,
        by: str | None = None,
        of: str | Iterable[str] | None = None,
        also: str | Iterable[str] | None = None,
        between: tuple[float, float] | None = None,
        harmonics: int | None = None,
    ) -> Identification:
        """Finds the friction force that fits the measurements best, with its uncertainty interval.

        The contact may be in any regime.  The method fits all measurements together, at one or several frequencies.  If
        the measurements do not determine the force, the verdict gives the reason.

        :param measured: recordings, or amplitudes and phases as an :class:`Observation`.
        :param by: quantities to compare: "both", "amplitude" or "phase".  The default is all measured quantities.
        :param of: names of the masses to use.  The default is all measured masses.
        :param also: further unknowns to fit: "damping", "frequency" (a factor on all natural frequencies),
            "stiction" or "stiffness" (of an elastic contact).
        :param between: range of friction forces to search, N.  The default range is from 0 to the
            smallest force at which the contact is stuck.
        :param harmonics: order up to which the odd harmonics of recordings are used too.
        :raises MeasureError: for recordings that cannot be used, a unit that is wrong by a power of 1000, and motions
            that no friction force explains.
        """
        items = [item._told if isinstance(item, Observation) else item._native for item in _listed(measured)]
        once, columns, system = _native.identify(
            self._native, items, names(of), (by, names(also, "also"), between, harmonics)
        )
        return Identification(once, columns, type(self)._of(system))

    def fit(
        self,
        sweep: Transmissibilities | File | None = None,
        *,
        hz: ArrayLike | None = None,
        transmissibility: Mapping[str, ArrayLike] | None = None,
        deviation: Mapping[str, ArrayLike] | None = None,
        damping: bool = False,
    ) -> Fit:
        """Fits natural frequencies, mass ratios and stiffness ratios to a sweep without friction.

        The base drives the system.  Give the sweep as `sweep`, or as `hz` and `transmissibility`.

        :param sweep: answer of :meth:`transmissibility`, or a CSV with `frequency_Hz`, `NAME.transmissibility` and
            `NAME.deviation`: a path, or a file opened for reading text.
        :param hz: frequencies of the sweep, Hz.
        :param transmissibility: amplitude of each mass over that of the base at these frequencies, by the mass's name.
        :param deviation: standard deviations of the transmissibilities, by the mass's name.  By default all amplitudes
            have the same relative error.
        :param damping: whether to fit also one damping ratio for all modes.

        >>> import frictiongen, numpy
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> hz = numpy.linspace(0.5, 8, 30)
        >>> swept = frame.response(hz=hz, friction=0, base=0.001)["lower"].amplitude_m / 0.001
        >>> softer = frictiongen.System(frictiongen.FRAME.replace("1323.0", "1200.0"))
        >>> round(1190 * softer.fit(hz=hz, transmissibility={"lower": swept}).stiffness_ratios["lower - upper"].value, 3)
        1323.0
        """
        if sweep is None:
            if hz is None or transmissibility is None:
                raise _native.DomainError("a sweep is needed, or hz and transmissibility")
            return self._fit_arrays(hz, _masses(transmissibility, deviation), False, damping)
        if hz is not None or transmissibility is not None or deviation is not None:
            raise _native.DomainError("give either sweep, or hz and transmissibility, not both")
        if isinstance(sweep, Transmissibilities):
            motions = {name: sweep[name] for name in sweep.motions if name in self._native.masses}
            amplitudes = {name: motion.transmissibility for name, motion in motions.items()}
            deviations = {name: motion.deviation for name, motion in motions.items()}
            return self._fit_arrays(sweep.frequency_Hz, _masses(amplitudes, deviations), True, damping)
        return self._fitted(_native.fit_text(self._native, text_of(sweep), name_of(sweep), bool(damping)))

    def _fit_arrays(self, hz: ArrayLike, masses: list[tuple[str, Any, Any]], gaps: bool, damping: bool) -> Fit:
        return self._fitted(_native.fit(self._native, np.atleast_1d(hz), masses, gaps, bool(damping)))

    def _fitted(self, found: tuple[dict[str, Any], dict[str, Any], _native.System]) -> Fit:
        once, columns, system = found
        return Fit(once, columns, type(self)._of(system))

    def fit_motion(
        self, recording: Recording, *, friction: float | None = None, vary: str | Iterable[str] | None = None
    ) -> MotionFit:
        """Fits the friction force and numbers of the description to the whole motion in a recording, sample by sample.

        The recording has the channels of :meth:`drive`, and displacements or velocities of masses.  The motion starts from
        rest.

        :param friction: first guess of the friction force, N.  Leave it out if the recording has a channel `friction`.
        :param vary: names of the numbers to fit, as for :meth:`optimum`.  Their first guesses are those of the
            description.

        >>> import frictiongen, numpy
        >>> plate = frictiongen.System('''struct Plate {
        ...     masses: { plate: 2.0 }, springs: { base - plate: 750.0 }, contact: plate - wall, excitation: plate,
        ... }''')
        >>> load = 20 * numpy.sin(9 * 0.01 * numpy.arange(300))
        >>> motion = plate.step(0.01, force=load, friction=3.0)["plate"].displacement_m
        >>> recording = frictiongen.Recording({"force": (load, "N"), "plate": (motion, "m")}, rate=100, drives=True)
        >>> found = plate.fit_motion(recording, friction=2.0)
        >>> round(found.friction_N.value, 6)
        3.0
        """
        if not isinstance(recording, Recording):
            raise TypeError(f"a Recording is needed, not {type(recording).__name__}")
        once, system = _native.fit_motion(self._native, recording._native, friction, names(vary, "vary"))
        return MotionFit(once, type(self)._of(system))

    def free_decay(
        self, recording: Recording, *, damping: float | None = None, find_damping: bool = False
    ) -> FreeDecay:
        """Finds friction, natural frequency and damping from a free vibration of a system with one mass.

        The mass is pulled and released.

        :param damping: damping ratio, instead of the damping ratio in the description.
        :param find_damping: whether to fit the damping ratio, even if the description has one.

        >>> import frictiongen, numpy
        >>> plate = frictiongen.System('''struct Plate {
        ...     masses: { plate: 2.0 }, springs: { base - plate: 752.0 }, contact: plate - wall, excitation: base,
        ... }''')
        >>> half, side = divmod(numpy.arange(2500) * 0.006, 1)  # at 3 Hz, about 0.5 mm to either side
        >>> x = (-1) ** half * (0.5 + (19.5 - half) * numpy.cos(numpy.pi * side))
        >>> found = plate.free_decay(frictiongen.Recording({"plate": (x, "mm")}, rate=1000))
        >>> round(found.friction_N.value, 6), round(found.frequency_Hz.value, 6)
        (0.376, 3.0)
        """
        if not isinstance(recording, Recording):
            raise TypeError(f"a Recording is needed, not {type(recording).__name__}")
        return FreeDecay(*_native.free_decay(self._native, recording._native, damping, bool(find_damping)))


def _listed(given: Any, *kinds: type) -> list[Any]:
    """Returns the items as a list, and checks their types."""
    kinds = kinds or (Recording, Observation)
    needed = " or ".join(kind.__name__ for kind in kinds)
    if isinstance(given, kinds):
        return [given]
    try:
        listed = list(given)
    except TypeError:
        raise TypeError(f"a {needed} is needed, or a list of such, not {type(given).__name__}") from None
    for item in listed:
        if not isinstance(item, kinds):
            raise TypeError(f"a {needed} is needed, not {type(item).__name__}")
    if not listed:
        raise _native.DomainError(f"at least one {needed} is needed")
    return listed


def _masses(amplitudes: Any, deviations: Any) -> list[tuple[str, Any, Any]]:
    for argument, given in (("transmissibility", amplitudes), ("deviation", deviations)):
        if given is not None and not (isinstance(given, Mapping) and all(isinstance(name, str) for name in given)):
            raise TypeError(f"{argument}: numbers by the names of masses are needed, {{name: numbers}}")
    deviations = deviations or {}
    for name in deviations:
        if name not in amplitudes:
            raise _native.DomainError(f"deviation: there is no transmissibility of {name!r}")
    return [(name, given, deviations.get(name)) for name, given in amplitudes.items()]

"""Measured amplitudes and phases."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Observation:
    """Measured amplitudes and phases of masses at one or several frequencies.

    :meth:`System.identify` takes an observation instead of recordings.

    :param hz: driving frequencies, Hz.
    :param base: amplitude of the base motion, m, if the base moves: one number, or one for each frequency.
    :param force: amplitude of the force, N, if a force drives a mass: one number, or one for each frequency.
    :param amplitude_m: amplitude of each mass's fundamental, m, by the mass's name.
    :param phase_deg: lag of each mass's fundamental behind the excitation, degrees, by the mass's name.
    :param deviation_m: standard deviation of each amplitude, m.
    :param phase_deviation_deg: standard deviation of each phase that has no amplitude, degrees.
    :param load_deviation: standard deviation of the excitation's amplitude, in the unit of that amplitude.

    A deviation is one number for all masses, or a number for each mass by its name.  Amplitudes or phases may be
    omitted, but not both.

    >>> import frictiongen
    >>> plate = frictiongen.System('''struct Plate {
    ...     masses: { plate: 2.0 }, springs: { base - plate: 752.0 }, contact: plate - wall, excitation: base,
    ... }''')
    >>> truth = plate.response(hz=[2.5, 4.0], friction=0.5, base=1.75e-3, harmonics=1)["plate"]["X1"]
    >>> seen = frictiongen.Observation(
    ...     hz=[2.5, 4.0], base=1.75e-3, amplitude_m={"plate": truth.amplitude_m}, phase_deg={"plate": truth.phase_deg},
    ...     deviation_m=2e-6,
    ... )
    >>> found = plate.identify(seen)
    >>> found.verdict, round(found.friction_N.value, 6), found.friction_N.holds(0.5)
    ('determined', 0.5, True)
    """

    __slots__ = ("_told",)

    def __init__(
        self,
        *,
        hz: ArrayLike,
        base: ArrayLike | None = None,
        force: ArrayLike | None = None,
        amplitude_m: Mapping[str, ArrayLike] | None = None,
        phase_deg: Mapping[str, ArrayLike] | None = None,
        deviation_m: ArrayLike | Mapping[str, ArrayLike] | None = None,
        phase_deviation_deg: ArrayLike | Mapping[str, ArrayLike] | None = None,
        load_deviation: ArrayLike = 0.0,
    ) -> None:
        amplitudes, phases = _by_name("amplitude_m", amplitude_m), _by_name("phase_deg", phase_deg)
        motions = [
            (
                name,
                1,
                amplitudes.get(name),
                phases.get(name),
                _of(deviation_m, name),
                _of(phase_deviation_deg, name),
            )
            for name in dict.fromkeys([*amplitudes, *phases])
        ]
        self._told = (hz, (force, base), load_deviation, motions)


def _by_name(argument: str, given: Any) -> dict[str, Any]:
    if given is None:
        return {}
    if not isinstance(given, Mapping) or not all(isinstance(name, str) for name in given):
        raise TypeError(f"{argument}: numbers by the names of masses are needed, {{name: numbers}}")
    return dict(given)


def _of(given: Any, name: str) -> Any:
    """Returns the deviation of a mass: the common deviation of all masses, or the mass's own deviation."""
    return given.get(name) if isinstance(given, Mapping) else given

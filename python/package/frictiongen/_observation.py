"""Amplitudes and phases that were measured."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class Observation:
    """Amplitudes and phases of masses at one frequency or several, read from wherever they are: for
    :meth:`System.identify` in place of recordings.

    :param hz: the driving frequencies, Hz.
    :param base: the amplitude of the base motion, m, where the base moves: one, or one for each frequency.
    :param force: the amplitude of the force, N, where a force drives a mass.
    :param amplitude_m: the amplitude of each mass's fundamental, m, by its name.
    :param phase_deg: by how much it lags behind the excitation, degrees.
    :param deviation_m: the standard deviation of each amplitude, m.
    :param phase_deviation_deg: of a phase without an amplitude, degrees.
    :param load_deviation: the standard deviation of the excitation's amplitude, in its unit.

    Deviations are one number for all masses, or one by the name of each.  Either amplitudes or phases may be left out.

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
    ('told', 0.5, True)
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
    """A deviation for all masses, or one of several."""
    return given.get(name) if isinstance(given, Mapping) else given

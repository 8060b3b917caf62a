"""What measurements tell."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from .. import _plot
from .table import Counts, Floats, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._system import System

_Interval = tuple[float, float, float]


class Estimate(NamedTuple):
    """A number with its interval of 95 %, from `low` to `high`, which may be infinite."""

    value: float
    low: float
    high: float

    def holds(self, value: float) -> bool:
        """Whether a number lies within the interval."""
        return self.low <= value <= self.high


def _estimates(found: list[tuple[str, _Interval]]) -> dict[str, Estimate]:
    return {name: Estimate(*interval) for name, interval in found}


class Transmissibilities(Table):
    """Of each recording, a line: the driving `frequency_Hz`, from when on it is steady, the amplitude of the excitation, and
    of each mass `["upper"].transmissibility` (over the excitation: m/m or m/N), `lag_deg`, `deviation` of the
    transmissibility, and `third_harmonic`; NaN where it was not recorded.
    """

    frequency_Hz: Floats
    steady_from_s: Floats

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws them over frequency, each with two deviations.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.transmissibilities(self, ax)


class Identification(Table):
    """The friction force that explains measurements, and each motion beside what the system does with it, a line for each.

    `friction_N` is the force with its interval.  `verdict` says what the measurements tell: not explained (residuals exceed
    the noise, and the force may be far from the rig's), told, several levels (each of `levels` explains them), stuck (any
    force from `friction_N.low` on), not told, all but stuck; `says` is the same as a sentence.  `unknowns` has the other
    unknowns by name, and `undetermined` the names of those that the measurements do not determine: the other results hold at
    any value of these.  `misfit`, the sum of squares of residuals over deviations by the `freedom`, is 1 where noise is all
    that is left, and None without freedom; `is_explained` is whether noise exceeds it more than once in 1000 recordings.
    `condition` is by how much a relative error of the data may grow.  `system` has what was found.
    """

    friction_N: Estimate
    levels: list[Estimate]
    verdict: str
    says: str
    unknowns: dict[str, Estimate]
    undetermined: list[str]
    condition: float
    misfit: float | None
    freedom: int
    is_explained: bool
    #: The description with what was found.
    system: System
    recording: Counts
    frequency_Hz: Floats
    r: Floats
    beta: Floats
    regime: Words
    of: Words
    harmonic: Counts
    amplitude_measured: Floats
    amplitude_computed: Floats
    lag_measured_deg: Floats
    lag_computed_deg: Floats
    residual_over_deviation: Floats
    residual_real: Floats
    residual_imaginary: Floats

    def __init__(self, once: dict[str, Any], columns: dict[str, Any], system: System) -> None:
        super().__init__(columns)
        self.friction_N = Estimate(*once["friction_N"])
        self.levels = [Estimate(*level) for level in once["levels"]]
        self.verdict, self.says = once["verdict"], once["says"]
        self.unknowns = _estimates(once["unknowns"])
        self.undetermined = once["undetermined"]
        self.condition, self.misfit = once["condition"], once["misfit"]
        self.freedom, self.is_explained = once["freedom"], once["is_explained"]
        self.system = system

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the residuals over their deviations, real and imaginary parts, and lines at two deviations.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.residuals(self, ax)

    def __repr__(self) -> str:
        force = self.friction_N
        return f"Identification: {self.verdict}, {force.value:.6g} N, 95 %: {force.low:.6g} to {force.high:.6g} N"


class Fit(Table):
    """What a sweep without friction says of a system, and its points, a line for each, measured less computed in `residual`.

    `reference_Hz` is sqrt(k1/m1)/2pi, `mass_ratios` m/m1 and `stiffness_ratios` k/k1 of the masses and springs from the
    second on, `natural_frequencies_Hz`, `damping` if it was asked for.  `scatter` is the root of the mean square of the
    relative residuals; `misfit` is 1 where noise is all that is left, None where no deviations were given; `is_explained` is
    whether noise exceeds it more than once in 1000 sweeps.  `system` has what was found, its first mass as it was.
    """

    reference_Hz: Estimate
    mass_ratios: dict[str, Estimate]
    stiffness_ratios: dict[str, Estimate]
    damping: Estimate | None
    natural_frequencies_Hz: list[Estimate]
    misfit: float | None
    freedom: int
    is_explained: bool
    scatter: float
    condition: float
    #: The description with what was found.
    system: System
    frequency_Hz: Floats
    of: Words
    transmissibility: Floats
    deviation: Floats
    residual: Floats

    def __init__(self, once: dict[str, Any], columns: dict[str, Any], system: System) -> None:
        super().__init__(columns)
        self.reference_Hz = Estimate(*once["reference_Hz"])
        self.mass_ratios = _estimates(once["mass_ratios"])
        self.stiffness_ratios = _estimates(once["stiffness_ratios"])
        self.damping = None if once["damping"] is None else Estimate(*once["damping"])
        self.natural_frequencies_Hz = [Estimate(*found) for found in once["natural_frequencies_Hz"]]
        self.misfit, self.scatter, self.condition = once["misfit"], once["scatter"], once["condition"]
        self.freedom, self.is_explained = once["freedom"], once["is_explained"]
        self.system = system

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the points beside what the system does without friction.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.fit(self, ax)

    def __repr__(self) -> str:
        natural = ", ".join(f"{found.value:.6g}" for found in self.natural_frequencies_Hz)
        return f"Fit: natural frequencies {natural} Hz"


class FreeDecay(Table):
    """What a free vibration says, and the extremes that were used, a line for each.

    `friction_N`; `length_m`, F/k, half the distance of the two points about which the mass swings; `damping`, whose interval
    is a point where it was known; `frequency_Hz`, the natural frequency without damping; `linear_decrement_m`, F/k as the
    linear decrement has it.  `misfit` is 1 where noise is all that is left.
    """

    friction_N: Estimate
    length_m: Estimate
    damping: Estimate
    frequency_Hz: Estimate
    linear_decrement_m: float
    misfit: float
    time_s: Floats
    displacement_m: Floats

    def __init__(self, once: dict[str, Any], extremes: dict[str, Any]) -> None:
        super().__init__(extremes)
        self.friction_N, self.length_m = Estimate(*once["friction_N"]), Estimate(*once["length_m"])
        self.damping, self.frequency_Hz = Estimate(*once["damping"]), Estimate(*once["frequency_Hz"])
        self.linear_decrement_m, self.misfit = once["linear_decrement_m"], once["misfit"]

    def __repr__(self) -> str:
        force = self.friction_N
        return f"FreeDecay: {force.value:.6g} N, 95 %: {force.low:.6g} to {force.high:.6g} N"

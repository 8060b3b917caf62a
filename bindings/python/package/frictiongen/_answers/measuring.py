"""Answers from measurements."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from .. import _plot
from .table import Counts, Floats, Table, Words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .._system import System

_Interval = tuple[float, float, float]


class Estimate(NamedTuple):
    """A number with its 95 % interval from `low` to `high`, which may be infinite."""

    value: float
    low: float
    high: float

    def holds(self, value: float) -> bool:
        """Returns whether a number lies within the interval."""
        return self.low <= value <= self.high


def _estimates(found: list[tuple[str, _Interval]]) -> dict[str, Estimate]:
    return {name: Estimate(*interval) for name, interval in found}


class Transmissibilities(Table):
    """Transmissibilities found in recordings, one line for each recording.

    * `frequency_Hz`: driving frequency.  `steady_from_s`: start of the steady interval.  The amplitude of the
      excitation follows.
    * `["upper"].transmissibility` of a mass: amplitude over that of the excitation, in m/m or m/N.
    * `["upper"].lag_deg`, `.deviation` (of the transmissibility) and `.third_harmonic`.

    A mass that was not recorded has NaN.
    """

    frequency_Hz: Floats
    steady_from_s: Floats

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws the transmissibilities over frequency, each with error bars of two deviations.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.transmissibilities(self, ax)


class Identification(Table):
    """The friction force that explains measurements, and a line for each motion, measured and computed.

    * `friction_N`: the friction force with its interval.
    * `verdict`: the conclusion.  "determined": the measurements determine the force.  "several levels": each of `levels`
      explains the measurements.  "stuck": any force from `friction_N.low` on explains them.  "not determined": they do
      not determine the force.  "almost stuck": friction almost sticks the contact, or a unit is wrong.  "not
      explained": the residuals exceed the noise, and the force may be far from the rig's.
    * `says`: the verdict as a sentence.
    * `unknowns`: the other unknowns by name.  `undetermined`: the names of those that the measurements do not
      determine.  The other results are valid for any value of these.
    * `misfit`: sum of the squared residuals over their variances, divided by the degrees of `freedom`.  It is about 1
      if only noise is left, and None without degrees of freedom.
    * `is_explained`: whether noise alone exceeds this misfit in more than one of 1000 recordings.
    * `condition`: factor by which a relative error of the data may grow.
    * `system`: the system with the values that were found.
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
    #: The system with the values that were found.
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
        """Draws real and imaginary parts of the residuals over their deviations, with lines at two deviations.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.residuals(self, ax)

    def __repr__(self) -> str:
        force = self.friction_N
        return f"Identification: {self.verdict}, {force.value:.6g} N, 95 %: {force.low:.6g} to {force.high:.6g} N"


class Fit(Table):
    """A system fitted to a sweep without friction, and a line for each point of the sweep.

    * `reference_Hz`: sqrt(k1/m1)/2pi.  `natural_frequencies_Hz`: the natural frequencies.
    * `mass_ratios`, `stiffness_ratios`: m/m1 and k/k1 of the masses and springs from the second on.
    * `damping`: the damping ratio, if it was asked for.
    * `scatter`: root mean square of the relative residuals.
    * `misfit`: sum of the squared residuals over their variances, divided by the degrees of `freedom`.  It is about 1
      if only noise is left, and None if no deviations were given.
    * `is_explained`: whether noise alone exceeds this misfit in more than one of 1000 sweeps.
    * `system`: the system with the values that were found.  Its first mass keeps its value.

    `residual` of a line is the measured less the computed transmissibility.
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
    #: The system with the values that were found.
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
        """Draws the points with the response of the fitted system without friction.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.fit(self, ax)

    def __repr__(self) -> str:
        natural = ", ".join(f"{found.value:.6g}" for found in self.natural_frequencies_Hz)
        return f"Fit: natural frequencies {natural} Hz"


class MotionFit:
    """Friction force and numbers of the description that explain the whole motion in a recording.

    * `friction_N`: the friction force with its interval, or None if it was recorded.
    * `numbers`: the fitted numbers of the description by name.
    * `scatter`: root mean square of the residuals, each divided by the root mean square of its channel.  Above 0.1 the
      description does not explain the recording.
    * `freedom`: number of measured values less that of the unknowns.
    * `condition`: factor by which a relative error of the data may grow.
    * `runs`, `exact_derivatives`: numbers of computed motions, and of those with exact derivatives.  `differences`: number
      of derivatives that are differences of two motions, because the motion grazes an event.
    * `system`: the system with the values that were found.
    """

    friction_N: Estimate | None
    numbers: dict[str, Estimate]
    scatter: float
    freedom: int
    condition: float
    runs: int
    exact_derivatives: int
    differences: int
    #: The system with the values that were found.
    system: System

    def __init__(self, once: dict[str, Any], system: System) -> None:
        self.__dict__.update(once)
        self.friction_N = None if once["friction_N"] is None else Estimate(*once["friction_N"])
        self.numbers = _estimates(once["numbers"])
        self.system = system

    def __repr__(self) -> str:
        named = {"friction": self.friction_N, **self.numbers}
        found = ", ".join(f"{name} {value.value:.6g}" for name, value in named.items() if value is not None)
        return f"MotionFit: {found}, scatter {self.scatter:.3g}"


class FreeDecay(Table):
    """Friction and damping found in a free vibration, and a line for each extreme that was used.

    * `friction_N`: friction force.
    * `length_m`: F/k, half the distance between the two points about which the mass swings.
    * `damping`: damping ratio.  Its interval is a single point if the ratio was given.
    * `frequency_Hz`: natural frequency without damping.
    * `linear_decrement_m`: F/k by the linear decrement.
    * `misfit`: deviation of the residuals over that of the noise.  It is about 1 if only noise is left.
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

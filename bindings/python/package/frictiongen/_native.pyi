"""The compiled module: the functions and classes that `frictiongen.System` calls."""

from typing import Any, final

from numpy import float64
from numpy.typing import NDArray

_Frequency = tuple[Any | None, Any | None, Any | None]
_Friction = tuple[Any | None, Any | None]
_Load = tuple[Any | None, Any | None]
_Driven = tuple[_Load, Any | None]
_Columns = dict[str, Any]
_Beginning = tuple[Any | None, Any | None, Any | None]

__all__ = [
    "DomainError",
    "MeasureError",
    "Recording",
    "SceneError",
    "StepState",
    "System",
    "branch",
    "by_contact",
    "curve",
    "drive",
    "drive_peaks",
    "features",
    "fit",
    "fit_motion",
    "fit_text",
    "free_decay",
    "identify",
    "limit_cycle",
    "limits",
    "map",
    "optimum",
    "orbit",
    "periodic",
    "states",
    "response",
    "response_spectrum",
    "sensitivities",
    "simulate",
    "step",
    "transmissibility",
]

class SceneError(Exception):
    errors: list[Any]

class DomainError(ValueError): ...

class MeasureError(DomainError):
    line: int | None

@final
class StepState: ...

@final
class Recording:
    def __new__(
        cls, channels: list[tuple[str, Any, str | None]], rate: Any | None, times: Any | None, drives: bool
    ) -> Recording: ...
    @staticmethod
    def read(
        text: str, source: str | None, channels: list[tuple[str, str, str | None]], rate: Any | None, drives: bool
    ) -> Recording: ...
    @property
    def rate(self) -> float: ...
    @property
    def uneven_times(self) -> NDArray[float64] | None: ...
    @property
    def channels(self) -> list[tuple[str, str]]: ...
    def samples(self, name: str) -> NDArray[float64]: ...
    def to_csv(self) -> str: ...
    def to_uff58(self) -> str: ...
    def __len__(self) -> int: ...

@final
class System:
    def __new__(cls, text: str) -> System: ...
    @property
    def masses(self) -> list[str]: ...
    @property
    def mass_values(self) -> NDArray[float64]: ...
    @property
    def springs(self) -> list[tuple[str, str, float]]: ...
    @property
    def contact(self) -> tuple[str, str]: ...
    @property
    def contacts(self) -> list[tuple[str, str, str]]: ...
    @property
    def driven_mass(self) -> str | None: ...
    @property
    def is_joined(self) -> bool: ...
    @property
    def natural_frequencies(self) -> NDArray[float64]: ...
    @property
    def resonances(self) -> NDArray[float64]: ...
    @property
    def damping_ratios(self) -> NDArray[float64]: ...
    @property
    def mode_shapes(self) -> NDArray[float64]: ...
    def frequency_ratio_at_hertz(self, hertz: float) -> float: ...
    def hertz(self, r: float) -> float: ...
    def description(self) -> str: ...
    def equals(self, other: System) -> bool: ...
    def with_values(self, values: list[tuple[str, float]]) -> System: ...

def limits(system: System, frequency: _Frequency, load: _Load, estimates: bool, search: bool) -> _Columns: ...
def branch(
    system: System,
    along: tuple[str, tuple[float, float], tuple[Any, bool, Any]],
    frequency: _Frequency,
    friction: _Friction,
    load: _Driven,
    of: Any | None,
) -> tuple[_Columns, _Columns, tuple[str, str]]: ...
def limit_cycle(system: System, friction: Any, start: Any | None, of: Any | None) -> tuple[_Columns, list[float]]: ...
def by_contact(
    system: System, frequency: _Frequency, friction: _Friction, load: _Driven, of: Any | None
) -> _Columns: ...
def response(
    system: System, frequency: _Frequency, friction: _Friction, load: _Driven, of: Any | None, highest: Any | None
) -> _Columns: ...
def orbit(
    system: System, frequency: _Frequency, friction: _Friction, load: _Driven, of: Any | None, highest: Any | None
) -> _Columns: ...
def states(
    system: System, frequency: _Frequency, friction: _Friction, load: _Driven, of: Any | None, highest: Any | None
) -> list[_Columns]: ...
def periodic(
    system: System, load: tuple[Any, Any, bool], friction: Any, of: Any | None, motion: bool
) -> tuple[_Columns, list[_Columns]]: ...
def curve(
    system: System,
    frequency: _Frequency,
    friction: _Friction,
    load: _Driven,
    of: Any | None,
    fineness: tuple[Any | None, Any | None, Any | None, bool, list[str]],
) -> _Columns: ...
def map(
    system: System, frequency: _Frequency, friction: _Friction, load: _Driven, asked: tuple[Any | None, Any | None]
) -> tuple[_Columns, _Columns | None]: ...
def simulate(
    system: System,
    frequency: _Frequency,
    friction: _Friction,
    load: _Load,
    of: Any | None,
    extent: tuple[
        Any | None, Any | None, Any | None, Any | None, tuple[Any | None, list[str]], tuple[bool, bool]
    ],
) -> tuple[_Columns, _Columns, _Columns | None]: ...
def step(
    system: System,
    dt: Any,
    acting: tuple[Any | None, Any | None, Any | None],
    friction: tuple[Any, dict[Any, Any] | None],
    of: Any | None,
    beginning: _Beginning,
) -> _Columns: ...
def drive(
    system: System, driver: Recording | tuple[list[str], Any | None, Any | None], keywords: tuple[Any | None, Any | None, Any | None, Any | None]
) -> _Columns: ...
def drive_peaks(
    system: System, driver: Recording | tuple[list[str], Any | None, Any | None], keywords: tuple[Any | None, Any | None, Any | None, Any | None]
) -> _Columns: ...
def response_spectrum(system: System, recording: Recording, damping: Any) -> _Columns: ...
def optimum(
    system: System,
    of: Any,
    frequency: _Frequency,
    load: _Driven,
    constraints: tuple[tuple[str, float, float] | None, dict[str, float] | None],
) -> tuple[list[_Columns], list[tuple[str, str, dict[str, float]]]]: ...
def sensitivities(
    system: System, of: Any, frequency: _Frequency, friction: _Friction, load: _Load
) -> tuple[str, _Columns]: ...
def features(
    system: System, frequency: _Frequency, friction: _Friction, load: _Load, of: Any | None
) -> dict[str, tuple[_Columns, dict[str, Any]]]: ...
def transmissibility(system: System, recordings: list[Recording]) -> _Columns: ...
def identify(
    system: System,
    items: list[Any],
    of: Any | None,
    asked: tuple[str | None, Any | None, Any | None, Any | None],
) -> tuple[_Columns, _Columns, System]: ...
def fit(
    system: System, hertz: Any, masses: list[tuple[str, Any, Any | None]], gaps: bool, damping: bool
) -> tuple[_Columns, _Columns, System]: ...
def fit_motion(
    system: System, recording: Recording, friction: Any | None, vary: Any | None
) -> tuple[dict[str, Any], System]: ...
def fit_text(system: System, text: str, source: str | None, damping: bool) -> tuple[_Columns, _Columns, System]: ...
def free_decay(
    system: System, recording: Recording, damping: Any | None, find_damping: bool
) -> tuple[_Columns, _Columns]: ...

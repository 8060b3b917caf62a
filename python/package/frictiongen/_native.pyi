"""The compiled part: what `frictiongen.System` calls."""

from typing import Any, final

from numpy import float64
from numpy.typing import NDArray

_Frequency = tuple[Any | None, Any | None, Any | None]
_Friction = tuple[Any | None, Any | None]
_Load = tuple[Any | None, Any | None]
_Columns = dict[str, Any]

__all__ = [
    "DomainError",
    "SceneError",
    "System",
    "curve",
    "limits",
    "map",
    "optimum",
    "orbit",
    "response",
    "sensitivities",
    "simulate",
    "step",
]

class SceneError(Exception):
    errors: list[Any]

class DomainError(ValueError): ...

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
    def driven_mass(self) -> str | None: ...
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

def limits(system: System, frequency: _Frequency, load: _Load, estimates: bool, search: bool) -> _Columns: ...
def response(
    system: System, frequency: _Frequency, friction: _Friction, load: _Load, of: Any | None, highest: Any | None
) -> _Columns: ...
def orbit(
    system: System, frequency: _Frequency, friction: _Friction, load: _Load, of: Any | None, highest: Any | None
) -> _Columns: ...
def curve(
    system: System,
    frequency: _Frequency,
    friction: _Friction,
    load: _Load,
    of: Any | None,
    fineness: tuple[Any | None, Any | None, Any | None, bool],
) -> _Columns: ...
def map(
    system: System, frequency: _Frequency, friction: _Friction, load: _Load, of: Any | None
) -> _Columns: ...
def simulate(
    system: System,
    frequency: _Frequency,
    friction: _Friction,
    load: _Load,
    of: Any | None,
    extent: tuple[Any | None, Any | None, Any | None, tuple[Any, Any] | None, bool],
) -> tuple[_Columns, _Columns]: ...
def step(
    system: System,
    dt: Any,
    acting: tuple[Any | None, Any | None, Any | None],
    friction: Any,
    on: dict[Any, Any] | None,
    of: Any | None,
) -> _Columns: ...
def optimum(system: System, of: Any, frequency: _Frequency, load: _Load) -> list[_Columns]: ...
def sensitivities(
    system: System, of: Any, frequency: _Frequency, friction: _Friction, load: _Load
) -> tuple[str, _Columns]: ...

"""Common base of all answers: numpy arrays with the names of the command line's columns."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pandas import DataFrame

Floats = NDArray[np.float64]
Counts = NDArray[np.int64]
Flags = NDArray[np.bool_]
Words = NDArray[np.str_]

#: Columns that depend on the frequency alone.
_FREQUENCY = ("frequency_Hz", "omega_rad_s", "r")


def frame(columns: dict[str, Any]) -> DataFrame:
    """Returns columns as a pandas frame."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_frame() needs pandas, which is not installed: pip install pandas") from error
    return pandas.DataFrame({name: _cells(values) for name, values in columns.items()})


def joined(tables: dict[str, dict[str, Any]], title: str) -> DataFrame:
    """Returns several tables in one pandas frame, with their names in a column."""
    frames = {name: frame(columns) for name, columns in tables.items()}
    import pandas

    # A table without lines contributes only its columns.
    kept = [whole.assign(**{title: name}) for name, whole in frames.items() if len(whole)]
    known = [title, *dict.fromkeys(name for columns in tables.values() for name in columns)]
    return pandas.concat(kept, ignore_index=True).reindex(columns=known)


def _cells(values: Any) -> Any:
    """Returns values with missing counts, -1, as NaN."""
    values = np.ravel(values)
    if values.dtype.kind == "i" and (values < 0).any():
        return np.where(values < 0, np.nan, values)
    return values


class Columns:
    """Arrays by name, as attributes and as items."""

    def __init__(self, name: str, columns: dict[str, Any]) -> None:
        self._name = name
        self._columns = columns

    def keys(self) -> list[str]:
        """Returns the names of the arrays."""
        return list(self._columns)

    def __getattr__(self, name: str) -> Any:
        columns = self.__dict__.get("_columns", {})
        if name in columns:
            return columns[name]
        raise AttributeError(_missing(self, name, columns))

    def __getitem__(self, name: str) -> Any:
        """Returns an array by its name; `["X3"]` is the third harmonic."""
        return item(self, name, self._columns)

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name in self._columns if "." not in name)]

    def __repr__(self) -> str:
        return f"{type(self).__name__} {self._name!r}: {', '.join(self._columns)}"


class Motion(Columns):
    """Motion of the contact or of a mass: the columns of an answer under its name.

    >>> import frictiongen
    >>> frame = frictiongen.System(frictiongen.FRAME)
    >>> lower = frame.response(r=0.9, beta=0.3, harmonics=3)["lower"]
    >>> lower.keys()[:5]
    ['amplitude', 'centred', 'phase', 'fundamental_phase', 'amplitude_monoharmonic']
    >>> bool(lower["X3"].amplitude < lower.amplitude)
    True
    """

    amplitude: Floats
    amplitude_m: Floats
    centred: Floats
    centred_m: Floats
    phase: Floats
    phase_deg: Floats
    fundamental_phase: Floats
    fundamental_phase_deg: Floats


def _missing(answer: object, name: str, columns: dict[str, Any]) -> str:
    message = f"{type(answer).__name__} has no {name!r}"
    units = [known for known in columns if known.rsplit("_", 1)[0] == name]
    groups = [known for known in columns if name.rsplit("_", 1)[0] == known]
    if units:
        return f"{message}: with a load it is {units[0]!r}"
    if groups:
        return f"{message}: without a load (`force` or `base`) it is {groups[0]!r}"
    return f"{message}; it has {', '.join(columns)}"


def item(answer: object, name: str, columns: dict[str, Any]) -> Any:
    if name in columns:
        return columns[name]
    inner = {known[len(name) + 1 :]: value for known, value in columns.items() if known.startswith(f"{name}.")}
    if not inner:
        raise KeyError(_missing(answer, name, columns))
    return Motion(name, inner)


class Table(Columns):
    """Columns of one length, or single values.  This is the base of every answer."""

    def __init__(self, columns: dict[str, Any]) -> None:
        super().__init__("", columns)

    def to_frame(self) -> DataFrame:
        """Returns a pandas frame with one line for each point and the command line's columns.

        :raises ImportError: if pandas is not installed.
        """
        return frame(self._columns)

    @property
    def motions(self) -> list[str]:
        """Names of the contact and of masses that `answer[name]` takes."""
        return list(dict.fromkeys(name.split(".")[0] for name in self._columns if "." in name))

    def _repr_size(self) -> str:
        first = next(iter(self._columns.values()), np.empty(0))
        return f"{np.size(first)} lines"

    def __repr__(self) -> str:
        names = [name for name in self._columns if "." not in name]
        return f"{type(self).__name__} of {self._repr_size()}: {', '.join([*names, *self.motions])}"


class Grid(Table):
    """Answer over frequencies and frictions.

    Its arrays have the shape of the frequencies followed by that of the frictions.
    """

    r: Floats
    frequency_Hz: Floats
    omega_rad_s: Floats
    beta: Floats
    friction_N: Floats

    #: Columns over frequency alone, which the frame leaves out.
    _beside: tuple[str, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the frequencies, followed by that of the frictions."""
        return np.shape(self.r) + np.shape(self.beta)

    def to_frame(self) -> DataFrame:
        """Returns a pandas frame with one line for each point, first all frictions of the first frequency.

        :raises ImportError: if pandas is not installed.
        """
        frequency = np.shape(self.r) + (1,) * np.ndim(self.beta)
        columns = {}
        for name, values in self._columns.items():
            if name not in self._beside:
                values = np.reshape(values, frequency) if name in _FREQUENCY else values
                columns[name] = np.broadcast_to(values, self.shape)
        return frame(columns)

    def _repr_size(self) -> str:
        return f"shape {self.shape}"

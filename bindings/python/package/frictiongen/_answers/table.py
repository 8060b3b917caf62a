"""Common base of all answers: numpy arrays with the names of the command line's columns."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from pandas import DataFrame
    from xarray import Dataset

Floats = NDArray[np.float64]
Counts = NDArray[np.int64]
Flags = NDArray[np.bool_]
Words = NDArray[np.str_]

#: Columns that depend on the frequency alone.
_FREQUENCY = ("frequency_Hz", "omega_rad_s", "r")
#: Columns that depend on the friction alone.
_FRICTION = ("friction_N", "beta")
#: Units at the end of the names of columns, as xarray has them.  The first that fits holds.
_UNITS = {
    "_rad_s": "rad/s",
    "_m_s2": "m/s2",
    "_m_s": "m/s",
    "_Hz": "Hz",
    "_N": "N",
    "_m": "m",
    "_deg": "degree",
    "_W": "W",
    "_J": "J",
    "_s": "s",
}


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
    """Returns values as a frame holds them: counts as nullable integers, in which a missing count, -1, is `NA`."""
    values = np.ravel(values)
    if values.dtype.kind == "i":
        import pandas

        return pandas.arrays.IntegerArray(values.astype(np.int64), values < 0)
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

    def __eq__(self, other: object) -> bool:
        """Returns whether both have the same type, names and values.  NaN equals NaN."""
        if not isinstance(other, Columns) or type(self) is not type(other):
            return NotImplemented
        return _same(self._compared(), other._compared())

    def _compared(self) -> dict[str, Any]:
        """Returns all values that `==` compares, by name."""
        return vars(self)

    __hash__ = None  # type: ignore[assignment]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name in self._columns if "." not in name)]

    def __repr__(self) -> str:
        return f"{type(self).__name__} {self._name!r}: {', '.join(self._columns)}"


class Motion(Columns):
    """Motion of the contact or of a mass: the columns of an answer under its name.

    >>> import frictiongen
    >>> frame = frictiongen.System(frictiongen.FRAME)
    >>> lower = frame.response(r=0.9, beta=0.3, harmonics=3)["lower"]
    >>> lower.keys()[:4]
    ['amplitude', 'phase', 'fundamental_phase', 'amplitude_monoharmonic']
    >>> bool(lower["X3"].amplitude < lower.amplitude)
    True
    """

    amplitude: Floats
    amplitude_m: Floats
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


def _same(one: Any, other: Any) -> bool:
    """Returns whether two values are the same, also inside dicts and lists."""
    if isinstance(one, dict) and isinstance(other, dict):
        return list(one) == list(other) and all(_same(value, other[name]) for name, value in one.items())
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, (np.ndarray, np.generic, float)):
        return np.array_equal(one, other, equal_nan=np.asarray(one).dtype.kind in "fc")
    return bool(one == other)


def item(answer: object, name: str, columns: dict[str, Any]) -> Any:
    if name in columns:
        return columns[name]
    inner = _inner(columns, name)
    if not inner:
        raise KeyError(_missing(answer, name, columns))
    return Motion(name, inner)


def _inner(columns: dict[str, Any], name: str) -> dict[str, Any]:
    """Returns the columns of one motion, by their names without the motion's."""
    return {known[len(name) + 1 :]: value for known, value in columns.items() if known.startswith(f"{name}.")}


class Table(Columns):
    """Columns of one length, or single values.  This is the base of every answer."""

    def __init__(self, columns: dict[str, Any]) -> None:
        columns = dict(columns)
        #: Names of the contacts among the motions.
        self._contacts: list[str] = columns.pop("contacts", [])
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

    @property
    def masses(self) -> dict[str, Motion]:
        """Motions of the masses by name, as in `answer.masses["lower"].amplitude_m`."""
        names = (name for name in self.motions if name not in self._contacts)
        return {name: Motion(name, _inner(self._columns, name)) for name in names}

    @property
    def contacts(self) -> dict[str, Motion]:
        """Numbers of the contacts by name, as in `answer.contacts["brace"].stuck_fraction`."""
        return {name: Motion(name, _inner(self._columns, name)) for name in self._contacts}

    @property
    def contact(self) -> Motion:
        """Motion of the contact, or of the first one."""
        found: Motion = self[next(iter(self._contacts), "contact")]
        return found

    def _repr_html_(self) -> str:
        """Returns what a notebook shows: the first lines of the frame, or its names where pandas is missing."""
        try:
            whole = self.to_frame()
        except ImportError:
            return f"<pre>{escape(repr(self))}</pre>"
        return str(whole.to_html(max_rows=10, index=False))

    def __len__(self) -> int:
        """Returns the number of lines of the frame."""
        return int(np.size(next(iter(self._columns.values()), np.empty(0))))

    def __bool__(self) -> bool:
        """Returns true, also for an answer without lines."""
        return True

    def _repr_size(self) -> str:
        return f"{len(self)} lines"

    def __repr__(self) -> str:
        names = [name for name in self._columns if "." not in name]
        return f"{type(self).__name__} of {self._repr_size()}: {', '.join([*names, *self.motions])}"


class Single(Table):
    """Answer of one line.  Its values are a Python int, float, bool or str, and lists are arrays."""

    def __init__(self, columns: dict[str, Any]) -> None:
        plain = {name: value.item() if isinstance(value, np.generic) else value for name, value in columns.items()}
        super().__init__(plain)

    def __len__(self) -> int:
        return 1


class Grid(Table):
    """Answer over frequencies and frictions.

    Its arrays have the shape of the frequencies followed by that of the frictions.  Under a load whose amplitude varies
    with frequency, `beta` has this shape too.
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
        return np.shape(self.r) + np.shape(self._friction)

    def __len__(self) -> int:
        """Returns the number of points, which is the number of lines of the frame."""
        return int(np.prod(self.shape))

    @property
    def _friction(self) -> Floats:
        """Frictions as they were given: in N with a load, else ratios."""
        found: Floats = self._columns.get("friction_N", self._columns["beta"])
        return found

    def to_frame(self) -> DataFrame:
        """Returns a pandas frame with one line for each point, first all frictions of the first frequency.

        :raises ImportError: if pandas is not installed.
        """
        frequency = np.shape(self.r) + (1,) * np.ndim(self._friction)
        columns = {}
        for name, values in self._columns.items():
            if name not in self._beside:
                values = np.reshape(values, frequency) if name in _FREQUENCY else values
                columns[name] = np.broadcast_to(values, self.shape)
        return frame(columns)

    def to_xarray(self) -> Dataset:
        """Returns an xarray dataset with the dimensions frequency and friction, as far as these are arrays.

        The coordinates `frequency` and `friction` select points, as in `.sel(frequency=2.5, method="nearest")`.  They are
        in rad/s if frequencies were given so, or else in Hz, and in N; without units, they are ratios.  `r`, `beta` and
        the other columns of frequency and friction are coordinates, too.  Units are attributes.

        :raises ImportError: if xarray is not installed.

        >>> import frictiongen
        >>> frame = frictiongen.System(frictiongen.FRAME)
        >>> answer = frame.response(hz=[1.0, 2.5], friction=[0.4, 0.6, 1.0], base=0.001).to_xarray()
        >>> dict(answer.sizes), answer["lower.amplitude_m"].dims
        ({'frequency': 2, 'friction': 3}, ('frequency', 'friction'))
        >>> str(answer.regime.sel(frequency=2.5, friction=1.0).values)
        'stuck'
        """
        try:
            import xarray
        except ImportError as error:
            raise ImportError("to_xarray() needs xarray, which is not installed: pip install xarray") from error
        both = ("frequency",) * np.ndim(self.r) + ("friction",) * np.ndim(self._friction)
        variables = {}
        for name, values in self._columns.items():
            if name in _FREQUENCY or name in self._beside:
                dimensions = both[: np.ndim(self.r)]
            elif name in _FRICTION and np.shape(values) == np.shape(self._friction):
                dimensions = both[np.ndim(self.r) :]
            else:
                dimensions = both
            unit = next((unit for tail, unit in _UNITS.items() if name.endswith(tail)), None)
            variables[name] = (dimensions, np.asarray(values), {} if unit is None else {"units": unit})
        given = [*_FREQUENCY, *_FRICTION]
        coordinates = {name: variables.pop(name) for name in given if name in variables}
        for dimension, names in (("frequency", ("omega_rad_s", *_FREQUENCY)), ("friction", _FRICTION)):
            own = (coordinates[name] for name in names if name in coordinates)
            label = next((entry for entry in own if entry[0] == (dimension,)), None)
            if label is not None:
                coordinates[dimension] = label
        return xarray.Dataset(variables, coordinates)

    def _repr_size(self) -> str:
        return f"shape {self.shape}"

"""Recordings: samples of several channels, each with a unit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _native, _plot
from ._answers.table import Floats, frame
from ._files import File, name_of, text_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import ArrayLike
    from pandas import DataFrame


class Recording:
    """Samples of the excitation and of masses.  Each channel has a unit.

    :param channels: samples and unit of each channel, by the channel's name: `base`, `force` or the name of a mass.
        Units are m, cm, mm, um, m/s, mm/s, m/s2, cm/s2, mm/s2, in/s2, ft/s2, g, Gal, N, mN, kN.  Displacements,
        velocities and accelerations may be mixed.
    :param rate: sampling rate, Hz.
    :param time_s: time of each sample, s, evenly spaced, instead of `rate`.  With `drives` the steps may differ.
    :param drives: whether the channels are inputs of :meth:`System.drive`.  Then one channel is enough, and it may be
        constant.
    :raises MeasureError: for a channel without a unit, too few samples, numbers that are not finite, a channel that is
        constant or clipped, and uneven times.

    >>> import frictiongen, numpy
    >>> t = numpy.arange(5000) / 500
    >>> base, plate = 1.75 * numpy.cos(25 * t), 3.5 * numpy.cos(25 * t - 0.3)
    >>> frictiongen.Recording({"base": (base, "mm"), "plate": (plate, "mm")}, time_s=t)
    Recording of 5000 samples at 500 Hz: base (mm), plate (mm)
    >>> try:
    ...     frictiongen.Recording({"base": base}, rate=500)
    ... except frictiongen.MeasureError as error:
    ...     print(error)
    the channel `base` has no unit: give one, as in {"base": (samples, "mm")}, or of a column of a file {"base": ("COLUMN", "mm")}
    """

    __slots__ = ("_native",)

    _native: _native.Recording

    def __init__(
        self,
        channels: Mapping[str, tuple[ArrayLike, str]],
        *,
        rate: float | None = None,
        time_s: ArrayLike | None = None,
        drives: bool = False,
    ) -> None:
        if not isinstance(channels, Mapping):
            raise TypeError(
                f"channels by their names are needed, {{name: (samples, unit)}}, not {type(channels).__name__}"
            )
        listed = [(_name(name), *_with_unit(given)) for name, given in channels.items()]
        self._native = _native.Recording(listed, rate, time_s, bool(drives))

    @classmethod
    def from_file(
        cls,
        file: File,
        *,
        channels: Mapping[str, str | int | tuple[str | int, str]] | None = None,
        rate: float | None = None,
        drives: bool = False,
    ) -> Recording:
        """Reads a recording from a CSV or a universal file (UFF58, text).

        The first line of a CSV has the names of the columns.  The units are part of the names, as in
        `time_s,base_mm,upper_m_s2`, or in a second line.

        :param file: a path, or a file opened for reading text.
        :param channels: columns to read, by the name of the channel.  Each is the column's name or its number from 1,
            with its unit if the file does not contain it: `{"upper": ("AI1", "mm")}`.  By default all columns are read
            under their own names.
        :param rate: samples per second, if no column has the time.
        :raises OSError: if the file cannot be read.
        :raises MeasureError: if a line is wrong, with its number in `line`, or if the recording cannot be used.
        """
        return cls.from_text(text_of(file), channels=channels, rate=rate, drives=drives, source=name_of(file))

    @classmethod
    def from_text(
        cls,
        text: str,
        *,
        channels: Mapping[str, str | int | tuple[str | int, str]] | None = None,
        rate: float | None = None,
        drives: bool = False,
        source: str | None = None,
    ) -> Recording:
        """Reads a recording from the text of a file.  `source` is the name of the file in messages.

        >>> import frictiongen
        >>> text = "t;AI1;AI2\\n" + "".join(f"{n};{n % 7};{n % 5}\\n" for n in range(40))
        >>> columns = {"time": ("t", "ms"), "base": ("AI1", "mm"), "upper": (3, "m/s2")}
        >>> frictiongen.Recording.from_text(text, channels=columns)
        Recording of 40 samples at 1000 Hz: base (mm), upper (m/s2)
        """
        if not isinstance(text, str):
            raise TypeError(f"a text is needed, not {type(text).__name__}; a file is read by Recording.from_file(path)")
        if channels is not None and not isinstance(channels, Mapping):
            raise TypeError("channels: columns by the names of channels are needed, {name: (column, unit)}")
        columns = []
        for name, given in (channels or {}).items():
            column, unit = _with_unit(given)
            if not isinstance(column, (str, int)) or isinstance(column, bool):
                raise TypeError(f"channels[{name!r}]: the name or the number of a column is needed")
            columns.append((_name(name), str(column), unit))
        recording = cls.__new__(cls)
        recording._native = _native.Recording.read(text, source, columns, rate, bool(drives))
        return recording

    @property
    def rate(self) -> float:
        """Sampling rate, Hz.  With uneven times, it is that of the shortest step."""
        return self._native.rate

    @property
    def time_s(self) -> Floats:
        """Time of each sample in s, from 0."""
        uneven = self._native.uneven_times
        return np.arange(len(self)) / self.rate if uneven is None else uneven

    @property
    def units(self) -> dict[str, str]:
        """Unit of each channel, by the channel's name."""
        return dict(self._native.channels)

    def keys(self) -> list[str]:
        """Returns the names of the channels."""
        return list(self.units)

    def __getitem__(self, name: str) -> Floats:
        """Returns the samples of a channel, in its unit."""
        if name not in self.units:
            raise KeyError(f"there is no channel {name!r}; there are {', '.join(self.units)}")
        return self._native.samples(name)

    def __len__(self) -> int:
        return len(self._native)

    def __repr__(self) -> str:
        channels = ", ".join(f"{name} ({unit})" for name, unit in self.units.items())
        return f"Recording of {len(self)} samples at {self.rate:.6g} Hz: {channels}"

    def to_csv(self) -> str:
        """Returns a CSV that :meth:`from_text` reads back, every number with all its digits."""
        return self._native.to_csv()

    def to_uff58(self) -> str:
        """Returns a universal file, with 13 digits of each number."""
        return self._native.to_uff58()

    def to_frame(self) -> DataFrame:
        """Returns a pandas frame, with the units in the names.

        :raises ImportError: if pandas is not installed.
        """
        columns = {f"{name} ({unit})": self[name] for name, unit in self.units.items()}
        return frame({"time_s": self.time_s, **columns})

    def plot(self, ax: Axes | None = None) -> Axes:
        """Draws all channels over time, in their units.

        :raises ImportError: if matplotlib is not installed.
        """
        return _plot.recording(self, ax)


def _name(name: Any) -> str:
    if not isinstance(name, str):
        raise TypeError(f"the name of a channel is a text, not {type(name).__name__}")
    return name


def _with_unit(given: Any) -> tuple[Any, str | None]:
    """Splits a value from its unit, if it has one."""
    if isinstance(given, tuple) and len(given) == 2 and isinstance(given[1], str):
        return given
    return given, None

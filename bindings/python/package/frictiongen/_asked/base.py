"""Base class for the groups of methods."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from .. import _native

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .. import _native as compiled
    from .._system import System


class Base:
    """Base class of a system.  It contains the system of the compiled module."""

    __slots__ = ("_native",)

    _native: compiled.System

    @classmethod
    def _of(cls, native: compiled.System) -> System:
        """Returns a `System` for an existing object of the compiled module."""
        raise NotImplementedError


def names(of: str | Iterable[str] | None, argument: str = "of") -> str | list[str] | None:
    """Returns names as the compiled module expects them: one text, a list, or `None`."""
    if of is None or isinstance(of, str):
        return of
    try:
        return list(of)
    except TypeError:
        raise TypeError(f"{argument}: a name or a list of names is needed") from None


def state(start: str | tuple[ArrayLike, ArrayLike] | None) -> str | tuple[ArrayLike, ArrayLike] | None:
    """Returns an initial state as the compiled module expects it: a text, two rows, or `None`."""
    if start is None or isinstance(start, str):
        return start
    try:
        displacements, velocities = start
    except (TypeError, ValueError):
        raise _native.DomainError(
            "start: two rows are needed, the displacements of all masses and their velocities"
        ) from None
    return displacements, velocities

"""Common base of the groups of methods."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .. import _native as compiled
    from .._system import System


class Base:
    """A system with its compiled counterpart."""

    __slots__ = ("_native",)

    _native: compiled.System

    @classmethod
    def _of(cls, native: compiled.System) -> System:
        """Wraps a compiled system that exists already."""
        raise NotImplementedError


def names(of: str | Iterable[str] | None, argument: str = "of") -> str | list[str] | None:
    """Returns names in the form that the compiled module takes."""
    if of is None or isinstance(of, str):
        return of
    try:
        return list(of)
    except TypeError:
        raise TypeError(f"{argument}: a name or a list of names is needed") from None

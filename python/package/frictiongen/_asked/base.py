"""What all questions have in common."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .. import _native as compiled
    from .._system import System


class Base:
    """The compiled system that is asked."""

    __slots__ = ("_native",)

    _native: compiled.System

    @classmethod
    def _of(cls, native: compiled.System) -> System:
        """A system that is there already."""
        raise NotImplementedError


def names(of: str | Iterable[str] | None, argument: str = "of") -> str | list[str] | None:
    """Names as the compiled part takes them; what is no iterable is its to refuse."""
    if of is None or isinstance(of, str):
        return of
    try:
        return list(of)
    except TypeError:
        raise TypeError(f"{argument}: a name or a list of names is needed") from None

"""Writes descriptions from Python values."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from numbers import Real
from typing import cast

from ._native import DomainError

#: Damping: a ratio of all modes, a ratio of each mode, or `{"a": ..., "b": ...}` for C = aM + bK.
Damping = float | Sequence[float] | Mapping[str, float]


def described(
    name: str,
    masses: Mapping[str, float],
    springs: Mapping[str, float],
    contact: str,
    excitation: str,
    damping: Damping | None,
    **fields: float | str | None,
) -> str:
    """Returns the description of a scene.  `fields` are further fields; those with the value `None` are left out."""
    lines = {
        "masses": _braced("masses", masses),
        "springs": _braced("springs", springs),
        "contact": _nodes("contact", contact),
        "excitation": _nodes("excitation", excitation),
    }
    if damping is not None:
        lines["damping"] = _damping(damping)
    for field, value in fields.items():
        if value is not None:
            lines[field] = value if isinstance(value, str) else number(field, value)
    body = "".join(f"    {field}: {value},\n" for field, value in lines.items())
    return f"struct {_nodes('name', name)} {{\n{body}}}\n"


def number(argument: str, value: object) -> str:
    """Returns a number as a description writes it, with all its digits."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise TypeError(f"{argument}: a number is needed, not {type(value).__name__}")
    value = float(value)
    if value != value or value in (float("inf"), -float("inf")):
        raise DomainError(f"{argument} is {value}: a finite number is needed")
    return repr(value)


def _braced(argument: str, values: Mapping[str, float]) -> str:
    if not isinstance(values, Mapping):
        raise TypeError(f"{argument}: numbers by their names are needed, {{name: number}}, not {type(values).__name__}")
    entries = (f"{_nodes(argument, name)}: {number(f'{argument}[{name!r}]', value)}" for name, value in values.items())
    return f"{{ {', '.join(entries)} }}"


def _nodes(argument: str, text: str) -> str:
    """Returns the name of a node, or two names with a hyphen between them."""
    if not isinstance(text, str):
        raise TypeError(f"{argument}: a name is needed, not {type(text).__name__}")
    names = [name.strip() for name in text.split("-")]
    # Other characters could end the field and begin another one.
    if not all(name.isidentifier() for name in names):
        raise DomainError(f"{argument}: {text!r} is no name; names have letters, digits and _, as in 'base - lower'")
    return " - ".join(names)


def _damping(given: Damping) -> str:
    if isinstance(given, Mapping):
        if set(given) != {"a", "b"}:
            raise DomainError("damping: give both factors of C = aM + bK, {'a': ..., 'b': ...}")
        return f"rayleigh({number('damping[a]', given['a'])}, {number('damping[b]', given['b'])})"
    if isinstance(given, Real):
        return f"modal({number('damping', given)})"
    if isinstance(given, str):
        raise TypeError("damping: a ratio, a list of ratios or the factors {'a': ..., 'b': ...} are needed, not str")
    ratios = (number(f"damping[{mode}]", ratio) for mode, ratio in enumerate(cast("Sequence[float]", given)))
    return f"modal[{', '.join(ratios)}]"

"""Reads texts from files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import IO

#: A path, or a file opened for reading text.
File = str | os.PathLike[str] | IO[str]


def text_of(file: File) -> str:
    """Reads the text of a file.

    :raises OSError: if the file cannot be read.
    """
    if isinstance(file, (str, os.PathLike)):
        return Path(file).read_text(encoding="utf-8")
    if not hasattr(file, "read"):
        raise TypeError(f"a path or an open file is needed, not {type(file).__name__}")
    text = file.read()
    if not isinstance(text, str):
        raise TypeError("the file is open for bytes: open it as text")
    return text


def name_of(file: File) -> str | None:
    """Returns the name of a file for messages, if the file has a name."""
    if isinstance(file, (str, os.PathLike)):
        return os.fspath(file)
    name = getattr(file, "name", None)
    return name if isinstance(name, str) else None

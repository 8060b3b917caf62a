"""Tests that the Python code of the pages in docs runs unchanged."""

import doctest
import os
import re
import subprocess
from pathlib import Path

import pytest

from conftest import SCENES

DOCS = Path(__file__).resolve().parents[3] / "docs"


def run(page):
    failed, tried = doctest.testfile(str(DOCS / page), module_relative=False, encoding="utf-8")
    assert tried > 5 and failed == 0, f"{failed} of {tried}"


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Changes to an empty folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_start(folder):
    run("start.md")
    assert (folder / "curve.png").stat().st_size > 1000


def test_guide(folder):
    """Checks that pandas reads the files that the commands above the code write."""
    pytest.importorskip("pandas")
    program = os.environ.get("FRICTIONGEN")
    if program is None:
        pytest.skip("FRICTIONGEN does not say where the command is; scripts/python sets it")
    (folder / "frame.friction").write_text((SCENES / "frame.friction").read_text(encoding="utf-8"), encoding="utf-8")
    text = (DOCS / "guide.md").read_text(encoding="utf-8")
    commands = re.findall(r"^frictiongen (.* -o curve\.(?:csv|json))$", text, re.MULTILINE)
    assert len(commands) == 2
    for command in commands:
        subprocess.run([program, *command.split()], check=True)
    run("guide.md")

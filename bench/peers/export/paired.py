"""Simulates the FMU of two contacts under a recording, and compares it with the recorded results, bit for bit.

    paired.py pair.fmu recording.csv

`src/bin/paired.rs` prints the recording.
"""

import csv
import sys

from fmpy import extract, read_model_description
from fmpy.validation import validate_fmu
from recorded import DISCARD, Unit, bits, refused

INPUTS = 4


def main():
    path, recorded = sys.argv[1:]
    problems = validate_fmu(path)
    assert not problems, problems
    description, folder = read_model_description(path), extract(path)
    with open(recorded) as file:
        [names, *rows] = csv.reader(file)
    unit, other = (Unit(folder, description) for _ in range(2))
    for one in (unit, other):
        one.fmu.exitInitializationMode()
    half = len(rows) // 2
    for index, row in enumerate(rows):
        if index == half:
            # The state continues in another instance.
            state = unit.fmu.getFMUState()
            data = unit.fmu.serializeFMUState(state)
            unit.fmu.freeFMUState(state)
            state = other.fmu.deserializeFMUState(data)
            other.fmu.setFMUState(state)
            other.time, unit = other.get("time"), other
        values = [float(value) for value in row]
        for name, value in zip(names[:INPUTS], values):
            unit.set(name, value)
        unit.step()
        for name, value in zip(names[INPUTS:], values[INPUTS:]):
            found = unit.get(name)
            assert bits(found) == bits(value), f"row {index}: {name} is {found!r}, in Rust {value!r}"
        for contact in ("brace", "pads"):
            assert unit.get(f"{contact}.sticks") == (unit.get(f"{contact}.direction") == 0)
    refused(lambda: unit.set("pads.friction", -1.0), DISCARD, "pads.friction is -1.0", "at least 0")
    refused(lambda: unit.set("brace.stiction", 0.5), DISCARD, "brace.stiction is 0.5", "at least 1")
    print(f"pair: FMPy simulates {len(rows)} steps of two contacts with the same bits as Rust")


main()

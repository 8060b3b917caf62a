"""Simulates an FMU with FMPy under a recording, and compares it with the recorded results, bit for bit.

    recorded.py SCENE.fmu recording.csv

`src/bin/recorded.rs` prints the recording.
"""

import csv
import math
import struct
import sys

import numpy
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi3 import FMU3Slave, fmi3LogMessageCallback
from fmpy.validation import validate_fmu

DISCARD, ERROR = 2, 3
INTEGERS = {"Boolean", "Int32", "UInt64"}


class Unit:
    """An instance with its variables by name."""

    told = []

    def __init__(self, folder, description, start=(), early_return=False):
        self.variables = {variable.name: variable for variable in description.modelVariables}
        self.step_size = float(description.defaultExperiment.stepSize)
        self.fmu = FMU3Slave(
            guid=description.guid,
            unzipDirectory=folder,
            modelIdentifier=description.coSimulation.modelIdentifier,
            instanceName="unit",
        )
        self.fmu.instantiate(earlyReturnAllowed=early_return, logMessage=LOGGER)
        self.time = 0.0
        for name, value in start:
            self.set(name, value)
        self.fmu.enterInitializationMode()

    def set(self, name, value):
        self.fmu.setFloat64([self.variables[name].valueReference], [value])

    def get(self, name):
        variable = self.variables[name]
        read = getattr(self.fmu, f"get{variable.type}")
        return read([variable.valueReference])[0]

    def step(self, steps=1):
        """Takes steps in one call. Returns false unless the FMU has returned early."""
        event, terminates, early, self.time = self.fmu.doStep(self.time, steps * self.step_size)
        assert not (event or terminates)
        return early

    def bytes(self):
        state = self.fmu.getFMUState()
        found = self.fmu.serializeFMUState(state)
        self.fmu.freeFMUState(state)
        return found

    def close(self):
        self.fmu.terminate()
        self.fmu.freeInstance()


def log(environment, status, category, message):
    Unit.told.append((status, category.decode(), message.decode()))


LOGGER = fmi3LogMessageCallback(log)


def bits(value):
    return struct.pack("<d", value)


def refused(call, status, *words):
    """Fails unless the call gives this status and a message with these words."""
    Unit.told.clear()
    try:
        call()
    except FMICallException as error:
        assert error.status == status, f"status {error.status}, not {status}: {Unit.told}"
    else:
        raise AssertionError(f"a call succeeded; it should say {words}")
    [(logged, category, message)] = Unit.told
    assert logged == status and category == ("logStatusDiscard" if status == DISCARD else "logStatusError")
    assert all(word in message for word in words), message


class Recording:
    """Names and values of a recording. The first row is the start, each further row one step."""

    def __init__(self, path):
        with open(path) as file:
            [self.names, *rows] = csv.reader(file)
        self.rows = [[float(value) for value in row] for row in rows]
        self.inputs = self.names[: self.names.index("friction") + 1]
        self.outputs = self.names[len(self.inputs):]

    def apply(self, unit, row):
        for name, value in zip(self.inputs, self.rows[row]):
            unit.set(name, value)

    def compare(self, unit, row):
        for name, value in zip(self.outputs, self.rows[row][len(self.inputs):]):
            found = unit.get(name)
            assert bits(found) == bits(value), f"row {row}: {name} is {found!r}, in Rust {value!r}"

    def run(self, units, first, last):
        """Takes the steps of these rows in all units alternately."""
        for row in range(first, last):
            for unit in units:
                self.apply(unit, row)
                unit.step()
                self.compare(unit, row)


def initial(description):
    """Initial displacements and velocities of `src/bin/recorded.rs`."""
    for variable in description.modelVariables:
        [mass, *rest] = variable.name.split(".")
        if rest and rest[0].startswith("initial_"):
            value = 1e-3 * len(mass)
            # The scene of single precision rounds the same product.
            single = float(numpy.float32(1e-3) * numpy.float32(len(mass)))
            yield variable.name, single if description.modelName == "Pushed" else value


def errors(unit, recording):
    """Bad calls between two steps change nothing."""
    before = unit.bytes()
    name = recording.inputs[0]
    for value in [math.nan, math.inf, -math.inf]:
        refused(lambda: unit.set(name, value), DISCARD, name, "give a finite number")
    refused(lambda: unit.set("friction", -1.0), DISCARD, "friction is -1.0", "at least 0")
    refused(lambda: unit.set("stiction", 0.5), DISCARD, "stiction is 0.5", "at least 1")
    references = [unit.variables[of].valueReference for of in (name, "friction")]
    refused(lambda: unit.fmu.setFloat64(references, [1e-9, math.nan]), DISCARD, "friction is NaN")
    output = unit.variables["contact.force"].valueReference
    refused(lambda: unit.fmu.setFloat64([output], [1.0]), ERROR, "cannot be set")
    refused(lambda: unit.fmu.getFloat64([10_000]), ERROR, "10000")
    refused(lambda: unit.fmu.getBoolean([output]), ERROR, "not that of a variable of this type")
    refused(lambda: unit.fmu.getInt8([output]), ERROR, "not that of a variable of this type")
    [start] = [of for of in unit.variables if of.endswith("initial_velocity")][:1]
    refused(lambda: unit.set(start, 0.0), ERROR, start, "mode Step")
    for length in [0.5, 1.5, 0.0, -1.0, math.nan]:
        refused(lambda: unit.fmu.doStep(unit.time, length * unit.step_size), ERROR, "multiple of the step")
    refused(lambda: unit.fmu.doStep(unit.time + unit.step_size, unit.step_size), ERROR, "communication point")
    refused(lambda: unit.fmu.exitInitializationMode(), ERROR, "fmi3ExitInitializationMode is not allowed")
    refused(lambda: unit.fmu.enterEventMode(), ERROR, "fmi3EnterEventMode")
    assert unit.bytes() == before, "a refused call changed the state"
    # A number whose square overflows is finite, and only the step can refuse it.
    old = unit.get(name)
    unit.set(name, 1e300 if DOUBLE else 1e30)
    time = unit.get("time")
    refused(unit.step, DISCARD, name)
    refused(lambda: unit.step(3), DISCARD, name)
    unit.set(name, old)
    assert unit.get("time") == time and unit.bytes() == before, "a refused step changed the state"


def saved(unit, fresh, recording, middle, end):
    """A state continues with the same bits in its own instance and in another instance."""
    state = unit.fmu.getFMUState()
    data = unit.fmu.serializeFMUState(state)
    recording.run([unit], middle, end)
    unit.fmu.setFMUState(state)
    unit.time = unit.get("time")
    recording.compare(unit, middle - 1)
    recording.run([unit], middle, end)
    unit.fmu.freeFMUState(state)
    before = fresh.bytes()
    for place in range(0, len(data), 7):
        changed = bytearray(data)
        changed[place] ^= 1 << place % 8
        refused(lambda: fresh.fmu.deserializeFMUState(bytes(changed)), ERROR, "a bit has changed")
    refused(lambda: fresh.fmu.deserializeFMUState(data[:-1]), ERROR, f"a state has {len(data)}")
    assert fresh.bytes() == before, "a damaged state changed the instance"
    state = fresh.fmu.deserializeFMUState(data)
    fresh.fmu.setFMUState(state)
    fresh.fmu.freeFMUState(state)
    assert fresh.bytes() == data
    fresh.time = fresh.get("time")
    recording.run([fresh], middle, end)


def between(recording, hold, step_size, steps):
    """Inputs of the steps in a call over several steps, from the second row of the recording to the third."""
    last = [recording.rows[1][place] for place in range(len(recording.inputs))]
    new = [recording.rows[2][place] for place in range(len(recording.inputs))]
    length = steps * step_size
    for step in range(1, steps + 1):
        s = step / steps
        sample = list(new) if hold else [a + (b - a) * s for a, b in zip(last, new)]
        sample[-1] = new[-1]
        if not hold and recording.inputs[0] == "base.displacement":
            (y0, v0), (y1, v1) = last[:2], new[:2]
            # The cubic of Hermite, by its four base functions and their derivatives.
            functions = [(1 + 2 * s) * (1 - s) ** 2, s * (1 - s) ** 2, s * s * (3 - 2 * s), s * s * (s - 1)]
            slopes = [6 * s * s - 6 * s, 3 * s * s - 4 * s + 1, 6 * s - 6 * s * s, 3 * s * s - 2 * s]
            ends = [y0, v0 * length, y1, v1 * length]
            sample[0] = sum(a * b for a, b in zip(functions, ends))
            sample[1] = sum(a * b for a, b in zip(slopes, ends)) / length
        yield dict(zip(recording.inputs, sample))


def several_steps(one, other, recording, samples):
    """A call over several steps gives the results of one call for each step with the inputs between the samples. If
    the FMU returns early, the last step before its return is the first with an event. Returns the number of steps."""
    for unit in (one, other):
        recording.apply(unit, 1)
        unit.fmu.exitInitializationMode()
    recording.apply(one, 2)
    early = one.step(len(samples))
    taken = round(one.time / one.step_size)
    assert early == (taken < len(samples))
    events = 0
    for sample in samples[:taken]:
        assert not (early and events), "the FMU passed an event before it returned early"
        for name, value in sample.items():
            other.set(name, value)
        other.step()
        events += other.get("contact.events")
    assert events == one.get("contact.events")
    assert events or not early, "the FMU returned early without an event"
    for name in recording.outputs:
        if one.variables[name].type == "Float64":
            a, b = one.get(name), other.get(name)
            # The samples differ by a few roundings: of f64, or of f32 where the scene computes in it.
            assert abs(a - b) <= (1e-10 if DOUBLE else 1e-4) * max(abs(b), 1e-6), f"{name}: {a!r}, {b!r}"
    return taken


def instants(path, start, samples, outputs):
    """With early return, FMPy's loop records the end of each step with events, and the instant is within this step.
    Returns the numbers of instants and of early returns."""
    description = read_model_description(path)
    step = float(description.defaultExperiment.stepSize)
    result = simulate_fmu(
        path, input=samples, output=outputs, start_values=dict(start), output_interval=8 * step,
        stop_time=(len(samples) // 8) * 8 * step, early_return_allowed=True,
    )
    found, early = 0, 0
    for before, row in zip(result, result[1:]):
        # Only an early return ends between two multiples of the communication step.
        is_early = round(row["time"] / step) % 8 != 0
        assert not is_early or row["contact.events"], "the FMU returned early without an event"
        early += is_early
        if row["contact.events"]:
            since = row["contact.last_event_time"] - (row["time"] - step)
            # A rounding of the time decides at the ends of the step.
            assert -1e-9 * row["time"] <= since <= step + 1e-9 * row["time"], f"{since} s after the start of a step"
            found += 1
        else:
            assert row["contact.last_event_time"] == before["contact.last_event_time"]
    assert 0 < early <= found, (early, found)
    return found, early


def main():
    path, recorded = sys.argv[1:]
    problems = validate_fmu(path)
    assert not problems, problems
    description, folder = read_model_description(path), extract(path)
    global DOUBLE
    DOUBLE = description.modelName != "Pushed"
    recording = Recording(recorded)
    start = list(initial(description))
    end = len(recording.rows)
    middle = end // 2

    # Two instances take their steps alternately.
    units = [Unit(folder, description, start) for _ in range(2)]
    for unit in units:
        recording.apply(unit, 0)
        recording.compare(unit, 0)
        refused(unit.step, ERROR, "fmi3DoStep is not allowed")
        unit.fmu.exitInitializationMode()
        recording.compare(unit, 0)
    recording.run(units, 1, middle)
    errors(units[0], recording)
    saved(units[0], units[1], recording, middle, end)
    # After a reset the whole run repeats with the same results.
    units[0].fmu.reset()
    for name, value in start:
        units[0].set(name, value)
    units[0].fmu.enterInitializationMode()
    recording.apply(units[0], 0)
    units[0].fmu.exitInitializationMode()
    units[0].time = 0.0
    recording.run(units[:1], 1, middle)
    for unit in units:
        unit.close()

    hold, step = description.modelName == "Held", float(description.defaultExperiment.stepSize)
    for early_return, steps in [(False, 3), (True, 3), (True, 1000)]:
        pair = [Unit(folder, description, start, early) for early in (early_return, False)]
        taken = several_steps(*pair, recording, list(between(recording, hold, step, steps)))
        assert taken == steps or early_return
        for unit in pair:
            unit.close()
    other = read_model_description(path)
    other.guid = "of another scene"
    Unit.told.clear()
    try:
        Unit(folder, other)
    except Exception:
        assert "of another scene" in Unit.told[0][2], Unit.told
    else:
        raise AssertionError("another instantiation token was accepted")

    # FMPy's own loop sets the sample of a step at its start.
    columns = [("time", float), *((name, float) for name in recording.inputs)]
    samples = [(row * step, *values[: len(recording.inputs)]) for row, values in enumerate(recording.rows[1:])]
    samples = numpy.array(samples, dtype=columns)
    result = simulate_fmu(
        path,
        input=samples,
        output=recording.outputs,
        start_values=dict(start),
        output_interval=step,
        stop_time=(end - 1) * step,
    )
    assert len(result) == end, (len(result), end)
    for row, values in zip(result, recording.rows):
        for name, value in zip(recording.outputs, values[len(recording.inputs):]):
            assert bits(row[name]) == bits(value), f"simulate_fmu at {row['time']} s: {name} is {row[name]!r}, in Rust {value!r}"
    found, early = instants(path, start, samples, recording.outputs)
    print(
        f"{description.modelName}: no message of the validator; {end - 1} steps by two instances and by simulate_fmu, "
        f"{len(recording.outputs)} outputs each with the bits of Rust; {early} early returns, {found} instants of events; "
        "saved, restored and refused as stated"
    )


if __name__ == "__main__":
    main()

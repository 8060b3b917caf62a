"""Tests that other threads run while an answer is computed, and that Ctrl-C ends the computation."""

import os
import signal
import threading
import time

import frictiongen
import numpy as np
import pytest


def test_another_thread_runs_while_a_map_is_computed(frame):
    """Checks that a counter in another thread runs during a map.  If the map held Python's lock, the counter would
    stand still."""
    counted = []
    done = threading.Event()

    def count():
        while not done.is_set():
            counted.append(time.perf_counter())
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    frame.map(r=np.linspace(0.1, 2.5, 200), beta=np.linspace(0.01, 1.5, 200))
    end = time.perf_counter()
    done.set()
    thread.join()
    meanwhile = [instant for instant in counted if start + 0.1 * (end - start) < instant < end - 0.1 * (end - start)]
    assert end - start > 0.02
    # The counter must reach at least a twentieth of the count of an idle machine.
    assert len(meanwhile) > 0.8 * (end - start) / 0.001 / 20


def test_many_threads_ask_one_system(frame):
    expected = frame.response(r=[0.4, 0.9], beta=[0.2, 0.8])["lower"].amplitude
    found = []

    def ask():
        found.append(frame.response(r=[0.4, 0.9], beta=[0.2, 0.8])["lower"].amplitude)

    threads = [threading.Thread(target=ask) for _ in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 16 and all((amplitude == expected).all() for amplitude in found)


@pytest.fixture
def ctrl_c():
    """Handles Ctrl-C as in a terminal, because a background process ignores it at first."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="there are no signals to threads here")
def test_an_interrupt_ends_a_long_map(frame, ctrl_c):
    """Checks that an interrupt ends a map of a million points, which would take many seconds."""
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        frame.map(r=np.linspace(0.1, 2.5, 2000), beta=np.linspace(0.01, 1.5, 2000))
    assert time.perf_counter() - start < 5.0


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="there are no signals to threads here")
def test_an_interrupt_ends_a_search(ctrl_c):
    """Checks that an interrupt ends a search for the best friction and spring, which would take several seconds."""
    masses = ", ".join(f"m{i}: 1" for i in range(6))
    springs = ", ".join(["base - m0: 1"] + [f"m{i} - m{i + 1}: 1" for i in range(5)])
    tower = frictiongen.System(
        f"struct Tower {{ masses: {{ {masses} }}, springs: {{ {springs} }}, contact: m5 - wall, excitation: base,"
        " damping: modal(0.01), stiction: 1.2 }"
    )
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        tower.optimum("m5", r=(0.1, 2.2), vary=("k m0 - m1", 1.0, 2.0))
    assert time.perf_counter() - start < 5.0
    # A search for several quantities consists of several searches, and an interrupt must end the whole search.
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        tower.optimum({"m5": 5.0, "accel(m4)": 3.0, "shear": 2.0}, r=(0.1, 2.2))
    assert time.perf_counter() - start < 5.0


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="there are no signals to threads here")
def test_an_interrupt_leaves_a_single_run(frame, ctrl_c):
    """Checks that an interrupt ends the wait for one run of 10⁷ cycles, which takes many seconds."""
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        frame.simulate(r=0.9, beta=0.4, skip=10_000_000)
    assert time.perf_counter() - start < 1.3
    # The thread of the first run has no effect on later calls.
    assert frame.orbit(r=0.9, beta=0.4) is not None


@pytest.mark.skipif(not hasattr(signal, "pthread_kill"), reason="there are no signals to threads here")
@pytest.mark.parametrize("question", ["by_contact", "drive"])
def test_an_interrupt_ends_a_question_about_several_contacts(frame, ctrl_c, question):
    """Checks that an interrupt ends a grid of many points and a motion of many samples, which take many seconds."""
    recording = frictiongen.Recording({"base": (np.sin(0.05 * np.arange(3_000_000)), "m/s2")}, rate=1000, drives=True)
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        if question == "drive":
            frame.drive(recording, friction=[0.4, 0.8, 1.2], peaks=True)
        else:
            frame.by_contact(r=np.linspace(0.1, 2.5, 500), beta=np.linspace(0.01, 1.5, 500))
    assert time.perf_counter() - start < 5.0

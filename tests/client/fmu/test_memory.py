"""Tests that many steps leave no memory behind."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

CONTACT = {"grid.nx": 7, "grid.ny": 7, "grid.dx": 2.0, "grid.dy": 2.0}
WHEEL = {"elements.dx": 1.0, "elements.dy": 1.0, "model": 2}


def resident_bytes():
    return 1024 * int(re.search(r"^VmRSS:\s+(\d+) kB", Path("/proc/self/status").read_text(), re.MULTILINE)[1])


def run(fmu, steps, vary):
    """Makes steps, every tenth of them reset once, like masters."""
    for k in range(steps):
        state = fmu.slave.getFMUState() if k % 10 == 0 else None
        for _ in range(2 if state else 1):
            fmu.set(vary(k))
            fmu.slave.doStep(fmu.time, 1e-3)
            if state:
                fmu.slave.setFMUState(state)
        if state:
            fmu.slave.freeFMUState(state)
        fmu.time += 1e-3


def of_contact(k):
    return {"motion.xi": 1e-4 * (k % 17), "load.Fn": 40e3 + 100 * (k % 13)}


def of_wheel(k):
    return {"position.y": 0.05 * (k % 40), "load.Fz": 60e3 + 100 * (k % 13)}


@pytest.mark.slow  # eleven thousand steps
@pytest.mark.timeout(300)
@pytest.mark.parametrize(("kind", "values", "vary"), [("contact", CONTACT, of_contact), ("wheel", WHEEL, of_wheel)])
def test_ten_thousand_steps_leave_memory_flat(contact, wheel, kind, values, vary):
    fmu = {"contact": contact, "wheel": wheel}[kind]().start(values)
    run(fmu, 1000, vary)
    before = resident_bytes()
    run(fmu, 10_000, vary)
    assert resident_bytes() - before < 2 << 20


def test_instances_that_come_and_go_leave_memory_flat(contact):
    fmu = contact().start(CONTACT)

    def again(times):
        for _ in range(times):
            fmu.slave.reset()
            fmu.time = 0
            fmu.start(CONTACT).step()

    again(50)
    before = resident_bytes()
    again(200)
    assert resident_bytes() - before < 4 << 20

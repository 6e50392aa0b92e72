"""Tests FMUs whose contacts a daemon solves."""

from __future__ import annotations

import signal

import pytest

from support.daemons import eventually

SMALL = {"grid.nx": 15, "grid.ny": 15}
COARSE = {"elements.dx": 0.5, "elements.dy": 0.5, "model": 2}


@pytest.mark.parametrize("parameters", [SMALL, {"model": 2}], ids=["full", "fastsim"])
def test_a_contact_has_the_same_answers_there_to_the_last_bit(contact, shared_daemon, parameters):
    there = contact(name="there").start({**parameters, "endpoint": shared_daemon.endpoint})
    here = contact(name="here").start(parameters)
    for k in range(4):
        assert there.step({"motion.xi": 5e-4 * k}) == here.step({"motion.xi": 5e-4 * k})
    state = there.slave.getFMUState()
    later = there.step({"motion.xi": 3e-3})
    there.slave.setFMUState(state)
    assert there.step({"motion.xi": 3e-3}) == later
    assert there.derivatives(["Fx"], "motion.xi") == here_derivatives(here)


def here_derivatives(fmu):
    fmu.step({"motion.xi": 3e-3})
    return fmu.derivatives(["Fx"], "motion.xi")


def test_a_wheel_has_the_same_answers_there_to_the_last_bit(wheel, shared_daemon):
    there = wheel(name="there").start({**COARSE, "endpoint": shared_daemon.endpoint})
    here = wheel(name="here").start(COARSE)
    for y in (0.0, 2.0):
        assert there.step({"position.y": y}) == here.step({"position.y": y})


def test_nobody_listens(contact, wheel, tmp_path):
    from fmpy.fmi1 import FMICallException

    for fmu in (contact(), wheel()):
        fmu.enter({"endpoint": f"ipc://{tmp_path}/nobody", "limits.connect": 0.2})
        with pytest.raises(FMICallException):
            fmu.slave.exitInitializationMode()
        assert "No daemon is listening" in fmu.log[-1][2]


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGSTOP], ids=["killed", "stopped"])
@pytest.mark.parametrize("kind", ["contact", "wheel"])
def test_a_daemon_that_goes_in_mid_run_is_an_error_and_a_sentence(contact, wheel, daemons, kind, end):
    """It must end within the limit, and so must freeing the instance."""
    from fmpy.fmi1 import FMICallException

    fmu = {"contact": contact, "wheel": wheel}[kind]()
    daemon = daemons.start()
    limits = {"limits.step": 4.0, "limits.connect": 1.0}
    fmu.start({**(SMALL if kind == "contact" else COARSE), **limits, "endpoint": daemon.endpoint})
    before = fmu.step()
    daemon.process.send_signal(end)
    with pytest.raises(FMICallException) as caught:
        fmu.step()
    assert caught.value.status == 3
    assert fmu.log[-1][:2] == (3, "errors")
    assert len(fmu.log[-1][2]) > 20
    assert fmu.outputs() == before
    fmu.slave.reset()
    if end == signal.SIGSTOP:
        daemon.process.send_signal(signal.SIGCONT)
    else:
        daemon.process.wait()


def test_a_daemon_that_comes_back_serves_after_a_reset(contact, daemons):
    from fmpy.fmi1 import FMICallException

    daemon = daemons.start("again")
    fmu = contact().start({**SMALL, "endpoint": daemon.endpoint, "limits.step": 5.0})
    before = fmu.step()
    daemon.kill()
    daemons.start("again")
    with pytest.raises(FMICallException):
        fmu.step()
    fmu.slave.reset()
    fmu.time = 0
    assert fmu.start({**SMALL, "endpoint": daemon.endpoint}).step() == before


def test_an_instance_that_is_given_back_leaves_no_session(contact, daemons):
    daemon = daemons.start()
    fmu = contact().start({**SMALL, "endpoint": daemon.endpoint})
    fmu.step()
    with daemon.client() as client:
        assert len(client.sessions()) == 1
        fmu.slave.reset()
        eventually(lambda: not client.sessions())


def test_a_step_beyond_its_limit_ends(contact):
    """It must be solved in process, where no machine solves a contact of 300 x 300 elements within 2 ms."""
    from fmpy.fmi1 import FMICallException

    fmu = contact()
    with pytest.raises(FMICallException):
        fmu.start({"grid.nx": 300, "grid.ny": 300, "grid.dx": 0.05, "grid.dy": 0.05, "limits.step": 0.002})
        fmu.step({"motion.xi": 1e-3})
    assert any("0.002" in text or "2 ms" in text for _, _, text in fmu.log), fmu.log


def test_a_wheel_goes_on_when_its_daemon_is_back(wheel, daemons):
    daemon = daemons.start("again")
    fmu = wheel().start({**COARSE, "endpoint": daemon.endpoint, "limits.step": 20.0})
    before = fmu.step({"position.y": 1.0})
    daemon.kill()
    daemons.start("again")
    assert fmu.step({"position.y": 1.0}) == before

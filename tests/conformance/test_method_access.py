"""Tests methods and builds that are disabled, or restricted to other users."""

from conformance.requests import QUICK_BUILD, TABLE
from conformance.wire import OK, UNIMPLEMENTED

PERMISSION_DENIED = 7


def test_what_the_configuration_keeps_from_a_user_is_told_apart(start):
    rules = {"disabled": ["ic.delete"], "allowed_users": {"ic.list": [], "builds": []}}
    with start(methods=rules).peer() as peer:
        reply = peer.ask("ic.delete", {"key": "0" * 64})
        assert (reply.code, reply.reason) == (UNIMPLEMENTED, "METHOD_DISABLED")
        reply = peer.ask("ic.list")
        assert (reply.code, reply.reason) == (PERMISSION_DENIED, "METHOD_DENIED")
        reply = peer.ask("ic.get", QUICK_BUILD)
        assert (reply.code, reply.reason) == (PERMISSION_DENIED, "BUILD_DENIED")
        assert peer.ask("ic.get", TABLE).code == OK

"""What a client can be asked, said once for the client that waits (Client) and the one that awaits (AsyncClient)."""

from __future__ import annotations

from .asking import Awaits, Waits
from .contact import ContactCalls, solved, solved_many
from .server import ServerCalls
from .sessions import SessionCalls
from .tables import TableCalls
from .wheel_rail import WheelRailCalls

__all__ = [
    "Awaits",
    "ContactCalls",
    "ServerCalls",
    "SessionCalls",
    "TableCalls",
    "Waits",
    "WheelRailCalls",
    "solved",
    "solved_many",
]

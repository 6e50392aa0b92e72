"""Scales the timeouts of tests."""

from __future__ import annotations

import os

#: The factor by which timeouts are longer if the programs are slow, as with sanitizers.
SLOWER = int(os.environ.get("CONTACTD_SLOWER", "1"))

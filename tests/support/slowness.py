"""How long tests wait."""

from __future__ import annotations

import os

#: How much longer everything may take where the programs are slow, as with sanitizers.
SLOWER = int(os.environ.get("CONTACTD_SLOWER", "1"))

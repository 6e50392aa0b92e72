"""Tables of creep forces: their nodes, solved in rows that are resumed and shared as those of studies, and their check."""

from __future__ import annotations

__all__: list[str] = []

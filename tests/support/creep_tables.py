"""Tables of creep forces that were not solved."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

RATIOS, CELLS = (0.5, 2.0), (4, 8, 4, 8)


def invented_table(folder: Path, nu: tuple[float, ...] = (0.28,)) -> Path:
    """Writes a table of the creepages divided by 1 and their length. Skips the test without contactd_local."""
    local = pytest.importorskip("contactd_local")
    path, nodes = folder / "invented.creep", []
    for ratio in nu:
        for row in range(len(local.creep_table_rows(RATIOS, CELLS)) // 8):
            creepages = np.frombuffer(local.creep_table_row(RATIOS, CELLS, ratio, row)[1]).reshape(-1, 3)
            nodes.append(creepages / (1 + np.linalg.norm(creepages, axis=1))[:, None])
    local.write_creep_table(RATIOS, CELLS, str(path), np.array(nu).tobytes(), np.concatenate(nodes).tobytes(), b'{"statement": null}')
    return path

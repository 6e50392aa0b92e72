"""Runs the examples of guides with the installed package: test_guides.py GUIDE...

A guide is a page (.md), whose examples use the client of a private daemon, or a notebook (.ipynb), which creates its
own.
"""

from __future__ import annotations

import json
import re
import runpy
import sys
from pathlib import Path
from typing import Any

import contactd


def examples(guide: Path) -> list[str]:
    if guide.suffix == ".md":
        return re.findall(r"^```python\n(.*?)^```", guide.read_text(), re.MULTILINE | re.DOTALL)
    cells = json.loads(guide.read_text())["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def run(guide: Path, **names: Any) -> dict[str, Any]:
    for example in examples(guide):
        exec(compile(example, f"{guide.name}: {example.splitlines()[0]}", "exec"), names)
    return names


def run_page(guide: Path) -> None:
    runpy.run_path("/srv/support/contact_hertz.py")["write_case"](Path())  # contains files that an example reads
    with contactd.LocalDaemon() as daemon, daemon.client() as client:
        names = run(guide, client=client)
        table, solution = names["table"], names["solution"]
        assert table.to_xarray().sel(displacement="z", load="z")[0, 0].item() == table["zz"][0, 0]
        assert solution.to_xarray().pressure.max().item() == solution.pmax
        assert client.solve(names["wheel"], progress=True).Fn == solution.Fn


for guide in map(Path, sys.argv[1:]):
    assert guide.parents[1] not in Path(contactd.__file__).parents, f"{contactd.__file__} is that of the sources"
    run_page(guide) if guide.suffix == ".md" else run(guide)
    print(f"wheel test: {len(examples(guide))} examples of {guide.name} ran")

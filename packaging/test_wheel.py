"""Runs the examples of a guide with the package that is installed, at a private daemon: test_wheel.py GUIDE."""

import re
import sys
from pathlib import Path

import contactd

guide = Path(sys.argv[1])
assert guide.parents[1] not in Path(contactd.__file__).parents, f"{contactd.__file__} is that of the sources"
with contactd.local() as client:
    names = {"client": client}
    for example in re.findall(r"^```python\n(.*?)^```", guide.read_text(), re.MULTILINE | re.DOTALL):
        exec(compile(example, f"{guide.name}: {example.splitlines()[0]}", "exec"), names)
    table, solution = names["table"], names["solution"]
    assert abs(table.to_xarray().sel(displacement="z", load="z")[0, 0].item() - table["zz"][0, 0]) == 0
    assert solution.to_xarray().pressure.max().item() == solution.pmax
    assert client.solve(names["wheel"], progress=True).Fn == solution.Fn
print(f"the examples of {guide.name} ran with {contactd.__file__}")

"""Runs an SSP archive by libcosim (PACKAGES ARCHIVE STEP SECONDS). Prints the last body.y and right.pmax as JSON after
the word values, among the output of libcosim."""

import json
import sys

sys.path.append(sys.argv[1])
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver

archive, step, seconds = sys.argv[2], float(sys.argv[3]), float(sys.argv[4])
nanoseconds = 1_000_000_000
execution = CosimExecution.from_ssp_file(ssp_path=archive, step_size=round(step * nanoseconds))
observer = CosimObserver.create_last_value()
assert execution.add_observer(observer)
assert execution.step(step_count=round(seconds / step))
values = {}
for name in ("body.y", "right.pmax"):
    component, _, variable = name.partition(".")
    slave = execution.slave_index_from_instance_name(component)
    (reference,) = [found.reference for found in execution.slave_variables(slave) if found.name.decode() == variable]
    (values[name],) = observer.last_real_values(slave, [reference])
print("values", json.dumps(values))

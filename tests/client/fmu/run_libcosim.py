"""Makes one step of an FMU by libcosim (PACKAGES ARCHIVE VALUES REFERENCES). Prints the reals of the references as
JSON after the word values, among the output of libcosim.

VALUES is a list of [type, reference, value].
"""

import json
import sys

sys.path.append(sys.argv[1])
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

archive, values, references = sys.argv[2], json.loads(sys.argv[3]), json.loads(sys.argv[4])
execution = CosimExecution.from_step_size(step_size=1_000_000)
fmu = CosimLocalSlave(fmu_path=archive, instance_name="one")
slave = execution.add_local_slave(fmu)
for kind, reference, value in values:
    name = {"Real": "real", "Integer": "integer", "Boolean": "boolean", "String": "string"}[kind]
    assert getattr(execution, f"{name}_initial_value")(slave, reference, value)
observer = CosimObserver.create_last_value()
assert execution.add_observer(observer)
assert execution.step(step_count=1)
print("values", json.dumps(observer.last_real_values(slave, references)))

"""Makes one step of an FMU by fmuloader (PACKAGES ARCHIVE KIND TOKEN VALUES REFERENCES), like run_libcosim.py."""

import json
import sys

sys.path.append(sys.argv[1])
from fmuloader.fmi3 import Fmi3Slave

archive, kind, token = sys.argv[2:5]
values, references = json.loads(sys.argv[5]), json.loads(sys.argv[6])
slave = Fmi3Slave(archive, model_identifier=kind)
slave.instantiate_co_simulation("one", instantiation_token=token)
for of, reference, value in values:
    name = {"Enumeration": "int64"}.get(of, of.lower())
    getattr(slave, f"set_{name}")([reference], [value])
slave.enter_initialization_mode(start_time=0.0)
slave.exit_initialization_mode()
slave.do_step(0.0, 0.001)
print("values", json.dumps(slave.get_float64(references)))
slave.terminate()
slave.free_instance()

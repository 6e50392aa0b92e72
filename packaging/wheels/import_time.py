"""Prints the processor time of `import contactd` in a separate process, including the interpreter: the minimum of five."""

import resource
import subprocess
import sys


def seconds(statement: str) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", statement], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


for statement in ("import contactd", "import contactd_local"):
    print(f"wheel test: {statement}: {min(seconds(statement) for _ in range(5)):.3f} s of processor time")

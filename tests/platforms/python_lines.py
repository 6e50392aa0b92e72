"""Prints results of the cases of tests/congruence in the process of Python: python_lines.py contacts|wheels CASES.

The numbers are those of platform_cases.py's programs, with all digits. It needs tests/ and contactd on Python's path.
"""

from __future__ import annotations

import sys
from pathlib import Path

import contactd
from congruence.driver import answers
from congruence.wheel_driver import wheel_answers

if __name__ == "__main__":
    of = {"contacts": answers, "wheels": wheel_answers}[sys.argv[1]]
    with contactd.local(in_process=True) as client:
        for line in of(client, Path(sys.argv[2])):
            sys.stdout.buffer.write(f"{line}\n".encode())

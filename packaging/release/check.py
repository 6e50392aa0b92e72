#!/usr/bin/env python3
"""Checks a folder of release files: python3 check.py FOLDER SIGNERS [NAME].

SIGNERS is a file of allowed signers in the format of ssh; NAME is the required signer (contactd-release). The check passes
if the signature of SHA256SUMS is valid, SHA256SUMS lists every other file, and the sums agree. The exit code is then 0;
otherwise it is 1, and the reasons are printed.
"""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import sys
from pathlib import Path

__all__ = ["problems"]

SUMS, SIGNATURE, NAMESPACE = "SHA256SUMS", "SHA256SUMS.sig", "contactd-release"


def problems(folder: Path, signers: Path, name: str = NAMESPACE) -> list[str]:
    """Returns the defects of the folder; empty if it is unchanged since it was signed."""
    sums, signature = folder / SUMS, folder / SIGNATURE
    if not folder.is_dir():
        return [f"{folder} is not a folder"]
    if not signers.is_file():
        return [f"{signers} is not a file; it must list signers, with lines such as: {name} ssh-ed25519 AAAA..."]
    if shutil.which("ssh-keygen") is None:
        return ["ssh-keygen, which checks signatures, is missing; install the client of OpenSSH"]
    for file in (sums, signature):
        if not file.is_file():
            return [f"{file.name} is missing: these files are not signed"]
    command = ["ssh-keygen", "-Y", "verify", "-f", str(signers), "-I", name, "-n", NAMESPACE, "-s", str(signature)]
    verified = subprocess.run(command, input=sums.read_bytes(), capture_output=True, check=False)
    if verified.returncode != 0:
        return [f"{SIGNATURE} is not a signature of {name} for this {SUMS}"]
    listed = dict(reversed(line.split("  ", 1)) for line in sums.read_text().splitlines())
    found = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()} - {SUMS, SIGNATURE}
    wrong = [f"{file} is not listed in {SUMS}" for file in sorted(found - listed.keys())]
    wrong += [f"{file} is missing" for file in sorted(listed.keys() - found)]
    return wrong + [
        f"{file} has been altered"
        for file in sorted(found & listed.keys())
        if hashlib.sha256((folder / file).read_bytes()).hexdigest() != listed[file]
    ]


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    wrong = problems(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
    print("\n".join(wrong) or "All files are as they were signed.")
    sys.exit(1 if wrong else 0)

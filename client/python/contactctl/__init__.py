"""contactctl: contactd from a terminal and from scripts (docs/contactctl.md).

Commands send requests to the daemon with the names of the wire (docs/protocol.md), which are also those of input files.
Results are tables on standard output, or one JSON document with --json. Progress bars, warnings and errors go to
standard error. `codes` lists the exit codes.
"""

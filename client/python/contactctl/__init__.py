"""contactctl: contactd from a terminal and from scripts (docs/contactctl.md).

Commands ask the daemon in the words of the wire (docs/protocol.md), which are also those of the files they read. Tables are
for people and go to standard output; with --json that is one JSON document instead. All else, bars, warnings and errors, goes
to standard error. `codes` lists the exit codes.
"""

"""What bodies by their cross-section change: the numbers and figures of docs/sections.md."""

"""Writes files in the formats of the CONTACT program."""

"""Converts solutions of contactd to the results of the CONTACT program."""

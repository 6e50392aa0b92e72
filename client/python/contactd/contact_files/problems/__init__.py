"""Converts cases to problems of contactd by the conventions of the CONTACT program."""

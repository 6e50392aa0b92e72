"""Cases as problems of contactd, by the conventions of the CONTACT program."""

"""Cases of the CONTACT program's input files: computed by threads, kept in a journal, compared and written."""

"""Cases of the CONTACT program's input files: computed in threads, recorded in a journal, compared and written."""

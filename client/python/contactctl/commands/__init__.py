"""Contains the commands, one module for each family; `add_to` adds them to the program."""

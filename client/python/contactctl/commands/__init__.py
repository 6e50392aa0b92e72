"""The commands, a module each family; `add_to` puts them into the program."""

"""A page in the browser that shows what a daemon does: a client of it like any other, in a process of its own.

`Watcher` asks the daemon and knows nothing of pages; `pages` show what it has heard, by NiceGUI; `serving` runs both.
"""

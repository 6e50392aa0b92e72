"""Serves a browser page that shows the activity of a daemon. It is an ordinary client in a separate process.

`Watcher` queries the daemon independently of pages, `pages` shows its data with NiceGUI, and `serving` runs both.
"""

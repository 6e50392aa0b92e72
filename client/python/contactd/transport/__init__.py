"""Transports requests: sockets, messages, keys, a private daemon, the engine in this process."""

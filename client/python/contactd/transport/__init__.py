"""How a request reaches whoever answers it: sockets, messages, keys, a private daemon, the engine in this process."""

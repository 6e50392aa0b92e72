"""Calls of a client, written once for the client that waits (Client) and the one that awaits (AsyncClient)."""

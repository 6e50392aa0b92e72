"""Calls of a client, written once for the blocking client (Client) and the asyncio client (AsyncClient)."""

"""What a client can be asked, said once for the client that waits (Client) and the one that awaits (AsyncClient)."""

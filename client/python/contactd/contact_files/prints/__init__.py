"""Files as the CONTACT program writes them."""

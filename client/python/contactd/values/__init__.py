"""Values that users build and receive, plain and immutable, and their forms on the wire."""

"""What users build and receive, as plain, immutable values, and what they are on the wire."""

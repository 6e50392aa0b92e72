"""Defines immutable values that users create and receive, and their forms on the wire."""

"""The steps, the oldest first; one that was released never changes."""

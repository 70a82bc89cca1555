"""The search for homes once more, in Python and as plainly as can be: what the core's answers are held to."""

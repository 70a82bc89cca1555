"""Requests of those who want the service to work: what the worst costs, and that none is answered by a fault."""

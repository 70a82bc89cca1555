"""The vocabulary as Python asks for it: where a relation holds that somebody asks for, and whether it does.

What each means is said once, by its class in solver/core/furnish/relations. Comes in: a piece that seeks its place, or a finished room.
May import: catalogs, the ground floor. Not here: making candidates of it (furnish), choosing among them (placement).
"""

"""What the service keeps: homes, their versions and pictures, and long work; in an SQLite file, or in PostgreSQL.

Comes in: owners, names, bytes. Goes out: rows. `database` opens and brings up to date; `saved_homes` asks. May import: errors, refusals.
"""

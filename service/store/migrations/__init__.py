"""How the tables came to be, step by step, for alembic: `database` runs what a store lacks when it is opened."""

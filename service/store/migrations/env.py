"""What alembic runs: the steps that a store lacks, over the connection that it is handed."""

from alembic import context

from service.store.database import TABLES

context.configure(connection=context.config.attributes["connection"], target_metadata=TABLES)
with context.begin_transaction():
    context.run_migrations()

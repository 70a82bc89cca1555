"""How `/fix` repairs generated homes in which pieces were thrown about."""

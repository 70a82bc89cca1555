"""`python -m compose_homes` is `compose`."""

import sys

from service.cli import main

if __name__ == "__main__":
    sys.exit(main())

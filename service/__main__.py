"""`python -m service` is `compose`."""

import sys

from service.cli import main

if __name__ == "__main__":
    sys.exit(main())

"""``python -m urdfkit``."""

import sys

from urdfkit.cli import main

if __name__ == "__main__":
    sys.exit(main())

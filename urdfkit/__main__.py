"""``python -m urdfkit``."""

from __future__ import annotations

import sys

from urdfkit.cli import main

if __name__ == "__main__":
    sys.exit(main())

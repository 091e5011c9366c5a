"""``python -m fuzz HARNESS [--executions N] [--seed S] [--found DIR]``."""

import argparse
import hashlib
import os
import resource
import sys
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # processes are forked
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
os.environ["URDFKIT_CACHE_DIR"] = ""

from fuzz.execution import fuzz
from fuzz.harnesses import HARNESSES


def main() -> int:
    """Fuzz, and print what is found."""
    parser = argparse.ArgumentParser(prog="python -m fuzz", description=__doc__)
    parser.add_argument("harness", choices=[*HARNESSES, "all"])
    parser.add_argument("--executions", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--found", type=Path, help="directory for inputs that show a defect")
    options = parser.parse_args()
    count = 0
    for name in HARNESSES if options.harness == "all" else [options.harness]:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        for defect in fuzz(name, options.executions, options.seed):
            count += 1
            print(f"{name}: {defect.title}\n{defect.details}", flush=True)
            if options.found is not None:
                folder = options.found.resolve() / name
                folder.mkdir(parents=True, exist_ok=True)
                digest = hashlib.sha256(defect.data).hexdigest()[:12]
                (folder / digest).write_bytes(defect.data)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(f"{name}: {options.executions} executions, {seconds:.0f} s", flush=True)
    print(f"{count} kinds of defects")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())

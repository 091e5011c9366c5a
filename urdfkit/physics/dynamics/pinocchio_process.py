"""Pinocchio's URDF parser in a separate process: ``python pinocchio_process.py < robot.urdf``.

The parser may crash on malicious text, and writes its messages to standard error. The process
prints one line of JSON: ``{"error": reason}``, with an empty reason for a valid robot.
"""

import json
import os
import sys

#: Limits of CPU time in seconds and memory in bytes; real robots need a tenth of a second.
SECONDS, MEMORY = 20, 4 * 2**30


def main() -> None:
    """Parse standard input and print the result."""
    _limit_resources()
    import pinocchio as pin

    text = sys.stdin.buffer.read().decode("utf-8", "replace")
    reason = ""
    try:
        pin.buildModelFromXML(text, pin.JointModelFreeFlyer())
    except (ValueError, RuntimeError, MemoryError) as error:
        reason = f"{error}" or type(error).__name__
    print(json.dumps({"error": reason}))


def _limit_resources() -> None:
    """Limit the effect of malicious text to this process."""
    try:
        import resource
    except ImportError:  # Windows, where Pinocchio is not available either
        return
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    sys.path[:] = [path for path in sys.path if os.path.abspath(path or ".") != here]
    main()

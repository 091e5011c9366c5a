"""What stands at the end of the help of a command."""

from __future__ import annotations


def examples(*lines: str) -> str:
    """Command lines as a list, which click leaves as it is."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)

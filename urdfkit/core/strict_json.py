"""JSON for programs: what any reader takes, however odd the numbers of a robot are."""

import json
from math import isfinite
from typing import Any


def dumped(document: object) -> str:
    """A document of plain values; numbers that JSON has not, such as NaN, are null."""
    try:
        text = json.dumps(document, ensure_ascii=False, indent=2, allow_nan=False)
    except ValueError:
        text = json.dumps(finite(document), ensure_ascii=False, indent=2)
    return text + "\n"


def finite(value: Any) -> Any:
    """A plain value of which JSON can hold every number; those of a hostile robot overflow."""
    if isinstance(value, float):
        return value if isfinite(value) else None
    if isinstance(value, dict):
        return {key: finite(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [finite(one) for one in value]
    return value

"""Strict JSON, without NaN and infinity, whatever numbers a robot contains."""

import json
from math import isfinite
from typing import Any


def dumped(document: object) -> str:
    """Serialise plain values; numbers that are not finite become null."""
    try:
        text = json.dumps(document, ensure_ascii=False, indent=2, allow_nan=False)
    except ValueError:
        text = json.dumps(finite(document), ensure_ascii=False, indent=2)
    return text + "\n"


def finite(value: Any) -> Any:
    """A plain value with None for numbers that are not finite."""
    if isinstance(value, float):
        return value if isfinite(value) else None
    if isinstance(value, dict):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return value

"""JSON that any reader takes."""

import json
from math import inf, nan

from urdfkit.core.strict_json import dumped


def strictly(text: str) -> object:
    def refuse(word: str) -> None:
        raise AssertionError(word)

    return json.loads(text, parse_constant=refuse)


def test_plain_values_are_what_they_were() -> None:
    document = {"a": [1, 2.5, None, True, "µ"], "b": {"c": (-0.0, 1e300)}}
    assert strictly(dumped(document)) == {"a": [1, 2.5, None, True, "µ"], "b": {"c": [-0.0, 1e300]}}
    assert dumped({"µ": 1}) == '{\n  "µ": 1\n}\n'


def test_what_json_has_no_number_for_is_null() -> None:
    document = {"a": nan, "b": [inf, {"c": (-inf, 1.5)}]}
    assert strictly(dumped(document)) == {"a": None, "b": [None, {"c": [None, 1.5]}]}

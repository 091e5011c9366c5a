"""LAU046: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import messages

POLYGON = (
    "collision_monitor: {{ros__parameters: {{observation_sources: [scan], polygons: [near], "
    "near: {{{}}}}}}}\n"
)
SQUARE = "points: '[[1, 1], [1, -1], [-1, -1], [-1, 1]]'"
MUX = "twist_mux: {{ros__parameters: {{topics: {{joy: {{{}}}}}, use_stamped: true}}}}\n"


@pytest.mark.parametrize(
    ("polygon", "words"),
    [
        (f"type: polygon, {SQUARE}", []),
        ("type: polygon, polygon_sub_topic: shape", []),
        ("type: polygon, action_type: approach", []),
        ("type: polygon, action_type: stop", ["no points"]),
        ("type: polygon, points: '[[1, 1], [1, -1], [-1, -1]]'", ["3 points"]),
        ("type: polygon, points: $(var points)", []),
        ("type: circle, radius: 0.3", []),
        ("type: circle", ["no radius"]),
        ("type: velocity_polygon, velocity_polygons: [slow]", []),
        (f"type: velocity_polygon, {SQUARE}", ["no velocity_polygons"]),
        ("enabled: true", []),
    ],
)
def test_polygons(tmp_path: Path, polygon: str, words: list[str]) -> None:
    node = 'package="nav2_collision_monitor", executable="collision_monitor", '
    node += 'parameters=["../a.yaml"]'
    found = messages("LAU046", tmp_path, POLYGON.format(polygon), node, '"collision_monitor"')
    assert [word in one for word, one in zip(words, found, strict=True)] == [True] * len(words)


@pytest.mark.parametrize(
    ("values", "count"),
    [
        ("topic: joy, timeout: 0.5, priority: 1", 0),
        ("topic: joy, timeout: 1.0", 1),
    ],
)
def test_inputs_of_twist_mux(tmp_path: Path, values: str, count: int) -> None:
    assert len(messages("LAU046", tmp_path, MUX.format(values))) == count

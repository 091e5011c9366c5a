"""LAU041: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import (
    messages,
)
from tests.launched import reported

VALID = {
    "image": "hall.pgm",
    "resolution": "0.05",
    "origin": "[0.0, 0.0, 0.0]",
    "negate": "0",
    "occupied_thresh": "0.65",
    "free_thresh": "0.25",
}


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("resolution", "0.05", ""),
        ("resolution", "0.05m", "resolution '0.05m'"),
        ("resolution", "-0.05", "is negative"),
        ("resolution", None, "no resolution"),
        ("origin", "[0.0, 0.0]", "origin has 2 values"),
        ("mode", "trinary", ""),
        ("mode", "trinery", "mean 'trinary'?"),
        ("occupied_thresh", "65", "occupied_thresh is 65, above 1"),
        ("free_thresh", "0.7", "free_thresh 0.7 is above occupied_thresh 0.65"),
        ("negate", None, "no negate"),
    ],
)
def test_maps(tmp_path: Path, key: str, value: str | None, words: str) -> None:
    values = {**VALID, key: value}
    yaml = "".join(f"{name}: {text}\n" for name, text in values.items() if text is not None)
    text = (
        '<node pkg="nav2_map_server" exec="map_server">\n'
        '<param name="yaml_filename" value="$(dirname)/../hall.yaml"/>\n</node>'
    )
    found = reported(tmp_path / "arm", "LAU041", "a.launch.xml", text, {"hall.yaml": yaml})
    assert [words in one.message for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("given", "count"),
    [
        ("", 1),
        ('<param name="yaml_filename" value="$(var map)"/>', 0),
        ('<param from="$(dirname)/../server.yaml"/>', 0),
        ('<param from="$(dirname)/../other.yaml"/>', 1),
    ],
)
def test_a_server_without_a_map(tmp_path: Path, given: str, count: int) -> None:
    text = f'<node pkg="nav2_map_server" exec="map_server">{given}</node>'
    files = {
        "server.yaml": "map_server: {ros__parameters: {yaml_filename: ''}}\n",
        "other.yaml": "map_server: {ros__parameters: {topic_name: map}}\n",
    }
    found = reported(tmp_path / "arm", "LAU041", "a.launch.xml", text, files)
    assert ["'yaml_filename' is not" in one.message for one in found] == [True] * count


SLAM = "slam_toolbox: {{ros__parameters: {{{}}}}}\n"


@pytest.mark.parametrize(
    ("yaml", "count"),
    [
        (SLAM.format("mode: localization"), 1),
        (SLAM.format("mode: localization, map_file_name: /a"), 0),
    ],
)
def test_localization_without_a_map(tmp_path: Path, yaml: str, count: int) -> None:
    assert len(messages("LAU041", tmp_path, yaml)) == count

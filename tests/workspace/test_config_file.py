from pathlib import Path

import pytest

from urdfkit.workspace.config_file import nearest


def test_the_nearest_one_upwards_is_found(tmp_path: Path) -> None:
    inner = tmp_path / "a" / "b"
    inner.mkdir(parents=True)
    (tmp_path / "pyproject.toml").write_text("[tool.urdfkit]\nignore = ['TRE']")
    assert nearest(str(inner)) == str(tmp_path / "pyproject.toml")
    (tmp_path / "a" / "pyproject.toml").write_text("[project]\nname = 'x'")  # nothing of urdfkit
    assert nearest(str(inner)) == str(tmp_path / "pyproject.toml")
    (inner / "urdfkit.toml").touch()
    assert nearest(str(inner)) == str(inner / "urdfkit.toml")


@pytest.mark.parametrize(
    ("text", "is_found"),
    [
        ("# [tool.urdfkit]\n# ignore = ['TRE']\n", False),
        ("\ufeff[tool.urdfkit]\n", True),
        ("[project]\n\n  [[tool.urdfkit.robot]]\n", True),
    ],
)
def test_a_section_in_a_comment_is_none(text: str, is_found: bool, tmp_path: Path) -> None:
    """It is how people switch a configuration off."""
    (tmp_path / "pyproject.toml").write_text(text, encoding="utf-8")
    assert (nearest(str(tmp_path)) == str(tmp_path / "pyproject.toml")) is is_found

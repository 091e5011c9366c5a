from pathlib import Path

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

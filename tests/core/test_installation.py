"""The hint of a missing extra names what works in the environment that prints it."""

import json
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from urdfkit.core import installation
from urdfkit.core.installation import install_command


@pytest.fixture
def prefix(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An environment that a wheel from a package index was installed into."""
    (tmp_path / "urdfkit-0.1.0.dist-info").mkdir()
    monkeypatch.setattr(installation, "_HOME", str(tmp_path))
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    return tmp_path


def test_a_checkout_is_installed_again_with_the_extra(
    prefix: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(installation, "_HOME", str(ROOT))
    assert install_command("meshes") == f'pip install -e "{ROOT}[meshes]"'
    assert install_command("") == f'pip install -e "{ROOT}"'


@pytest.mark.parametrize(
    ("direct_url", "requirement"),
    [
        (None, "urdfkit[lsp]"),
        ({"url": "file:///a%20b", "dir_info": {}}, "urdfkit[lsp] @ file:///a%20b"),
        ({"url": "file:///a.whl", "archive_info": {}}, "urdfkit[lsp] @ file:///a.whl"),
        (
            {"url": "https://a.org/b", "vcs_info": {"vcs": "git", "commit_id": "c0ffee"}},
            "urdfkit[lsp] @ git+https://a.org/b@c0ffee",
        ),
        ({"vcs_info": {}}, "urdfkit[lsp]"),
    ],
)
def test_the_origin_is_that_of_the_installation(
    prefix: Path, direct_url: object, requirement: str
) -> None:
    if direct_url is not None:
        record = prefix / "urdfkit-0.1.0.dist-info" / "direct_url.json"
        record.write_text(json.dumps(direct_url))
    assert install_command("lsp") == f'pip install "{requirement}"'


@pytest.mark.parametrize(
    ("file", "text", "program"),
    [
        ("uv-receipt.toml", "[tool]\n", "uv tool install"),
        ("pipx_metadata.json", "{}\n", "pipx install --force"),
        ("pyvenv.cfg", "home = /usr\nuv = 0.13.9\n", "uv pip install"),
        ("pyvenv.cfg", "home = /home/uv = /bin\n", "pip install"),
    ],
)
def test_the_program_is_that_which_made_the_environment(
    prefix: Path, file: str, text: str, program: str
) -> None:
    (prefix / file).write_text(text)
    assert install_command("lsp") == f'{program} "urdfkit[lsp]"'


def test_uvx_runs_another_environment(prefix: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "prefix", str(prefix / "archive-v0" / "c0ffee"))
    assert install_command("lsp") == 'uvx --from "urdfkit[lsp]" urdfkit'


def test_pre_commit_is_configured(prefix: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "prefix", str(prefix / "py_env-python3.12"))
    assert install_command("lsp") == (
        'additional_dependencies: [".[lsp]"] in .pre-commit-config.yaml'
    )


@pytest.mark.parametrize(
    ("extra", "name", "value"),
    [
        ("dynamics", "platform", "win32"),
        ("simulate", "version_info", (3, 10, 13)),
        ("usd", "version_info", (3, 14, 0)),
        ("lsp", "platform", "emscripten"),
    ],
)
def test_an_extra_without_wheels_is_not_to_be_installed(
    extra: str, name: str, value: object, prefix: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, name, value)
    assert install_command(extra).startswith("not possible ")


def test_extras_that_have_wheels(prefix: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "version_info", (3, 11, 0))
    monkeypatch.setattr(sys, "platform", "linux")
    assert not any("not possible" in install_command(name) for name in ("simulate", "usd", "all"))

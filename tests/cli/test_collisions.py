"""The collisions command."""

import json
import sys
from pathlib import Path

import pytest

from tests.conftest import GRIPPER
from tests.shipped import ARM
from urdfkit.cli import main
from urdfkit.core.installation import install_command

FEW = ["--samples", "200", "--jobs", "1"]

BENT = """<robot name="bent">
  <link name="base"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="arm"><collision><origin xyz="0 0 0.5"/>
    <geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="tip"><collision><origin xyz="0 0 0.5"/>
    <geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="arm"/></joint>
  <joint name="elbow" type="revolute"><parent link="arm"/><child link="tip"/>
    <origin xyz="0 0 0.6"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
</robot>
"""


@pytest.fixture(autouse=True)
def _needs_coal(request: pytest.FixtureRequest) -> None:
    if "without" not in request.node.name:
        pytest.importorskip("coal")


@pytest.fixture
def bent(tmp_path: Path) -> str:
    """A robot whose tip hits its base in a fifth of its poses."""
    path = tmp_path / "bent.urdf"
    path.write_text(BENT)
    return str(path)


def test_text(bent: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["collisions", bent, *FEW]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "bent: 3 pairs of 3 links, 200 samples, seed 0"
    assert lines[2].split()[:2] == ["2", "adjacent"]
    assert lines[3].split()[:2] == ["1", "sometimes"]
    assert lines[5] == "can collide"
    assert lines[6].split()[:2] == ["base", "tip"]
    assert lines[6].endswith("mm deep")
    assert max(map(len, lines)) <= 80


FLOATING = BENT.replace('"continuous"', '"floating"').replace('"revolute"', '"floating"')


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (BENT.replace("collision>", "visual>"), "bent: no link has collision geometry"),
        (
            BENT.replace("0.1", "-1").replace("0.2", "-1"),
            "bent: no link has usable collision geometry",
        ),
        (BENT.replace("0.1", "-1"), "bent: only link 'base' has collision geometry"),
        (FLOATING, "bent: no two links with collision geometry are connected by joints"),
    ],
)
def test_a_robot_without_pairs_says_why(
    text: str, line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "r.urdf").write_text(text)
    assert main(["collisions", str(tmp_path / "r.urdf"), *FEW]) == 0
    assert capsys.readouterr().out.splitlines()[0] == line


def test_json(bent: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["collisions", bent, *FEW, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    (pair,) = [pair for pair in found["pairs"] if pair["verdict"] == "sometimes"]
    assert pair["links"] == ["base", "tip"]
    assert 0 < pair["frequency"] < 0.5
    assert pair["distance"] < 0
    assert set(pair["pose"]) == {"shoulder", "elbow"}
    assert found["version"] == 1


def test_markdown(bent: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["collisions", bent, *FEW, "--format", "markdown"]) == 0
    out = capsys.readouterr().out
    assert out.startswith("### Collisions of bent: 3 pairs")
    assert "| base | tip | " in out


def test_an_srdf_is_written_compared_and_updated(
    bent: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    srdf = tmp_path / "bent.srdf"
    assert main(["collisions", bent, *FEW, "-o", str(srdf)]) == 0
    assert capsys.readouterr().err == f"wrote {srdf}\n"
    assert main(["collisions", bent, *FEW, "--compare", str(srdf)]) == 0
    assert "differs from this" in capsys.readouterr().out
    wrong = srdf.read_text().replace(
        "</robot>", '<disable_collisions link1="tip" link2="base" reason="Never"/></robot>'
    )
    srdf.write_text(wrong)
    assert main(["collisions", bent, *FEW, "--compare", str(srdf)]) == 1
    assert "disabled in the SRDF, but can collide" in capsys.readouterr().out
    assert main(["collisions", bent, *FEW, "-o", str(srdf)]) == 0
    assert capsys.readouterr().err == f"updated {srdf}\n"
    written = srdf.read_text()
    assert main(["collisions", bent, *FEW, "-o", "-"]) == 0
    printed = capsys.readouterr()
    assert (printed.out, printed.err) == (written, "")
    assert not Path("-").exists()
    assert 'link1="tip"' not in srdf.read_text()


@pytest.mark.parametrize("encoding", ["iso-8859-1", "utf-16"])
def test_an_srdf_keeps_its_encoding(encoding: str, bent: str, tmp_path: Path) -> None:
    srdf = tmp_path / "bent.srdf"
    comment = f'<?xml version="1.0" encoding="{encoding}"?>\n<!-- Gr\xf6\xdfe -->\n'
    srdf.write_bytes(f'{comment}<robot name="bent">\n</robot>\n'.encode(encoding))
    assert main(["collisions", bent, *FEW, "-o", str(srdf)]) == 0
    text = srdf.read_bytes().decode(encoding)
    assert text.startswith(comment)
    assert "<disable_collisions" in text


def test_an_srdf_with_a_byte_that_is_no_text_is_not_touched(
    bent: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    srdf = tmp_path / "bent.srdf"
    srdf.write_bytes(b'<!-- Gr\xf6\xdfe --><robot name="bent"></robot>')
    before = srdf.read_bytes()
    assert main(["collisions", bent, *FEW, "-o", str(srdf)]) == 2
    assert "not valid text" in capsys.readouterr().err
    assert srdf.read_bytes() == before


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["--compare", "no.srdf"], "no.srdf"),
        (["-o", "no/such/directory/r.srdf"], "no such directory"),
        (["--samples", "-1"], "--samples"),
        (["--joint", "none=1"], "no joint 'none'"),
    ],
)
def test_usage_errors(words: list[str], reason: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["collisions", ARM, *FEW, *words]) == 2
    assert reason in capsys.readouterr().err


def test_missing_coal_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for module in [name for name in sys.modules if name.startswith("urdfkit.physics.collision")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "coal", None)
    assert main(["collisions", ARM]) == 2
    assert install_command("dynamics") in capsys.readouterr().err


def test_a_urdf_is_not_an_srdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Who names the model itself keeps it as it is."""
    path = tmp_path / "gripper.urdf"
    text = (GRIPPER).read_bytes()
    path.write_bytes(text)
    for option in ("-o", "--compare"):
        assert main(["collisions", str(path), option, str(path), "--samples", "0"]) == 2
        assert "not an SRDF file" in capsys.readouterr().err
    assert path.read_bytes() == text


def test_shapes_omitted_for_one_reason_are_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shape = '<collision><geometry><mesh filename="no.stl"/></geometry></collision>'
    links = "".join(f'<link name="l{number}">{shape}</link>' for number in range(12))
    joints = "".join(
        f'<joint name="j{number}" type="fixed"><parent link="l0"/><child link="l{number}"/></joint>'
        for number in range(1, 12)
    )
    file = tmp_path / "r.urdf"
    file.write_text(f'<robot name="r">{links}{joints}</robot>')
    assert main(["collisions", str(file)]) == 0
    said = capsys.readouterr().out.split("\n\n")[1:]
    assert len(said) == 1
    assert said[0].split()[:9] == "omitted: collision 1 of links 'l0', 'l1', 'l2', 'l3',".split()
    assert said[0].split()[-7:] == "and 4 more: the file is missing".split()

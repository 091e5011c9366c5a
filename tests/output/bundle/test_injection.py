"""Names that try to leave a bundle."""

import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.meshed import SOUND
from tests.payloads import NOT_XML, PAYLOADS, named, output
from urdfkit.cli import main


def test_a_bundle_keeps_names_in_their_places(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In the names of its files, the URDF, the manifest and the build files."""
    pytest.importorskip("numpy")
    monkeypatch.chdir(tmp_path)
    names = [
        f"{one.replace('/', '_').replace(chr(92), '_')}.stl"
        for one in PAYLOADS.values()
        if not NOT_XML.search(one)
    ]
    for name in names:
        Path(name).write_bytes(SOUND)
    links = "".join(
        f'<link name="l{number}"><visual><geometry><mesh filename={named(name)}/></geometry>'
        "</visual></link>"
        for number, name in enumerate(names)
    )
    head = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
    robot = named("../../" + "".join(names)[:100])
    Path("r.urdf.xacro").write_text(f"{head} name={robot}>{links}</robot>")
    for consumer in ("any", "ros"):
        output(["bundle", "r.urdf.xacro", "-o", consumer, "--for", consumer], capsys)
        manifest = json.loads(Path(consumer, "bundle.json").read_text())
        urdf = ElementTree.parse(Path(consumer, manifest["urdf"])).getroot()
        assert [one.tag for one in urdf.iter()] == [
            "robot",
            *("link", "visual", "geometry", "mesh") * len(names),
        ]
        meshes = {one.get("filename", "").rpartition("/")[2] for one in urdf.iter("mesh")}
        assert meshes == {path.name for path in Path(consumer, "meshes").iterdir()}
        assert meshes == set(names)
    assert re.fullmatch(r"urdf/[a-z0-9_]+\.urdf", manifest["urdf"])
    ElementTree.parse("ros/package.xml")
    assert "pwned" not in Path("ros/CMakeLists.txt").read_text().replace(
        Path(manifest["urdf"]).stem, ""
    )
    assert {path.name for path in tmp_path.iterdir()} == {*names, "r.urdf.xacro", "any", "ros"}


def test_no_name_of_a_bundle_leads_elsewhere_on_windows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("numpy")
    monkeypatch.chdir(tmp_path)
    obj = "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n"
    mesh = '<visual><geometry><mesh filename="a.obj"/></geometry></visual>'
    Path("r.urdf").write_text(f'<robot name="r"><link name="a">{mesh}</link></robot>')
    Path("a.obj").write_text(obj)
    Path("a.mtl").write_text("newmtl a\nmap_Kd ..\\..\\a.png\n")
    Path("..\\..\\a.png").write_bytes(b"\x89PNG")
    main(["bundle", "r.urdf", "-o", "made"])
    assert not [path for path in Path("made").rglob("*") if "\\" in path.name]

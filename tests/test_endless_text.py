"""Texts in which things begin over and over and never end: read in a time like their length.

A pattern that looks for an end anew from each beginning takes the square of that. For the texts
here that is a minute and more; read once, they take some milliseconds.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.workspaces import add_file, mesh_link
from urdfkit import check
from urdfkit.lint.config import Config
from urdfkit.lint.discovery import discover
from urdfkit.lint.suppress import ignores
from urdfkit.mesh.io.salvage import salvage
from urdfkit.mesh.io.sniff import sniff
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import is_xacro
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.package_references import mentions
from urdfkit.workspace.resolve import Resolver

MANY = 40_000
#: Seconds of the processor.
ENOUGH = 20.0

TRIANGLE = b"facet normal 0 0 1\nouter loop\nvertex 0 0 %s\nendloop\nendfacet\nendsolid"
MESHES = {
    "comments": (b"<COLLADA>" + b"<!-- " * MANY, ".dae"),
    "comments before the root": (b"<!-- " * MANY, ".dae"),
    "instructions": (b"<? " * MANY, ".dae"),
    "declarations": (b"<!a " * MANY, ".dae"),
    "character data": (b"<COLLADA>" + b"<![CDATA[" * MANY, ".dae"),
    "tags in a comment": (b"<COLLADA><!-- " + b"<triangles " * MANY + b"--></COLLADA>", ".dae"),
    "inputs in a comment": (b"<COLLADA><!-- " + b"<input a" * MANY + b"--></COLLADA>", ".dae"),
    "one number": (b"solid a\n" + TRIANGLE % (b"1" * MANY + b"x"), ".stl"),
    "one list": (
        b"<COLLADA><source id='s'><float_array>" + b"1," * MANY + b"</float_array></source>"
        b"<mesh><input semantic='POSITION' source='#s'/></mesh><triangles/><instance_geometry/>"
        b"<scene><instance_visual_scene a='&b;'/></scene></COLLADA>",
        ".dae",
    ),
}


@contextmanager
def soon() -> Iterator[None]:
    start = time.process_time()
    yield
    assert time.process_time() - start < ENOUGH


@pytest.mark.parametrize("name", MESHES)
def test_mesh_files(name: str, tmp_path: Path):
    data, suffix = MESHES[name]
    path = add_file(tmp_path / f"mesh{suffix}", data)
    with soon():
        assert sniff(data, suffix).defect
        salvage(str(path))


def test_a_manifest(tmp_path: Path):
    head = b"<package><name>arm</name><export><build_type>ament_cmake</build_type></export>"
    add_file(tmp_path / "package.xml", head + b"<!-- " * MANY)
    with soon():
        manifest = manifest_of(Resolver(), str(tmp_path / "arm.urdf"))
        assert manifest is not None
        assert (manifest.package, manifest.ros) == ("arm", 2)


def test_a_setup_file(tmp_path: Path):
    add_file(tmp_path / "package.xml", b"<package><name>arm</name></package>")
    add_file(tmp_path / "setup.py", b"\n" * MANY + b"package_name = 'leg'\n")
    robot = f"<robot name='arm'>{mesh_link('package://arm/arm.stl')}</robot>"
    path = add_file(tmp_path / "arm.urdf", robot.encode())
    with soon():
        assert "PKG005" in [found.code for found in check(path, select=["PKG"]).diagnostics]


@pytest.mark.parametrize(
    "comment", [b"<!-- ", b"<!-- urdfkit: ignore[A] ", b"<!-- urdfkit: ignore["]
)
def test_comments_of_a_robot(comment: bytes):
    source = Source("arm.urdf", b"<robot xmlns:xacro='x'>package://a<xacro:a/>" + comment * MANY)
    with soon():
        assert not is_xacro(source)
        assert ignores(source) == ()
        assert [one.package for one in mentions(source)] == ["a"]


def test_many_ignore_comments():
    many = MANY // 4
    comments = b"<!-- urdfkit: ignore[A] --><link/>" * many
    with soon():
        assert len(ignores(Source("arm.urdf", b"<robot>" + comments + b"</robot>"))) == many


@pytest.mark.parametrize("piece", [b"<!-- ", b"<xacro:macro ", b"<xacro:include "])
def test_a_folder(piece: bytes, tmp_path: Path):
    add_file(tmp_path / "arm.urdf", b"<robot name='arm'><link name='a'/></robot>")
    add_file(tmp_path / "macros.xacro", b"<robot>" + piece * MANY)
    with soon():
        found = discover(str(tmp_path), Config(), Resolver())
        assert str(tmp_path / "arm.urdf") in [robot.file for robot in found.robots]

from __future__ import annotations

from pathlib import Path

from urdfkit import Diagnostic, check

MESH = '<visual><geometry><mesh filename="package://arm/{}"/></geometry></visual>'
INSTALL = "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\n"


def reported(folder: Path, *paths: str, build: str | None = INSTALL) -> list[Diagnostic]:
    (folder / "package.xml").write_text("<package><name>arm</name></package>")
    if build is not None:
        (folder / "CMakeLists.txt").write_text(build)
    for name in ("urdf", "meshes"):
        (folder / name).mkdir(exist_ok=True)
        (folder / name / "a.stl").write_text("solid")
    file = folder / "urdf" / "r.urdf"
    meshes = "\n".join(map(MESH.format, paths))
    file.write_text(f'<robot name="r"><link name="base">\n{meshes}\n</link></robot>')
    report = check(file, select=["PKG002"])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_a_folder_that_is_not_installed(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "urdf/a.stl", "meshes/a.stl", "meshes/a.stl")
    assert found.message == (f"'meshes/a.stl' is not installed by {tmp_path}/CMakeLists.txt")
    assert found.help == "write install(DIRECTORY meshes DESTINATION share/${PROJECT_NAME})"
    assert (found.span.line, found.span.text) == (3, "package://arm/meshes/a.stl")


def test_what_is_installed_or_is_not_there(tmp_path: Path) -> None:
    assert reported(tmp_path, "urdf/a.stl") == []
    assert reported(tmp_path, "meshes/b.stl") == [], "MSH001"
    assert reported(tmp_path, "meshes/a.stl", build=INSTALL.replace("urdf", "urdf meshes")) == []


def test_nothing_says_what_is_installed(tmp_path: Path) -> None:
    assert reported(tmp_path, "meshes/a.stl", build=None) == []
    assert reported(tmp_path, "meshes/a.stl", build="project(arm)") == []

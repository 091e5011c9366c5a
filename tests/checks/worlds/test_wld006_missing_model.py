"""WLD006: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import (
    CLASSIC,
    INCLUDE,
    findings,
    messages,
    only_finding,
)
from tests.naming import naming
from urdfkit import Severity

CODE = "WLD006"


def test_missing_models(tmp_path: Path) -> None:
    include = "<include><uri>model://{}</uri></include>"
    files = {"models/big_shelf/model.config": "<model/>", "README.md": "GZ_SIM_RESOURCE_PATH"}
    assert messages(tmp_path, CODE, world=include.format("big_shelf"), files=files) == []
    (typo,) = messages(tmp_path, CODE, world=include.format("big_shlef"))
    assert typo == naming("model://big_shlef", "big_shelf")
    unknown = only_finding(tmp_path, CODE, world=include.format("cafe"))
    assert (unknown.severity, "not in the workspace" in unknown.message) == (Severity.INFO, True)
    for name in ("sun", "ground_plane"):
        (online,) = messages(tmp_path, CODE, world=include.format(name))
        assert online == naming(f"model://{name}", "Gazebo", "Classic")
        assert messages(tmp_path, CODE, world=include.format(name), launch=CLASSIC) == []


def test_a_model_of_gazebo_is_not_misspelt(tmp_path: Path) -> None:
    """mobile_manip_ws has a my_ground_plane, and worlds with the ground_plane of Gazebo."""
    world = "<include><uri>model://ground_plane</uri></include>"
    files = {"models/my_ground_plane/model.config": "<model/>"}
    assert messages(tmp_path, CODE, world=world, files=files, launch=CLASSIC) == []


@pytest.mark.parametrize(
    ("uri", "words"),
    [
        ("model://shelf/shelf.dae", ""),
        ("model://shelf/other.dae", "is not found"),
        ("model://elsewhere/shelf.dae", ""),
        ("model://urdf/shelf/shelf.dae", ""),  # below the path of models of another directory
        ("file:///opt/shelf.dae", ""),
        ("file:///home/me/shelf.dae", "one computer"),
        ("/home/me/shelf.dae", "one computer"),
        ("shelf.dae", "is not found"),
    ],
)
def test_meshes_of_a_world(tmp_path: Path, uri: str, words: str) -> None:
    shape = f"<geometry><mesh><uri>{uri}</uri></mesh></geometry>"
    world = f'<model name="m"><link name="l"><visual name="v">{shape}</visual></link></model>'
    files = {"models/shelf/model.config": "<model/>", "models/shelf/shelf.dae": "x"}
    files["urdf/arm.urdf"] = "<robot/>"
    found = messages(tmp_path, CODE, world=world, files=files)
    assert [words in one for one in found] == [True] * bool(words)


SETTING = """
from launch.actions import AppendEnvironmentVariable

AppendEnvironmentVariable("{}", share + "/{}")
"""
CONFIG = "<model><sdf version='1.9'>{}</sdf></model>"
EXPORT = """<package format="3"><name>arm</name><export>
<gazebo_ros gazebo_model_path="${prefix}/models"/></export></package>"""


@pytest.mark.parametrize(
    ("variable", "directory", "files", "line"),
    [
        ("GZ_SIM_RESOURCE_PATH", "models", {}, None),
        ("GZ_SIM_RESOURCE_PATH", "", {}, 3),
        ("GZ_SIM_RESOURCE_PATH", "", {"env.sh": "export GZ_SIM_RESOURCE_PATH=models"}, None),
        ("GZ_SIM_RESOURCE_PATH", "share/models", {}, None),  # in another layout
        ("GAZEBO_MODEL_PATH", "models", {}, 3),
        ("GAZEBO_MODEL_PATH", "models", {"../b/package.xml": EXPORT.replace("arm", "b")}, 3),
        ("IGN_GAZEBO_RESOURCE_PATH", "models", {}, None),
        ("IGN_GAZEBO_RESOURCE_PATH", "models", {"a.yaml": "use_stamped: true"}, 21),
    ],
)
def test_a_model_on_the_resource_path(
    tmp_path: Path, variable: str, directory: str, files: dict[str, str], line: int | None
) -> None:
    launch = INCLUDE + SETTING.format(variable, directory)
    made = files | {"models/shelf/model.config": "<model/>"}
    if "a.yaml" in files:
        launch += 'Node(package="twist_mux", executable="t", parameters=[share + "/a.yaml"])\n'
    world = "<include><uri>model://shelf</uri></include>"
    found = findings(tmp_path / "arm", CODE, world=world, launch=launch, files=made)
    assert [one.span.line for one in found] == ([] if line is None else [line])
    unread = "IGN_GAZEBO_RESOURCE_PATH" if line == 21 else "GZ_SIM_RESOURCE_PATH"
    assert [one.message for one in found] == [naming("model://shelf", unread)] * len(found)


def test_a_model_path_that_a_package_exports(tmp_path: Path) -> None:
    files = {"models/shelf/model.config": "<model/>"}
    world = "<include><uri>model://shelf</uri></include>"
    (missing,) = findings(tmp_path / "a", CODE, world=world, files=files)
    assert missing.help == "add arm/models to GZ_SIM_RESOURCE_PATH in the launch file"
    files["package.xml"] = EXPORT
    assert messages(tmp_path / "b", CODE, world=world, files=files) == []


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ({"model.config": CONFIG.format("model.sdf"), "model.sdf": ""}, []),
        ({"model.config": CONFIG.format("shelf.sdf"), "model.sdf": ""}, ["shelf", "shelf.sdf"]),
        ({"model.config": CONFIG.format("a.sdf"), "a.sdf": ""}, []),
        ({"model.sdf": "<sdf/>"}, ["model://shelf", "model.config"]),
        ({"model.sdf": "<sdf/>", "manifest.xml": CONFIG.format("model.sdf")}, []),
        ({"model.config": "<model/>"}, []),
    ],
)
def test_the_file_of_a_model(tmp_path: Path, files: dict[str, str], words: list[str]) -> None:
    made = {f"models/shelf/{name}": text for name, text in files.items()}
    made["package.xml"] = EXPORT
    found = messages(
        tmp_path, CODE, world="<include><uri>model://shelf</uri></include>", files=made
    )
    assert found == [naming(*words)] * bool(words)

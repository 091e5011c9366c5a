"""Links and joints in the other files of a package."""

from pathlib import Path

import pytest

from tests.lsp.edited import XACRO, Edited
from urdfkit.errors import UrdfkitError
from urdfkit.lsp.navigation import CannotRename, definitions, references, renamable, rename
from urdfkit.lsp.workspace import Workspace
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.source import Source

ROBOT = XACRO.format(
    """<link name="base_link"/>
<link name="wheel_link"/>
<joint name="left" type="continuous"><parent link="base_link"/><child link="wheel_link"/></joint>
"""
)
#: After the joint ``left`` is renamed to ``port``, and the link ``base_link`` to ``body``.
YAML = {
    "controllers.yaml": (
        """left:
  ros__parameters:
    type: diff_drive_controller/DiffDriveController
    left_wheel_names: ["left"]  # left
    side: left
    base_frame_id: base_link
    joints: [ left , 'right' ]
    gains:
      left: {p: 1.0}
""",
        """left:
  ros__parameters:
    type: diff_drive_controller/DiffDriveController
    left_wheel_names: ["port"]  # left
    side: left
    base_frame_id: body
    joints: [ port , 'right' ]
    gains:
      port: {p: 1.0}
""",
    ),
    "initial_positions.yaml": ("left: 0.1\n", "port: 0.1\n"),
    "other.yaml": ("a: [base_link, left]\n", "a: [base_link, left]\n"),
    "broken.yaml": ("joints: [left\n", "joints: [left\n"),
}
LAUNCH = {
    "a.launch.py": (
        """from launch_ros.actions import Node
# é
Node(executable="static_transform_publisher", arguments=["0", "--frame-id", "base_link"])
Node(executable="spawner", arguments=["left", "base_link"], parameters=[{"frame": 'base_link'}])
""",
        """from launch_ros.actions import Node
# é
Node(executable="static_transform_publisher", arguments=["0", "--frame-id", "body"])
Node(executable="spawner", arguments=["left", "base_link"], parameters=[{"frame": 'body'}])
""",
    ),
    "b.launch": (
        """<launch><node pkg="tf" type="static_transform_publisher" args="0 0 base_link a 100"/>
<param name="base_frame" value="base_link"/><param name="x" value="base_link"/></launch>
""",
        """<launch><node pkg="tf" type="static_transform_publisher" args="0 0 body a 100"/>
<param name="base_frame" value="body"/><param name="x" value="base_link"/></launch>
""",
    ),
}


def package(directory: Path) -> Path:
    """A package with everything; the path of its robot."""
    for place, files in (("config", YAML), ("launch", LAUNCH)):
        (directory / place).mkdir()
        for name, (before, _) in files.items():
            (directory / place / name).write_text(before, encoding="utf-8")
    (directory / "package.xml").write_text("<package><name>p</name></package>")
    (directory / "urdf").mkdir()
    path = directory / "urdf" / "r.xacro"
    path.write_text(ROBOT)
    return path


def renamed(path: Path, before: str, after: str, new: str) -> None:
    """Rename what stands between two pieces of the robot's text, on disk."""
    text = path.read_text(encoding="utf-8")
    assert before + after in text
    file = Edited(path, text.replace(before + after, f"{before}|{after}", 1))
    edits = rename(file.robot, file.markup, file.offset, new)
    for source in {edit.span.source for edit in edits}:
        mine = [edit for edit in edits if edit.span.source is source]
        Path(source.path).write_bytes(apply_edits(source.data, mine))


def test_renaming_reaches_yaml_and_launch_files(tmp_path: Path) -> None:
    path = package(tmp_path)
    renamed(path, 'joint name="le', "ft", "port")
    renamed(path, 'link name="base', "_link", "body")
    for place, files in (("config", YAML), ("launch", LAUNCH)):
        for name, (_, after) in files.items():
            assert (tmp_path / place / name).read_text(encoding="utf-8") == after, name


def test_references_tell_the_places(tmp_path: Path) -> None:
    path = package(tmp_path)
    file = Edited(path, ROBOT.replace('joint name="le', 'joint name="le|'))
    spans = references(file.robot, file.markup, file.offset, definitions=False)
    assert sorted((Path(s.source.path).name, s.line, s.text) for s in spans) == [
        ("controllers.yaml", 4, "left"),
        ("controllers.yaml", 7, "left"),
        ("controllers.yaml", 9, "left"),
        ("initial_positions.yaml", 1, "left"),
    ]


def test_what_may_be_another_robot_s_is_left_alone(tmp_path: Path) -> None:
    path = package(tmp_path)
    (tmp_path / "urdf" / "twin.urdf").write_text('<robot name="t"><joint name="left"/></robot>')
    renamed(path, 'joint name="le', "ft", "port")
    assert (tmp_path / "config/initial_positions.yaml").read_text() == "left: 0.1\n"
    assert 'name="port"' in path.read_text()


def sharing(directory: Path) -> Edited:
    """A link of a file that two robots include; the second one and a YAML file use its name."""
    (directory / "package.xml").write_text("<package><name>p</name></package>")
    (directory / "c.yaml").write_text("tool_frame: tool0\n")
    include = '<xacro:include filename="common.xacro"/>'
    (directory / "a.urdf.xacro").write_text(XACRO.format(include))
    gripper = """<link name="g"/>
<joint name="k" type="fixed"><parent link="tool0"/><child link="g"/></joint>"""
    (directory / "b.urdf.xacro").write_text(XACRO.format(include + gripper))
    return Edited(directory / "common.xacro", XACRO.format('<link name="to|ol0"/>'))


def test_renaming_reaches_all_robots_that_share_a_file(tmp_path: Path) -> None:
    file = sharing(tmp_path)
    others = file.workspace.other_robots(file.path)
    edits = rename(file.robot, file.markup, file.offset, "flange", others)
    places = ["b.urdf.xacro", "c.yaml", "common.xacro"]
    assert sorted(Path(edit.span.source.path).name for edit in edits) == places
    with pytest.raises(CannotRename, match="there is already a link 'g'"):
        rename(file.robot, file.markup, file.offset, "g", others)


@pytest.mark.parametrize("text", ["", "\0", "[", "- " * 500, "a: &x [*x]", "joints: [left]\xff"])
def test_odd_files_do_no_harm(tmp_path: Path, text: str) -> None:
    path = package(tmp_path)
    for name in ("config/odd.yaml", "launch/odd.launch.py", "launch/odd.launch"):
        (tmp_path / name).write_bytes(text.encode("latin-1") + b" left")
    renamed(path, 'joint name="le', "ft", "port")
    assert Source.read(path).data.count(b"port") == 1


def test_a_yaml_file_leads_to_the_robot(tmp_path: Path) -> None:
    path = package(tmp_path)
    yaml = tmp_path / "config" / "controllers.yaml"
    text = yaml.read_text().replace('["left"]', '["le|ft"]')
    file = Edited(yaml, text)
    at = (file.robot, file.markup, file.offset)
    (given,) = definitions(*at)
    assert (given.source.path, given.line, given.text) == (str(path), 4, "left")
    assert len(references(*at, definitions=False)) == 4
    here = renamable(*at).span
    assert (Path(here.source.path), here.line, here.text) == (yaml, 4, "left")
    edits = rename(*at, "port")
    assert {edit.span.source.path for edit in edits} >= {str(path), str(yaml)}
    nothing = Edited(yaml, text.replace("|", "").replace("side: left", "side: le|ft"))
    assert definitions(nothing.robot, nothing.markup, nothing.offset) == []


def test_yaml_of_no_robot_has_nothing_to_say(tmp_path: Path) -> None:
    workspace = Workspace()
    path = str(tmp_path / "a.yaml")
    workspace.set_text(path, b"joints: [left]\n")
    assert workspace.check(path, thorough=True).diagnostics == {path: []}
    with pytest.raises(UrdfkitError, match="is not part of a robot"):
        workspace.robot(path)
    assert workspace.close(path) == {}

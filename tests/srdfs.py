"""A robot with an SRDF beside it, for the tests of the SRD rules."""

from pathlib import Path

from urdfkit import Diagnostic, check

ROBOT = """<robot name="r">
  <link name="base"/>
  <link name="arm"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="hand"/>
  <link name="finger"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
  <joint name="wrist" type="fixed"><parent link="arm"/><child link="hand"/></joint>
  <joint name="knuckle" type="fixed"><parent link="hand"/><child link="finger"/></joint>
</robot>
"""


def findings(directory: Path, body: str, code: str, name: str = "r") -> list[Diagnostic]:
    """What one rule says about an SRDF; its first line is line 2 of the file."""
    (directory / "r.urdf").write_text(ROBOT)
    (directory / "r.srdf").write_text(f'<robot name="{name}">\n{body}\n</robot>\n')
    return list(check(directory / "r.urdf", select=[code]).diagnostics)


def message_of(directory: Path, body: str, code: str) -> str:
    """The message of the one finding of a rule, which is on the line of the body."""
    (found,) = findings(directory, body, code)
    assert (found.span.source.path, found.span.line) == (str(directory / "r.srdf"), 2)
    return found.message


#: A planning group of the robot.
GROUP = '<group name="g"><chain base_link="base" tip_link="hand"/></group>'


def findings_in(
    directory: Path, file: str, text: str, code: str
) -> list[tuple[int, str, str, str]]:
    """Line, severity, message and help of what a rule says about a file next to the SRDF."""
    (directory / file).write_text(text)
    return [
        (found.span.line, found.severity.name, found.message, found.help)
        for found in findings(directory, GROUP, code)
        if found.span.source.path == str(directory / file)
    ]


#: Controllers of MoveIt.
TRAJECTORY_CONTROLLERS = """\
moveit_simple_controller_manager:
  controller_names: [arm_controller]
  arm_controller:
    type: FollowJointTrajectory
    joints: [shoulder, wrist, knuckle]
"""
#: Launch files of their own pass the whole file as the settings of the manager.
WITHOUT_MANAGER = """\
controller_names: [arm_controller]
arm_controller: {type: FollowJointTrajectory, joints: [shoulder, wrist, knuckle]}
"""

"""The SRDF or a MoveIt configuration file contains an unknown name.

- An unknown link, joint or group in a group, state, end effector, virtual or passive joint: MoveIt
  drops the group or state, and planning fails with "group not found" or with joints that never
  move. A warning for the group of a state if the SRDF has no groups: Pinocchio reads the state.
- An unknown link in the collision matrix (warning): "Link is not known to URDF. Cannot disable
  collisions"; the entry has no effect.
- A state that sets a joint outside its group (warning): MoveIt ignores the value.
- An unknown joint in `joint_limits.yaml` (warning): MoveIt ignores the entry, and plans with the
  limits of the URDF and without acceleration limits.
- An unknown group in `kinematics.yaml` or `ompl_planning.yaml` (warning): MoveIt plans with the
  default planner, and without inverse kinematics.
- In `ompl_planning.yaml`, a planner of a group that it does not define (warning): "Could not find
  the planner configuration"; a misspelt planning plugin: "Exception while loading planner"; an
  unknown adapter, or one for responses among those for requests.
- A misspelt solver in `kinematics.yaml`: "The kinematics plugin (arm) failed to load", and the
  group cannot be moved to a pose.
- In `moveit_controllers.yaml` (or the files of ROS 1) or `initial_positions.yaml`, an unknown
  joint, or a controller without settings: "Unable to identify any set of controllers that can
  actuate the specified joints".
- In `moveit_controllers.yaml` of ROS 2, a controller that no parameter file of ros2_control in the
  workspace defines, while another controller commands its joints; or a controller with other joints
  than in ros2_control, which rejects each trajectory ("Joints on incoming trajectory don't match
  the controller joints"; fixed, mimic, passive and virtual joints are ignored); or with another
  type or action ("Action client not connected"). Or no launch file names the controller, while a
  spawner loads another one of the file (warning).
- In the file of MoveIt Servo, an unknown group or frame, or the topic of a controller that is not
  defined, or that reads another type (warning): the robot does not follow the commands. A parameter
  that is missing, or has another type or an invalid value: Servo stops.
- A misspelt or misplaced setting of a controller or of `trajectory_execution`, a list that is a
  text, a pipeline that is half of Humble and half of Jazzy, an octomap updater or the Cartesian
  limits of Pilz without a required parameter (mostly warnings).

The SRDF is out of date, or the name is misspelt.

Sources:
    SRDF: https://wiki.ros.org/srdf
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    MoveIt, robot_model_loader.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/robot_model_loader/src/robot_model_loader.cpp
    MoveIt, kinematics: https://moveit.picknik.ai/main/doc/examples/kinematics_configuration/kinematics_configuration_tutorial.html
    MoveIt, OMPL: https://moveit.picknik.ai/main/doc/examples/ompl_interface/ompl_interface_tutorial.html
    MoveIt, controllers: https://moveit.picknik.ai/main/doc/examples/controller_configuration/controller_configuration_tutorial.html
    ros2_controllers, joint_trajectory_controller: https://control.ros.org/rolling/doc/ros2_controllers/joint_trajectory_controller/doc/userdoc.html
    MoveIt, moveit_simple_controller_manager.cpp: https://github.com/moveit/moveit2/blob/main/moveit_plugins/moveit_simple_controller_manager/src/moveit_simple_controller_manager.cpp
    MoveIt, Servo: https://moveit.picknik.ai/main/doc/examples/realtime_servo/realtime_servo_tutorial.html
    ros-controls/gz_ros2_control#456: https://github.com/ros-controls/gz_ros2_control/issues/456
    moveit/moveit#955: https://github.com/moveit/moveit/issues/955
    moveit/moveit_planners#6: https://github.com/moveit/moveit_planners/issues/6
    moveit/moveit_tutorials#728: https://github.com/moveit/moveit_tutorials/issues/728
"""

from urdfkit.checks.srdf.configuration import unknown_names
from urdfkit.checks.srdf.configuration_layout import invalid_layout
from urdfkit.checks.srdf.namesakes import has_incomplete_namesake, launched_namesakes
from urdfkit.checks.srdf.servo import unknown_in_servo
from urdfkit.checks.srdf.trajectory_controllers import mismatched_controllers
from urdfkit.core.suggest import SIMILAR, Suggester
from urdfkit.lint.misspelt_names import corrected_definition
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.samples import link_xml
from urdfkit.ros.moveit.samples import named_xml, srdf_files
from urdfkit.ros.moveit.srdf import Srdf, is_free_flyer
from urdfkit.ros.moveit.srdf_variant import names_of_namesakes
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value

BAD = named_xml("bad", link_xml("forearm"))
GOOD = BAD.replace('"bad"', '"good"')
FILES = srdf_files(
    '<group name="arm"><link name="forarm"/></group>',
    '<group name="arm"><link name="forearm"/></group>',
)
FIXED_FILES = {"bad.srdf": FILES["good.srdf"].replace(b"good", b"bad", 1)}


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="fix the name, or generate the SRDF for this robot",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    elsewhere = set[str]()
    is_of_namesake = bool(srdf.unknown) and has_incomplete_namesake(context, srdf)
    if is_of_namesake:
        elsewhere = set(srdf.unknown)
    elif srdf.unknown:
        elsewhere = _names_in_namesakes(context, srdf) | names_of_namesakes(context)
    suggestions = _Suggestions(context, srdf)
    for kind, attribute in srdf.references():
        if kind != "group" and attribute.value in elsewhere:
            continue
        is_known = attribute.value in srdf.known(kind) or is_free_flyer(attribute)
        if attribute.value and not is_known:
            finding = suggestions.unknown(kind, attribute)
            is_for_pinocchio = attribute.element.tag == "group_state" and not srdf.groups
            yield finding._replace(severity=Severity.WARNING) if is_for_pinocchio else finding
    links = srdf.known("link") | elsewhere
    for pair in (*srdf.root.all("disable_collisions"), *srdf.root.all("enable_collisions")):
        for key in ("link1", "link2"):
            name = pair.attributes.get(key)
            if name is not None and name.value not in links:
                yield suggestions.unknown("link", name)._replace(
                    help="compute the collision matrix again, or fix the name",
                    severity=Severity.WARNING,
                )
    yield from _not_in_group(context, srdf)
    if not is_of_namesake:
        yield from unknown_names(context, srdf)
    yield from invalid_layout(context, srdf)
    yield from mismatched_controllers(context, srdf)
    yield from unknown_in_servo(context, srdf)


def _names_in_namesakes(context: Context, srdf: Srdf) -> set[str]:
    """Links and joints of robots of the same name in launch files of the workspace."""
    models = (robot.model for robot in launched_namesakes(context, srdf))
    return {name for model in models for name in (*model.links_by_name, *model.joints_by_name)}


class _Suggestions:
    """Findings about unknown names, of which the first few get a suggestion."""

    def __init__(self, context: Context, srdf: Srdf) -> None:
        self._context = context
        self._srdf = srdf
        self._number = 0

    def unknown(self, kind: str, name: Attribute) -> Finding:
        context, known = self._context, frozenset[str]()
        self._number += 1
        if self._number <= Suggester.MAX_WORDS:
            known = self._srdf.known(kind) - _siblings(name)
        suggested = Suggester(known).suggested(name.value)
        model = context.model
        defined = (model.links_by_name if kind == "link" else model.joints_by_name).get(suggested)
        fix = corrected_definition(context, defined, name.value) if kind != "group" else None
        fix = fix or fix_value(name, suggested)
        message = f"unknown {kind} '{name.value}'{Suggester(known, SIMILAR).hint(name.value)}"
        arguments = " ".join(f"{key}:={value}" for key, value in context.arguments.items())
        related = Related(
            context.document.root.span, f"compared with this robot{arguments and ', '}{arguments}"
        )
        key = name.value if fix else kind
        return Finding(name, message, fix=fix, group_key=key, related=(related,))


def _siblings(name: Attribute) -> set[str]:
    """The other names in a group or a state, which are not suggested again."""
    parent = name.element.parent
    if parent is None or parent.tag not in ("group", "group_state"):
        return set()
    return {other.get(name.name) or "" for other in parent.all(name.element.tag)}


def _not_in_group(context: Context, srdf: Srdf) -> Findings:
    for state in srdf.states:
        group = state.get("group") or ""
        links = srdf.links_of(group)
        for element in state.all("joint") if links else ():
            joint = context.model.joints_by_name.get(element.get("name") or "")
            if joint is None or joint.child is None or joint.child_name in links:
                continue
            yield Finding(
                element,
                f"state '{state.get('name')}': joint '{joint.name}' is not in group '{group}'",
                "remove the joint from the state, or add it to the group",
                related=(Related(srdf.groups_by_name[group][0].span, "group defined here"),),
                severity=Severity.WARNING,
            )

"""A controller's type or one of its parameters is unknown, missing or invalid.

The controller manager does not load the controller, or the controller runs with a default:

- The type is misspelt, or its package does not have that class in this version of ROS: "Loader for
  controller 'x' (type 'y') not found". Many types of ROS 1 have another name in ROS 2. Or a package
  of the workspace exports other types (warning).
- The name of a parameter is misspelt (warning): with an unread `wheel_seperation`, the robot turns
  by the wrong angle.
- A required parameter is missing: "'joints' parameter was empty". In ROS 1, a `<param>` of the
  launch file may set it.
- A value has the wrong type. ROS 2 parameters are typed: a `double` does not accept the integer
  `50`, and a quoted number or a decimal comma is a string: "parameter 'publish_rate' has invalid
  type". Types that differ between versions of a class since Humble are not checked.
- A value must be positive but is not, or has the wrong sign, or is not one of the words that the
  parameter may have: `interpolation_method: linear`. Or a covariance has the wrong length: 6
  numbers for the diagonal of a drive, 9 for an IMU. The limits of a differential drive must have
  the right sign from Jazzy on (a warning, unless other parameters are those of Jazzy), and
  `use_stamped_vel: false` has no effect there (an info, or else a warning).
- The list of an axle has the wrong number of joints for the steering controller: two for Ackermann,
  one for a bicycle. A wheel is on both sides of a differential drive.
- A trajectory controller has a joint or an interface twice, or the state interface `velocity`
  without `position`: it is not configured. With `effort` or `velocity` as its only command
  interface, a PID computes the commands; without `gains` they are 0 and nothing moves (warning).
  Constraints or gains of a joint that it does not have are ignored (warning).

Only classes of packages that urdfkit knows are checked, unless the package is in the workspace,
where it may have other parameters, or a package of the workspace describes the class.

Sources:
    rclcpp, parameter types: https://docs.ros.org/en/rolling/Concepts/Basic/About-Parameters.html
    ros2_controllers: https://control.ros.org/master/doc/ros2_controllers/doc/controllers_index.html
    ros_controllers: https://wiki.ros.org/ros_controllers
    joint_trajectory_controller, interfaces: https://control.ros.org/master/doc/ros2_controllers/joint_trajectory_controller/doc/userdoc.html
    ros-controls/ros2_controllers#1631: https://github.com/ros-controls/ros2_controllers/issues/1631
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

import re
from collections.abc import Collection, Iterator

from urdfkit.checks.controllers.trajectory_interfaces import (
    invalid_interfaces,
    repeated_joints,
    unread_joints,
    without_gains,
)
from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.controllers import (
    ControllerParameters,
    classes,
    of_manager,
    parameters_of,
    successor,
)
from urdfkit.ros.catalog.ros_control import controller_types, parameters
from urdfkit.ros.controllers import (
    Controller,
    ParameterFile,
    Section,
    by_file,
    managers,
    named_sections,
)
from urdfkit.ros.gazebo.samples import ARM, CONTROL, controller_yaml
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.parameter_types import TYPES, correction, is_not_positive, number_of, type_of
from urdfkit.text.located_yaml import TEMPLATE_MARKS, Node, Value, scalars
from urdfkit.text.source import Span
from urdfkit.workspace.plugin_descriptions import is_described, why_unknown

BAD = ARM + CONTROL
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = controller_yaml(
    "joint_trajectory_controller/JointTrajectoryController",
    "joints: [shoulder]",
    "command_interfaces: [position]",
    "state_interfaces: [position]",
    "action_monitor_rate: 20.0",
)
FILES = {"config/bad.yaml": _YAML.replace(b"20.0", b"20"), "config/good.yaml": _YAML}

#: The package of the base classes of controllers.
_BASE = "controller_interface"
#: Joints per axle of a steering controller, by the first word of its package.
_OF_AXLE = {"ackermann": 2, "bicycle": 1}

#: Below more, in ROS 1, is a template that a program completes before it loads the controllers.
_MAX_NAMESPACES = 1

#: The name of a ``<param>`` of a launch file.
_PARAM = rb"<param\b[^<>]*?\sname\s*=\s*[\"']([^\"'<>]*)"

#: Place, message and help.
_Problem = tuple[Span, str, str]


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    for file, section in managers(context):
        for at, message, help in _invalid_values(of_manager(), section):
            yield Finding(at, f"controller manager: {message}", help, related=(file.note,))
        for name in section.given:
            suggested = nearest(name, of_manager().types, CLOSE_TYPO)
            if suggested and suggested not in section.given:
                message = (
                    f"controller manager: unknown parameter '{name}'; did you mean '{suggested}'?"
                )
                at, help = section.places[name], f"write {suggested}"
                yield Finding(at, message, help, related=(file.note,), severity=Severity.WARNING)
    sections = named_sections(context)
    for file, controllers in by_file(context.controllers):
        names = {controller.name for controller in controllers}
        set_apart = _set_in_launch_file(file)
        others = {name: section for name, section in sections.items() if name not in names}
        for controller in controllers:
            if _is_of_workspace(context, controller):
                yield from _not_exported(context, controller, file)
                continue
            if _is_own_class(context, controller):
                continue
            own = sections.get(controller.name, controller.section)
            given = set_apart.get(controller.name, ())
            later = _of_later_versions(controller, own, context)
            problems = _problems(controller, own, others, given)
            for severity, (at, message, help) in (*problems, *later):
                text = f"{controller.title}: {message}"
                yield Finding(at, text, help, related=(file.note,), severity=severity)


def _set_in_launch_file(file: ParameterFile) -> dict[str, set[str]]:
    """The parameters of controllers that the launch file of a parameter file sets, in ROS 1."""
    found: dict[str, set[str]] = {}
    for name in re.findall(_PARAM, file.span.source.data) if file.is_of_ros1 else ():
        above, _, parameter = name.decode("utf-8", "replace").rpartition("/")
        found.setdefault(above.rpartition("/")[2], set()).add(parameter)
    return found


def _problems(
    controller: Controller, own: Section, others: dict[str, Section], given: Collection[str]
) -> Iterator[tuple[Severity | None, _Problem]]:
    """Problems of a controller, with a severity if it differs from that of the rule.

    Args:
        own: the section with its parameters.
        others: the sections that do not belong to a controller of the file, by name.
        given: the parameters that are set elsewhere.
    """
    errors = [*_unknown_class(controller), *_missing(controller, own, others, given)]
    known = parameters_of(controller.type, controller.ros)
    if known is not None:
        errors += _invalid_values(known, controller.section)
        errors += [] if known.bounded_since else _wrong_signs(known, controller.section)
    errors += invalid_interfaces(controller)
    errors += _wrong_axles(controller)
    errors += _on_both_sides(controller)
    errors += _at_two_corners(controller)
    yield from ((None, problem) for problem in errors)
    warnings = (
        *_misspelt(controller),
        *without_gains(controller, own),
        *unread_joints(controller),
        *repeated_joints(controller),
    )
    yield from ((Severity.WARNING, problem) for problem in warnings)


def _of_later_versions(
    controller: Controller, own: Section, context: Context
) -> Iterator[tuple[Severity, _Problem]]:
    """Problems that only later versions have, with their severities."""
    known = parameters_of(controller.type, controller.ros)
    if known is None:
        return
    outdated = list(_outdated(known, own))
    wrong = list(_wrong_signs(known, controller.section)) if known.bounded_since else []
    is_later = bool(outdated or wrong) and is_for_jazzy(context.source.path, context.resolver)
    for problem in outdated:
        yield Severity.WARNING if is_later else Severity.INFO, problem
    for at, message, help in wrong:
        since = "" if is_later else f" from {known.bounded_since} on"
        yield Severity.ERROR if is_later else Severity.WARNING, (at, message + since, help)


def _is_of_workspace(context: Context, controller: Controller) -> bool:
    """True if the sources of the controller's package are in the workspace."""
    package = controller.type.partition("/")[0]
    directory = context.resolver.packages.known(context.source.path).get(package)
    find = context.resolver.directories.find
    return directory is not None and find(directory, "CMakeLists.txt") is not None


def _is_own_class(context: Context, controller: Controller) -> bool:
    """True if a package of the workspace adds the class to the names of another package."""
    is_known = controller.type in classes(controller.ros)
    return not is_known and is_described(controller.type, context.source.path, context.resolver)


def _not_exported(context: Context, controller: Controller, file: ParameterFile) -> Findings:
    """A type of a package in the workspace that its plugin description does not have."""
    near, at = context.source.path, controller.type_at
    if problem := why_unknown(controller.type, _BASE, near, context.resolver):
        message, help = f"{controller.title}: {problem[0]}", problem[1]
        yield Finding(at, message, help, related=(file.note,), severity=Severity.WARNING)


def _unknown_class(controller: Controller) -> Iterator[_Problem]:
    """A type whose package is known, but does not have the class in this version of ROS."""
    kind, known = controller.type, classes(controller.ros)
    if kind in known:
        return
    if controller.ros == 1:
        if kind in classes(2):
            help = "use the class of ros_controllers"
            yield controller.type_at, f"type '{kind}' exists only in ROS 2", help
    elif suggested := successor(kind):
        message = f"type '{kind}' does not exist in ROS 2, Humble to Rolling"
        yield controller.type_at, message, f"use {suggested}, and check its parameters"
    else:
        package = kind.partition("/")[0]
        types = [name for name in known if name.startswith(f"{package}/")]
        if types and not nearest(kind, known, CLOSE_TYPO):
            message = f"package '{package}' has no controller type '{kind}'"
            yield controller.type_at, message, f"use one of: {', '.join(types)}"


def _misspelt(controller: Controller) -> Iterator[_Problem]:
    known = controller_types()
    if controller.type not in known:
        if suggested := nearest(controller.type, known, CLOSE_TYPO):
            message = f"unknown type '{controller.type}'; did you mean '{suggested}'?"
            yield controller.type_at, message, f"write {suggested}"
        return
    typed = parameters_of(controller.type, controller.ros)
    names = {*parameters(controller.type), *(typed.types if typed else ())}
    for name in controller.section.given:
        suggested = nearest(name, names, CLOSE_TYPO) if name not in names else None
        if suggested and suggested not in controller.section.given and len(suggested) > 4:
            message = f"unknown parameter '{name}'; did you mean '{suggested}'?"
            yield controller.section.places[name], message, f"write {suggested}"


def _missing(
    controller: Controller, own: Section, others: dict[str, Section], given: Collection[str]
) -> Iterator[_Problem]:
    """Required parameters that the controller does not have, except misspelt ones."""
    if controller.namespaces > _MAX_NAMESPACES:
        return
    known = parameters_of(controller.type, controller.ros)
    required = known.required if known else ()
    known_names = {*own.places, *given}
    absent = [name for name in required if known_names.isdisjoint(name.split("|"))]
    declared = parameters(controller.type) if controller.type in controller_types() else ()
    missing = [
        name.replace("|", " or ")
        for name in absent
        if not any(
            one in declared and nearest(one, own.places, CLOSE_TYPO) for one in name.split("|")
        )
    ]
    message = f"required parameters are missing: {', '.join(missing)}"
    if missing and own.at:
        help = "add " + " and ".join(f"{name}: ..." for name in missing)
        if missing[0] == "joint" and "joints" in own.places:
            help = "write joint: NAME in place of joints, as it moves one joint"
            if group := _group(controller):
                help = f"use {group}, which reads joints, or name one joint"
        yield own.at, message, help
    elif missing:  # no parameters at all: they may be in another file, or under another name
        unowned = [
            name
            for name, section in others.items()
            if not any(section.places.keys().isdisjoint(one.split("|")) for one in required)
        ]
        if len(unowned) == 1 and (at := others[unowned[0]].at):
            message += f"; '{unowned[0]}' has them, but is not a controller"
            yield at, message, f"rename '{unowned[0]}' to '{controller.name}', or the reverse"


def _group(controller: Controller) -> str:
    """The class for several joints, in place of one for a single joint; empty if there is none."""
    group = controller.type.replace("/Joint", "/JointGroup")
    is_other = group != controller.type
    return group if is_other and parameters_of(group, controller.ros) else ""


def _invalid_values(known: ControllerParameters, section: Section) -> Iterator[_Problem]:
    lengths: dict[str, int] = data("controllers")["lengths"]
    for name, node in section.given.items():
        expected, actual = known.type_of(name), type_of(node)
        span = section.places[name] if isinstance(node, list) else node.span
        if expected and actual and actual != expected:
            message = f"{name} is {TYPES[actual]}, must be {TYPES[expected]}"
            yield span, message, correction(node, expected)
        elif name in known.positive and isinstance(node, Value) and is_not_positive(node):
            yield span, f"{name} is {node.text}, must be > 0", "write a positive number"
        elif wrong := _unknown_word(known, name, node):
            yield wrong
        elif isinstance(node, list) and len(node) != lengths.get(name, len(node)):
            message = f"{name} has {len(node)} values, must have {lengths[name]}"
            yield span, message, f"write {lengths[name]} values"


def _wrong_signs(known: ControllerParameters, section: Section) -> Iterator[_Problem]:
    for name, node in section.given.items():
        if isinstance(node, Value) and (bound := _bound(known, name, node)):
            yield node.span, f"{name} is {node.text}, must be {bound} 0", "change the sign"


def _bound(known: ControllerParameters, name: str, value: Value) -> str:
    """How a number must be to 0 and is not; empty if it has no such bound."""
    number = number_of(value)
    if number is None:
        return ""
    if name in known.not_negative and number < 0:
        return ">="
    return "<=" if name in known.not_positive and number > 0 else ""


def _unknown_word(
    known: ControllerParameters, name: str, node: Value | list[Node]
) -> _Problem | None:
    """A word that a parameter cannot have."""
    words = known.words_of(name)
    for value in scalars(node if isinstance(node, list) else [node]) if words else ():
        if value.text and value.text not in words and not value.text.startswith(TEMPLATE_MARKS):
            message = f"{name} has '{value.text}'{did_you_mean(value.text, words)}"
            return value.span, message, f"write one of {', '.join(words)}"
    return None


def _outdated(known: ControllerParameters, section: Section) -> Iterator[_Problem]:
    """A switch that newer versions do not read: it has no effect there."""
    for name, last in known.until.items():
        node = section.given.get(name)
        if isinstance(node, Value) and node.text.lower() == "false":
            message = f"{name} is not read after {last}: the controller reads stamped commands"
            yield node.span, message, f"publish TwistStamped, and remove {name}"


def _on_both_sides(controller: Controller) -> Iterator[_Problem]:
    """A wheel in the lists of both sides of a drive."""
    left = {value.text for value in controller.section.values("left_wheel_names")}
    for value in controller.section.values("right_wheel_names"):
        if value.text in left:
            message = f"'{value.text}' is in left_wheel_names, too"
            yield value.span, message, "name each wheel on its side only"
            break


def _at_two_corners(controller: Controller) -> Iterator[_Problem]:
    """A wheel that several parameters name, each of which is for another wheel."""
    names = controller.kind.joints if controller.kind else ()
    first: dict[str, str] = {}
    for name in names if "ecanum" in controller.type else ():
        for value in controller.section.values(name):
            if (other := first.setdefault(value.text, name)) != name:
                message = f"'{value.text}' is {other}, too"
                yield value.span, message, "name each wheel once"


def _wrong_axles(controller: Controller) -> Iterator[_Problem]:
    """Joint lists of a steering controller with the wrong length."""
    count = _OF_AXLE.get(controller.type.partition("_steering_controller/")[0])
    known = controller_types().get(controller.type)
    for name in known.joints if count and known else ():
        joints = controller.values([name])
        if len(joints) not in (0, count):
            message = f"{name} has {len(joints)} joints, must have {count}"
            yield controller.section.places[name], message, "name the joints of one axle only"

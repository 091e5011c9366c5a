"""A name is not accepted by a common program.

- White space: it splits Gazebo's topics, command lines and parameter names, and references to a
  name that ends in a space do not match.
- `::` separates scopes in SDF, and Gazebo rejects it in a name.
- `/` in the name of a joint that moves: ROS 1 parameters and MoveIt read it as a path. An info if
  the link has the same namespace.
- `/` at the beginning of the name of a link: links become frames of TF, and tf2 rejects such
  frames; `/base_link` and `base_link` are two frames. The first TF of ROS 1 allowed it.
- `world` and names in double underscores are reserved in SDF. Gazebo never creates a link `world`:
  it is right as the empty root that fixes the robot to the ground, but its mass and shapes are
  lost, and as the child of a joint it makes Gazebo and MuJoCo reject the robot (an error for
  MuJoCo if the joint moves: "joint found in world body").
- A digit at the beginning: USD rejects it, so that Isaac Sim renames the link or joint.

Use letters, digits and `_`, and begin with a letter.

Sources:
    ROS 1, names: http://wiki.ros.org/Names
    ROS 2, names: https://design.ros2.org/articles/topic_and_service_names.html
    sdformat, Utils.cc: https://github.com/gazebosim/sdformat/blob/main/src/Utils.cc
    tf2, migration: http://wiki.ros.org/tf2/Migration
    robot_state_publisher: https://github.com/ros/robot_state_publisher/blob/rolling/src/robot_state_publisher.cpp
    MuJoCo, xml_urdf.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
    Isaac Sim, URDF importer: https://docs.isaacsim.omniverse.nvidia.com/latest/robot_setup/ext_isaacsim_asset_importer_urdf.html
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.text.document import Attribute, Element
from urdfkit.text.grammar import is_expression

BAD = '<link name="base link"/>'
GOOD = '<link name="base_link"/>'


@rule(Severity.WARNING, help="use letters, digits and _")
def check(context: Context) -> Findings:
    model = context.model
    for element in (*(link.at for link in model.links), *(joint.at for joint in model.joints)):
        name = element.attributes.get("name")
        if name and name.value and not is_expression(name.value):
            yield from _characters(name)
            yield from _first_character(context, name)
            yield from _reserved(context, name)


def _characters(name: Attribute) -> Findings:
    """At most one finding about a character that is not accepted."""
    tag, text = name.element.tag, name.value
    is_fixed_joint = tag == "joint" and name.element.get("type") == "fixed"
    if text != text.strip():
        reason = "white space at an end of the name"
    elif any(character.isspace() for character in text):
        reason = "white space in the name, at which Gazebo topics and command lines break"
    elif "::" in text:
        reason = "'::' in the name separates scopes in Gazebo's SDF"
    elif "/" in text and tag == "joint" and not is_fixed_joint:
        reason = "'/' in the name of a joint, which ROS parameters read as a path"
    else:
        return
    # Nothing refers to a fixed joint by name; the same namespace in the link is intended.
    is_harmless = is_fixed_joint or ("/" in text and _has_namespace(name.element, text))
    severity = Severity.INFO if is_harmless else None
    yield Finding(name, f"{tag} '{text}': {reason}", group_key=reason, severity=severity)


def _has_namespace(joint: Element, text: str) -> bool:
    """True if the name of the child link of a joint has the same namespace."""
    child = joint.child("child")
    space = text.rpartition("/")[0] + "/"
    return child is not None and (child.get("link") or "").startswith(space)


def _first_character(context: Context, name: Attribute) -> Findings:
    tag, text = name.element.tag, name.value
    if text.startswith("/") and tag == "link":
        message = f"{tag} '{text}': tf2 rejects frames that begin with '/'"
        yield Finding(name, message, "remove the slash, here and wherever the link is named")
    elif "0" <= text[0] <= "9":
        isaac = context.targets.that("needs_usd_names")
        yield Finding(
            name,
            f"{tag} '{text}' begins with a digit, which USD does not allow",
            "begin with a letter",
            severity=Severity.WARNING if isaac else Severity.INFO,
            targets=isaac,
        )


def _reserved(context: Context, name: Attribute) -> Findings:
    tag, text = name.element.tag, name.value
    model = context.model
    if len(text) > 4 and text.startswith("__") and text.endswith("__"):
        reason = "names in double underscores are reserved in Gazebo's SDF"
    elif text != "world":
        return
    elif tag == "joint":
        reason = "the name is reserved for the world in Gazebo's SDF"
    elif any(joint.child_name == text for joint in model.joints):
        reason = "Gazebo and MuJoCo read it as the world, which cannot be a child link"
    elif not model.links_by_name[text].is_frame:
        reason = "Gazebo reads it as the world and drops its mass and shapes"
    else:
        return
    readers = context.targets.that("reserves_world")
    moves = any(joint.child_name == text and joint.kind != "fixed" for joint in model.joints)
    severity = Severity.WARNING if readers else Severity.INFO
    yield Finding(
        name,
        f"{tag} '{text}': {reason}",
        "choose another name",
        severity=Severity.ERROR if tag == "link" and moves and "mujoco" in readers else severity,
        targets=readers,
    )

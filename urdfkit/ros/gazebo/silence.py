"""Which rules about ``<gazebo>`` cannot have anything to say: a look costs less than their import.

The answers are cautious: a rule that is not named as silent may still find nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from itertools import chain
from math import inf, pi
from typing import TYPE_CHECKING

from urdfkit.ros.catalog.plugins import misspelt
from urdfkit.ros.catalog.sensors import types
from urdfkit.ros.gazebo.drives import drive_of
from urdfkit.ros.gazebo.plugins import Use, fate
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.targets import CLASSIC, GZ

if TYPE_CHECKING:
    from urdfkit.robot.model import RobotModel
    from urdfkit.ros.gazebo.conversion import Conversion
    from urdfkit.ros.gazebo.parameters import Unread
    from urdfkit.ros.targets import Targets


def about_blocks(model: RobotModel) -> set[str]:
    """The rules about the blocks themselves."""
    codes: set[str] = set()
    known = {"", *model.links_by_name, *model.joints_by_name}
    if all((block.get("reference") or "") in known for block in model.gazebo):
        codes.add("GAZ001")
    of_the_model = (block for block in model.gazebo if not block.get("reference"))
    if {child.tag for block in of_the_model for child in block.children} <= {"plugin", "static"}:
        codes.add("GAZ002")
    if not _may_lose_tags(model):
        codes.add("GAZ068")
    return codes


def _may_lose_tags(model: RobotModel) -> bool:
    """True if a shape has a name, or a link that Gazebo merges begins with the name of another."""
    bodies = (body for link in model.links for body in (*link.visuals, *link.collisions))
    if any("name" in body.at.attributes for body in bodies):
        return True
    merged = {joint.child.value for joint in model.joints if joint.child and joint.kind == "fixed"}
    merged &= {block.get("reference") or "" for block in model.gazebo}
    return any(_begins_with_another(name, model.links_by_name) for name in merged)


def _begins_with_another(name: str, others: Collection[str]) -> bool:
    """True if one of some names begins a name; of a very long one that is not looked for."""
    return len(name) > 200 or any(name[:end] in others for end in range(1, len(name)))


def about_plugins(uses: tuple[Use, ...], targets: Targets, conversion: Conversion) -> set[str]:
    """The rules about plugins.

    Args:
        uses: the plugins of the model.
        targets: that it is checked for.
        conversion: what Gazebo makes of it.
    """
    codes = {code for code, is_odd in _ABOUT_PLUGINS.items() if not any(map(is_odd, uses))}
    if not any(map(_is_of_another_generation, uses)):
        if not targets.any_of(("gz-fortress",)):  # which has names of its own
            codes.add("GAZ012")
        if len({use.plugin.generation for use in uses if use.plugin}) < 2:
            codes.add("GAZ013")
    references = list(chain.from_iterable(use.references() for use in uses))
    if all(fate(conversion, one.kind, one.name) == "kept" for one in references):
        codes |= {"GAZ020", "GAZ021", "GAZ022", "GAZ023"}
    if not any(reference.kind == "joint" for reference in references):
        codes.add("GAZ028")
    if conversion.model.transmissions or conversion.model.ros2_controls:
        codes.add("GAZ029")
    nodes = [use.name for use in uses if use.plugin and use.plugin.node]
    if len({*nodes}) == len(nodes):
        codes.add("GAZ027")
    return codes


def about_tags(unread: list[Unread]) -> set[str]:
    """The rules about tags that plugins do not read."""
    told = {
        "GAZ016": any(one.other is None and one.meant is None for one in unread),
        "GAZ018": any(one.other is not None for one in unread),
        "GAZ032": any(one.other is None and one.meant is not None for one in unread),
    }
    return {code for code, is_told in told.items() if not is_told}


def about_sensors(model: RobotModel, targets: Targets) -> set[str]:
    """The rules about sensors."""
    there = list(sensors(model))
    codes = {code for code, is_odd in _ABOUT_SENSORS.items() if not any(map(is_odd, there))}
    links = model.links_by_name
    if all(sensor.reference in links and sensor.type != "force_torque" for sensor in there):
        codes.add("GAZ062")
    if len({sensor.name for sensor in there}) == len(there):
        codes.add("GAZ061")
    if targets.names and not targets.any_of(GZ):
        codes.add("GAZ053")
        known = (types().get(sensor.type) for sensor in there)
        if targets.any_of(CLASSIC) and all(kind is None or kind.classic for kind in known):
            codes.add("GAZ041")
    return codes


def _is_of_another_generation(use: Use) -> bool:
    return use.plugin is None and not all(plugin.removed for plugin in use.known)


def _is_misplaced(use: Use) -> bool:
    kinds = use.plugin.kinds if use.plugin else ()
    return use.place == "link" or (bool(kinds) and use.place not in kinds)


def _is_in_another_sensor(use: Use) -> bool:
    serves = use.plugin.sensors if use.plugin and use.place == "sensor" else ()
    assert use.at.parent is not None
    return bool(serves) and use.at.parent.get("type") not in serves


def _has_absolute_name(use: Use) -> bool:
    return any(item.text.startswith("/") or ":=" in item.text for item in use.items)


def _has_odometry(use: Use) -> bool:
    return use.plugin is not None and any("odom" in name for name in use.plugin.parameters)


def _is_named_oddly(use: Use) -> bool:
    return not (use.name.isascii() and use.name.isidentifier())


def _has_no_rate(sensor: Sensor) -> bool:
    rate = sensor.number("update_rate")
    return rate is None or rate.value <= 0


def _has_odd_clip(sensor: Sensor) -> bool:
    near, far = sensor.number("camera/clip/near"), sensor.number("camera/clip/far")
    return near is not None and not 0 < near.value < (far.value if far else inf)


def _has_odd_view(sensor: Sensor) -> bool:
    angle = sensor.number("camera/horizontal_fov")
    is_odd = angle is not None and not 0 < angle.value <= 2 * pi
    return is_odd or len(sensor.at.all("camera")) > 1


def _is_on_optical_frame(sensor: Sensor) -> bool:
    return "optical" in sensor.reference


#: Silent if no plugin is odd in this way.
_ABOUT_PLUGINS: dict[str, Callable[[Use], bool]] = {
    "GAZ010": lambda use: not (use.name.strip() and use.filename),
    "GAZ011": lambda use: not use.known,
    "GAZ070": lambda use: not use.known and bool(misspelt(use.filename)),
    "GAZ014": _is_misplaced,
    "GAZ015": _is_in_another_sensor,
    "GAZ030": _has_absolute_name,
    "GAZ031": _has_odometry,
    "GAZ034": _is_named_oddly,
    "GAZ064": lambda use: drive_of(use) is not None,
}

#: Silent if no sensor is odd in this way.
_ABOUT_SENSORS: dict[str, Callable[[Sensor], bool]] = {
    "GAZ040": lambda sensor: sensor.type not in types(),
    "GAZ043": _has_no_rate,
    "GAZ048": _has_odd_clip,
    "GAZ049": _is_on_optical_frame,
    "GAZ056": _has_odd_view,
    "GAZ060": lambda sensor: not sensor.name.strip(),
}

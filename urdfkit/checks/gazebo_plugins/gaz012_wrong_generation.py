"""A plugin is for another generation of Gazebo than the robot, or than another of its plugins.

Gazebo Classic with ROS 1, Gazebo Classic with ROS 2, Fortress and gz-sim have separate libraries.
A library of another generation is not found: Gazebo writes an error and starts without it, and the
robot does not move or publishes no data. Use the successor, whose tags have other names, too.
Fortress accepts the names of gz-sim from 6.16 (January 2024) on, but only for the plugins of gz-sim
itself (info).

If no target is given and the plugins are for different generations, no Gazebo loads all of them: a
warning. It is a warning, too, if the robot's package is for another ROS than all of its plugins:
they are left over from that ROS, or the robot is still used with it. Choose one generation, or
select the block with a xacro argument (`<xacro:if value="$(arg use_gz)">`).

Sources:
    Gazebo, migration from Classic: https://gazebosim.org/docs/latest/migrating_gazebo_classic_ros2_packages/
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SystemLoader.cc
    gazebosim/ros_gz#362: https://github.com/gazebosim/ros_gz/issues/362
    gazebosim/gz-sim#2275: https://github.com/gazebosim/gz-sim/pull/2275
    jackal/jackal#129: https://github.com/jackal/jackal/issues/129
"""

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.plugins import GENERATIONS, TITLES, find
from urdfkit.ros.gazebo.plugins import PluginUse, generations
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.ros.targets import CLASSIC, GAZEBO, GZ, Targets, target_of_plugin
from urdfkit.text.editing.edits import all_or_none, replace_value

TARGETS = ("gz-fortress",)
BAD = robot_xml(
    solid_xml("base"),
    gazebo_xml(
        '<plugin name="gz::sim::systems::PosePublisher" filename="gz-sim-pose-publisher-system"/>'
    ),
)
FIXED = GOOD = BAD.replace("gz::sim", "ignition::gazebo").replace("gz-sim", "ignition-gazebo")

_NONE = "no successor is known"


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    by_target=dict.fromkeys(GAZEBO, Severity.ERROR),
    migrates=True,
)
def check(context: Context) -> Findings:
    findings = list(_wrong_generations(context))
    if not findings:
        return
    from urdfkit.ros.launch.robot_arguments import is_not_started  # for few robots

    # An expanded copy that no launch file starts may be for another Gazebo.
    if context.given_targets or not is_not_started(context.source, context.resolver):
        yield from findings


def _wrong_generations(context: Context) -> Findings:
    targets = [name for name in context.targets.names if name in GENERATIONS]
    is_reported = False
    severity = Severity.WARNING if _is_left_over(context) else None
    for use in context.plugins:
        present = [plugin for plugin in use.known if not plugin.removed]
        if not targets or not present or any(_runs(use, name) for name in targets):
            continue
        if context.targets.evidence and _is_of_another_family(use, context.targets):
            continue  # the robot itself is for two simulators
        if targets == ["gz-fortress"] and any(plugin.fortress_files for plugin in present):
            yield _renamed(use)
            continue
        loaders = " and ".join(dict.fromkeys(TITLES[plugin.generation] for plugin in present))
        targeted = " or ".join(TITLES[target] for target in targets)
        is_reported = True
        message = f"{use.title} is for {loaders}, but the robot is for {targeted}"
        fix = _fix(use, targets[0]) if targets[0] in GZ else None
        at, help = use.at.attributes["filename"], _successor(use, targets[0])
        yield Finding(at, message, help, fix, severity=severity)
    is_given = len({GENERATIONS[name][0] for name in targets}) == 1 and not context.targets.evidence
    if not is_reported and not is_given:
        yield from _mixed(context.plugins, context.targets)


def _is_left_over(context: Context) -> bool:
    """True if all plugins are for one Gazebo, and the target only follows from the package."""
    if not context.targets.evidence:
        return False
    possible = [names for use in context.plugins if (names := generations(use))]
    return bool(possible) and bool(set.intersection(*possible))


def _renamed(use: PluginUse) -> Finding:
    """A plugin of Fortress by the name that it has in gz-sim."""
    return Finding(
        use.at.attributes["filename"],
        f"{use.title} has this name in gz-sim; Gazebo Fortress finds it from 6.16 on",
        _successor(use, "gz-fortress"),
        _fix(use, "gz-fortress"),
        severity=Severity.INFO,
    )


def _mixed(plugins: tuple[PluginUse, ...], targets: Targets) -> Findings:
    """The first plugin that no Gazebo loads together with those before it.

    If the first plugin is not for the Gazebo that the robot is for, it is the exception.
    """
    first: PluginUse | None = None
    common: set[str] = set()
    for use in plugins:
        possible = generations(use)
        if not possible:
            continue
        if first is None:
            first, common = use, possible
        elif common & possible:
            common = common & possible
        else:
            is_first = _is_of_another_family(first, targets)
            pairs = [(use, possible), (first, common)]
            if is_first and not _is_of_another_family(use, targets):
                pairs.reverse()
            (wrong, its), (other, those) = pairs
            yield Finding(
                wrong.at.attributes["filename"],
                f"{wrong.title} is for {_named(its)}, but {other.title} for {_named(those)}",
                "keep the plugins of one, or choose between them with a xacro argument",
                related=(Related(other.at.span, f"for {_named(those)}"),),
                severity=Severity.WARNING,
            )
            return


def _named(possible: set[str]) -> str:
    return " or ".join(TITLES[name] for name in sorted(possible))


def _is_of_another_family(use: PluginUse, targets: Targets) -> bool:
    """True for a plugin of Gazebo Classic in a robot for gz-sim, and the reverse."""
    target = target_of_plugin(use.at.get("filename") or "", use.at)
    family = CLASSIC if target in CLASSIC else GZ
    return target is not None and not targets.any_of(family)


def _runs(use: PluginUse, target: str) -> bool:
    if target == "gz-fortress" and use.name.startswith("gz::sim::"):
        return False
    return not generations(use).isdisjoint(GENERATIONS[target])


def _fix(use: PluginUse, target: str) -> Fix | None:
    """The replacement in gz-sim; for plugins of gz-sim, their names in Fortress."""
    plugin = next((known for known in use.known if known.generation == "gz"), None)
    if plugin is None:
        from urdfkit.ros.gazebo.successors import successor

        return successor(use, target)
    if target != "gz-fortress" or not plugin.fortress_files or not plugin.fortress_class:
        return None
    names = {"filename": plugin.fortress_files[0], "name": plugin.fortress_class}
    edits = all_or_none(replace_value(use.at.attributes[key], text) for key, text in names.items())
    return Fix.of("use the names of Fortress", edits)


def _successor(use: PluginUse, target: str) -> str:
    """The replacement, one or two generations later."""
    if target == "gz-fortress" and any(plugin.generation == "gz" for plugin in use.known):
        return "use the names of Fortress: ignition-gazebo-... and ignition::gazebo::systems::..."
    old = use.known[0]
    for _ in range(len(use.known) + 1):
        if old.successor is None:
            return f"use its successor: {old.advice}" if old.advice else _NONE
        successors = [plugin for plugin in find(old.successor) if not plugin.removed]
        if any(plugin.generation in GENERATIONS[target] for plugin in successors):
            advice = f" ({old.advice})" if old.advice else ""
            return f"use {old.successor}{advice}; its tags have other names"
        newer = (p for p in successors if p.id != old.id and p.generation != old.generation)
        successor = next(newer, None)
        if successor is None:
            return _NONE
        old = successor
    return _NONE

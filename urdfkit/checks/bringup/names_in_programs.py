"""Typos in what programs of the workspace name: the actions of controllers, and lists of joints.

Also topics of a controller that controllers of other types, or of ROS 1, read.

A name that is far from all known ones may be of another robot, and is not reported.
"""

import re
from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache

from urdfkit.checks.bringup.defined_controllers import controllers_of_workspace
from urdfkit.checks.bringup.workspace_launches import robots_of_workspace
from urdfkit.core.suggest import is_typo, nearest
from urdfkit.lint.rules import Context, Finding, Findings
from urdfkit.ros.catalog import data
from urdfkit.text.source import Source, Span
from urdfkit.workspace.program_strings import sources_of_programs
from urdfkit.workspace.resolve import Resolver

#: ``"arm_controller/follow_joint_trajectory"``, and lists of three or more words.
_ACTION = re.compile(rb"""(["'])/?(\w+)/(\w+)\1""")
_LIST = re.compile(
    rb"""[\[({]\s*((?:["'][\w/]+["']\s*,\s*){2,63}["'][\w/]+["'])(?:\s*,)?\s*[\])}]"""
)
_WORD = re.compile(rb"""["']([\w/]+)["']""")
#: Least similarity of a misspelt action: the topic ``joint_trajectory`` is not one.
_OF_ACTIONS = 0.9
#: How many letters of an action a program must contain.
_BEGIN = 8
#: The topics of controllers, which programs may use in place of their actions.
_TOPICS = {"joint_trajectory_controller/JointTrajectoryController": "joint_trajectory"}
#: What the names of controllers have next to the name of their part.
_KINDS = {"control", "controller", "effort", "joint", "position", "trajectory", "velocity"}
#: The topic of the controllers of ROS 1.
_OF_ROS_1 = "command"
#: Least length of a word with a typo: ``arm_l`` is not ``arm_r``.
_MIN_LENGTH = 3


def misspelt_names(context: Context) -> Findings:
    """Actions and joints with a typo in the programs that a launch file starts."""
    near, resolver = context.source.path, context.resolver
    known = resolver.packages.known(near)
    packages = dict.fromkeys(node.package for node in context.launch.started)
    own = [package for package in packages if package in known]
    actions = [name for package in own for name in _actions(package, near, resolver)]
    lists = [names for package in own for names in _lists(package, near, resolver)]
    if actions:
        yield from _misspelt_actions(context, actions)
    if topics := [name for package in own for name in _topics(package, near, resolver)]:
        yield from _unread_topics(context, topics)
    if lists:
        robots = [robot.model for robot in robots_of_workspace(context)]
        joints = {name for model in robots for name in model.joints_by_name}
        links = {name for model in robots for name in model.links_by_name}
        for names in lists:
            yield from _misspelt_joint(names, joints, links)


def _misspelt_actions(context: Context, named: Iterable[Span]) -> Findings:
    controllers = controllers_of_workspace(context)
    served: dict[str, str] = {}
    for controller in controllers.values():
        if action := data("moveit")["actions"].get(controller.type):
            served[controller.name] = action[1]
    for at in named:
        name, _, action = at.text.strip("/").partition("/")
        expected = served.get(name, "")
        if expected and action != expected and nearest(action, [expected], _OF_ACTIONS):
            message = f"controller '{name}' serves '{expected}', not '{action}'"
            yield Finding(at, message, f"write {name}/{expected}")
        elif name not in controllers:
            others = [
                other
                for other in served
                if action in (served[other], _TOPICS.get(controllers[other].type))
            ]
            similar = [other for other in others if _is_misspelt(name, other)]
            similar += [other for other in others if _part(other) == _part(name) != set()]
            if other := next(iter(similar), ""):
                message = f"no controller is called '{name}'; did you mean '{other}'?"
                yield Finding(at, message, f"write {other}/{action}")


def _unread_topics(context: Context, named: Iterable[Span]) -> Findings:
    """Topics of commands that a controller of this type does not read."""
    controllers = controllers_of_workspace(context)
    by_type: dict[str, str] = data("moveit")["servo_topics"]
    for at in named:
        name, _, topic = at.text.strip("/").partition("/")
        controller = controllers.get(name)
        read = by_type.get(controller.type, "") if controller else ""
        if read and topic != read and topic in (_OF_ROS_1, *by_type.values()):
            message = f"controller '{name}' reads '{read}', not '{topic}'"
            yield Finding(at, message, f"write {name}/{read}")


def _misspelt_joint(names: list[Span], joints: Collection[str], links: Collection[str]) -> Findings:
    """The only name in a list of joints that is none, but almost another joint of the robots."""
    listed = {at.text for at in names}
    unknown = [at for at in names if at.text not in joints]
    if len(unknown) != 1 or unknown[0].text in links:
        return
    (at,) = unknown
    free = sorted(set(joints) - listed)
    if other := next((joint for joint in free if _is_misspelt(at.text, joint)), ""):
        message = f"unknown joint '{at.text}'; did you mean '{other}'?"
        yield Finding(at, message, f"write {other}")


def _part(controller: str) -> set[str]:
    """The words for what a controller moves: of ``arm_trajectory_controller``, ``arm``."""
    return set(controller.split("_")) - _KINDS


def _is_misspelt(name: str, other: str) -> bool:
    """True if one word of a name has a typo; short words tell similar parts apart."""
    pairs = list(zip(name.split("_"), other.split("_"), strict=False))
    different = [pair for pair in pairs if pair[0] != pair[1]]
    is_long = all(len(word) >= _MIN_LENGTH for pair in different for word in pair)
    return name.count("_") == other.count("_") and is_long and is_typo(name, other)


@lru_cache(maxsize=16)  # several launch files start programs of one package
def _actions(package: str, near: str, resolver: Resolver) -> tuple[Span, ...]:
    names = [action for _, action in data("moveit")["actions"].values()]
    served = {name.encode()[:_BEGIN] for name in (*names, *_TOPICS.values())}
    sources = sources_of_programs(package, near, resolver)
    naming = (source for source in sources if any(begin in source.data for begin in served))
    return tuple(at for source in naming for at in pairs_of_words(source))


@lru_cache(maxsize=16)
def _topics(package: str, near: str, resolver: Resolver) -> tuple[Span, ...]:
    words = {f"/{topic}".encode() for topic in data("moveit")["servo_topics"].values()}
    words.add(f"/{_OF_ROS_1}".encode())
    sources = sources_of_programs(package, near, resolver)
    naming = (source for source in sources if any(word in source.data for word in words))
    return tuple(at for source in naming for at in pairs_of_words(source))


@lru_cache(maxsize=16)
def _lists(package: str, near: str, resolver: Resolver) -> tuple[list[Span], ...]:
    sources = sources_of_programs(package, near, resolver)
    return tuple(names for source in sources for names in lists_of_words(source))


def pairs_of_words(source: Source) -> Iterator[Span]:
    """What may name the action of a controller, without quotes."""
    for match in _ACTION.finditer(source.data):
        yield Span(source, match.start() + 1, match.end() - 1)


def lists_of_words(source: Source) -> Iterator[list[Span]]:
    """What may be a list of joints, without quotes."""
    for match in _LIST.finditer(source.data):
        start = match.start(1)
        words = _WORD.finditer(match[1])
        yield [Span(source, start + word.start(1), start + word.end(1)) for word in words]

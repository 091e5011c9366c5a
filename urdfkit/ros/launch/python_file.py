"""A launch file in Python, its calls, and the files that it names."""

import ast
import os
from collections.abc import Collection, Iterable, Iterator
from functools import cached_property

from urdfkit.core import disk
from urdfkit.ros.launch.branches import decided_calls
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.collect import Collector, frame_at, path_from
from urdfkit.ros.launch.contents import LaunchedFile
from urdfkit.ros.launch.launch_description import TRIGGERS
from urdfkit.ros.launch.values import COMPUTED, Values
from urdfkit.text import python_source
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import CallFrame, Tag

#: Actions that start a node.
NODES = ("LifecycleNode", "Node")
#: Conditions with an expression that is true or false.
_PREDICATES = ("IfCondition", "UnlessCondition")
#: What reads an argument of the launch file, and the parameter with its name.
_OF_ARGUMENTS = {
    "LaunchConfiguration": "variable_name",
    "LaunchConfigurationEquals": "launch_configuration_name",
    "LaunchConfigurationNotEquals": "launch_configuration_name",
}
#: Starts of paths that do not depend on the working directory, or only on the usual one.
_KNOWN_STARTS = ("~", "$", "package://", "file://", "src/")


class PythonLaunchFile:
    """A launch file with the known values of its arguments.

    Attributes:
        values: of its expressions; the defaults of arguments are added while the file is read.
        frame: the launch files that include it.
    """

    def __init__(self, collector: Collector, file: LaunchedFile, tree: ast.Module) -> None:
        self.collector = collector
        self.source = file.source
        self.frame = file.frame
        self.fixed = file.fixed
        self.tree = tree
        self.values = Values(collector, file, tree)
        self._conditions: dict[ast.Call, bool | None] = {}
        self.calls = [node for node in python_source.nodes(tree) if isinstance(node, ast.Call)]

    def call_frame(self, call: ast.Call) -> CallFrame:
        start = self.values.span(call).start
        return frame_at(self.source, Tag(self.source, start, start), self.frame)

    # ---------------------------------------------------------------- files

    def path(self, node: ast.expr | None) -> str | None:
        """An absolute path; None for a relative path: the working directory is unknown.

        None, too, for a missing file with an argument in its path that is still empty.
        """
        text = self.values.text(node)
        path = path_from(self.source, text) if text else ""
        if not text or node is None or not (os.path.isabs(text) or disk.exists(path)):
            return None
        return None if self.lacks_argument(node) else path

    def lacks_argument(self, node: ast.expr) -> bool:
        """True for the path of a missing file with an argument in it that is still empty."""
        text = self.values.text(node)
        if not text or disk.exists(path_from(self.source, text)):
            return False
        calls = (call for call in self._calls_in([node]) if called(call) == "LaunchConfiguration")
        return any(self.values.text(call) == "" for call in calls)

    def record_file(self, node: ast.expr, purpose: str) -> None:
        """Record a file that the launch file names, and report a relative path."""
        if path := self.path(node):
            self.collector.file(path, self.values.span(node), purpose)
        else:
            self.report_relative(node, purpose)

    def report_relative(self, node: ast.expr, purpose: str) -> None:
        """Report a path that is only found from one working directory.

        An included file is reported when it is read itself. A path below ``src`` is meant to be
        found from the workspace, where launch is usually started.
        """
        text = self.values.text(node)
        if not text or self.frame or os.path.isabs(text) or text.startswith(_KNOWN_STARTS):
            return
        name, path = self._package_of(text)
        message = f"{purpose} '{text}' is looked for where launch is started, not in the package"
        help = f'write os.path.join(get_package_share_directory("{name}"), "{path}")'
        problem = Problem("LAU003", self.values.span(node), message, help)
        self.collector.problems.append(problem)

    def _package_of(self, path: str) -> tuple[str, str]:
        """The package with a relative path, such as ``src/arm/config/arm.yaml``, and what follows.

        That of the launch file if none has the file.
        """
        packages = self.collector.resolver.packages
        own = packages.enclosing(self.source.path)
        if own and not disk.exists(os.path.join(own[1], path)):
            directories, slash, rest = path.partition("/")
            known = packages.known(self.source.path)
            while slash:
                directory = known.get(directories)
                if directory and disk.exists(os.path.join(directory, rest)):
                    return directories, rest
                directories, slash, rest = rest.partition("/")
        return own[0] if own else "PACKAGE", path

    # ---------------------------------------------------------------- conditions

    def condition(self, action: ast.Call) -> bool | None:
        """Value of the condition of an action; None if known only at run time."""
        if action not in self._conditions:
            self._conditions[action] = self._condition(action)
        return self._conditions[action]

    def _condition(self, action: ast.Call) -> bool | None:
        written = argument(action, None, "condition")
        if written is None:
            return None if action in self._decided else True
        condition = self.values.resolved(written)
        is_missing = isinstance(condition, ast.Constant) and condition.value is None
        if not isinstance(condition, ast.Call) and not is_missing:
            return None
        if isinstance(condition, ast.Call) and not (holds := self._holds(condition)):
            return holds
        return None if action in self._decided else True

    def _holds(self, condition: ast.Call) -> bool | None:
        """Value of a condition; None if known only at run time.

        A false comparison with a default is unknown, too: the action belongs to another choice.
        """
        predicate = self.values.resolved(argument(condition, 0, "predicate_expression"))
        is_choice = called(condition) not in _PREDICATES or called(predicate) in COMPUTED
        holds = self._with_these_values(condition)
        return None if is_choice and holds is False else holds

    def _with_these_values(self, condition: ast.Call) -> bool | None:
        """Value of a condition with the known values of the arguments."""
        name = called(condition)
        if name not in _PREDICATES:
            return self._equals(condition)
        text = self.values.text(argument(condition, 0, "predicate_expression")) or ""
        is_true = {"true": True, "1": True, "false": False, "0": False}.get(text.lower())
        return None if is_true is None else is_true is (name == "IfCondition")

    def _equals(self, condition: ast.Call) -> bool | None:
        name = called(condition)
        if name not in ("LaunchConfigurationEquals", "LaunchConfigurationNotEquals"):
            return None
        key = self.values.text(argument(condition, 0, "launch_configuration_name")) or ""
        value = self.values.configuration(key)
        expected = self.values.text(argument(condition, 1, "expected_value"))
        is_known = value is not None and expected is not None
        return (value == expected) is name.endswith("nEquals") if is_known else None

    def chosen_otherwise(self, action: ast.Call) -> set[str]:
        """The arguments with other values where an action runs than those that are known.

        They decide on it by a condition, or on its group, that does not hold with these values.
        """
        conditions = [*self._conditions_around.get(action, ()), *self._open_condition(action)]
        return {name for condition in conditions for name in self._compared(condition)}

    def _open_condition(self, action: ast.Call) -> Iterator[ast.Call]:
        """The condition of an action, unless it is true with the known values."""
        condition = self.values.resolved(argument(action, None, "condition"))
        if isinstance(condition, ast.Call) and not self._with_these_values(condition):
            yield condition

    def _compared(self, condition: ast.Call) -> Iterator[str]:
        """The arguments in a condition."""
        for call in self._calls_in([condition]):
            if called(call) in _OF_ARGUMENTS:
                yield self.values.text(argument(call, 0, _OF_ARGUMENTS[called(call)])) or ""

    @cached_property
    def _conditions_around(self) -> dict[ast.Call, list[ast.Call]]:
        """The conditions of groups that are not true with the known values, by action."""
        conditions: dict[ast.Call, list[ast.Call]] = {}
        for group in filter(_is_group, self._conditional):
            for condition in self._open_condition(group):
                for action in self._within([group]):
                    conditions.setdefault(action, []).append(condition)
        return conditions

    def is_sure(self, action: ast.Call) -> bool:
        """True if an action certainly runs."""
        is_free = not self._has_open_groups and action not in self._outer_conditions
        return is_free and self.condition(action) is True

    def is_off(self, action: ast.Call) -> bool:
        """True if a condition switches an action off, or the action that contains it."""
        return self._outer_conditions.get(action) is False or self.condition(action) is False

    def is_never(self, action: ast.Call) -> bool:
        """True if arguments that are given, as by the including launch file, switch it off."""
        condition = self.values.resolved(argument(action, None, "condition"))
        if not self.fixed or not isinstance(condition, ast.Call):
            return False
        names = set(self._compared(condition))
        is_given = bool(names) and names <= self.fixed
        return is_given and self._with_these_values(condition) is False

    def only_of_never(self) -> set[ast.Call]:
        """The calls whose values only nodes get that never run, as `is_never` says."""
        never = [call for call in self.calls if called(call) in NODES and self.is_never(call)]
        if not never:
            return set()
        inner = set(self._within(never)).union(never)
        outer = [child for call in self.calls if call not in inner for child in _children(call)]
        return inner.difference(self._calls_in(outer, set(never)))

    @cached_property
    def _decided(self) -> frozenset[ast.Call]:
        return decided_calls(self.tree)

    @cached_property
    def _has_open_groups(self) -> bool:
        """True if any action may be in a group with a condition, whose actions are unknown."""
        groups = filter(_is_group, self._conditional)
        lists = {self.values.resolved(argument(group, 0, "actions")) for group in groups}
        items = (item for actions in lists for item in self.values.items(actions))
        return not all(isinstance(self.values.resolved(item), ast.Call) for item in items)

    @cached_property
    def _outer_conditions(self) -> dict[ast.AST, bool | None]:
        """The condition, unless it is true, of what contains or triggers an action, by action."""
        conditions: dict[ast.AST, bool | None] = {}
        for holds in (None, False):
            outer = [call for call, value in self._conditional.items() if value is holds]
            conditions.update(dict.fromkeys(self._within(outer), holds))
        return conditions

    @cached_property
    def _conditional(self) -> dict[ast.Call, bool | None]:
        """The groups, and what starts actions later, whose condition is not always true."""
        outer = [call for call in self.calls if _is_group(call) or called(call) in TRIGGERS]
        return {call: holds for call in outer if (holds := self.condition(call)) is not True}

    def _within(self, calls: Iterable[ast.Call]) -> Iterator[ast.Call]:
        """The calls in other calls, also by the names in them."""
        return self._calls_in([child for call in calls for child in _children(call)])

    def _calls_in(
        self, stack: list[ast.AST], passed: Collection[ast.AST] = ()
    ) -> Iterator[ast.Call]:
        """The calls in nodes, also by the names in them, but not in those that are passed over."""
        seen = set(passed)
        while stack:
            node = stack.pop()
            if node in seen:
                continue
            seen.add(node)
            if isinstance(node, ast.Call):
                yield node
            if isinstance(node, ast.Name) and (value := self.values.resolved(node)):
                stack.append(value)
            stack += ast.iter_child_nodes(node)


def _children(call: ast.Call) -> list[ast.AST]:
    return list(ast.iter_child_nodes(call))


def _is_group(call: ast.Call) -> bool:
    return called(call) == "GroupAction"

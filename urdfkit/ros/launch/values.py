"""Values of constant expressions in a Python launch file."""

import ast
import operator
import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from urdfkit.ros.launch.calls import argument, called, parts_of_path
from urdfkit.ros.launch.chosen_values import chosen
from urdfkit.ros.launch.collect import UNKNOWN, Collector
from urdfkit.ros.launch.computed import computed
from urdfkit.ros.launch.contents import LaunchedFile, Word
from urdfkit.ros.launch.joined_texts import joined, joined_path
from urdfkit.ros.launch.scopes import scopes
from urdfkit.text import python_source
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.source import Span

#: Greatest depth of nested expressions that are evaluated.
MAX_DEPTH = 40
#: Most expressions that are evaluated for one text: lists of lists double them at each level.
_MAX_STEPS = 10_000

#: Greatest number that is computed with.
_MAX_NUMBER = 1e15

PACKAGE_DIRECTORY = ("get_package_share_directory", "FindPackageShare", "get_package_share_path")
#: Calls whose value is that of an argument, with its name.
_PASSED_ON = {
    "FindExecutable": "name",
    "ParameterValue": "value",
    "TextSubstitution": "text",
    "ParameterFile": "param_file",
    "str": "object",
    "Path": "",
    "abspath": "path",
    "realpath": "filename",
    "perform_substitution": "substitution",
    "PythonLaunchDescriptionSource": "launch_file_path",
    "XMLLaunchDescriptionSource": "launch_file_path",
    "YAMLLaunchDescriptionSource": "launch_file_path",
    "FrontendLaunchDescriptionSource": "launch_file_path",
    "AnyLaunchDescriptionSource": "launch_file_path",
}
#: Methods whose value is that of their object: of a substitution in an OpaqueFunction, of a path.
_OF_OBJECT = ("perform", "resolve", "absolute", "as_posix")
#: Functions with the value of an environment variable, and the name of the argument for its
#: default: most users do not set the variable.
_OF_ENVIRONMENT = {"EnvironmentVariable": "default_value", "get": "default", "getenv": "default"}
_ENVIRONMENTS = ("os.environ", "environ")
#: Attributes of ``os`` on Linux.
_SEPARATORS = {"pathsep": ":", "sep": "/"}
#: Variables that are always set, with a value that files for several distributions expect.
_ASSUMED = {"ROS_DISTRO": "jazzy"}
#: Variables that are always set, so that a default is never the value.
_ALWAYS_SET = ("HOME", "LOGNAME", "PATH", "PWD", "USER")
#: Operators between numbers; between other values, ``+`` joins texts, and ``/`` paths.
_ARITHMETIC: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
#: Substitutions whose result is computed: the name in XML, and the names of the arguments.
COMPUTED = {
    "PythonExpression": ("eval", ("expression",)),
    "EqualsSubstitution": ("equals", ("left", "right")),
    "NotEqualsSubstitution": ("not-equals", ("left", "right")),
    "AndSubstitution": ("and", ("left", "right")),
    "OrSubstitution": ("or", ("left", "right")),
    "NotSubstitution": ("not", ("value",)),
    "IfElseSubstitution": ("if", ("condition", "if_value", "else_value")),
    "AllSubstitution": ("all", ()),
    "AnySubstitution": ("any", ()),
}

#: What follows the name of a list or a dictionary where it gets further items.
_GROWS = r"\s*(?:\.(?:append|extend|insert|setdefault|update)\(|\[[^\]\n]*\]\s*=[^=]|[|+]=)"


class Values:
    """Evaluates constants in a launch file.

    Attributes:
        arguments: values as text, or expressions of defaults; None if unknown.
    """

    def __init__(self, collector: Collector, file: LaunchedFile, tree: ast.Module) -> None:
        self.collector = collector
        self.source = file.source
        self.arguments: dict[str, ast.expr | str | None] = dict(file.arguments)
        self._scopes = scopes(tree)
        self._steps = 0
        self._opened: dict[str, list[ast.expr]] = {}
        self._set: list[ast.Call] = []
        for node in python_source.nodes(tree):
            if isinstance(node, ast.Call) and called(node) == "SetLaunchConfiguration":
                self._set.append(node)
            for item in node.items if isinstance(node, ast.With) else ():
                if isinstance(item.optional_vars, ast.Name):
                    self._opened.setdefault(item.optional_vars.id, []).append(item.context_expr)

    def text(self, node: ast.expr | None, depth: int = 0) -> str | None:
        """The text of an expression; None if it is known only at run time."""
        self._steps = self._steps + 1 if depth else 0
        if node is None or depth > MAX_DEPTH or self._steps > _MAX_STEPS:
            return None
        if isinstance(node, ast.Constant) and isinstance(node.value, (str, bool)):
            return str(node.value)
        if isinstance(node, ast.Name):
            if node.id == "__file__":
                return os.path.abspath(self.source.path)
            return self.text(self._scopes.value(node), depth + 1)
        if isinstance(node, (ast.List, ast.Tuple)):
            return self._of_parts(joined, node.elts, depth)
        if isinstance(node, ast.BinOp):
            return self._of_operation(node, depth)
        if (value := self._number(node, depth)) is not None:
            return str(value)
        if isinstance(node, ast.JoinedStr):
            return joined(self.text(part, depth + 1) for part in node.values)
        if isinstance(node, ast.FormattedValue):
            return self.text(node.value, depth + 1)
        return self._of_expression(node, depth)

    def _of_operation(self, node: ast.BinOp, depth: int) -> str | None:
        """The text of a number that is computed, of joined texts or of a path."""
        value = self._number(node, depth)
        if value is not None or not isinstance(node.op, (ast.Add, ast.Div)):
            return None if value is None else str(value)
        if self._number(node.left, depth + 1) is not None:
            return None  # a number that cannot be computed
        join = joined_path if isinstance(node.op, ast.Div) else joined
        return join(self.text(n, depth + 1) for n in (node.left, node.right))

    def _of_parts(
        self, join: Callable[[Iterable[str | None]], str | None], parts: list[ast.expr], depth: int
    ) -> str | None:
        """The joined texts of expressions, and of those that ``*`` unpacks."""
        every = (one for part in parts for one in self._unpacked(part, depth))
        return join(self.text(one, depth + 1) for one in every)

    def _number(self, node: ast.expr | None, depth: int) -> float | None:
        """The value of a number, or of a sum, difference, product or quotient of numbers."""
        self._steps += 1
        node = self.resolved(node)
        if depth > MAX_DEPTH or self._steps > _MAX_STEPS:
            return None
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
            return None if isinstance(node.value, bool) else _bounded(node.value)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            value = self._number(node.operand, depth + 1)
            return None if value is None else -value
        if not isinstance(node, ast.BinOp) or type(node.op) not in _ARITHMETIC:
            return None
        left = self._number(node.left, depth + 1)
        right = None if left is None else self._number(node.right, depth + 1)
        if left is None or right is None:
            return None
        try:
            return _bounded(_ARITHMETIC[type(node.op)](left, right))
        except ArithmeticError:
            return None

    def _of_expression(self, node: ast.expr, depth: int) -> str | None:
        """The text of an attribute, a condition, an item or a call."""
        if isinstance(node, ast.Attribute) and node.attr == "parent":
            return _directory(self.text(node.value, depth + 1))
        if isinstance(node, ast.Attribute) and node.attr in _SEPARATORS:
            return _SEPARATORS[node.attr] if python_source.dotted_name(node.value) == "os" else None
        if isinstance(node, ast.Attribute) and node.attr == "package_path":
            builder = self._builder(node.value)
            package = self.package_of(builder) if builder else None
            return self._directory_of(package, builder) if builder and package else None
        if isinstance(node, ast.IfExp):
            holds = self._holds(node.test, depth + 1)
            branch = node.body if holds else node.orelse
            return None if holds is None else self.text(branch, depth + 1)
        if (
            isinstance(node, ast.Subscript)
            and python_source.dotted_name(node.value) in _ENVIRONMENTS
        ):
            return _ASSUMED.get(self.text(node.slice, depth + 1) or "")
        if isinstance(node, ast.Subscript) and _is_of_context(node.value):
            return self.configuration(self.text(node.slice, depth + 1) or "", depth)
        return self._of_call(node, depth) if isinstance(node, ast.Call) else None

    def _holds(self, test: ast.expr, depth: int) -> bool | None:
        """Whether two texts are equal; None for any other test, or unknown texts."""
        known = self.resolved(test)
        if isinstance(known, ast.UnaryOp) and isinstance(known.op, ast.Not) and depth < MAX_DEPTH:
            holds = self._holds(known.operand, depth + 1)
            return None if holds is None else not holds
        if not isinstance(known, ast.Compare) or len(known.ops) > 1:
            return None
        (operator,), (right,) = known.ops, known.comparators
        if isinstance(operator, (ast.Eq, ast.NotEq)):
            others = [self.text(right, depth)]
        elif isinstance(operator, (ast.In, ast.NotIn)) and not isinstance(right, ast.Constant):
            others = [self.text(item, depth) for item in self.items(right, depth)]
        else:
            return None
        left = self.text(known.left, depth)
        if left is None or None in others:
            return None
        return (left in others) == isinstance(operator, (ast.Eq, ast.In))

    def resolved(self, node: ast.expr | None) -> ast.expr | None:
        """An expression, or the value of a name; None if it is ambiguous."""
        for _ in range(MAX_DEPTH):
            node = self._of_name(node)
            part = node and chosen(node, self._of_name)
            if part is node:
                return node
            node = part
        return None

    def _of_name(self, node: ast.expr | None) -> ast.expr | None:
        """An expression, or what a name is assigned; None if it is ambiguous."""
        for _ in range(MAX_DEPTH):
            if not isinstance(node, ast.Name):
                return node
            node = self._scopes.value(node)
        return None

    def created(self, node: ast.expr) -> ast.expr | None:
        """What an expression creates: itself, or what a function of the file returns."""
        for _ in range(MAX_DEPTH):
            returned = self._scopes.returned(node) if isinstance(node, ast.Call) else None
            if returned is None:
                return node
            node = returned
        return None

    def has_context(self, node: ast.expr) -> bool:
        """True for a name in a function with the context in which its value is known."""
        return isinstance(node, ast.Name) and self._scopes.sees(node, "context")

    def problem(
        self,
        code: str,
        node: ast.expr | ast.stmt,
        message: str,
        help: str,
        severity: Severity = Severity.ERROR,
    ) -> Problem:
        """A problem of an expression or a statement of the launch file."""
        return Problem(code, self.span(node), message, help, severity=severity)

    def pairs(self, node: ast.expr | None) -> list[tuple[ast.expr | None, ast.expr]]:
        """The keys and values of a dictionary; empty for any other expression."""
        node = self.resolved(node)
        written = zip(node.keys, node.values, strict=True) if isinstance(node, ast.Dict) else ()
        pairs: list[tuple[ast.expr | None, ast.expr]] = []
        for key, value in written:
            inner = self.resolved(value) if key is None else None
            pairs += self.pairs(inner) if isinstance(inner, ast.Dict) else [(key, value)]
        return pairs

    def opened(self, node: ast.expr | None) -> ast.expr | None:
        """The call that opens the file of a name in ``with open(...) as name``."""
        calls = self._opened.get(node.id, []) if isinstance(node, ast.Name) else []
        return calls[0] if len(calls) == 1 else None

    def items(self, node: ast.expr | None, depth: int = 0) -> list[ast.expr | None]:
        """The items of a list; None stands for any number of unknown items."""
        node = self.resolved(node)
        if depth > MAX_DEPTH:
            return [None]
        if isinstance(node, (ast.List, ast.Tuple)):
            return [one for item in node.elts for one in self._unpacked(item, depth)]
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            left, right = (self.items(side, depth + 1) for side in (node.left, node.right))
            return left + right
        if isinstance(node, ast.Call) and (returned := self._scopes.returned(node)) is not None:
            return self.items(returned, depth + 1)
        if isinstance(node, ast.Call) and called(node) in ("list", "tuple") and node.args:
            return self._keys(node.args[0]) or self.items(node.args[0], depth + 1)
        return [None]

    def _unpacked(self, item: ast.expr, depth: int) -> list[ast.expr | None]:
        """An item of a list, or the items that ``*`` unpacks."""
        if not isinstance(item, ast.Starred):
            return [item]
        return [None] if self.grows(item.value) else self.items(item.value, depth + 1)

    def grows(self, node: ast.expr | None) -> bool:
        """True for the name of a list or a dictionary that gets further items later."""
        name = node.id if isinstance(node, ast.Name) else None
        return bool(name and re.search(rf"\b{name}{_GROWS}".encode(), self.source.data))

    def _keys(self, node: ast.expr) -> list[ast.expr | None]:
        """The keys of a dictionary; empty for any other expression."""
        function = node.func if isinstance(node, ast.Call) else None
        is_keys = isinstance(function, ast.Attribute) and function.attr == "keys"
        owner = function.value if isinstance(function, ast.Attribute) and is_keys else node
        return [key for key, _ in self.pairs(owner)]

    def words(self, node: ast.expr | None) -> tuple[Word, ...]:
        """The words of a command line in a list; empty without one."""
        if node is None:
            return ()
        place = self.span(node)
        resolved = self.resolved(node)
        if isinstance(resolved, ast.Call) and called(resolved) == "split" and not resolved.args:
            owner = resolved.func.value if isinstance(resolved.func, ast.Attribute) else None
            text = self.text(owner)
            return tuple(Word(word, place) for word in (text.split() if text else [None]))
        return tuple(
            Word(None, place) if item is None else Word(self.text(item), self.span(item))
            for item in self.items(node)
        )

    def span(self, node: ast.expr | ast.stmt) -> Span:
        """Source location of a node; ast counts columns in bytes of UTF-8."""
        starts = self.source.offset(node.lineno, 1) + node.col_offset
        end_line, end_column = node.end_lineno or node.lineno, node.end_col_offset or 0
        return Span(self.source, starts, self.source.offset(end_line, 1) + end_column)

    def _of_call(self, call: ast.Call, depth: int) -> str | None:
        name = called(call)
        if name in PACKAGE_DIRECTORY:
            return self._package_directory(call, depth)
        if parts := parts_of_path(call):
            return self._of_parts(joined_path, parts, depth)
        if name == "LaunchConfiguration":
            return self._of_configuration(call, depth)
        if name == "ThisLaunchFileDir":
            return os.path.dirname(os.path.abspath(self.source.path))
        if name in COMPUTED:
            return self._computed(call, depth)
        if isinstance(call.func, ast.Attribute) and name in _OF_OBJECT:
            return self.text(call.func.value, depth + 1)
        if isinstance(call.func, ast.Attribute) and name == "lower":
            text = self.text(call.func.value, depth + 1)
            return None if text is None else text.lower()
        if (returned := self._scopes.returned(call)) is not None:
            return self.text(returned, depth + 1)
        return self._of_function(call, depth)

    def _of_function(self, call: ast.Call, depth: int) -> str | None:
        name = called(call)
        if name in _PASSED_ON:
            return self.text(argument(call, 0, _PASSED_ON[name]), depth + 1)
        if name == "dirname":
            return _directory(self.text(argument(call, 0, "p"), depth + 1))
        if name in _OF_ENVIRONMENT:
            if isinstance(call.func, ast.Attribute) and _is_of_context(call.func.value):
                return self.configuration(self.text(argument(call, 0, ""), depth + 1) or "", depth)
            if (
                name == "get"
                and python_source.dotted_name(call.func).removesuffix(".get") not in _ENVIRONMENTS
            ):
                return None
            default = argument(call, 1, _OF_ENVIRONMENT[name])
            variable = self.text(argument(call, 0, "name"), depth + 1) or ""
            if variable in _ALWAYS_SET:
                return None
            assumed = None if default else _ASSUMED.get(variable)
            return assumed or self.text(default, depth + 1)
        if name == "find" and isinstance(call.func, ast.Attribute):
            package = call.func.value  # FindPackageShare(...).find(...): its argument counts
            is_one = called(package) in PACKAGE_DIRECTORY
            return self._package_directory(call, depth) if is_one else None
        return None

    def _computed(self, call: ast.Call, depth: int) -> str | None:
        name, keys = COMPUTED[called(call)]
        nodes = [argument(call, place, key) for place, key in enumerate(keys)] or call.args
        return computed(
            name, ["" if node is None else self.text(node, depth + 1) for node in nodes]
        )

    def _package_directory(self, call: ast.Call, depth: int) -> str | None:
        named = argument(call, 0, "package") or argument(call, 0, "package_name")
        package = self.text(named, depth + 1)
        return None if package is None else self._directory_of(package, call)

    def _directory_of(self, package: str, at: ast.expr) -> str:
        directory = self.collector.package(package, self.source, self.span(at))
        return f"{UNKNOWN}/{package}" if directory is None else directory

    def _builder(self, node: ast.expr | None) -> ast.Call | None:
        """The MoveItConfigsBuilder on which a chain of methods is called, or None."""
        for _ in range(MAX_DEPTH):
            node = self.resolved(node)
            if not isinstance(node, ast.Call) or called(node) == "MoveItConfigsBuilder":
                return node if isinstance(node, ast.Call) else None
            node = node.func.value if isinstance(node.func, ast.Attribute) else None
        return None

    def package_of(self, builder: ast.Call) -> str | None:
        """The package that a MoveItConfigsBuilder reads."""
        written = argument(builder, 1, "package_name")
        robot = self.text(argument(builder, 0, "robot_name"))
        return self.text(written) if written else robot and f"{robot}_moveit_config"

    def configuration(self, name: str, depth: int = 0) -> str | None:
        """The value of an argument of the launch file; None if unknown."""
        value = self.arguments.get(name)
        return value if isinstance(value, str) else self.text(value, depth + 1)

    def _of_configuration(self, call: ast.Call, depth: int) -> str | None:
        name = self.text(argument(call, 0, "variable_name"), depth + 1)
        if changes := self._changes(name or "", depth):
            is_sure = len(changes) == 1 and argument(changes[0], 2, "condition") is None
            value = argument(changes[0], 1, "value")
            return self.text(value, depth + 1) if is_sure else None
        declared = self.arguments.get(name or "")
        is_own = isinstance(declared, ast.expr) and self.resolved(declared) is call
        if is_own or name not in self.arguments:
            return self.text(argument(call, None, "default"), depth + 1)
        return self.configuration(name, depth)

    @contextmanager
    def without(self, names: set[str]) -> Iterator[None]:
        """Arguments whose values are unknown for a while."""
        known = self.arguments
        self.arguments = {**known, **dict.fromkeys(names)} if names else known
        try:
            yield
        finally:
            self.arguments = known

    def _changes(self, name: str, depth: int) -> list[ast.Call]:
        """The actions that give an argument another value."""
        set_names = ((call, self.text(argument(call, 0, "name"), depth + 1)) for call in self._set)
        return [call for call, set_name in set_names if set_name == name]


def _is_of_context(node: ast.expr) -> bool:
    """True for the values of the arguments in ``context.launch_configurations``."""
    return isinstance(node, ast.Attribute) and node.attr == "launch_configurations"


def _bounded(number: float) -> float | None:
    """A number of ordinary size, else None: integers of Python have any number of digits."""
    return number if abs(number) < _MAX_NUMBER else None


def _directory(path: str | None) -> str | None:
    """The directory of a path; None for a relative one, which is not that of the file."""
    return os.path.dirname(path) if path and os.path.isabs(path) else None

"""The arguments that a Python launch file uses and passes on."""

import ast
from collections.abc import Collection, Iterator

from urdfkit.core.suggest import Suggester
from urdfkit.ros.launch.argument_checks import (
    declares_others,
    is_included,
    missing_in_include,
    misspelt,
    undeclared,
    unknown_to_included,
)
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.contents import Word
from urdfkit.ros.launch.signature import Signature, declares, signature
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Span


class Configurations:
    """The launch configurations of one file.

    Args:
        own: the arguments that it declares.
        idle: expressions whose value is unused.
    """

    def __init__(
        self, values: Values, own: Signature, calls: list[ast.Call], idle: Collection[ast.expr]
    ) -> None:
        self._values = values
        self._calls = calls
        self._idle = idle
        declared = (
            argument(call, 0, "name") for call in calls if declares(call) and call not in idle
        )
        names = {values.text(name) for name in declared}
        self._known = {name for name in names if name}
        #: False if other modules or included files may declare what is used here.
        self._is_whole = own.imports_plainly and None not in names

    def include(self, call: ast.Call, path: str) -> Iterator[Problem]:
        """Problems of the arguments that an include passes."""
        passed = self._passed(call)
        source = self._values.collector.resolver.readable(path)
        if source is None:
            self._is_whole = self._is_whole and not declares_others(path)
            return
        taken = signature(source)
        self._is_whole = self._is_whole and taken.is_whole
        yield from unknown_to_included(passed or (), taken, source, None, ros=2)
        known = {*self._known, *(name for name, _ in passed or ())}
        if passed is not None and not taken.required <= known and not self._may_inherit():
            yield from missing_in_include(known, taken, source, self._values.span(call), None)
        self._known |= taken.names  # an include declares them for the including file, too

    def visible(self, call: ast.Call) -> dict[str, Word] | None:
        """The arguments that an included file sees: those of the include, and of this file.

        None if the names are unknown.
        """
        pairs = self._pairs(call)
        if pairs is None:
            return None
        values = self._values
        place = values.span(call)
        own = {name: Word(values.configuration(name), place) for name in values.arguments}
        passed = {
            name: Word(values.text(value), values.span(value))
            for key, value in pairs
            if (name := values.text(key))
        }
        return own | passed

    def fixed(self, call: ast.Call) -> frozenset[str]:
        """The arguments that an include sets to a literal, which no user can change."""
        pairs = self._pairs(call) or []
        literals = (key for key, value in pairs if isinstance(value, ast.Constant))
        return frozenset(name for key in literals if (name := self._values.text(key)))

    def _passed(self, call: ast.Call) -> list[tuple[str, Span]] | None:
        """The names of the arguments that an include passes; None if not all are known."""
        pairs = self._pairs(call)
        if pairs is None:
            return None
        names = [(self._values.text(key), key) for key, _ in pairs]
        known = [(name, self._values.span(key)) for name, key in names if name and key]
        return known if len(known) == len(names) else None

    def _pairs(self, call: ast.Call) -> list[tuple[ast.expr | None, ast.expr]] | None:
        """The names and values that an include passes; None if they are not literal."""
        written = argument(call, 1, "launch_arguments")
        if written is None:
            return []
        node = self._values.resolved(written)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            node = self._values.resolved(node.func.value) if node.func.attr == "items" else None
        if isinstance(node, ast.Dict):
            return self._values.pairs(node)
        if not isinstance(node, (ast.List, ast.Tuple)):
            return None
        pairs = [i.elts for i in node.elts if isinstance(i, ast.Tuple) and len(i.elts) == 2]
        return [(k, v) for k, v in pairs] if len(pairs) == len(node.elts) else None

    def undeclared(self) -> Iterator[Problem]:
        """Uses of arguments that neither this file nor its included files declare."""
        used: dict[str, ast.Call] = {}
        for call in self._calls:
            if (
                called(call) == "LaunchConfiguration"
                and argument(call, 1, "default") is None
                and call not in self._idle
            ):
                name = self._values.text(argument(call, 0, "variable_name"))
                if name:
                    used.setdefault(name, call)
        missing = {name: call for name, call in used.items() if name not in self._known}
        if not missing or b".launch_configurations" in self._values.source.data:
            return
        is_sure = self._is_whole and not self._may_inherit()
        for number, (name, call) in enumerate(missing.items()):
            span = self._values.span(call)
            known = self._known if number < Suggester.MAX_WORDS else ()
            suggested = misspelt(name, known, span.source)
            if is_sure or suggested:
                yield undeclared(name, suggested, span, None, is_lost=False, ros=2)

    def _may_inherit(self) -> bool:
        """True if other launch files may include this file and pass unknown arguments."""
        return is_included(self._values.source.path, self._values.collector.resolver)

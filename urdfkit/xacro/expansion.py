"""The state of one expansion: the files that xacro reads, and the locations of its errors."""

from __future__ import annotations

import os
import sys
from types import FrameType

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.errors import PackageNotFound
from urdfkit.text.document import CallFrame
from urdfkit.text.xml_reader import DocumentTooLarge
from urdfkit.workspace.manifest import manifest_of
from urdfkit.xacro import dom_builder
from urdfkit.xacro.budget import Budget
from urdfkit.xacro.definitions import Definitions
from urdfkit.xacro.dom import Dom, Node
from urdfkit.xacro.errors import FAILED, DependsOnError, MissingArgument, root_cause
from urdfkit.xacro.expansion_log import ExpansionLog, Message
from urdfkit.xacro.file_reader import FileReader
from urdfkit.xacro.locator import LocatedExpression
from urdfkit.xacro.sandbox import Sandbox
from urdfkit.xacro.substitution import SubstitutionContext, SubstitutionError, substitute

if TYPE_CHECKING:
    from urdfkit.text.source import Source
    from urdfkit.workspace.resolve import Resolver
    from urdfkit.xacro.trace import Tracer

MAX_MACRO_DEPTH = 150
#: Most macro calls of an expansion; PR2 has 140.
MAX_CALLS = 50_000


class ExpansionRequest(Record):
    """A file to expand, with the options of ``urdfkit.xacro.expand``."""

    source: Source
    resolver: Resolver
    arguments: dict[str, str]
    trust: bool
    root_dir: str
    traced: bool
    frame: CallFrame | None


class ExpansionRun:
    """The state of one expansion.

    Args:
        deadline: processor time of the thread at which it must have ended.
    """

    def __init__(
        self, request: ExpansionRequest, log: ExpansionLog, reader: FileReader, deadline: float
    ) -> None:
        self.request = request
        self.budget = Budget(deadline)
        self.sandbox = Sandbox(self.budget)
        self.log = log
        self.reader = reader
        #: Macros, properties and arguments of the files.
        self.defined = Definitions(request.source, reader.sources, request.arguments)
        self.tracer = _tracer(self.defined) if request.traced else None
        self.xacro: Any = None  # the private module of the engine that expands
        #: Locations of the include tags that were processed, as (path, offset).
        self.included: set[tuple[str, int]] = set()
        self.dependencies: list[str] = []  # included and loaded files, as the models spell them
        self.document: Dom | None = None  # may be incomplete after an error
        # The current state of the instrumented engine: open properties, includes and defaults.
        self.resolving: list[tuple[Any, str]] = []
        self.including: list[Node] = []
        self._location: LocatedExpression | None = None
        self._defaulting: set[str] = set()
        self._calls = 0

    # ------------------------------------------------------------------ files

    def parse(self, filename: str) -> Dom:
        """The DOM of a file; replaces ``xacro.parse``."""
        include = self.including[-1] if self.including else None
        if include is None:
            frame, source = self.request.frame, self.request.source
        else:
            frame = CallFrame("include", filename, include.tag_at, None, include.frame)
            source = self._included(filename)
        try:
            document, problems, arguments = dom_builder.parse(source, frame, self.budget)
        except Exception as error:
            error.urdfkit_location = (source, frame, include)  # type: ignore[attr-defined]
            raise
        for problem in problems:
            self.log.add(problem._replace(frame=frame))
        self.defined.add_arguments(arguments)
        self._remove_failed_tags(document)
        if include is None:
            self.document = document
        else:
            self.included.add((include.tag_at.source.path, include.tag_at.start))
        return document

    def _included(self, filename: str) -> Source:
        xacro = self.xacro
        if FAILED in filename:  # not a missing file, which could be optional
            raise DependsOnError(filename)
        try:
            return self.reader.xacro(self._from_root(filename))
        except OSError as error:
            xacro.filestack.pop()
            text = f"{error.strerror}: {error.filename}"
            raise xacro.XacroException(text, exc=error) from error
        except ValueError as error:
            raise xacro.XacroException(str(error), exc=error) from error

    def _remove_failed_tags(self, document: Dom) -> None:
        """Remove the tags that failed in earlier runs and were reported."""
        if not self.log.has_removed_tags:
            return
        stack: list[Any] = [document.documentElement]
        while stack:
            node = stack.pop()
            if self.log.is_removed(node.tag_at):
                node.parentNode.removeChild(node)
            else:
                stack.extend(child for child in node.childNodes if isinstance(child, Node))

    def load_yaml(self, filename: str) -> Any:
        """The value of a YAML file; replaces ``xacro.load_yaml``."""
        from urdfkit.xacro import yaml_files

        xacro = self.xacro
        filename = xacro.abs_filename_spec(filename)
        if FAILED in filename:  # such as a file of a missing package
            raise DependsOnError(filename)
        source = self.reader.yaml(filename)
        self.budget.charge(10 * len(source.data))  # parsing YAML takes ten times longer
        xacro.filestack.append(filename)
        try:
            value = yaml_files.load(
                source,
                lambda e: xacro.safe_eval(e, xacro._global_symbols),
                located=self.tracer is not None,
            )
        except SyntaxError as error:
            raise xacro.XacroException(f"invalid expression: {error.text}") from error
        finally:
            xacro.filestack.pop()
            self.dependencies.append(filename)
        return xacro.YamlListWrapper.wrap(value)

    # ---------------------------------------------------------------- $(...)

    def substitute(self, content: str, symbols: Any) -> str:
        """The value of ``$(content)``; replaces ``xacro.eval_extension``."""
        xacro = self.xacro
        context = SubstitutionContext(
            self._find_package,
            lambda name: self.argument(name, symbols),
            os.path.dirname(xacro.filestack[-1] or ""),
            self.request.root_dir,
            disk.Environment(),
            None if self.request.trust else self.sandbox,
            {**xacro._global_symbols["math"], **xacro._global_symbols["python"]},
            self._ros_version,
            self.warn,
        )
        try:
            return substitute(content, context)
        except MissingArgument as error:
            text = "Undefined substitution argument"
            raise xacro.XacroException(text, exc=error) from error
        except (SubstitutionError, PackageNotFound) as error:
            raise xacro.XacroException(exc=error) from error
        except Exception as error:
            raise xacro.XacroException(f"{type(error)}: {error}", exc=error) from error

    def _ros_version(self) -> str:
        """The default of ``ROS_VERSION``, which ROS sets: the version of the package, else 2."""
        manifest = manifest_of(self.request.resolver, self.request.source.path)
        return str((manifest.ros if manifest else None) or 2)

    def _find_package(self, name: str) -> str:
        near = self.xacro.filestack[-1] or self.request.source.path
        return self.request.resolver.package(name, self._from_root(near))

    def _from_root(self, path: str) -> str:
        return os.path.join(self.request.root_dir, path)

    def argument(self, name: str, symbols: Any) -> str:
        """The value of an argument.

        Raises:
            MissingArgument: it has no value and no default.
        """
        values = self.xacro.substitution_args_context["arg"]
        if name not in values:
            values[name] = self._later_default(name, symbols)
        if self.tracer is not None:
            self.tracer.argument(name, values[name])
        return str(values[name])

    def _later_default(self, name: str, symbols: Any) -> str:
        """The default of an argument that is declared after its first use.

        xacro fails here, which is reported. ``<robot name="$(arg name)">`` above the declaration
        is common, and the default allows the rest of the robot to be checked.
        """
        node = self.defined.defaulting_nodes.get(name)
        if node is None or name in self._defaulting:  # its default refers to the argument itself
            raise MissingArgument(name)
        self._defaulting.add(name)
        try:
            from urdfkit.xacro import diagnosis

            self.log.add(diagnosis.used_too_early(name, node, _caller()))
            return str(self.xacro.eval_text(node.getAttribute("default"), symbols))
        finally:
            self._defaulting.discard(name)

    # ------------------------------------------------------------ definitions

    def enter_call(self, depth: int) -> None:
        self._calls += 1
        if depth > MAX_MACRO_DEPTH:
            raise DocumentTooLarge(
                f"macros call each other more than {MAX_MACRO_DEPTH} levels deep"
            )
        if self._calls > MAX_CALLS:
            raise DocumentTooLarge(f"more than {MAX_CALLS} macro calls")

    def define(self, table: Any, key: str, definer: Any) -> None:
        """Note the definition of a property or a macro parameter."""
        if problem := self.defined.add_value(table, key, definer):
            self.log.add(problem)

    # --------------------------------------------------------------- messages

    def warn(self, text: str) -> None:
        from urdfkit.xacro import diagnosis  # most runs do not need it

        node, local = diagnosis.node_in(_caller())
        self.log.add_message(Message("warning", text, node.tag_at.span if node else None))
        if node is not None:
            problem = diagnosis.warning(text, node, local)
            if problem is not None:
                self.log.add(problem)

    def add_message(self, kind: str, text: str) -> None:
        """Add a message of the model to the user."""
        self.log.add_message(Message(kind, text, None))

    # ----------------------------------------------------------------- errors

    def locate(self, text: str, offset: int, token: str) -> None:
        """Note the location of an error: in the innermost property, its outermost text."""
        location = LocatedExpression(text, offset, token, tuple(self.resolving))
        previous = self._location
        if previous is None or len(previous.resolving) == len(location.resolving):
            self._location = location

    def report(self, error: Exception, used: LocatedExpression, frame: FrameType) -> None:
        """Report an expression that failed, with its location.

        Args:
            error: of the expression, or of a property that it uses.
            used: the expression.
            frame: of the function that evaluates it.
        """
        located, self._location = self._location, None
        if isinstance(root_cause(error), (DocumentTooLarge, RecursionError, MemoryError)):
            raise error
        from urdfkit.xacro import diagnosis

        log = self.log
        log.first_error = log.first_error or str(error) or repr(error)
        if not log.is_full and not log.is_consequence(error):
            log.add_error(diagnosis.problem(self.defined, error, located or used, used, frame))


def _tracer(defined: Definitions) -> Tracer:
    from urdfkit.xacro.trace import Tracer

    return Tracer(defined)


def _caller() -> FrameType:
    return sys._getframe(2)

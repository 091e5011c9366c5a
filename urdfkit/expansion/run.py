"""One expansion: its budgets, what it met, and the places of its errors."""

from __future__ import annotations

import os
import sys
import time
from types import FrameType
from typing import TYPE_CHECKING, Any, NamedTuple

from urdfkit.document import Frame, Tag
from urdfkit.errors import PackageNotFound
from urdfkit.expansion import describe, dom
from urdfkit.expansion.dom import Dom, Node
from urdfkit.expansion.engine import load_xacro
from urdfkit.expansion.errors import EscapesRoots, MissingArgument, root_cause
from urdfkit.expansion.expressions import MAX_LENGTH, TooLarge
from urdfkit.expansion.substitution import Context, SubstitutionError, substitute
from urdfkit.expansion.trace import Tracer
from urdfkit.reading import Problem, TooMuch
from urdfkit.source import Source, Span

if TYPE_CHECKING:
    from urdfkit.resolve import Resolver

MAX_MACRO_DEPTH = 150
#: Macro calls of one expansion; PR2 has 140.
MAX_CALLS = 50_000
MAX_SECONDS = 60.0
MAX_PROBLEMS = 500
#: Uses of one failing property that are worth naming.
MAX_RELATED = 5
MAX_YAML_BYTES = 8 * 1024 * 1024


class Definition(NamedTuple):
    """Something that a xacro file defines: a macro, a property or an argument.

    Attributes:
        name: of it.
        tag: the defining tag.
        frame: the calls that led to the definition.
        attributes: of the tag, as written.
    """

    name: str
    tag: Tag
    frame: Frame | None
    attributes: dict[str, str]


class Message(NamedTuple):
    """What xacro or the model itself says while it is expanded."""

    kind: str
    text: str
    span: Span | None


class Located(NamedTuple):
    """An expression in the text it was found in, and the properties being resolved around it."""

    text: str
    offset: int
    token: str
    resolving: tuple[tuple[Any, str], ...]


class Run:
    """The state of one expansion.

    Attributes:
        problems: errors and warnings, each with its place.
        macros, properties: everything that was defined, in order.
        messages: of xacro and of the model, in order.
        sources: the xacro files by path, the checked one first.
        data_files: YAML files that were read.
        included: places of the include tags that were carried out, as (path, offset).
        declared: every ``xacro:arg`` of the files, evaluated or not.
        first_error: text of the first error, as stock xacro words it.
    """

    def __init__(
        self,
        source: Source,
        resolver: Resolver,
        arguments: dict[str, str],
        *,
        trust: bool,
        root_dir: str = os.curdir,
        traced: bool = False,
        frame: Frame | None = None,
        without: frozenset[tuple[str, int]] = frozenset(),
        lost: frozenset[str] = frozenset(),
    ) -> None:
        self.source = source
        self.resolver = resolver
        self.arguments = dict(arguments)
        self.trust = trust
        self.root_dir = root_dir
        self.frame = frame
        self.without = without
        self.lost = set(lost)
        self.problems: list[Problem] = []
        self.macros: list[Definition] = []
        self.properties: list[Definition] = []
        self.messages: list[Message] = []
        self.sources: dict[str, Source] = {source.path: source}
        self.included: set[tuple[str, int]] = set()
        self.data_files: list[str] = []
        self.first_error: str | None = None
        self.declared: list[Definition] = []
        self.document: Dom | None = None
        self.tracer = Tracer(self) if traced else None
        # What the instrumented engine is doing at the moment.
        self.depth = 0
        self.resolving: list[tuple[Any, str]] = []
        self.including: list[Node] = []
        self._location: Located | None = None
        self._declared_nodes: list[Node] = []
        self._copies = [0]
        self._calls = 0
        self._deadline = time.monotonic() + MAX_SECONDS

    # ------------------------------------------------------------------ files

    def parse(self, filename: str) -> Dom:
        """A file as DOM; the counterpart of ``xacro.parse``."""
        include = self.including[-1] if self.including else None
        if include is None:
            frame, source = self.frame, self.source
        else:
            self.included.add((include.tag_at.source.path, include.tag_at.start))
            frame = Frame("include", filename, include.tag_at, None, include.frame)
            source = self._read(filename)
        try:
            document, problems, arguments = dom.parse(source, frame, self._copies)
        except Exception as error:
            error.urdfkit_source = source  # type: ignore[attr-defined]
            error.urdfkit_frame = frame  # type: ignore[attr-defined]
            raise
        self.problems += [problem._replace(frame=frame) for problem in problems]
        self._declared_nodes += arguments
        self.declared += [_definition(node) for node in arguments]
        self._drop_reported(document)
        if include is None:
            self.document = document
        return document

    def _drop_reported(self, document: Dom) -> None:
        """Take out the tags that failed in an earlier run and were reported.

        An include stays until its turn comes: what precedes it cannot suffer from its lack.
        """
        if not self.without:
            return
        stack: list[Any] = [document.documentElement]
        while stack:
            node = stack.pop()
            if self._is_reported(node) and node.tagName != "xacro:include":
                node.parentNode.removeChild(node)
            else:
                stack.extend(child for child in node.childNodes if isinstance(child, Node))

    def _is_reported(self, node: Node) -> bool:
        return (node.tag_at.source.path, node.tag_at.start) in self.without

    def leaves_out(self, include: Node) -> bool:
        """True for an include that failed in an earlier run; from here on anything may lack."""
        if self._is_reported(include):
            self.lost.add("*")
            return True
        return False

    def _read(self, filename: str) -> Source:
        path = os.path.join(self.root_dir, filename)
        xacro = load_xacro()
        try:
            path = self._admitted(path)
            if path not in self.sources:
                with open(path, "rb") as file:
                    self.sources[path] = Source(path, file.read())
        except OSError as error:
            xacro.filestack.pop()
            text = f"{error.strerror}: {error.filename}"
            raise xacro.XacroException(text, exc=error) from error
        except ValueError as error:  # a NUL in the name
            raise xacro.XacroException(str(error), exc=error) from error
        return self.sources[path]

    def _admitted(self, path: str) -> str:
        """The path to open: as installed if it is not in the source tree, and not outside."""
        if not os.path.exists(path):
            path = self.resolver.installed(path) or path
        if not os.path.lexists(path):
            return path  # opening it will say that there is no such file
        if not self.trust and not self.resolver.allows(path, self.source.path):
            raise EscapesRoots(path)
        return path

    def load_yaml(self, filename: str) -> Any:
        """The value of a YAML file; the counterpart of ``xacro.load_yaml``."""
        from urdfkit.expansion import values

        xacro = load_xacro()
        filename = xacro.abs_filename_spec(filename)
        path = self._admitted(filename)
        with open(path, encoding="utf-8") as file:
            text = file.read(MAX_YAML_BYTES + 1)
        if len(text) > MAX_YAML_BYTES:
            raise TooLarge(f"{path} is larger than {MAX_YAML_BYTES // 2**20} MiB")
        xacro.filestack.append(filename)
        try:
            value = values.load(
                text,
                lambda e: xacro.safe_eval(e, xacro._global_symbols),
                marked_as=path if self.tracer else None,
            )
        except SyntaxError as error:
            raise xacro.XacroException(f"invalid expression: {error.text}") from error
        finally:
            xacro.filestack.pop()
            xacro.all_includes.append(filename)
            self.data_files.append(path)
        return xacro.YamlListWrapper.wrap(value)

    # ---------------------------------------------------------------- $(...)

    def substitute(self, content: str, symbols: Any) -> str:
        """The value of ``$(content)``; the counterpart of ``xacro.eval_extension``."""
        xacro = load_xacro()
        folder = os.path.dirname(xacro.filestack[-1] or "")
        context = Context(
            self._find_package,
            lambda name: self._argument(name, symbols),
            folder,
            self.root_dir,
            os.environ,
            self.trust,
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

    def _find_package(self, name: str) -> str:
        return self.resolver.package(name, load_xacro().filestack[-1] or self.source.path)

    def _argument(self, name: str, symbols: Any) -> str:
        values = load_xacro().substitution_args_context["arg"]
        if name not in values:
            values[name] = self._later_default(name, symbols)
        if self.tracer is not None:
            self.tracer.argument(name, values[name])
        return str(values[name])

    def _later_default(self, name: str, symbols: Any) -> str:
        """The default of an argument that is declared after its first use.

        xacro gives up here, which is told; ``<robot name="$(arg name)">`` above the declaration
        is common, and the rest of the robot can be checked with the default.
        """
        for node in self._declared_nodes:
            if node.getAttribute("name") == name and node.hasAttribute("default"):
                self._add(describe.used_too_early(name, node, _caller()))
                return str(load_xacro().eval_text(node.getAttribute("default"), symbols))
        raise MissingArgument(name)

    # ---------------------------------------------------------------- budgets

    def enter_call(self) -> None:
        """Count a macro call."""
        self._calls += 1
        if len(load_xacro().macrostack) > MAX_MACRO_DEPTH:
            raise TooMuch(f"macros call each other more than {MAX_MACRO_DEPTH} levels deep")
        if self._calls > MAX_CALLS:
            raise TooMuch(f"more than {MAX_CALLS} macro calls")
        if self._calls % 64 == 0 and time.monotonic() > self._deadline:
            raise TooMuch(f"the expansion takes longer than {MAX_SECONDS:g} s")

    def check_text(self, text: str) -> None:
        """Refuse a text that grew by repetition."""
        if len(text) > MAX_LENGTH:
            raise TooLarge(f"a text of {len(text)} characters")

    # ------------------------------------------------------------ definitions

    def note_macro(self, node: Node) -> None:
        """A macro is defined."""
        name = node.getAttribute("name").removeprefix("xacro:")
        self.macros.append(_definition(node)._replace(name=name))

    def note_definition(self, table: Any, key: str, definer: Any) -> None:
        """A property or a macro parameter gets a value."""
        if not isinstance(definer, Node):
            return
        places = table.__dict__.setdefault("places", {})
        if definer.tagName == "xacro:property":
            self.properties.append(_definition(definer)._replace(name=key))
            self._note_redefinition(table, key, definer, places.get(key))
        places[key] = definer
        table.__dict__.setdefault("used", set()).discard(key)

    def note_use(self, table: Any, key: str) -> None:
        """A name is looked up."""
        table.__dict__.setdefault("used", set()).add(key)

    def _note_redefinition(self, table: Any, key: str, node: Node, earlier: Node | None) -> None:
        if earlier is None or key in table.used or key.startswith("**"):
            return
        same_block = earlier.around == node.around and earlier.tagName == node.tagName
        same_value = _attributes(earlier).get("value") == _attributes(node).get("value")
        if same_block and not same_value and earlier.tag_at != node.tag_at:
            message = f"property '{key}' is defined again before its first value is used"
            related = describe.related(earlier.tag_at.span, "first defined here")
            span = node.tag_at.attribute_spans().get("name", node.tag_at.span)
            self.problems.append(
                Problem("XAC008", span, message, frame=node.frame, related=related)
            )

    def shadows(self, key: str) -> None:
        """A property or parameter takes the name of something that expressions already have."""
        self.warn(f"redefining global symbol: {key}")

    # --------------------------------------------------------------- messages

    def warn(self, text: str) -> None:
        """xacro warns."""
        node, local = describe.node_in(_caller())
        self.messages.append(Message("warning", text, node.tag_at.span if node else None))
        if node is not None:
            problem = describe.warning(text, node, local)
            if problem is not None and problem not in self.problems:
                self.problems.append(problem)

    def say(self, kind: str, text: str) -> None:
        """The model speaks to the user."""
        self.messages.append(Message(kind, text, None))

    # ----------------------------------------------------------------- errors

    def locate(self, text: str, offset: int, token: str) -> None:
        """Note where an error arose; the innermost property and its outermost text count."""
        here = Located(text, offset, token, tuple(self.resolving))
        before = self._location
        if before is None or len(before.resolving) == len(here.resolving):
            self._location = here

    def report(self, error: Exception, text: str, frame: FrameType) -> None:
        """An expression failed: note it with its place, and go on."""
        located, self._location = self._location, None
        if isinstance(root_cause(error), (TooMuch, RecursionError, MemoryError)):
            raise error
        self.first_error = self.first_error or str(error) or repr(error)
        located = located or Located(text, 0, text, ())
        if not self._is_consequence(error, located):
            self._add(describe.problem(self, error, located, frame))

    def _add(self, problem: Problem) -> None:
        """Keep a problem; the same one met again only adds the place that met it."""
        if len(self.problems) >= MAX_PROBLEMS:
            return
        for number, known in enumerate(self.problems):
            again = known._replace(related=()) == problem._replace(related=())
            if again or (problem.code == "XAC010" and known[2] == problem.message):
                uses = problem.related if again else describe.related(problem.span, "needed here")
                if len(known.related) < MAX_RELATED:
                    related = tuple(dict.fromkeys((*known.related, *uses)))
                    self.problems[number] = known._replace(related=related)
                return
        self.problems.append(problem)

    def _is_consequence(self, error: Exception, located: Located) -> bool:
        """True if the error follows from one that was already reported."""
        if not self.lost:
            return False
        if isinstance(root_cause(error), NameError):
            return "*" in self.lost or any(name in located.token for name in self.lost)
        return False

    def known_arguments(self) -> dict[str, str]:
        """The arguments that the files declare, with their defaults as written."""
        return {d.name: d.attributes.get("default", "") for d in reversed(self.declared)}


def _definition(node: Node) -> Definition:
    return Definition(node.getAttribute("name"), node.tag_at, node.frame, _attributes(node))


def _attributes(node: Node) -> dict[str, str]:
    return dict(zip(node.raw[::2], node.raw[1::2], strict=True))


def _caller() -> FrameType:
    return sys._getframe(2)

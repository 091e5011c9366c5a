"""Stock xacro, loaded as a private copy and instrumented.

xacro's own processing of the document is not changed, so the output equals that of the ``xacro``
command byte for byte. Replaced are parsing (nodes with locations), the evaluation of texts (a
sandbox, errors with locations), ``$(...)`` without ROS, files, and messages. The copy is private
because xacro keeps its state in module globals and patches ``minidom`` for the whole process, which
must not affect a program that also uses xacro.
"""

from __future__ import annotations

import re
import sys
import warnings
from _thread import allocate_lock
from collections.abc import Callable
from contextlib import redirect_stderr
from functools import lru_cache
from io import StringIO
from keyword import iskeyword
from types import ModuleType
from xml.dom import minidom

from urdfkit.core import libraries
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.core.words import few
from urdfkit.errors import Unavailable
from urdfkit.xacro import dom
from urdfkit.xacro.bounds import TooLarge, UnsafeExpression
from urdfkit.xacro.dom import Node
from urdfkit.xacro.errors import FAILED, DependsOnError
from urdfkit.xacro.evaluation import Evaluation
from urdfkit.xacro.expansion import ExpansionRun

if TYPE_CHECKING:
    from importlib.machinery import ModuleSpec

#: Most characters of a name. xacro parses names as Python, which needs much memory for long ones.
MAX_NAME = 200

#: Most characters of all parameters of a macro; real macros have 1 000.
_MAX_PARAMETERS = 10_000
#: Most characters of a default for which xacro's pattern may backtrack.
_MAX_TRIED = 24
_WITH_DEFAULT = r"\s*[^\s:=]+?\s*:?=\s*"
#: xacro's pattern of a default, without backtracking.
_DEFAULT = r"""(?:\^\|?)?(?:\$\{.*?\}|\$\(.*?\)|(?:'[^'\n]*'|"[^"\n]*"|[^\s'"])+|)(?:\s|$)"""

_PRIVATE_NAME = "_urdfkit_xacro"
#: Names that the instrumentation requires; other versions of xacro do not have all of them.
_REQUIRED = (
    "all_includes create_global_symbols eval_all eval_default_arg eval_extension eval_text "
    "filestack get_boolean_value glob grab_macro grab_property handle_macro_call "
    "include_no_matches_msg is_valid_name macrostack NameSpace parse parse_macro_arg "
    "process_include remove_previous_comments replace_node root_dir safe_eval Table tokenize "
    "XacroException YamlListWrapper"
).split()


@lru_cache(maxsize=1)
def load_engine() -> XacroEngine:
    """The engine, loaded at the first call.

    Raises:
        Unavailable: no xacro on the path is one of the supported versions.
    """
    return XacroEngine(_private_copy())


def _private_copy() -> Any:
    """A copy of the first supported xacro on the path; ROS puts its own version in front."""
    reasons = []
    for spec in libraries.find_all("xacro"):
        try:
            module = _loaded(spec)
        except Exception as error:  # such as that of a ROS for Python 2
            reasons.append(f"the xacro at {spec.origin} cannot be imported ({error})")
            continue
        missing = [name for name in _REQUIRED if not hasattr(module, name)]
        if not missing:
            return module
        lacks = few(missing, 3)
        reasons.append(f"the xacro at {spec.origin} is not version 2.1 (it lacks {lacks})")
    reason = reasons[0] if reasons else "xacro is not installed"
    raise Unavailable(f"{reason}; run: pip install 'xacro>=2.1,<2.2'")


def _loaded(spec: ModuleSpec) -> Any:
    """The private copy of a xacro, not yet instrumented."""
    for name in [name for name in sys.modules if name.startswith(f"{_PRIVATE_NAME}.")]:
        del sys.modules[name]  # parts of another xacro
    loader: Any = spec.loader
    module: Any = ModuleType(_PRIVATE_NAME)
    module.__spec__ = type(spec)(_PRIVATE_NAME, loader, is_package=True)
    module.__path__ = spec.submodule_search_locations
    # xacro's command line is not used, and importing its optparse takes 4 ms.
    command_line = ModuleType(f"{_PRIVATE_NAME}.cli")
    vars(command_line)["process_args"] = None
    sys.modules[command_line.__name__] = command_line
    sys.modules[_PRIVATE_NAME] = module
    stock_writexml = minidom.Element.writexml
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Python 3.10 warns about names in xacro
            exec(loader.get_code("xacro"), vars(module))
        Node.writexml = minidom.Element.writexml
    finally:
        minidom.Element.writexml = stock_writexml  # type: ignore[method-assign]
    return module


class XacroEngine:
    """The private xacro, for one run at a time, as its state is global."""

    def __init__(self, xacro: Any) -> None:
        self.xacro = xacro  # the module
        self._evaluation = Evaluation(xacro)
        self._lock = allocate_lock()
        self._replace_evaluation()
        self._replace_tag_handlers()
        self._replace_slow_functions()
        self._replace_file_access()
        self._replace_messages()

    @property
    def _run(self) -> ExpansionRun:
        return self._evaluation.run

    def expand(self, run: ExpansionRun) -> Any:
        """Expand the file of a run to a DOM.

        Raises:
            Exception: the error that stopped the expansion.
        """
        xacro = self.xacro
        with self._lock:
            self._evaluation.begin(run)
            run.xacro = xacro
            xacro.all_includes = run.dependencies
            xacro.root_dir = run.request.root_dir
            xacro.verbosity = 1
            xacro.substitution_args_context.clear()
            xacro._global_symbols = self._global_symbols(trust=run.request.trust)
            xacro._empty_text_node = minidom.Document().createTextNode("\n\n")
            try:
                return xacro.process_file(
                    run.request.source.path, mappings=dict(run.defined.values)
                )
            finally:
                self._reset()

    def _reset(self) -> None:
        """Remove all references to the run from xacro's globals, which would keep it in memory."""
        xacro = self.xacro
        del self._evaluation.run
        xacro.all_includes, xacro._global_symbols, xacro._empty_text_node = [], {}, None
        xacro.substitution_args_context.clear()
        xacro.init_stacks(None)

    def _global_symbols(self, *, trust: bool) -> dict[str, Any]:
        symbols: dict[str, Any] = self.xacro.create_global_symbols()
        dict.__setitem__(symbols["xacro"], "arg", lambda name: self._run.argument(name, symbols))
        if not trust:
            for name in ("type", "vars"):  # they give access to the whole interpreter
                dict.__setitem__(symbols["python"], name, _rejecting(f"python.{name}()"))
        return symbols

    def _replace_evaluation(self) -> None:
        xacro, evaluation = self.xacro, self._evaluation
        stock_boolean = xacro.get_boolean_value
        stock_default = xacro.eval_default_arg

        def get_boolean_value(value: Any, condition: Any) -> bool:
            return False if value is FAILED else stock_boolean(value, condition)

        def eval_default_arg(*arguments: Any) -> Any:
            try:
                return stock_default(*arguments)
            except DependsOnError:  # the forwarded property failed
                return FAILED

        def resolve(table: Any, key: str) -> Any:
            return evaluation.resolve(table, key)

        def set_item(table: Any, key: str, value: Any, unevaluated: bool) -> None:
            evaluation.set_item(table, key, value, unevaluated)

        xacro.get_boolean_value = get_boolean_value
        xacro.eval_default_arg = eval_default_arg
        xacro.eval_text = evaluation.eval_text
        xacro.safe_eval = evaluation.safe_eval
        xacro.Table._resolve_ = resolve
        xacro.Table._setitem = set_item

    def _replace_tag_handlers(self) -> None:
        xacro = self.xacro
        stock_include = xacro.process_include
        stock_macro = xacro.grab_macro

        def process_include(elt: Node, *arguments: Any) -> None:
            self._run.including.append(elt)
            try:
                stock_include(elt, *arguments)
            finally:
                self._run.including.pop()

        def grab_macro(elt: Node, macros: Any) -> None:
            stock_macro(elt, macros)
            self._run.defined.add_macro(elt)

        def enter_call() -> None:
            self._run.enter_call(len(xacro.macrostack))

        xacro.process_include = self._with_recovery(process_include)
        xacro.grab_property = self._with_recovery(xacro.grab_property)
        xacro.grab_macro = self._with_recovery(grab_macro)
        xacro.handle_macro_call = self._with_recovery(xacro.handle_macro_call, enter_call)
        xacro.parse_macro_arg = _bounded_macro_arg(xacro.parse_macro_arg)

    def _with_recovery(
        self, stock: Callable[..., Any], begin: Callable[[], None] | None = None
    ) -> Callable[..., bool]:
        """A function of xacro that handles a tag, and removes the tag if it fails.

        Args:
            begin: called before each tag.
        """
        xacro = self.xacro

        def handle(tag: Node, *arguments: Any) -> bool:
            """False if the tag is not a xacro tag."""
            if not tag.tagName.startswith("xacro:"):
                return False
            if begin is not None:
                begin()
            files, macros = len(xacro.filestack), len(xacro.macrostack)
            try:
                if not self._run.log.is_removed(tag.tag_at):
                    stock(tag, *arguments)
                    return True
            except Exception as error:
                from urdfkit.xacro import failures  # not needed without errors

                if not failures.remove_tag(self._run, error, tag):
                    raise
            del xacro.filestack[files:], xacro.macrostack[macros:]
            if tag.parentNode is not None:
                tag.parentNode.removeChild(tag)
            return True

        return handle

    def _replace_slow_functions(self) -> None:
        """Replace slow functions by fast ones with the same results."""
        xacro = self.xacro
        stock_name = xacro.is_valid_name

        def is_valid_name(name: str) -> bool:
            if name.isascii():  # the same result without Python's parser
                return name.isidentifier() and not iskeyword(name)
            return len(name) <= MAX_NAME and bool(stock_name(name))

        def remove_previous_comments(node: Node) -> None:
            dom.remove_previous_comments(node, xacro._empty_text_node)

        xacro.is_valid_name = is_valid_name
        xacro.replace_node = dom.replace_node
        xacro.remove_previous_comments = remove_previous_comments

    def _replace_file_access(self) -> None:
        xacro = self.xacro

        def parse(_: Any, filename: str) -> Any:
            return self._run.parse(filename)

        def load_yaml(filename: str) -> Any:
            return self._run.load_yaml(filename)

        def glob(pattern: str) -> list[str]:
            return list(self._run.reader.glob(pattern, self._run.budget))

        xacro.parse = parse
        xacro.load_yaml = load_yaml
        xacro.glob = ModuleType("glob")
        xacro.glob.glob = glob
        xacro.YamlListWrapper.wrap = staticmethod(self._traced(xacro.YamlListWrapper.wrap))

    def _traced(self, wrap: Callable[[Any], Any]) -> Callable[[Any], Any]:
        """xacro's access to YAML values, recorded by the tracer."""

        def traced(item: Any) -> Any:
            if self._run.tracer is not None:
                self._run.tracer.yaml_value(item)
            return wrap(item)

        return traced

    def _replace_messages(self) -> None:
        xacro = self.xacro

        # Models call these functions by their names, which xacro reads from the functions.
        def warning(*words: Any, **_: Any) -> None:
            self._run.warn(_joined(words))

        def error(*words: Any, **_: Any) -> None:
            self._run.add_message("error", _joined(words))

        def message(*words: Any, **_: Any) -> None:
            self._run.add_message("", _joined(words))

        locate = xacro.print_location

        def print_location() -> None:
            text = StringIO()
            with redirect_stderr(text):
                locate()
            for line in text.getvalue().splitlines():
                self._run.add_message("", line)

        for function in (warning, error, message, print_location):
            setattr(xacro, function.__name__, function)
        xacro.tokenize = _bounded_tokenize(xacro.tokenize)


def _rejecting(function: str) -> Callable[..., Any]:
    """A replacement of a function that models may not call."""

    def reject(*_: Any) -> Any:
        raise UnsafeExpression(f"{function} is not allowed in expressions")

    return reject


def _joined(words: tuple[Any, ...]) -> str:
    return " ".join(map(str, words))


def _bounded_macro_arg(stock: Callable[[str], Any]) -> Callable[[str], Any]:
    """xacro's ``parse_macro_arg`` in bounded time.

    Its pattern matches ``a:=xxxxx'``, a default with an unmatched quote, in 2^5 ways.
    """

    def parse_macro_arg(text: str) -> Any:
        if len(text) > _MAX_PARAMETERS:
            raise TooLarge(f"parameters of {len(text)} characters")
        start = len(text) > _MAX_TRIED and re.match(_WITH_DEFAULT, text)
        default = text[start.end() :] if start else ""
        if len(default) > _MAX_TRIED and not re.match(_DEFAULT, default):
            raise TooLarge("a long default with an unmatched quote")
        return stock(text)

    return parse_macro_arg


def _bounded_tokenize(stock: Callable[..., Any]) -> Callable[..., Any]:
    """xacro's ``tokenize``, whose separators must not contain ``]``, which ends their pattern."""

    def tokenize(s: str, sep: str = ",; ", skip_empty: bool = True) -> Any:
        if "]" in sep[1:]:
            raise UnsafeExpression("']' among separators is not allowed in expressions")
        return stock(s, sep, skip_empty)

    return tokenize

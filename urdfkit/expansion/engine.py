"""Stock xacro, loaded as a private copy and instrumented.

The engine stays xacro's own: what it does to the document is not touched, so its output is
that of the ``xacro`` command byte for byte. Exchanged are the edges of it: parsing (nodes with
places), ``eval_text`` (an allow-list, a cache, errors with places), ``$(...)`` without ROS, and
``load_yaml``. The copy is private because xacro keeps its state in module globals and patches
``minidom`` for the whole process; a program that uses xacro too must not notice us.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from importlib.util import find_spec, module_from_spec, spec_from_file_location
from types import CodeType, ModuleType
from typing import TYPE_CHECKING, Any
from xml.dom import minidom

from urdfkit.errors import UrdfkitError
from urdfkit.expansion.dom import Node
from urdfkit.expansion.expressions import GUARDS, bounded_range, compile_expression

if TYPE_CHECKING:
    from urdfkit.expansion.run import Run

_PRIVATE_NAME = "_urdfkit_xacro"
#: What the instrumentation builds on; other versions of xacro lack some of it.
_REQUIRED = (
    "Table NameSpace XacroException eval_all eval_text eval_extension grab_macro grab_property "
    "handle_macro_call process_include get_boolean_value get_include_files parse root_dir "
    "create_global_symbols filestack macrostack all_includes"
).split()

_TOKEN = re.compile(
    r"(?P<escape>\$\$+[{(])|(?P<expression>\$\{[^}]*\})|(?P<command>\$\([^)]*\))"
    r"|(?P<text>[^$]+|\$[^{($]+|\$$)"
)


class Poison(str):
    """The value of something that failed and was reported; using it is no further error."""

    __slots__ = ()


class Tainted(Exception):
    """An expression uses the value of something that failed and was reported."""


#: The one Poison.
POISON = Poison()

_codes: dict[tuple[str, bool], CodeType] = {}
_tokens: dict[str, list[tuple[str, str, int]]] = {}


@lru_cache(maxsize=1)
def load_xacro() -> Any:
    """The private copy of xacro, instrumented; loaded at the first call.

    Raises:
        UrdfkitError: the xacro on the path is not one of the supported versions.
    """
    return _instrument(_private_copy())


def _private_copy() -> Any:
    spec = find_spec("xacro")
    if spec is None or spec.origin is None:
        raise UrdfkitError("xacro is not installed; run: pip install 'xacro>=2.1,<2.2'")
    private = spec_from_file_location(
        _PRIVATE_NAME, spec.origin, submodule_search_locations=spec.submodule_search_locations
    )
    assert private is not None
    assert private.loader is not None
    module = module_from_spec(private)
    # xacro's own command line is never used here, and its optparse costs 4 ms.
    command_line = ModuleType(f"{_PRIVATE_NAME}.cli")
    vars(command_line)["process_args"] = None
    sys.modules[command_line.__name__] = command_line
    sys.modules[_PRIVATE_NAME] = module
    stock_writexml = minidom.Element.writexml
    private.loader.exec_module(module)
    Node.writexml = minidom.Element.writexml
    minidom.Element.writexml = stock_writexml  # type: ignore[method-assign]
    missing = [name for name in _REQUIRED if not hasattr(module, name)]
    if missing:
        raise UrdfkitError(
            f"the xacro at {spec.origin} is not version 2.1 (it lacks {', '.join(missing)}); "
            "run: pip install 'xacro>=2.1,<2.2', or take it off PYTHONPATH"
        )
    return module


class _Active:
    """The run that the instrumented functions work for; xacro's globals allow only one."""

    run: Run


@contextmanager
def activated(run: Run) -> Iterator[Any]:
    """The private xacro with its globals set for one run."""
    xacro = load_xacro()
    _Active.run = run
    xacro.all_includes = []
    xacro.root_dir = run.root_dir
    xacro.verbosity = 1
    xacro.substitution_args_context.clear()
    xacro._global_symbols = _global_symbols(xacro, trust=run.trust)
    xacro._empty_text_node.parentNode = None
    xacro.init_stacks(run.source.path)
    yield xacro


def _global_symbols(xacro: Any, *, trust: bool) -> dict[str, Any]:
    symbols: dict[str, Any] = xacro.create_global_symbols()
    if not trust:
        for name in ("type", "vars"):  # they lead from any value to the whole interpreter
            dict.pop(symbols["python"], name, None)
        stock_range = symbols["range"]
        symbols["range"] = lambda *bounds: stock_range(*bounds) and bounded_range(*bounds)
        dict.__setitem__(symbols["python"], "range", bounded_range)
    return symbols


def _instrument(xacro: Any) -> Any:
    stock_boolean = xacro.get_boolean_value
    stock_include = xacro.process_include
    stock_macro = xacro.grab_macro
    stock_call = xacro.handle_macro_call
    stock_path = xacro.abs_filename_spec

    def abs_filename_spec(filename: str) -> Any:
        if filename is POISON:
            raise Tainted(filename)
        return stock_path(filename)

    def get_boolean_value(value: Any, condition: Any) -> bool:
        return False if value is POISON else stock_boolean(value, condition)

    def process_include(elt: Node, macros: Any, symbols: Any, func: Any) -> None:
        if _Active.run.leaves_out(elt):
            elt.parentNode.removeChild(elt)
            return
        _Active.run.including.append(elt)
        try:
            stock_include(elt, macros, symbols, func)
        except Tainted:  # its name failed and was reported
            _Active.run.lost.add("*")
            elt.parentNode.removeChild(elt)
        _Active.run.including.pop()

    def grab_macro(elt: Node, macros: Any) -> None:
        _Active.run.note_macro(elt)
        stock_macro(elt, macros)

    def handle_macro_call(node: Node, macros: Any, symbols: Any) -> bool:
        if node.tagName.startswith("xacro:"):
            _Active.run.enter_call()
        return bool(stock_call(node, macros, symbols))

    xacro.get_boolean_value = get_boolean_value
    xacro.abs_filename_spec = abs_filename_spec
    xacro.process_include = process_include
    xacro.grab_macro = grab_macro
    xacro.handle_macro_call = handle_macro_call
    xacro.parse = lambda inp, filename=None: _Active.run.parse(filename)
    xacro.eval_text = eval_text
    xacro.safe_eval = safe_eval
    xacro.load_yaml = lambda filename: _Active.run.load_yaml(filename)  # noqa: PLW0108 - late
    xacro.warning = lambda *words, **_: _Active.run.warn(" ".join(map(str, words)))
    xacro.error = lambda *words, **_: _Active.run.say("error", " ".join(map(str, words)))
    xacro.message = lambda *words, **_: _Active.run.say("", " ".join(map(str, words)))
    for shown in ("warning", "error", "message"):
        getattr(xacro, shown).__name__ = shown  # the names under which models call them
    xacro.YamlListWrapper.wrap = staticmethod(_noting(xacro.YamlListWrapper.wrap))
    xacro.print_location = lambda: None
    xacro.print_location.__name__ = "print_location"
    xacro.Table._resolve_ = _resolve
    xacro.Table._setitem = _setitem
    return xacro


def _noting(wrap: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """xacro's access to YAML values, which also tells the tracer."""

    def noting(item: Any) -> Any:
        if _Active.run.tracer is not None:
            _Active.run.tracer.yaml_value(item)
        return wrap(item)

    return noting


def _setitem(table: Any, key: str, value: Any, unevaluated: bool) -> None:
    """xacro's ``Table._setitem``, which also notes who defines the name."""
    run = _Active.run
    if key in table.root:
        run.shadows(key)
    frame = sys._getframe(1)
    definer = frame.f_locals.get("elt") or frame.f_locals.get("node")
    run.note_definition(table, key, definer)
    if run.tracer is not None and not unevaluated:
        run.tracer.defined(table, key)
    value = POISON if value is POISON else table._eval_literal(value)
    dict.__setitem__(table, key, value)
    if unevaluated and isinstance(value, str):
        table.unevaluated.add(key)
    else:
        table.unevaluated.discard(key)


def _resolve(table: Any, key: str) -> Any:
    """xacro's ``Table._resolve_``, which leaves the table usable when a property fails."""
    run = _Active.run
    run.note_use(table, key)
    if key in table.unevaluated:
        if key in table.recursive:
            chain = " -> ".join([*table.recursive, key])
            raise load_xacro().XacroException(
                f"circular variable definition: {chain}\n"
                'Consider disabling lazy evaluation via lazy_eval="false"'
            )
        table.recursive.append(key)
        run.resolving.append((table, key))
        try:
            value = table._eval_literal(eval_text(dict.__getitem__(table, key), table))
        finally:
            table.recursive.remove(key)
            run.resolving.pop()
        dict.__setitem__(table, key, value)
        table.unevaluated.remove(key)
        if run.tracer is not None:
            run.tracer.defined(table, key)
    value = dict.__getitem__(table, key)
    if value is POISON:
        raise Tainted(key)
    if run.tracer is not None:
        run.tracer.looked_up(table, key, value)
    return value


def tokens(text: str) -> list[tuple[str, str, int]]:
    """The pieces of a text: kind, text and offset of each.

    Raises:
        XacroException: a ``${`` or ``$(`` is not closed.
    """
    found = _tokens.get(text)
    if found is None:
        found = []
        position = 0
        while position < len(text):
            match = _TOKEN.match(text, position)
            if match is None:
                raise load_xacro().XacroException("invalid expression: " + text[position:])
            found.append((match.lastgroup or "", match.group(), position))
            position = match.end()
        _tokens[text] = found
    return found


def eval_text(text: str, symbols: Any) -> Any:
    """xacro's ``eval_text``: the value of a text with ``${}`` and ``$()`` in it.

    A single expression keeps its type. At the outermost level an error is reported with its
    place and the value becomes POISON, so that the expansion goes on to the next error.
    """
    if text is POISON or "$" not in text:
        return text
    run = _Active.run
    run.depth += 1
    if run.tracer is not None:
        run.tracer.begin()
    try:
        return _evaluate(run, text, symbols)
    except Tainted:
        if run.depth > 1:
            raise
        return POISON
    except Exception as error:
        if run.depth > 1:
            raise
        run.report(error, text, sys._getframe(1))
        return POISON
    finally:
        run.depth -= 1
        if run.tracer is not None:
            run.tracer.end(text, sys._getframe(1))


def _evaluate(run: Run, text: str, symbols: Any) -> Any:
    values: list[Any] = []
    for kind, token, offset in tokens(text):
        if kind == "text":
            values.append(token)
        elif kind == "escape":
            values.append(token[1:])
        else:
            try:
                values.append(_value(run, kind, eval_text(token[2:-1], symbols), symbols))
            except Exception as error:
                if not isinstance(error, Tainted):
                    run.locate(text, offset, token)
                if run.depth > 1:
                    raise
                values.append(POISON)
                if not isinstance(error, Tainted):
                    run.report(error, text, sys._getframe(2))  # and on to the next one
    if any(value is POISON for value in values):
        return POISON
    if len(values) == 1:
        return values[0]
    joined = "".join(map(str, values))
    run.check_text(joined)
    return joined


def _value(run: Run, kind: str, inner: Any, symbols: Any) -> Any:
    return _expression(inner, symbols) if kind == "expression" else run.substitute(inner, symbols)


def _expression(text: str, symbols: Any) -> Any:
    try:
        return safe_eval(text, symbols)
    except Tainted:
        raise
    except Exception as error:
        suffix = f"\nwhen evaluating expression '{text}'"
        wrapped = load_xacro().XacroException(exc=error, suffix=suffix)
        raise wrapped from error


def safe_eval(expression: str, symbols: Any, local: Any = None) -> Any:
    """xacro's ``safe_eval``, with the allow-list of ``expressions`` in front."""
    trust = _Active.run.trust
    code = _codes.get((expression, trust))
    if code is None:
        code = compile_expression(expression.strip(), trust=trust)
        _refuse_double_underscores(code)
        _codes[expression, trust] = code
    symbols.update(__builtins__=GUARDS)
    return eval(code, symbols, local)


def _refuse_double_underscores(code: CodeType) -> None:
    names = [name for name in code.co_names if name.startswith("__")]
    if names:
        raise load_xacro().XacroException("Use of invalid name(s): ", ", ".join(names))

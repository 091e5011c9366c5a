"""Evaluation of texts and properties as in xacro, but without stopping at errors.

An expression that fails is reported with its location, and its value becomes FAILED. Uses of that
value are not reported, so that one run finds all errors.
"""

import re
import sys
from functools import lru_cache

from urdfkit.core.static_typing import Any
from urdfkit.xacro.definitions import annotations_of
from urdfkit.xacro.errors import FAILED, DependsOnError
from urdfkit.xacro.expansion import ExpansionRun
from urdfkit.xacro.expressions import evaluate
from urdfkit.xacro.locator import LocatedExpression

_TOKEN = re.compile(
    r"(?P<escape>\$\$+[{(])|(?P<expression>\$\{[^}]*\})|(?P<command>\$\([^)]*\))"
    r"|(?P<text>[^$]+|\$[^{($]+|\$$)"
)


@lru_cache(maxsize=4096)
def tokens(text: str) -> tuple[tuple[str, str, int], ...]:
    """The tokens of a text: kind, text and offset of each."""
    result: list[tuple[str, str, int]] = []
    position = 0
    while position < len(text):
        match = _TOKEN.match(text, position)
        if match is None:
            # xacro reads one token ahead: it fails here before it evaluates the previous token.
            result.insert(max(len(result) - 1, 0), ("unclosed", text[position:], position))
            break
        result.append((match.lastgroup or "", match.group(), position))
        position = match.end()
    return tuple(result)


class Evaluation:
    """Replacements of xacro's evaluation functions, for one run at a time."""

    run: ExpansionRun

    def __init__(self, xacro: Any) -> None:
        self._xacro = xacro
        self._stock_eval = xacro.safe_eval
        self._depth = 0

    def begin(self, run: ExpansionRun) -> None:
        self.run = run
        self._depth = 0

    def eval_text(self, text: Any, symbols: Any) -> Any:
        """The value of a text with ``${}`` and ``$()``; a single expression keeps its type."""
        if text is FAILED:
            return text
        if not text or "$" not in text:
            return text or ""  # minidom has None for an empty xmlns
        tracer = self.run.tracer
        self._depth += 1
        if tracer is not None:
            tracer.begin()
        try:
            return self._value(text, symbols)
        except DependsOnError:
            if self._depth > 1:
                raise
            return FAILED
        finally:
            self._depth -= 1
            if tracer is not None:
                tracer.end(text, sys._getframe(1))

    def _value(self, text: str, symbols: Any) -> Any:
        values: list[Any] = []
        for kind, token, offset in tokens(text):
            if kind in ("text", "escape"):
                values.append(token if kind == "text" else token[1:])
                continue
            try:
                values.append(self._token_value(kind, token, symbols))
            except DependsOnError:
                values.append(FAILED)
            except Exception as error:
                values.append(FAILED)
                self.run.locate(text, offset, token)
                if self._depth > 1:
                    raise
                self.run.report(error, LocatedExpression(text, offset, token), sys._getframe(2))
        if any(value is FAILED for value in values):
            raise DependsOnError
        sandbox = self.run.sandbox
        if len(values) > 1:
            return sandbox.charged("".join(sandbox.charged(str(value)) for value in values))
        return values[0] if self._depth > 1 else sandbox.charged(values[0])

    def _token_value(self, kind: str, token: str, symbols: Any) -> Any:
        if kind == "unclosed":
            raise self._xacro.XacroException("invalid expression: " + token)
        inner = self.eval_text(token[2:-1], symbols)
        if kind == "command":
            return self.run.substitute(str(inner), symbols)
        try:
            return self.safe_eval(inner, symbols)
        except DependsOnError:
            raise
        except Exception as error:
            suffix = f"\nwhen evaluating expression '{inner}'"
            raise self._xacro.XacroException(exc=error, suffix=suffix) from error

    def safe_eval(self, expression: str, symbols: Any, local: Any = None) -> Any:
        """The value of an expression, sandboxed unless the user trusts the model."""
        if self.run.request.trust:
            return self._stock_eval(expression, symbols, local)
        return evaluate(expression.strip(), symbols, self.run.sandbox)

    def set_item(self, table: Any, key: str, value: Any, unevaluated: bool) -> None:
        """xacro's ``Table._setitem``; also notes the element that defines the name."""
        run = self.run
        if key in table.root:
            run.warn(f"redefining global symbol: {key}")
        local = sys._getframe(2).f_locals
        run.define(table, key, local.get("elt") or local.get("node"))
        if run.tracer is not None and not unevaluated:
            run.tracer.defined(table, key)
        value = FAILED if value is FAILED else table._eval_literal(value)
        dict.__setitem__(table, key, value)
        if unevaluated and isinstance(value, str):
            table.unevaluated.add(key)
        else:
            table.unevaluated.discard(key)

    def resolve(self, table: Any, key: str) -> Any:
        """xacro's ``Table._resolve_``; the table stays valid after a property fails."""
        run = self.run
        annotations_of(table).used.add(key)
        if key in table.unevaluated:
            if key in table.recursive:
                chain = " -> ".join([*table.recursive, key])
                raise self._xacro.XacroException(
                    f"circular variable definition: {chain}\n"
                    'Consider disabling lazy evaluation via lazy_eval="false"'
                )
            table.recursive.append(key)
            run.resolving.append((table, key))
            try:
                value = self.eval_text(dict.__getitem__(table, key), table)
            finally:
                table.recursive.remove(key)
                run.resolving.pop()
            value = FAILED if value is FAILED else table._eval_literal(value)
            dict.__setitem__(table, key, value)
            table.unevaluated.remove(key)
            if run.tracer is not None:
                run.tracer.defined(table, key)
        value = dict.__getitem__(table, key)
        if value is FAILED:
            raise DependsOnError(key)
        if run.tracer is not None:
            run.tracer.looked_up(table, key, value)
        return value

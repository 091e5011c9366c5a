"""A property, an argument or a macro is defined and never used.

A change of the property, or `name:=value` on the command line, then has no effect. An unused
definition is an info: the robot is the same without it. It is a warning if it is misleading: a use
misspells the name, the file repeats the number of a property elsewhere, or a launch file or the
caller sets an argument without effect. Definitions are not reported in files that other files
include, in libraries of macros, and if an include is not expanded: the name may be used there.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

import re
from collections.abc import Iterable
from itertools import chain

from urdfkit.core.suggest import is_typo
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Location, Need, Severity, rule
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.comments import blank_comments, comments
from urdfkit.text.editing.edits import remove_spans
from urdfkit.xacro import Xacro
from urdfkit.xacro.definitions import Definition

BAD = xacro_xml(
    '<xacro:property name="width" value="0.3"/>',
    '<xacro:property name="side" value="left"/>',
    '<link name="${side}_base"/>',
)
GOOD = BAD.replace("${side}_base", "${side}_${width}")
FIXED = BAD.replace('  <xacro:property name="width" value="0.3"/>\n', "")

#: Numbers that are too common to compare.
_COMMON_NUMBERS = (-1.0, 0.0, 1.0)
#: Most names that nothing defines that are compared with each unused one.
_MAX_UNDEFINED = 100
_COLOUR = rb"""\brgba\s*=\s*(["'])[^"']*\1"""
#: A use without the dollar, which XAC003 reports.
_WITHOUT_DOLLAR = rb"(?<![$\w}])\{([A-Za-z_]\w*)\}"
_NUMBER = rb"(?<![\w.])[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"


@rule(Severity.WARNING, needs=(Need.XACRO, Need.MODEL, Need.FILES), help="delete it, or use it")
def check(context: Context) -> Findings:
    xacro = context.xacro
    if xacro.is_library or not xacro.is_complete:
        return
    undefined = _undefined(xacro)
    unused = (_properties(context, undefined), _arguments(context, undefined), _macros(context))
    if not context.is_included:
        yield from chain.from_iterable(unused)


def _properties(context: Context, undefined: Iterable[str]) -> Findings:
    """Unused properties of the checked file; those of other files may be for other robots."""
    unused = [
        (definition, name)
        for definition in context.xacro.properties
        if (name := definition.name.removeprefix("**")) not in context.xacro.usage.names
        and definition.tag.source is context.source
    ]
    text = blank_comments(context.source.data) if unused else b""
    meant = {name.decode() for name in re.findall(_WITHOUT_DOLLAR, text)}
    unused = [(definition, name) for definition, name in unused if name not in meant]
    written = _numbers_written(context) if unused else set()
    commented = _names_in_comments(context) if unused else set()
    for definition, name in unused:
        misleads = _is_written_out(definition, written) or _is_misspelt(name, undefined)
        yield Finding(
            Location(definition.tag.span, definition.frame),
            f"property '{name}' is never used",
            fix=None
            if name in commented
            else Fix("delete the property", remove_spans([definition.tag.whole_span])),
            group_key="unused",
            severity=None if misleads else Severity.INFO,
        )


def _names_in_comments(context: Context) -> set[str]:
    """The names in expressions that are commented out: they may come back."""
    texts = (comment[1] for comment in comments(context.source.data))
    expressions = (one for text in texts for one in re.findall(rb"\$\{([^{}]*)", text))
    return {word.decode() for one in expressions for word in re.findall(rb"[A-Za-z_]\w*", one)}


def _arguments(context: Context, undefined: Iterable[str]) -> Findings:
    for argument in context.xacro.arguments:
        name = argument.name
        if argument.tag.source is context.source and name not in context.xacro.usage.names:
            is_given = name in context.arguments
            yield Finding(
                Location(argument.tag.span, argument.frame),
                f"argument '{name}' is never used"
                + ("; the value that it is given changes nothing" if is_given else ""),
                group_key="unused",
                severity=None if is_given or _is_misspelt(name, undefined) else Severity.INFO,
            )


def _macros(context: Context) -> Findings:
    xacro = context.xacro
    # XAC002 reports macros that are called without the prefix.
    called = {*xacro.usage.calls, *(element.tag for element in context.document.root.walk())}
    for macro in () if "call" in xacro.usage.calls else xacro.macros:
        if macro.tag.source is context.source and macro.name not in called:
            at = Location(macro.tag.span, macro.frame)
            message = f"macro '{macro.name}' is never called"
            yield Finding(at, message, severity=Severity.INFO)


def _is_written_out(definition: Definition, written: set[float]) -> bool:
    """True for a number that is written elsewhere instead of the property."""
    value = definition.attributes.get("value", "").strip().encode()
    return re.fullmatch(_NUMBER, value) is not None and float(value) in written


def _undefined(xacro: Xacro) -> frozenset[str]:
    """Names that nothing defines: xacro did not evaluate their uses; empty if they are many."""
    defined = {
        definition.name.removeprefix("**") for definition in (*xacro.properties, *xacro.arguments)
    }
    undefined = xacro.usage.names - defined
    return frozenset(undefined) if len(undefined) <= _MAX_UNDEFINED else frozenset()


def _is_misspelt(name: str, undefined: Iterable[str]) -> bool:
    """True if an undefined name differs in one letter."""
    return any(is_typo(name, used) for used in undefined)


def _numbers_written(context: Context) -> set[float]:
    """The numbers of the checked file, except those of properties and colours."""
    data = bytearray(blank_comments(context.source.data))
    for definition in context.xacro.properties:
        span = definition.tag.whole_span
        if span.source is context.source:
            data[span.start : span.end] = b" " * (span.end - span.start)
    body = data.find(b"?>") + 1  # excludes the XML version
    text = re.sub(_COLOUR, b"", bytes(data[body:]))
    return {float(number) for number in re.findall(_NUMBER, text)}.difference(_COMMON_NUMBERS)

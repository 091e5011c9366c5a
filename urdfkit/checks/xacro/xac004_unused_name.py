"""A property, an argument or a macro is defined and never used.

A change of the property, or `name:=value` on the command line, then has no effect. Usually the use
was deleted, or misspells the name. An unused macro may be left over: that is an info. So may a
property that is a number, unless the file writes that number out elsewhere, or uses a name that
differs in one letter and is not defined. Not reported in files that other files include, in
libraries of macros, and where an include is not expanded: the name may be used there.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

from __future__ import annotations

import re

from urdfkit.core.suggest import is_typo
from urdfkit.lint.rules import Finding, Findings, Fix, Location, Need, Severity, Subject, rule
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.comments import blank_comments
from urdfkit.text.editing.edits import remove_spans
from urdfkit.workspace.includes import is_included
from urdfkit.xacro import Xacro
from urdfkit.xacro.definitions import Definition

BAD = xacro_xml(
    '<xacro:property name="width" value="0.3"/>',
    '<xacro:property name="side" value="left"/>',
    '<link name="${side}_base"/>',
)
GOOD = BAD.replace("${side}_base", "${side}_${width}")
FIXED = BAD.replace('  <xacro:property name="width" value="0.3"/>\n', "")

_NUMBER = re.compile(rb"(?<![\w.])[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?")


@rule(Severity.WARNING, needs=(Need.XACRO, Need.MODEL, Need.FILES), help="delete it, or use it")
def check(subject: Subject) -> Findings:
    xacro = subject.xacro
    if xacro.is_library or not xacro.is_complete:
        return
    found = [one for one in _unused(subject) if isinstance(one.at, Location)]
    found = [one for one in found if one.at.span.source is subject.source]
    if found and not is_included(subject.source.path, subject.resolver.packages):
        yield from found


def _unused(subject: Subject) -> Findings:
    xacro = subject.xacro
    written: set[float] | None = None
    for definition in xacro.properties:
        name = definition.name.removeprefix("**")
        if name not in xacro.usage.names:
            written = _numbers_written(subject) if written is None else written
            is_left_over = _is_left_over(definition, written) and not _is_misspelt(name, xacro)
            fix = Fix("delete the property", remove_spans([definition.tag.whole_span]))
            at = Location(definition.tag.span, definition.frame)
            yield Finding(
                at,
                f"property '{name}' is never used",
                fix=fix,
                group_key="unused",
                severity=Severity.INFO if is_left_over else None,
            )
    for argument in xacro.arguments:
        if argument.name not in xacro.usage.names:
            at = Location(argument.tag.span, argument.frame)
            yield Finding(at, f"argument '{argument.name}' is never used", group_key="unused")
    # XAC002 reports macros that are called without the prefix.
    called = {*xacro.usage.calls, *(element.tag for element in subject.document.root.walk())}
    for macro in () if "call" in xacro.usage.calls else xacro.macros:
        if macro.name not in called:
            at = Location(macro.tag.span, macro.frame)
            message = f"macro '{macro.name}' is never called"
            yield Finding(at, message, severity=Severity.INFO)


def _is_left_over(definition: Definition, written: set[float]) -> bool:
    """True for a number that stands nowhere else, where the property should."""
    value = definition.attributes.get("value", "").strip().encode()
    return _NUMBER.fullmatch(value) is not None and float(value) not in written


def _is_misspelt(name: str, xacro: Xacro) -> bool:
    """True if a name that nothing defines differs in one letter; xacro did not evaluate its use."""
    defined = {one.name.removeprefix("**") for one in (*xacro.properties, *xacro.arguments)}
    return any(is_typo(name, used) for used in xacro.usage.names - defined)


def _numbers_written(subject: Subject) -> set[float]:
    """The numbers of the checked file that are no values of properties."""
    data = bytearray(blank_comments(subject.source.data))
    for definition in subject.xacro.properties:
        span = definition.tag.whole_span
        if span.source is subject.source:
            data[span.start : span.end] = b" " * (span.end - span.start)
    body = data.find(b"?>") + 1  # no version of XML
    return {float(number) for number in _NUMBER.findall(bytes(data), body)}

"""The file cannot be expanded.

A property is not defined, a macro does not exist or is called with other parameters than it has, an
included file does not exist, Python cannot evaluate an expression. xacro stops at the first error
without a line number; urdfkit reports all errors, each at its expression. An error in a property is
reported at the property's definition, with its use as a note. All `<property>` elements of a file
without the prefix are one finding, at the first.

A name that is defined in a condition is a warning if an argument has its default: the file may be
for other values.

An included file that only xacrodoc finds, from the directory where it is run, is a warning, and so
are a file that the build creates, one that git ignores, as a script creates it, and an environment
variable that is not set.

A file that another file includes, and that uses macros, properties or arguments of that file, is
not a complete robot: an info. Check the top file; findings in included files are reported at their
lines. If all links of a file have a parent, which it does not define, and no file includes it, a
robot elsewhere may: a warning.

Sources:
    xacro: https://wiki.ros.org/xacro
    Albergo et al. 2021, misunderstandings of xacro: https://arxiv.org/abs/2109.09694
    ros/xacro#267: https://github.com/ros/xacro/issues/267
"""

import re

from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import (
    Confidence,
    Context,
    Finding,
    Findings,
    Related,
    Severity,
    reported,
    rule,
)
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.diagnostic import NOT_BUILT, NOT_CREATED
from urdfkit.xacro.errors import IN_CONDITION, ONLY_XACRODOC, VARIABLE

BAD = xacro_xml('<link name="${prefix}base"/>')
GOOD = xacro_xml('<xacro:property name="prefix" value="left_"/>', '<link name="${prefix}base"/>')

#: Starts of messages about what another place of work may have.
_OF_ENVIRONMENT = (NOT_BUILT, NOT_CREATED, ONLY_XACRODOC, VARIABLE)

#: All uses of a name lack one definition, and all properties without prefix the prefix.
_UNDEFINED = r"name '\w+' is not defined(: xacro ignores .*)?"
#: All conditions with one value have it from one argument.
_CONDITION = r"the condition is '.*', neither true nor false"
#: All uses of a missing key of a YAML file.
_NO_KEY = "The yaml dictionary has no key '[^']*'"


@rule(
    Severity.ERROR,
    needs=(),
    help="correct the expression or the call",
    depends_on_arguments=True,
)
def check(context: Context) -> Findings:
    unprefixed: dict[str, list[Finding]] = {}
    for finding in _reported(context):
        if start := next(filter(finding.message.startswith, _OF_ENVIRONMENT), ""):
            yield finding._replace(severity=Severity.WARNING, group_key=start)
            continue
        if _is_in_plain_macro(finding):
            message = f"<macro> without xacro: defines no macro, so {finding.message}"
            help = "write <xacro:macro> and </xacro:macro>, and xmlns:xacro in the root"
            yield finding._replace(message=message, help=help, group_key="<macro>")
            continue
        lacking = re.match(f"{_UNDEFINED}|{_CONDITION}|{_NO_KEY}", finding.message)
        if lacking and lacking[1]:
            unprefixed.setdefault(finding.span.source.path, []).append(finding)
        else:
            yield finding._replace(group_key=lacking[0]) if lacking else finding
    yield from map(_as_one, unprefixed.values())


def _reported(context: Context) -> Findings:
    """What reading met; a name that is defined for other values of an argument is a warning."""
    xacro = context.reading.xacro
    has_default = xacro is not None and not xacro.defaults.keys() <= context.arguments.keys()
    for finding in reported(context, "XAC001"):
        if has_default and IN_CONDITION in finding.help:
            help = f"{finding.help}; pass the argument that it depends on"
            severity, confidence = Severity.WARNING, Confidence.GUESSED
            yield finding._replace(help=help, severity=severity, confidence=confidence)
        else:
            yield finding


def _as_one(findings: list[Finding]) -> Finding:
    """The ``<property>`` elements of a file that lack the prefix, at the first of them."""
    first, *others = sorted(findings, key=lambda finding: finding.span.start)
    notes = tuple(Related(other.span, "without the prefix, too") for other in others)
    return first._replace(
        message=first.message + more_like_this(len(others)), related=first.related + notes
    )


def _is_in_plain_macro(finding: Finding) -> bool:
    """True inside ``<macro>``, which xacro of the first years of ROS knew without a namespace."""
    if not re.match(_UNDEFINED, finding.message):
        return False
    span = finding.span
    ends = re.findall(rb"<(/?)macro\b", span.source.data[: span.start])
    return bool(ends) and ends[-1] == b""

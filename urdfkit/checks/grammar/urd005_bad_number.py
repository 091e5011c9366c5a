"""A value is not a number, has too many or too few numbers, or is not a known keyword.

URDF parsers read digits with a decimal point and an exponent, such as `-1.5e-3`, with spaces
between the numbers. They reject a decimal comma, a unit, `inf`, `nan`, a tab between two numbers
and white space after the last. `xyz`, `rpy`, `size` and `scale` have three numbers, `rgba` four.

For a value in a joint, urdfdom (RViz, MoveIt, Gazebo, Pinocchio) rejects the robot; in a link it
drops the inertia or every shape of that link, and a colour becomes black. MuJoCo and Drake reject a
vector of the wrong length; PyBullet continues with a wrong number. Only Drake reads one number as
the `scale` in all directions: this is not reported if Drake is the only target. MuJoCo accepts the
numbers of C: hexadecimal numbers, any white space, `inf` in a `<limit>`. These are a warning if
MuJoCo is the only target.

In `<mujoco>` some attributes require a keyword, as `strippath="true"`: MuJoCo rejects other words
("invalid keyword"), and keywords in upper case.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    MuJoCo, keywords: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler
    ros/urdfdom#98: https://github.com/ros/urdfdom/issues/98
"""

import re

from urdfkit.core.words import counted
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import collision_xml, link_xml
from urdfkit.text import schema
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import as_written, fix_value
from urdfkit.text.grammar import has_break, is_number, owner

BAD = link_xml("ball", collision_xml('<sphere radius="0,05"/>', '<origin xyz="0, 0, 0,05"/>'))
FIXED = GOOD = BAD.replace('"0, 0, 0,05"', '"0 0 0.05"').replace('"0,05"', '"0.05"')

_PROPERTY = re.compile(rb"<xacro:property\s[^<>]*\bname=[\"']([A-Za-z_][A-Za-z_0-9]*)[\"']").findall
#: Numbers of C that urdfdom does not read.
_HEXADECIMAL = re.compile(r"(?ai)[-+]?0x([\da-f]+\.?[\da-f]*|\.[\da-f]+)(p[-+]?\d+)?")
#: Two numbers in Python, of ``${0,5 * pi}``.
_PAIR = r"\((-?[\d.e+-]+), (-?[\d.e+-]+)\)"
_OPERATOR = re.compile(r"[*/()]")
_INFINITE = re.compile(r"(?i)[-+]?inf(inity)?")
_WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*(?![\w.])").findall


@rule(
    Severity.ERROR,
    help="write the required count of numbers, with decimal points, separated by spaces",
)
def check(context: Context) -> Findings:
    properties: dict[str, set[str]] = {}  # by the path of their file
    reads_c = context.targets.all_are("reads_c_numbers")
    reads_scale = context.targets.all_are("reads_one_scale")
    for element, attribute, kind, _ in context.deviations.get("URD005", ()):
        assert attribute is not None
        if "|" in kind:
            yield _of_words(attribute, kind.split("|"))
            continue
        length = schema.LENGTHS.get(kind, 1)
        parts = [part for part in attribute.value.split(" ") if part]
        if length > 1 and len(parts) != length and all(map(is_number, parts[:100])):
            if reads_scale and attribute.name == "scale" and len(parts) == 1:
                continue
            reason, alike = f"has {counted(len(parts), 'number')}, not {length} ({kind})", ""
            better = _completed(attribute.name, kind, parts)
        else:
            text = as_written(attribute)
            better = _fixed(text, length)
            reason = alike = _reason(text, length, better or "")
        fix = fix_value(attribute, better)
        message = f"{owner(element)}: {attribute.name} of <{element.tag}> {reason}"
        help = (
            f'write {attribute.name}="{better}"' if better else _of_property(attribute, properties)
        )
        if re.fullmatch(_PAIR, attribute.value):
            help = "write a decimal point in the expression"
        if not help and _OPERATOR.search(attribute.value):
            help = "write the number; in a xacro, put the whole expression into one ${...}"
        is_taken = reads_c and _is_read_by_c(attribute, length)
        severity = Severity.WARNING if is_taken else None
        yield Finding(attribute, message, help, fix, group_key=alike, severity=severity)


def _is_read_by_c(attribute: Attribute, length: int) -> bool:
    """True if ``strtod`` reads this many numbers; only limits may be infinite."""
    parts = attribute.value.split()
    is_limit = attribute.element.tag == "limit"
    return len(parts) == length and all(
        is_number(part) or _HEXADECIMAL.fullmatch(part) or (is_limit and _INFINITE.fullmatch(part))
        for part in parts
    )


def _of_property(attribute: Attribute, properties: dict[str, set[str]]) -> str:
    """Help for the name of a property of the same file that is written without ``${}``."""
    source = attribute.span.source
    if source.path not in properties:
        properties[source.path] = {
            name.decode("utf-8", "replace") for name in _PROPERTY(source.data)
        }
    words = _WORD(attribute.value) if properties[source.path] else ()
    word = next((word for word in words if word in properties[source.path]), "")
    return f"write ${{{word}}}, the value of the property" if word else ""


def _of_words(attribute: Attribute, words: list[str]) -> Finding:
    text = attribute.value
    better = next((word for word in words if word.lower() == text.strip().lower()), "")
    return Finding(
        attribute,
        f"{owner(attribute.element)}: {attribute.name} of <{attribute.element.tag}> is "
        f"'{as_written(attribute)[:40]}', not {' or '.join(words)}",
        f'write {attribute.name}="{better}"' if better else "write one of these words",
        fix_value(attribute, better or None),
    )


def _reason(text: str, length: int, better: str) -> str:
    """The defect of a value, as text after its name; ``better`` is the correct value, if known."""
    count = len(text.split())
    if count == 0:
        return "is empty"
    if count > length == 1:
        if re.fullmatch(_PAIR, text):
            return f"is '{text[:40]}': its expression has a decimal comma"
        if _OPERATOR.search(text):
            return f"is '{text[:40]}', which no parser computes"
        are_numbers = all(map(is_number, text.split()))
        more = f"holds {count} numbers, not 1"
        return more if are_numbers else f"is '{text[:40]}', which is not a number"
    if has_break(text) and count > 1:
        return "has a tab or a line break between its numbers; parsers need spaces"
    bad = next((part for part in text.split() if not is_number(part)), "")
    if not bad:
        return "has white space after the number"
    if "," in bad and better == " ".join(text.replace(",", " ").split()):
        return "has commas between its numbers; parsers need spaces"
    if "," in bad:
        return f"has a decimal comma ('{bad[:40]}'); write a decimal point"
    if bad.strip("+-").lower() in ("inf", "infinity", "nan"):
        return f"is '{bad}', which URDF parsers reject"
    return f"holds '{bad[:40]}', which is not a number"


def _fixed(text: str, length: int) -> str | None:
    """The value with correct decimal points and white space, if it is valid then."""
    parts = [part.rstrip(",") for part in text.split()]
    spaced = " ".join(parts)
    for candidate in (spaced, spaced.replace(",", "."), " ".join(text.replace(",", " ").split())):
        found = candidate.split(" ")
        if len(found) == length and all(map(is_number, found)):
            return candidate
    return None


def _completed(name: str, kind: str, parts: list[str]) -> str | None:
    """The vector, if only one is possible: a scale for all axes, an opaque colour."""
    if name == "scale" and len(parts) == 1:
        return " ".join(parts * 3)
    return " ".join([*parts, "1"]) if kind == schema.RGBA and len(parts) == 3 else None

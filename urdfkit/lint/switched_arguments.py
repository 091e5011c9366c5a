"""Boolean arguments of a robot that no launch file switches, such as that of its simulation.

What is in an ``<xacro:if>`` of such an argument is checked, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.plan import Job

if TYPE_CHECKING:
    from urdfkit.lint.context import Context

#: Most arguments of a robot that are switched, one at a time.
MAX_SWITCHED = 4
#: A robot of more elements is not checked once more for each of them.
MAX_ELEMENTS = 5_000
_OTHER = {"true": "false", "false": "true"}
_CONDITION = re.compile(rb"<xacro:(?:if|unless)\b[^<>]*?\bvalue\s*=\s*(?:\"([^\"]*)|'([^']*))")
_WORD = re.compile(r"\w+")


def switched(started: list[tuple[Job, Context]]) -> Iterator[Job]:
    """A robot with the other value of each boolean argument that a condition names.

    Args:
        started: the robot with the sets of arguments with which it is started.
    """
    job, context = started[0]
    document, defaults = context.reading.document, context.reading.defaults
    if document is None or not any(value.lower() in _OTHER for value in defaults.values()):
        return
    if sum(1 for _ in document.root.walk()) > MAX_ELEMENTS:
        return
    sets = [{**defaults, **variant.arguments} for variant, _ in started]
    names = _words_in_conditions(context).intersection(defaults).difference(job.arguments)
    left = MAX_SWITCHED
    for name in filter(names.__contains__, defaults):  # in their order
        values = {arguments.get(name, "").lower() for arguments in sets}
        if left and len(values) == 1 and (value := _OTHER.get(*values)):
            left -= 1
            arguments = {**job.arguments, name: value}
            yield job._replace(arguments=arguments, may_fail=True, switched=f"{name}={value}")


def _words_in_conditions(context: Context) -> set[str]:
    assert context.reading.xacro is not None, "only a xacro has arguments"
    found = (
        match
        for source in context.reading.xacro.sources
        for match in _CONDITION.findall(source.data)
    )
    texts = (b" ".join(match).decode("utf-8", "replace") for match in found)
    return {word for text in texts for word in _WORD.findall(text)}

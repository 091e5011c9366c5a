"""Links and joints that a file of a robot defines, but an argument disables."""

import re
from functools import lru_cache

from urdfkit.lint.context import Context
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Source

#: The name of a link or joint, behind the expressions that it begins with; the joints of other
#: elements, such as ``<ros2_control>``, have no type.
_DEFINITION = (
    rb"""<(?:link|joint(?=[^<>]*\stype\s*=))\b[^<>]*?"""
    rb"""\bname\s*=\s*["'](?:\$[({][^)}"'<>]*[)}])*([^"'<>$]+)["']"""
)


def is_switched_off(context: Context, name: str) -> bool:
    """True if a file of the robot defines a link or joint inside a false condition.

    The joint of a controller may have the name of a link by mistake.
    """
    expanded, model = context.reading.xacro, context.model
    if expanded is None or name in model.links_by_name or name in model.joints_by_name:
        return False
    return name in _defined(expanded.sources)


@lru_cache(maxsize=1)  # a robot may have many unknown references
def _defined(sources: tuple[Source, ...]) -> frozenset[str]:
    """The names of the links and joints in some files, without expressions at their beginning."""
    found = (re.findall(_DEFINITION, blank_comments(source.data)) for source in sources)
    return frozenset(name.decode("utf-8", "replace") for names in found for name in names)

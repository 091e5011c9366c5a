"""The file is not well-formed XML.

No reader accepts it. All errors are listed, because the first one is often only where an
earlier slip was noticed: look for an unclosed tag, a missing quote or a stray `<` or `&` above.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule, told

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = '<robot name="r"><link name="a"></robot>'
GOOD = '<robot name="r"><link name="a"/></robot>'


@rule(
    "XML001",
    "not-well-formed",
    Severity.ERROR,
    needs=(),
    help="close every tag and quote; write < as &lt; and & as &amp;",
)
def check(subject: Subject) -> Iterator[Finding]:
    return told(subject, "XML001")

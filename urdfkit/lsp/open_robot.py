"""One robot in the editor, and what can be asked about it for the texts as they are."""

from __future__ import annotations

import os
from functools import cached_property

from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.context import Context
from urdfkit.lsp.markup import Page
from urdfkit.lsp.names import NameIndex
from urdfkit.robot.model import RobotModel
from urdfkit.text.document import Attribute, Document
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro, expand


class OpenRobot:
    """One description and what can be asked about it, for the texts as they are.

    Args:
        before: the same robot before the last change, for the names of a text that is broken.
    """

    def __init__(
        self, entry: RobotEntry, resolver: Resolver, config: Config, before: OpenRobot | None
    ) -> None:
        self.path = entry.file
        self.resolver = resolver
        arguments = {**config.arguments, **entry.arguments}
        self.context = Context(
            resolver.admit_and_read(entry.file), resolver, arguments, trust=config.trust
        )
        if before is not None and before.document is None:
            before = before.before
        self.before: OpenRobot | None = before if self.document is None else None
        self._others: dict[str, Source] = {}

    @cached_property
    def document(self) -> Document | None:
        """Expanded; None while it cannot be read."""
        return self.context.reading.document

    @property
    def model(self) -> RobotModel | None:
        """The robot; while it cannot be read, what it was before."""
        if self.document is not None:
            return self.context.model
        return self.before.model if self.before else None

    @cached_property
    def sources(self) -> dict[str, Source]:
        xacro = self.context.reading.xacro
        sources = xacro.sources if xacro else (self.context.source,)
        return {os.path.realpath(source.path): source for source in sources}

    @cached_property
    def names(self) -> NameIndex:
        """The names in its texts, in those that it had before it broke, and in its SRDF."""
        pages = [Page(source) for source in self.sources.values()]
        before = self.before.sources if self.before else {}
        pages += [Page(self.source(path)) for path in before if path not in self.sources]
        srdf = self.context.srdf if self.document else None
        if srdf is not None:
            pages.append(Page(self.source(srdf.path)))
        return NameIndex(pages, self.document)

    def source(self, path: str) -> Source:
        """One of its texts; of a file that it does not read at the moment, too."""
        real = os.path.realpath(path)
        found = self.sources.get(real) or self._others.get(real)
        if found is None:
            found = self._others[real] = self.resolver.read(path)
        return found

    def page(self, path: str) -> Page:
        source = self.source(path)
        pages = self.names.pages
        if source.path not in pages:
            pages[source.path] = Page(source)
        return pages[source.path]

    def given(self, *kinds: str) -> list[str]:
        """The names of some kinds that it gives; while it is broken, those of before as well."""
        found = set(self.names.given(*kinds))
        if self.before is not None:
            found.update(self.before.names.given(*kinds))
        return sorted(found)

    @cached_property
    def _written(self) -> dict[tuple[str, int, str], list[Attribute]]:
        found: dict[tuple[str, int, str], list[Attribute]] = {}
        xacro = self.traced
        document = xacro.document if xacro else self.document
        for element in document.root.walk() if document else ():
            at = element.tag_at
            for attribute in element.attributes.values():
                key = (os.path.realpath(at.source.path), at.start, attribute.name)
                found.setdefault(key, []).append(attribute)
        return found

    @cached_property
    def traced(self) -> Xacro | None:
        """The xacro expanded once more, with the origin of every value; None of a plain URDF."""
        if self.document is None or self.context.reading.xacro is None:
            return None
        context = self.context
        return expand(
            context.source, self.resolver, context.arguments, trust=context.trust, traced=True
        )

    def expanded(self, source: Source, start: int, name: str) -> list[Attribute]:
        """What an attribute of the tag at a place became: an attribute for every call."""
        return self._written.get((os.path.realpath(source.path), start, name), [])

"""A robot in the editor, with data derived from the current texts."""

from __future__ import annotations

import os
from functools import cached_property

from urdfkit.core.grouping import by_key
from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.context import Context
from urdfkit.lsp.markup import Markup
from urdfkit.lsp.names import NameIndex
from urdfkit.robot.model import RobotModel
from urdfkit.text.document import Attribute, Document
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro, expand


class OpenRobot:
    """A description with data derived from the current texts.

    Args:
        before: the robot before the last change, for the names of a text that is broken now.
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
        self._other_sources: dict[str, Source] = {}

    @cached_property
    def document(self) -> Document | None:
        """The expanded document; None if the expansion fails."""
        return self.context.reading.document

    @property
    def model(self) -> RobotModel | None:
        """The robot; if it is unreadable, its last readable state."""
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
        """The names in its texts, in its last readable texts, and in its SRDF."""
        markups = [Markup(source) for source in self.sources.values()]
        before = self.before.sources if self.before else {}
        markups += [Markup(self.source(path)) for path in before if path not in self.sources]
        srdf = self.context.srdf if self.document else None
        if srdf is not None:
            markups.append(Markup(self.source(srdf.path)))
        return NameIndex(markups, self.document)

    def source(self, path: str) -> Source:
        """The text of a file, even if the robot does not include it at the moment."""
        real = os.path.realpath(path)
        source = self.sources.get(real) or self._other_sources.get(real)
        if source is None:
            source = self._other_sources[real] = self.resolver.read(path)
        return source

    def markup(self, path: str) -> Markup:
        source = self.source(path)
        markups = self.names.markups
        if source.path not in markups:
            markups[source.path] = Markup(source)
        return markups[source.path]

    def defined(self, *kinds: str) -> list[str]:
        """Defined names of some kinds, including those of the last readable state."""
        names = set(self.names.defined(*kinds))
        if self.before is not None:
            names.update(self.before.names.defined(*kinds))
        return sorted(names)

    @cached_property
    def _written(self) -> dict[tuple[str, int, str], list[Attribute]]:
        xacro = self.traced
        document = xacro.document if xacro else self.document
        return by_key(
            ((os.path.realpath(at.source.path), at.start, attribute.name), attribute)
            for element in (document.root.walk() if document else ())
            for at in (element.tag_at,)
            for attribute in element.attributes.values()
        )

    @cached_property
    def traced(self) -> Xacro | None:
        """The xacro expanded again, with the origins of all values; None for a plain URDF."""
        if self.document is None or self.context.reading.xacro is None:
            return None
        context = self.context
        return expand(
            context.source, self.resolver, context.arguments, trust=context.trust, traced=True
        )

    def expanded(self, source: Source, start: int, name: str) -> list[Attribute]:
        """The expanded attributes of a tag at an offset, one for each call."""
        return self._written.get((os.path.realpath(source.path), start, name), [])

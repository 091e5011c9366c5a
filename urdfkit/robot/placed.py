"""Values of attributes with the place that they were read from."""

from urdfkit.core.static_typing import Generic, TypeVar
from urdfkit.robot.values import number
from urdfkit.text.document import Attribute, Element, Step
from urdfkit.text.source import Span

T = TypeVar("T", covariant=True)


class Placed(Generic[T]):
    """A value and the element or attribute it was read from."""

    __slots__ = ("at", "value")

    def __init__(self, value: T, at: Element | Attribute) -> None:
        self.value = value
        self.at = at

    @property
    def span(self) -> Span:
        return self.at.span

    @property
    def via(self) -> tuple[Step, ...]:
        return self.at.via

    def __repr__(self) -> str:
        return f"Placed({self.value!r} at {self.at.span})"


def placed_number(element: Element | None, name: str) -> Placed[float] | None:
    attribute = element.attributes.get(name) if element else None
    value = number(attribute.value) if attribute else None
    return None if attribute is None or value is None else Placed(value, attribute)


def placed_text(element: Element | None, name: str) -> Placed[str] | None:
    attribute = element.attributes.get(name) if element else None
    return None if attribute is None else Placed(attribute.value, attribute)

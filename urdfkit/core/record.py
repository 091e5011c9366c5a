"""Records: named tuples whose classes are created in a tenth of the time.

`typing.NamedTuple` compiles a constructor for every class, which takes 0.1 ms. A check loads about
ninety such classes, and would spend a tenth of its time on them. A `Record` is written and used
like a `NamedTuple`, and is one for type checkers. Its module must import annotations from
`__future__`: otherwise Python 3.14 does not provide the field names while a class is created.
"""

from __future__ import annotations

__all__ = ["Record", "frozen"]

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing import Any
    from typing import NamedTuple as Record
else:
    try:
        from _collections import _tuplegetter  # the descriptor of the standard named tuples
    except ImportError:  # not CPython
        from operator import itemgetter

        def _tuplegetter(index, doc):
            return property(itemgetter(index), doc=doc)

    class _RecordType(type):
        """Turns the annotations of a class body into fields."""

        def __new__(cls, name, bases, body):
            fields = tuple(body.get("__annotations__", ()))
            body["_fields"] = body["__match_args__"] = fields
            body["_field_defaults"] = {key: body.pop(key) for key in fields if key in body}
            body["_defaults"] = tuple(body["_field_defaults"].values())
            body["__slots__"] = ()
            for index, field in enumerate(fields):
                body[field] = _tuplegetter(index, None)
            return super().__new__(cls, name, bases, body)

    class Record(tuple, metaclass=_RecordType):
        """An immutable record."""

        def __new__(cls, *values, **named):
            if named:
                values = _completed(cls, values, named)
            missing = len(cls._fields) - len(values)
            if missing:
                if not 0 < missing <= len(cls._defaults):
                    raise _wrong(cls, f"{len(values)} values given")
                values += cls._defaults[-missing:]
            return tuple.__new__(cls, values)

        def _replace(self, **named):
            values = [named.pop(*item) for item in zip(self._fields, self, strict=True)]
            if named:
                raise _wrong(type(self), f"no {', '.join(named)}")
            return tuple.__new__(type(self), values)

        def _asdict(self):
            return dict(zip(self._fields, self, strict=True))

        def __getnewargs__(self):
            return tuple(self)

        def __repr__(self):
            parts = (f"{name}={value!r}" for name, value in self._asdict().items())
            return f"{type(self).__name__}({', '.join(parts)})"

    def _completed(cls, values, named):
        """Values of all fields, from positional and keyword arguments and defaults."""
        rest = cls._fields[len(values) :]
        known = {**cls._field_defaults, **named}
        if unknown := [name for name in named if name not in rest]:
            raise _wrong(cls, f"{', '.join(unknown)} given")
        if missing := [name for name in rest if name not in known]:
            raise _wrong(cls, f"{', '.join(missing)} missing")
        return values + tuple([known[name] for name in rest])

    def _wrong(cls, reason):
        return TypeError(f"{cls.__name__}({', '.join(cls._fields)}): {reason}")


def frozen(value: object) -> Any:
    """A JSON value with tuples instead of lists."""
    return tuple(map(frozen, value)) if isinstance(value, list) else value

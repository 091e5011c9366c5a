"""Compares a collision matrix with an SRDF file, and writes it as SRDF.

Source of the grammar: srdfdom's ``Model::loadDisabledCollisions`` and SRDFWriter.
"""

from typing import NamedTuple

from urdfkit.physics.collision.matrix import Matrix, PairResult, PairVerdict
from urdfkit.physics.collision.worker_pool import CollisionError
from urdfkit.ros.moveit.srdf import Srdf, is_srdf, pair_of
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import (
    escaped,
    insert_after,
    insert_last,
    remove_elements,
    replace_value,
)
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

#: Reasons computed by the Setup Assistant; other reasons were written by a person.
COMPUTED = frozenset(v.reason.lower() for v in PairVerdict if v.reason)


class MatrixComparison(NamedTuple):
    """Differences between a matrix and the disabled collisions of an SRDF."""

    #: Pairs that the SRDF disables, although they collide in some configurations.
    hidden: tuple[PairResult, ...]
    #: Pairs that the SRDF checks, although they never collide, always collide, are adjacent, or
    #: collide in the initial configuration and in most samples.
    watched: tuple[PairResult, ...]
    agreed: int  # number of pairs that both disable


def compare(matrix: Matrix, srdf: Srdf) -> MatrixComparison:
    """Compare a matrix with an SRDF."""
    hidden, watched, agreed = [], [], 0
    for pair in matrix.pairs:
        is_off = srdf.disables(frozenset((pair.first, pair.second)))
        if is_off and pair.verdict is PairVerdict.SOMETIMES:
            hidden.append(pair)
        elif is_off and pair.verdict.reason:
            agreed += 1
        elif pair.verdict.reason and not is_off and not pair.is_seldom:
            watched.append(pair)
    return MatrixComparison(tuple(hidden), tuple(watched), agreed)


def new_srdf(matrix: Matrix) -> bytes:
    """A new SRDF that only contains the matrix."""
    lines = [f"  {line}\n" for pair in matrix.pairs if (line := _line(pair))]
    name = escaped(matrix.robot)
    return f'<?xml version="1.0"?>\n<robot name="{name}">\n{"".join(lines)}</robot>\n'.encode()


def srdf_edits(matrix: Matrix, source: Source) -> tuple[Edit, ...]:
    """The edits that update the matrix in an SRDF; other contents do not change.

    Pairs that are disabled for a reason that is not computed (``User``), or that could not be
    measured, are kept.

    Raises:
        CollisionError: the file cannot be read, or is a xacro file.
    """
    if is_xacro(source):
        raise CollisionError(f"{source.path} is a xacro file; pass the expanded SRDF file")
    document, _ = read_xml(source)
    if document is None or not is_srdf(document.root):
        raise CollisionError(
            f"{source.path} is not an SRDF file; pass another file to write a new one"
        )
    results = {frozenset((result.first, result.second)): result for result in matrix.pairs}
    remaining: list[Element] = []
    obsolete: list[Element] = []
    edits: list[Edit] = []
    for element in document.root.all("disable_collisions"):
        result = results.get(pair_of(element))
        reason = element.attributes.get("reason")
        if result is None or not _is_computed(reason) or result.verdict is PairVerdict.UNKNOWN:
            remaining.append(element)
        elif not result.verdict.reason:
            obsolete.append(element)
        else:
            remaining.append(element)
            if reason and reason.value != result.verdict.reason:
                edits += replace_value(reason, result.verdict.reason) or ()
    existing = {pair_of(element) for element in remaining}
    new = [line for key, res in results.items() if key not in existing and (line := _line(res))]
    edits += remove_elements(obsolete)
    if new:
        edits += insert_after(remaining[-1], new) if remaining else insert_last(document.root, new)
    return tuple(edits)


def _is_computed(reason: Attribute | None) -> bool:
    return reason is not None and reason.value.lower() in COMPUTED


def _line(pair: PairResult) -> str:
    """The element that disables a pair; empty if the pair must be checked."""
    if not pair.verdict.reason:
        return ""
    first, second = escaped(pair.first), escaped(pair.second)
    reason = pair.verdict.reason
    return f'<disable_collisions link1="{first}" link2="{second}" reason="{reason}"/>'

"""A collision matrix as SRDF has it: compared with one that is there, and written.

Source of the grammar: srdfdom's ``Model::loadDisabledCollisions`` and SRDFWriter.
"""

from typing import NamedTuple

from urdfkit.physics.collision.matrix import Matrix, PairResult, PairVerdict
from urdfkit.physics.collision.worker_pool import CollisionError
from urdfkit.ros.moveit.srdf import Srdf, is_srdf, pair_of
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.editing.edits import insert_after, insert_last, remove_elements, replace_value
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

#: The reasons that the Setup Assistant computes; others were written by a person.
COMPUTED = frozenset(v.reason.lower() for v in PairVerdict if v.reason)


class MatrixComparison(NamedTuple):
    """A matrix and an SRDF that disables collisions."""

    #: Pairs that the SRDF disables, although they collide in some configurations.
    hidden: tuple[PairResult, ...]
    #: Pairs that it checks, although they never collide, always do, are adjacent, or collide where
    #: the robot begins and in most samples.
    watched: tuple[PairResult, ...]
    agreed: int  # the number of pairs that both disable


def compare(matrix: Matrix, srdf: Srdf) -> MatrixComparison:
    """What a matrix and an SRDF say differently."""
    hidden, watched, agreed = [], [], 0
    for one in matrix.pairs:
        is_off = srdf.disables(frozenset((one.first, one.second)))
        if is_off and one.verdict is PairVerdict.SOMETIMES:
            hidden.append(one)
        elif is_off and one.verdict.reason:
            agreed += 1
        elif one.verdict.reason and not is_off and not one.is_seldom:
            watched.append(one)
    return MatrixComparison(tuple(hidden), tuple(watched), agreed)


def written(matrix: Matrix) -> bytes:
    """A new SRDF that holds nothing but the matrix."""
    lines = [f"  {line}\n" for one in matrix.pairs if (line := _line(one))]
    name = _escaped(matrix.robot)
    return f'<?xml version="1.0"?>\n<robot name="{name}">\n{"".join(lines)}</robot>\n'.encode()


def updated(matrix: Matrix, source: Source) -> bytes:
    """An SRDF with its matrix brought up to date; all else stays as it is written.

    Kept are pairs that were disabled for a reason that is not computed (``User``), and those that
    could not be measured.

    Raises:
        CollisionError: it cannot be read, or is a xacro.
    """
    if is_xacro(source):
        raise CollisionError(f"{source.path} is a xacro; pass the expanded SRDF file")
    document, _ = read_xml(source)
    if document is None or not is_srdf(document.root):
        raise CollisionError(
            f"{source.path} is not an SRDF file; pass another file to write a new one"
        )
    wanted = {frozenset((one.first, one.second)): one for one in matrix.pairs}
    kept: list[Element] = []
    gone: list[Element] = []
    edits: list[Edit] = []
    for element in document.root.all("disable_collisions"):
        one = wanted.get(pair_of(element))
        reason = element.attributes.get("reason")
        if one is None or not _is_computed(reason) or one.verdict is PairVerdict.UNKNOWN:
            kept.append(element)
        elif not one.verdict.reason:
            gone.append(element)
        else:
            kept.append(element)
            if reason and reason.value != one.verdict.reason:
                edits += replace_value(reason, one.verdict.reason) or ()
    there = {pair_of(element) for element in kept}
    new = [line for pair, one in wanted.items() if pair not in there and (line := _line(one))]
    edits += remove_elements(gone)
    if new:
        edits += insert_after(kept[-1], new) if kept else insert_last(document.root, new)
    return apply_edits(source.data, edits)


def _is_computed(reason: Attribute | None) -> bool:
    return reason is not None and reason.value.lower() in COMPUTED


def _line(one: PairResult) -> str:
    """The element that disables a pair; empty if it must be watched."""
    if not one.verdict.reason:
        return ""
    first, second = _escaped(one.first), _escaped(one.second)
    reason = one.verdict.reason
    return f'<disable_collisions link1="{first}" link2="{second}" reason="{reason}"/>'


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")

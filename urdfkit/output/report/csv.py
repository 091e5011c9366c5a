"""A table of the report as CSV, for spreadsheets."""

import csv
import io
from collections.abc import Iterable, Iterator
from typing import Any

from urdfkit.errors import UrdfkitError
from urdfkit.output.report.document import ReportDocument

#: Columns of each table.
COLUMNS = {
    "findings": "severity code name message path line column element help".split(),
    "links": "name mass share center moments visuals collisions path line".split(),
    "joints": "name type parent child axis lower upper effort velocity path line".split(),
    "meshes": "link role name path format size triangles defect".split(),
    "statics": "joint unit at_zero worst effort used exceeded".split(),
    "collisions": "first second verdict frequency distance".split(),
}
#: Key of the rows, for tables whose part of the document contains more than rows.
_ROWS = {"statics": "joints", "collisions": "pairs"}
#: First characters of a cell that a spreadsheet interprets as a formula.
_FORMULA = ("=", "+", "-", "@", "\t", "\r")


def render(document: ReportDocument, table: str = "findings") -> str:
    """A table with a header row.

    Raises:
        UrdfkitError: the table is missing, for example because the robot cannot be read.
    """
    rows = document[table]
    if rows is None:
        reason = document["missing"].get(table, "skipped by --quick")
        raise UrdfkitError(f"no table '{table}': {reason}")
    if table in _ROWS:
        rows = rows[_ROWS[table]]
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    writer.writerow(COLUMNS[table])
    writer.writerows(_rows(rows, COLUMNS[table]))
    return text.getvalue()


def _rows(rows: Iterable[dict[str, Any]], columns: Iterable[str]) -> Iterator[list[object]]:
    for row in rows:
        yield [cell(row[column]) for column in columns]


def cell(value: object) -> object:
    """A value as a cell: lists are joined with spaces, formulas are quoted."""
    if isinstance(value, list):
        return cell(" ".join(map(str, value))) if value else ""
    if isinstance(value, str) and value.startswith(_FORMULA) and not _is_numbers(value):
        return f"'{value}"
    return value


def _is_numbers(text: str) -> bool:
    try:
        return bool([float(part) for part in text.split()])
    except ValueError:
        return False

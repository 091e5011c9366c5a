"""The results of a scan as two Parquet files: models and findings."""

import os
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any

from urdfkit.core.installation import needing
from urdfkit.scan import journal
from urdfkit.scan.rows import FindingRow, ModelRow

MODELS, FINDINGS = "models.parquet", "findings.parquet"
#: Models that are converted at a time.
_CHUNK = 1000


def write_tables(directory: str) -> None:
    """Write the Parquet files next to the results, completely or not at all.

    Raises:
        MissingLibrary: pyarrow is not installed.
        UnreadableFile: the directory does not contain a scan.
    """
    with needing("Parquet", "scan"):
        import pyarrow
        from pyarrow.parquet import ParquetWriter
    kinds = {"str": pyarrow.string(), "int": pyarrow.int64(), "float": pyarrow.float64()}

    def schema(fields: dict[str, str]) -> Any:
        return pyarrow.schema([(name, kinds[kind.split(" ")[0]]) for name, kind in fields.items()])

    models = {key: kind for key, kind in ModelRow.__annotations__.items() if key != "findings"}
    findings = {"model": "str", **FindingRow.__annotations__}
    paths = [os.path.join(directory, name) for name in (MODELS, FINDINGS)]
    with (
        ParquetWriter(f"{paths[0]}.tmp", schema(models), compression="zstd") as model_writer,
        ParquetWriter(f"{paths[1]}.tmp", schema(findings), compression="zstd") as finding_writer,
    ):
        for chunk in _chunks(journal.rows(directory)):
            model_writer.write_table(_table(pyarrow, schema(models), chunk))
            flat = [
                {"model": row["model"], **finding} for row in chunk for finding in row["findings"]
            ]
            finding_writer.write_table(_table(pyarrow, schema(findings), flat))
    for path in paths:
        os.replace(f"{path}.tmp", path)


def _table(pyarrow: Any, schema: Any, rows: list[dict[str, Any]]) -> Any:
    return pyarrow.Table.from_pylist(rows, schema=schema)


def _chunks(rows: Iterable[dict[str, Any]]) -> Iterator[list[dict[str, Any]]]:
    rows = iter(rows)
    while chunk := list(islice(rows, _CHUNK)):
        yield chunk

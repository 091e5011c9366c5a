"""Scans: the same rows by every engine, whatever a model or a kill does."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from urdfkit.cli import main
from urdfkit.errors import UnreadableFile, UnwritableFile, UrdfkitError
from urdfkit.lint import rule_index
from urdfkit.lint.options import Options
from urdfkit.scan import journal
from urdfkit.scan.engines import BATCH
from urdfkit.scan.isolated import Settings
from urdfkit.scan.run import scan

ROBOT = """<robot name="r{0}"><link name="base"><inertial><mass value="{0}"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<visual><geometry><box size="1 2 {0}"/></geometry></visual></link>
<link name="arm"/><joint name="j" type="continuous"><parent link="base"/><child link="arm"/>
<axis xyz="0 0 2"/></joint></robot>"""

#: A package of rules whose one rule does to its process what the name of the robot says.
RULE = '''"""A rule that ends badly."""
import os
from urdfkit.lint.rules import rule
from urdfkit.text.diagnostic import Severity
@rule(Severity.WARNING, help="none")
def check(context):
    name = context.model.name
    if name == "kills":
        os.kill(os.getpid(), 9)
    while name == "hangs":
        pass
    if name == "grows":
        list(range(10**10))
    if name == "fails":
        raise ValueError("a bug")
    return iter(())
'''


def write(directory: Path, count: int) -> Path:
    directory.mkdir()
    for number in range(1, count + 1):
        (directory / f"{number:04}.urdf").write_text(ROBOT.format(number))
    return directory


def rows(directory: Path) -> dict[str, dict[str, Any]]:
    """The rows by model, without times; each model is there once."""
    found = list(journal.rows(str(directory)))
    by_name = {row["model"]: row for row in found}
    assert len(by_name) == len(found)
    for row in found:
        del row["seconds"], row["cpu_seconds"]
    return by_name


def ran(zoo: Path, out: Path, **more: Any) -> dict[str, dict[str, Any]]:
    scan([str(zoo)], str(out), Settings(Options()), **more)
    return rows(out)


def test_a_row_says_what_a_model_is(tmp_path: Path) -> None:
    zoo = write(tmp_path / "zoo", 1)
    row = ran(zoo, tmp_path / "out")[str(zoo / "0001.urdf")]
    assert row["status"] == "ok"
    assert (row["robot"], row["links"], row["joints"], row["dof"]) == ("r1", 2, 1, 1)
    assert (row["mass"], row["size_x"], row["size_y"], row["size_z"]) == (1, 1, 2, 1)
    assert len(row["hash"]) == 64
    found = {(one["code"], one["severity"], one["line"]) for one in row["findings"]}
    assert ("JNT006", "warning", 5) in found
    assert row["warnings"] == sum(one["severity"] == "warning" for one in row["findings"])


def test_the_hash_is_of_the_content(tmp_path: Path) -> None:
    zoo = write(tmp_path / "zoo", 2)
    mesh = zoo / "a.stl"
    text = ROBOT.format(3).replace('<box size="1 2 3"/>', '<mesh filename="a.stl"/>')
    for name in ("meshed/a.urdf", "copy/a.urdf", "other/a.urdf"):
        (zoo / name).parent.mkdir()
        (zoo / name).write_text(text)
        mesh = (zoo / name).with_name("a.stl")
        mesh.write_bytes(b"solid other" if name.startswith("other") else b"solid")
    digests = {
        Path(name).parent.name: row["hash"] for name, row in ran(zoo, tmp_path / "o").items()
    }
    assert digests["meshed"] == digests["copy"] != digests["other"]


def test_what_a_model_does_to_its_process_costs_that_model_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Rules that are known once stay so, also for the tests that follow.
    monkeypatch.setattr(rule_index, "_modules", rule_index._known().copy())
    monkeypatch.setattr(rule_index, "_external", set())
    rules = tmp_path / "harmful_rules"
    rules.mkdir()
    (rules / "__init__.py").write_text('"""Rules."""\n')
    (rules / "bad001_ends_badly.py").write_text(RULE)
    zoo = write(tmp_path / "zoo", 3)
    for name in ("kills", "hangs", "grows", "fails"):
        (zoo / f"{name}.urdf").write_text(ROBOT.format(1).replace("r1", name))
    (zoo / "broken.urdf").write_text("<robot")
    settings = Settings(Options(rules=("harmful_rules",)), seconds=5, memory=2 * 2**30)
    monkeypatch.syspath_prepend(tmp_path)
    scan([str(zoo)], str(tmp_path / "out"), settings, jobs=2)
    found = {Path(name).stem: row for name, row in rows(tmp_path / "out").items()}
    assert {name: row["status"] for name, row in found.items()} == {
        "0001": "ok",
        "0002": "ok",
        "0003": "ok",
        "kills": "died",
        "hangs": "timeout",
        "grows": "memory",
        "fails": "crashed",
        "broken": "unreadable",
    }
    assert found["kills"]["reason"] == "its process ended by signal 9"
    assert "a bug" in found["fails"]["reason"]


def test_several_processes_give_the_same_rows(tmp_path: Path) -> None:
    zoo = write(tmp_path / "zoo", 40)
    assert ran(zoo, tmp_path / "1") == ran(zoo, tmp_path / "3", jobs=3)


def test_two_sources_name_a_model_once(tmp_path: Path) -> None:
    zoo = write(tmp_path / "zoo", 3)
    sources = [str(zoo), str(zoo / "0002.urdf")]
    assert scan(sources, str(tmp_path / "out"), Settings(Options()))[0] == 3


def test_a_run_goes_on_behind_the_last_whole_line(tmp_path: Path) -> None:
    zoo, out = write(tmp_path / "zoo", 5), tmp_path / "out"
    expected = ran(zoo, out)
    results = out / journal.RESULTS
    lines = results.read_bytes().splitlines(keepends=True)
    results.write_bytes(b"".join(lines[:2]) + lines[2][:40])
    assert scan([str(zoo)], str(out), Settings(Options()))[0] == 3
    assert rows(out) == expected
    assert scan([str(zoo)], str(out), Settings(Options()))[0] == 0


@pytest.mark.parametrize("line", ["x", "[1]", "[" * 100_000, '{"model": "a"}'])
def test_results_of_something_else_are_an_error(tmp_path: Path, line: str) -> None:
    (tmp_path / "results.jsonl").write_text(f"{line}\n")
    with pytest.raises(UnreadableFile, match="no results of a scan"):
        list(journal.rows(str(tmp_path)))


def test_a_run_that_is_killed_loses_and_doubles_nothing(tmp_path: Path) -> None:
    zoo, out = write(tmp_path / "zoo", 120), tmp_path / "out"
    program = "import sys; from urdfkit.cli import main; sys.exit(main())"
    words = [sys.executable, "-c", program, "scan", str(zoo), "-o", str(out), "--jobs", "2"]
    for part in (1, 30, 60):
        process = subprocess.Popen(words)
        while len(_lines(out)) < part:
            assert process.poll() is None
            time.sleep(0.01)
        process.kill()
        process.wait()
    assert subprocess.run(words, check=False).returncode == 0
    assert rows(out) == ran(zoo, tmp_path / "expected")


def _lines(out: Path) -> list[bytes]:
    try:
        return (out / journal.RESULTS).read_bytes().splitlines()
    except FileNotFoundError:
        return []


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_ctrl_c_ends_with_130_and_leaves_the_lines(tmp_path: Path) -> None:
    zoo, out = write(tmp_path / "zoo", 400), tmp_path / "out"
    program = (
        "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "from urdfkit.cli import main; sys.exit(main())"
    )
    words = [sys.executable, "-c", program, "scan", str(zoo), "-o", str(out), "--jobs", "2"]
    process = subprocess.Popen(words)
    while not _lines(out):
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    assert process.wait(30) == 130
    assert 0 < len(rows(out)) < 400


def test_other_options_do_not_mix(tmp_path: Path) -> None:
    zoo, out = write(tmp_path / "zoo", 1), str(tmp_path / "out")
    scan([str(zoo)], out, Settings(Options()))
    with pytest.raises(UnwritableFile, match="other options"):
        scan([str(zoo)], out, Settings(Options(select=("INE",))))


@pytest.mark.skipif(os.name == "nt", reason="no locks")
def test_two_scans_do_not_write_one_directory(tmp_path: Path) -> None:
    with (
        journal.Journal(str(tmp_path), {}),
        pytest.raises(UnwritableFile, match="another scan"),
    ):
        journal.Journal(str(tmp_path), {})


def test_a_wrong_option_stops_it(tmp_path: Path) -> None:
    with pytest.raises(UrdfkitError, match="NOSUCH"):
        scan([str(tmp_path)], str(tmp_path / "out"), Settings(Options(select=("NOSUCH",))))


@pytest.mark.parametrize("source", ["empty", "zoo/none*", "none.urdf"])
def test_no_model_is_an_error(
    tmp_path: Path, source: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "empty").mkdir()
    assert main(["scan", str(tmp_path / source), "-o", str(tmp_path / "out")]) == 2
    assert source.rpartition("/")[2] in capsys.readouterr().err


def test_a_damaged_archive_is_a_row_and_the_scan_goes_on(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    zoo, out, archive = write(tmp_path / "zoo", 1), tmp_path / "out", tmp_path / "a.zip"
    archive.write_bytes(b"no archive")
    for _ in range(2):  # the second time nothing is left to check
        assert main(["scan", str(archive), str(zoo), "-o", str(out)]) == 2
        assert f"{archive}: not a readable archive" in capsys.readouterr().err
    found = rows(out)
    assert found.keys() == {str(archive), str(zoo / "0001.urdf")}
    assert found[str(archive)]["status"] == "unreadable"
    assert found[str(zoo / "0001.urdf")]["status"] == "ok"


def test_parquet_has_the_rows(tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    zoo, out = write(tmp_path / "zoo", 4), tmp_path / "out"
    assert main(["scan", str(zoo), "-o", str(out)]) == 0
    known = list(journal.rows(str(out)))
    models = parquet.read_table(out / "models.parquet").to_pylist()
    findings = parquet.read_table(out / "findings.parquet").to_pylist()
    assert findings == [
        {"model": row["model"], **found} for row in known for found in row.pop("findings")
    ]
    assert models == known


def test_dask_gives_the_same_rows_though_a_worker_is_killed(tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    zoo = write(tmp_path / "zoo", 6 * BATCH)
    killed: list[int] = []
    with (
        distributed.LocalCluster(2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):

        def kill_one(done: int, total: int) -> None:
            if not killed:
                killed.extend([*client.run(os.getpid).values()][:1])
                os.kill(killed[0], signal.SIGKILL)

        found = ran(
            zoo,
            tmp_path / "dask",
            engine="dask",
            address=cluster.scheduler_address,
            progress=kill_one,
        )
    assert killed
    assert found == ran(zoo, tmp_path / "local")


def test_a_scheduler_that_does_not_answer(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("distributed")
    dask = pytest.importorskip("dask")
    zoo, out = str(write(tmp_path / "zoo", 1)), str(tmp_path / "out")
    words = ["scan", zoo, "-o", out, "--engine", "dask", "--address", "tcp://127.0.0.1:9"]
    with dask.config.set({"distributed.comm.timeouts.connect": "1s"}):
        assert main(words) == 2
    assert "error: no Dask scheduler at 'tcp://127.0.0.1:9'" in capsys.readouterr().err

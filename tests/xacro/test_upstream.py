"""xacro's own test-suite, with ``urdfkit expand`` in the place of the ``xacro`` command.

The suite is not part of this project. XACRO_SDIST names the directory of xacro's unpacked source
distribution, which ``.ci/run`` downloads.
"""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

SDIST = os.environ.get("XACRO_SDIST", "")
HARNESS = Path(__file__).parent
ROOT = HARNESS.parents[1]

#: These look into the Python module after a failure, where no command can have left anything.
LOOK_INTO_THE_MODULE = {
    "test_broken_include_error_reporting",  # filestack
    "test_error_reporting",  # print_location()
}
#: And this one wants the text "string" for a file that has a name here.
NAMED_OTHERWISE = {"test_print_location"}

STUB = """\
import os
def get_package_share_directory(name):
    return os.path.join(os.environ["AMENT_PREFIX_PATH"], "share", name)
"""


def run_suite(directory: Path, subject: list[str]) -> dict[str, bool]:
    """Run the suite with a command as its subject, in a copy.

    Returns:
        Whether each test passed.
    """
    package = directory / "share" / "xacro"
    shutil.copytree(SDIST, package)
    index = directory / "ros" / "ament_index_python"
    index.mkdir(parents=True)
    (index / "__init__.py").touch()
    (index / "packages.py").write_text(STUB, encoding="utf-8")
    report = directory / "report.xml"
    python_path = (HARNESS, ROOT, directory / "ros")
    environment = {
        **os.environ,
        "AMENT_PREFIX_PATH": str(directory),
        "PYTHONPATH": os.pathsep.join(map(str, python_path)),
        "SUBJECT": shlex.join(subject),
    }
    options = ["-p", "xacro_harness", "-c", os.devnull, "-n", "2", f"--junitxml={report}"]
    done = subprocess.run(
        [sys.executable, "-m", "pytest", *options, "test_xacro.py"],
        cwd=package / "test",
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode in (0, 1), done.stdout + done.stderr
    cases = ElementTree.parse(report).iter("testcase")
    return {
        f"{case.get('classname', '').rpartition('.')[2]}.{case.get('name')}": len(case) == 0
        for case in cases
    }


@pytest.mark.skipif(not SDIST, reason="XACRO_SDIST does not name xacro's unpacked sdist")
def test_it_passes_what_the_xacro_command_passes(tmp_path: Path) -> None:
    command = [sys.executable, "-c", "import xacro; xacro.main()"]
    stock = run_suite(tmp_path / "stock", command)
    ours = run_suite(tmp_path / "ours", [sys.executable, "-m", "urdfkit", "expand"])
    failing = {name.partition(".")[2] for name, passed in ours.items() if not passed}
    assert failing == LOOK_INTO_THE_MODULE | NAMED_OTHERWISE
    assert ours == stock
    assert len(ours) == 145

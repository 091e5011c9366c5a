"""What ``import urdfkit`` promises."""

import inspect
import re
import subprocess
import sys

import pytest

import urdfkit
from tests.conftest import GRIPPER, ROOT

#: What other programs rely on. A name that goes, or changes its meaning, breaks them: say so in
#: CHANGELOG.md, and think twice before adding one.
NAMES = """
Call Comparison Confidence Diagnostic Dynamics Edit Fix Fixes Formatted Options Related Report
RobotModel
Rule Severity Source Span Context Tolerances UnreadableRobot UrdfkitError Xacro all_rules bundle
check collisions compare convert expand find_rule fix format_files frames load mass_properties pose
read report simulate stand statics summarise to_yourdfpy transform
""".split()

SIGNATURES = {
    "all_rules": [],
    "check": "files arguments packages select ignore targets trust config options".split(),
    "expand": "file arguments packages trust".split(),
    "find_rule": ["word"],
    "fix": (
        "files unsafe force generate_meshes arguments packages select ignore targets trust config "
        "options"
    ).split(),
    "format_files": "files width force check config".split(),
    "load": "file arguments packages trust".split(),
    "read": "file arguments packages trust cache progress".split(),
}


def test_the_public_names_are_these() -> None:
    assert sorted(NAMES) == urdfkit.__all__


@pytest.mark.parametrize("name", SIGNATURES)
def test_the_parameters_are_these(name: str) -> None:
    parameters = inspect.signature(getattr(urdfkit, name)).parameters.values()
    assert [parameter.name for parameter in parameters] == SIGNATURES[name]
    assert [p.name for p in parameters if p.kind is p.POSITIONAL_OR_KEYWORD] == (
        [p for p in SIGNATURES[name] if p in ("file", "word")]
    )


def test_every_public_name_is_there_and_nothing_else_is_promised() -> None:
    homes = " ".join(urdfkit._HOMES.values()).split()
    assert sorted(homes) == sorted(urdfkit.__all__) == urdfkit.__all__
    for name in urdfkit.__all__:
        if name in ("Dynamics", "statics"):
            pytest.importorskip("pinocchio")
        value = getattr(urdfkit, name)
        assert value.__name__ == name
        assert value.__doc__
    assert set(urdfkit.__all__) <= set(dir(urdfkit))


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="module 'urdfkit' has no attribute 'no_such_name'"):
        urdfkit.no_such_name  # noqa: B018


def test_the_version_is_a_version() -> None:
    assert re.fullmatch(r"\d+\.\d+\.\d+(\.dev\d+|rc\d+)?", urdfkit.__version__)


def test_importing_it_imports_nothing_else() -> None:
    program = (
        "import sys; before = set(sys.modules); import urdfkit;"
        "print(*sorted(set(sys.modules) - before))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], cwd=ROOT, capture_output=True, check=True, text=True
    )
    assert done.stdout.split() == ["__future__", "urdfkit"]


def test_the_example_of_the_docstring() -> None:
    report = urdfkit.check(GRIPPER, arguments={"prefix": "left_"})
    assert isinstance(report, urdfkit.Report)
    assert [d for d in report.diagnostics if d.severity is not urdfkit.Severity.INFO] == []
    assert report.ok


def test_a_rule_is_found_by_its_code() -> None:
    assert urdfkit.find_rule("xml001") in urdfkit.all_rules()

"""Rules of other packages: installed ones, modules, and those that cannot be used."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.workspaces import add_file
from urdfkit.errors import RuleError
from urdfkit.lint import rule_index, rule_packages

OWN_RULE = ROOT / "examples" / "own_rule"

ROBOT = """\
<robot name="r">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <limit lower="-1" upper="1" effort="40" velocity="6"/>
  </joint>
</robot>
"""
FOUND = "r.urdf:7:55: warning ACM001 joint 'shoulder': 6 rad/s is over 3.14 rad/s"


class Place:
    """A project with a robot, and a directory from which Python imports."""

    def __init__(self, directory: Path) -> None:
        self.project = directory / "project"
        self.site = directory / "site"
        self.project.mkdir()
        self.site.mkdir()
        self.write("r.urdf", ROBOT)

    def write(self, name: str, text: str) -> None:
        add_file(self.project / name, text)

    def install(self, name: str = "acme", code: str = "") -> None:
        """What pip leaves behind of the example package."""
        shutil.copytree(OWN_RULE / "acme_rules", self.site / "acme_rules", dirs_exist_ok=True)
        if code:
            (self.site / "acme_rules" / "acm001_joint_too_fast.py").write_text(code)
        info = self.site / "acme_rules-1.0.0.dist-info"
        info.mkdir()
        (info / "METADATA").write_text("Metadata-Version: 2.1\nName: acme-rules\nVersion: 1.0.0\n")
        (info / "entry_points.txt").write_text(f"[urdfkit.lint.rules]\n{name} = acme_rules\n")

    def run(self, *words: str) -> subprocess.CompletedProcess[str]:
        """A command line in the project, as an installed urdfkit runs it.

        Unlike ``python -m urdfkit``, it does not import what lies in the current directory.
        """
        program = "import sys; from urdfkit.cli import main; sys.exit(main())"
        safe = ["-P"] if sys.version_info >= (3, 11) else []
        command = [sys.executable, *safe, "-c", program, *words]
        environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(self.site)])}
        return subprocess.run(
            command, check=False, cwd=self.project, env=environment, capture_output=True, text=True
        )

    def check(self, *words: str) -> tuple[int, str]:
        """The exit code and all that is printed."""
        done = self.run("check", "r.urdf", *words)
        assert "Traceback" not in done.stderr
        return done.returncode, done.stdout + done.stderr


@pytest.fixture
def place(tmp_path: Path) -> Place:
    return Place(tmp_path)


def test_an_installed_package_runs_where_it_is_named_and_only_there(place: Place) -> None:
    place.install()
    assert "ACM001" not in place.check()[1]
    code, text = place.check("--rules", "acme")
    assert code == 1
    assert FOUND in text
    place.write("urdfkit.toml", 'rule-packages = ["acme"]')
    code, text = place.check()
    assert code == 1
    assert FOUND in text


def test_its_rules_are_chosen_and_weighed_like_others(place: Place) -> None:
    place.install()
    place.write(
        "urdfkit.toml",
        'rule-packages = ["acme"]\nignore = ["REF"]\n[severity]\njoint-too-fast = "error"\n'
        '[[per-file-ignores]]\nfiles = ["old/*"]\ncodes = ["ACM"]\n',
    )
    assert "error ACM001" in place.check("--select", "ACM")[1]
    assert "ACM001" not in place.check("--ignore", "acm001")[1]
    place.write(
        "r.urdf", ROBOT.replace("<joint", "<!-- urdfkit: ignore[ACM001] new drive --><joint")
    )
    code, text = place.check("--select", "ACM,CFG")
    assert (code, text) == (0, "no findings in 1 file (1 finding suppressed)\n")


def test_every_format_knows_it(place: Place) -> None:
    place.install()
    for name in ("json", "sarif", "junit", "github", "gitlab", "statistics"):
        done = place.run("check", "r.urdf", "--rules", "acme", "--format", name)
        assert (done.returncode, done.stderr) == (1, "")
        assert "ACM001" in done.stdout
    run = json.loads(place.run("check", "r.urdf", "--rules", "acme", "--format", "sarif").stdout)
    (rule,) = [r for r in run["runs"][0]["tool"]["driver"]["rules"] if r["id"] == "ACM001"]
    assert rule["name"] == "JointTooFast"
    assert rule["shortDescription"]["text"] == "A joint is faster than the drives of our arms."


def test_installed_rules_are_listed_and_explained(place: Place) -> None:
    place.install()
    assert place.run("rules").stdout.splitlines()[-1].startswith("ACM001  warning  fix  joint-too-")
    for word in ("ACM001", "joint-too-fast"):
        done = place.run("explain", word)
        assert done.stdout.startswith("ACM001 joint-too-fast (warning, with a fix)\n\nA joint is")
    assert place.run("explain", "ACM002").returncode == 2


def test_several_processes_know_it(place: Place) -> None:
    place.install()
    place.write("s.urdf", ROBOT)
    one = place.run("check", "r.urdf", "s.urdf", "--rules", "acme")
    two = place.run("check", "r.urdf", "s.urdf", "--rules", "acme", "--jobs", "2")
    assert one.stdout.count("ACM001 joint 'shoulder'") == 2
    assert (two.returncode, two.stdout) == (one.returncode, one.stdout)


@pytest.mark.parametrize("name", ["acme_rules", "acme_rules.acm001_joint_too_fast"])
def test_a_module_may_be_named_by_hand(place: Place, name: str) -> None:
    shutil.copytree(OWN_RULE / "acme_rules", place.project / "acme_rules")
    code, text = place.check("--rules", name)
    assert code == 1
    assert FOUND in text
    assert place.run("explain", "ACM001", "--rules", name).returncode == 0
    assert "ACM001" in place.run("rules", "--rules", name).stdout


def test_a_module_in_a_configuration_that_was_found_is_not_imported(place: Place) -> None:
    place.write("evil/__init__.py", "raise SystemExit('it ran')")
    place.write("evil/abc123_x.py", "raise SystemExit('it ran')")
    place.write("urdfkit.toml", 'rule-packages = ["evil"]')
    code, text = place.check()
    assert code == 2
    assert text == (
        "error: urdfkit.toml:1: 'rule-packages': no rule package is installed as 'evil'; "
        "importing a module runs its code: pass --trust or --config FILE\n"
    )


@pytest.mark.parametrize("words", [["--trust"], ["--config", "urdfkit.toml"]])
def test_a_module_beside_the_configuration_runs_where_that_is_trusted(
    place: Place, words: list[str]
) -> None:
    shutil.copytree(OWN_RULE / "acme_rules", place.project / "acme_rules")
    place.write("urdfkit.toml", 'rule-packages = ["acme_rules"]\nselect = ["ACM"]')
    assert FOUND in place.check(*words)[1]


@pytest.mark.parametrize(
    ("files", "name", "message"),
    [
        ({}, "acme", "no rule package 'acme', neither installed nor as a module"),
        ({"a/__init__.py": ""}, "a", "'a': no module named abc123_some_defect in it"),
        ({"a/__init__.py": "1/0", "a/b/__init__.py": ""}, "a.b", "'a.b': ZeroDivisionError"),
        ({}, "..", "rule package '..': "),
        ({"ine900_mine.py": ""}, "ine900_mine", "the prefix INE is reserved by urdfkit"),
        ({"acm001_x.py": ""}, "acm001_x", "must define a function 'check' with @rule(...)"),
        ({"acm001_x.py": "1/0"}, "acm001_x", "acm001_x: ZeroDivisionError: division by zero"),
        (
            {"acm001_x.py": "check = 1"},
            "acm001_x",
            "must define a function 'check' with @rule(...)",
        ),
        (
            {"a/acm001_x.py": "", "a/__init__.py": "", "b/acm001_y.py": "", "b/__init__.py": ""},
            "a,b",
            "b.acm001_y: the code ACM001 is taken by a.acm001_x",
        ),
    ],
)
def test_what_cannot_be_used_is_an_error_that_names_it(
    place: Place, files: dict[str, str], name: str, message: str
) -> None:
    for file, text in files.items():
        place.write(file, text)
    code, text = place.check("--rules", name)
    assert code == 2
    assert message in text
    assert text.startswith("error: ")


def test_a_typo_in_the_name_is_reported_with_the_nearest(place: Place) -> None:
    place.install()
    assert (
        "'acne', neither installed nor as a module; did you mean 'acme'?"
        in place.check("--rules", "acne")[1]
    )


def test_a_rule_that_fails_is_reported_as_its_own_bug(place: Place) -> None:
    source = (OWN_RULE / "acme_rules" / "acm001_joint_too_fast.py").read_text()
    place.install(
        code=source.replace("for joint in context", "raise ValueError\n    for joint in context")
    )
    code, text = place.check("--rules", "acme", "--select", "ACM")
    assert code == 3
    assert "ACM001 failed with ValueError: . This is a bug in that rule, not in the robot" in (
        " ".join(text.split())
    )


def test_the_letters_of_all_rules_are_kept_for_urdfkit() -> None:
    assert {code[:3] for code in rule_index.codes()} <= rule_index.FAMILIES.keys()


def test_a_check_without_them_looks_nothing_up() -> None:
    program = (
        "import sys; from urdfkit.cli import main; main(['check', sys.argv[1]]);"
        "assert not {'importlib.metadata', 'urdfkit.lint.rule_packages'} & set(sys.modules)"
    )
    robot = ROOT / "models" / "good" / "gripper.urdf"
    subprocess.run([sys.executable, "-c", program, str(robot)], cwd=ROOT, check=True)


def test_in_the_library_they_run_where_they_are_asked_for() -> None:
    program = """
import sys
import urdfkit
from urdfkit.text.source import Source

robot = Source("r.urdf", sys.argv[1].encode())
own = urdfkit.check(robot, options=urdfkit.Options(rules=["acme_rules"]))
assert "ACM001" in own.rules
assert "ACM001" not in urdfkit.check(robot).rules  # although it is known by now
assert "ACM001" in urdfkit.check(robot, select=["ACM"]).rules
"""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), str(OWN_RULE)])}
    subprocess.run([sys.executable, "-c", program, ROBOT], env=environment, check=True)


def test_the_tests_of_the_example_pass(tmp_path: Path) -> None:
    directory = tmp_path / "own_rule"
    shutil.copytree(OWN_RULE, directory, ignore=shutil.ignore_patterns(".*", "__pycache__"))
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"],
        check=False,
        cwd=directory,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "3 passed" in done.stdout


def test_unknown_names_are_reported_in_the_library() -> None:
    with pytest.raises(RuleError, match="no rule package is installed as 'nothing_such'"):
        rule_packages.add(["nothing_such"], modules=False)

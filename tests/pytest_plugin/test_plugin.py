"""The plugin among others: what it lists, loads and costs; and the example of the project."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from tests.conftest import ROOT
from tests.pytest_plugin.projects import PLUGIN, Project, outcome

pytest_plugins = ["pytester"]


def test_the_marker_is_listed(project: Project) -> None:
    text = project.run("--markers").stdout.str()
    assert "@pytest.mark.urdf(path, args={}, variant='', variants={}): the model of" in text
    outcome(
        project.test(
            "@pytest.mark.urdf('urdf/arm.urdf.xacro')\ndef test_it(urdf_report): pass",
            "--strict-markers",
        ),
        passed=1,
    )


def test_the_settings_and_fixtures_are_listed(project: Project) -> None:
    assert "urdf_files (args):" in project.run("--help").stdout.str()
    text = project.run("--fixtures").stdout.str()
    fixtures = "urdf robot_model robot_dynamics robot_meshes urdf_report check_urdf".split()
    for fixture in fixtures:
        assert f"\n{fixture} -- " in text


def test_it_imports_only_pytest_until_it_is_used(project: Project) -> None:
    project.write(
        "test_it.py",
        "import sys\n"
        "def test_it():\n"
        "    ours = {name for name in sys.modules if name.partition('.')[0] == 'urdfkit'}\n"
        "    assert ours == {'urdfkit', 'urdfkit.pytest_plugin'}\n"
        "    assert not {'xacro', 'lxml', 'yaml', 'click', 'numpy'} & set(sys.modules)\n",
    )
    outcome(project.run_process(), passed=1)


def test_the_example_is_green_as_a_user_runs_it(tmp_path: Path) -> None:
    directory = tmp_path / "robot_tests"
    shutil.copytree(
        ROOT / "examples" / "robot_tests",
        directory,
        ignore=shutil.ignore_patterns(".*", "__pycache__"),
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}

    def run(*words: str) -> str:
        done = subprocess.run(
            [sys.executable, "-m", *words],
            check=False,
            cwd=directory,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    assert "8 passed" in run("pytest", *PLUGIN, "-p", "no:cacheprovider")
    assert run("urdfkit", "check", ".").startswith("no findings in 1 file")

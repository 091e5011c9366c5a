"""The configuration: what it says, and what it does not let pass."""

import re
from pathlib import Path

import pytest

from urdfkit import check
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config, ConfigError, RobotEntry, matches
from urdfkit.lint.config_reader import load
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Severity

ROBOT = """<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed">
    <parent link="a"/>
    <child link="b"/>
    <axis xyz="1 0 0"/>
  </joint>
</robot>
"""
ARGUED = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default=""/>
  <link name="$(arg side)_base"/>
</robot>
"""


def write(directory: Path, text: str, name: str = "urdfkit.toml") -> str:
    path = directory / name
    path.write_text(text)
    return str(path)


@pytest.fixture
def renamed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rule_index, "_redirects", {"TRE999": "JNT020", "TRE998": ""})


@pytest.mark.usefixtures("renamed")
def test_former_codes_work_and_are_noted(tmp_path: Path) -> None:
    text = 'select = ["TRE999"]\nignore = ["TRE998"]\n[severity]\nTRE999 = "error"\n'
    text += '[[per-file-ignores]]\nfiles = ["x"]\ncodes = ["TRE999"]\n'
    config = load(write(tmp_path, text))
    assert config.select == config.named == config.file_ignores[0].but_errors == {"JNT020"}
    assert config.severities == {"JNT020": Severity.ERROR}
    assert [warning.partition(": ")[2] for warning in config.warnings] == [
        "'select': TRE999 is now JNT020",
        "'ignore': no rule 'TRE998': it was removed",
        "'severity': TRE999 is now JNT020",
        "per-file-ignores[1]: 'codes': TRE999 is now JNT020, whose errors it does not ignore",
    ]


def test_a_former_code_lowers_no_severity(tmp_path: Path) -> None:
    """JNT021, an info, was merged into JNT002, an error."""
    config = load(write(tmp_path, '[severity]\nJNT021 = "info"\n'))
    assert config.severities == {}
    assert len(config.warnings) == 1


def test_options_of_rules(tmp_path: Path) -> None:
    text = "[rules.dense-collision-mesh]\nvisual-triangles = 50\n[rules.INE014]\nratio = 200\n"
    options = load(write(tmp_path, text)).options
    triangles = {"triangles": 20_000, "shared-triangles": 5_000, "visual-triangles": 50}
    assert options == {"MSH019": triangles, "INE014": {"ratio": 200.0}}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("MSH019.triangle = 5", "rules.MSH019: unknown option 'triangle'; did you mean"),
        ("MSH019.triangles = 5.5", "'triangles' must be a whole number from 0, not 5.5"),
        ("MSH019.triangles = true", "'triangles' must be a whole number from 0, not True"),
        ("INE014.ratio = -1", "'ratio' must be a number from 0, not -1"),
        ("INE014.ratio = inf", "'ratio' must be a number from 0, not inf"),
        ('INE014.ratio = "1"', "'ratio' must be a number from 0, not '1'"),
        ("INE014 = 5", "'rules.INE014' must be a table of options, not 5"),
        ("XML001.ratio = 1", "unknown option 'ratio'"),
        ("INE914.ratio = 1", "no rule 'INE914'"),
    ],
)
def test_a_wrong_option(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(ConfigError) as error:
        load(write(tmp_path, f"[rules]\n{text}\n"))
    assert message in str(error.value)


def test_packages_of_rules_are_another_setting(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="did you mean 'rule-packages'"):
        load(write(tmp_path, 'rules = ["acme"]'))


def test_an_option_changes_what_is_found(tmp_path: Path) -> None:
    link = (
        '<link name="{}"><inertial><mass value="{}"/>'
        '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    )
    joint = '<joint name="{1}" type="continuous"><parent link="{0}"/><child link="{1}"/></joint>'
    parts = [link.format("a", 1), link.format("b", 1), link.format("c", 500)]
    parts += [joint.format("a", "b"), joint.format("b", "c")]
    robot = write(tmp_path, f'<robot name="r">{"".join(parts)}</robot>', "r.urdf")

    def found(config: Config | None) -> int:
        return len(check(robot, select=["INE014"], config=config).diagnostics)

    assert found(None) == 0
    assert found(Config(options={"INE014": {"ratio": 499.0}})) == 1
    assert found(Config(options={"INE014": {"ratio": 500.0}})) == 0


def test_everything_that_can_be_set(tmp_path):
    (tmp_path / "arm").mkdir()
    (tmp_path / "r.urdf").write_text(ROBOT)
    config = load(
        write(
            tmp_path,
            """
            select = ["JNT", "TRE001"]
            ignore = ["ignored-axis-or-limit"]
            fail-on = "error"
            targets = ["gz-harmonic", "ros2"]
            exclude = ["old"]
            trust = true
            [packages]
            arm_description = "arm"
            [arguments]
            sim = true
            scale = 0.5
            [severity]
            TRE001 = "info"
            [[per-file-ignores]]
            files = ["old/*"]
            codes = ["TRE"]
            reason = "from CAD"
            [[robot]]
            file = "r.urdf"
            arguments = { a = "x" }
            variants = { left = { b = 1 }, right = { b = 2 } }
            """,
        )
    )
    assert {"JNT020", "TRE001"} <= config.select
    assert config.ignore == {"JNT020"}
    assert config.fail_on is Severity.ERROR
    assert config.targets == ("ros2", "gz-harmonic")
    assert config.packages == {"arm_description": str(tmp_path / "arm")}
    assert config.arguments == {"sim": "true", "scale": "0.5"}
    assert config.severities == {"TRE001": Severity.INFO}
    assert config.ignores("TRE003", str(tmp_path / "old" / "x.urdf"), Severity.ERROR)
    assert not config.ignores("TRE003", str(tmp_path / "new.urdf"), Severity.ERROR)
    assert not config.ignores("JNT001", str(tmp_path / "old" / "x.urdf"), Severity.ERROR)
    file = str(tmp_path / "r.urdf")
    assert config.robots == (
        RobotEntry(file, "left", {"a": "x", "b": "1"}),
        RobotEntry(file, "right", {"a": "x", "b": "2"}),
    )
    assert config.trust


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("selct = []", ["unknown setting 'selct'", "'select'"]),
        ('select = ["XYZ"]', ["'select'", "XYZ"]),
        ('fail-on = "fatal"', ["'fail-on'", "error, warning, info"]),
        ('targets = ["gazebo"]', ["unknown target 'gazebo'"]),
        ('[packages]\na = "nowhere"', ["'packages.a'", "nowhere"]),
        ('[severity]\nTRE001 = "bad"', ["severity.TRE001"]),
        ("[arguments]\na = []", ["'arguments.a'"]),
        ('[[robot]]\nfile = "nowhere.urdf"', ["robot[1]", "nowhere.urdf"]),
        ('[[robot]]\nfle = "r.urdf"', ["robot[1]: unknown setting 'fle'; did you mean 'file'?"]),
        ("[[robot]]\narguments.a = 1", ["robot[1]: it needs 'file'"]),
        ('ignore = "MSH"', ["must be a list, not 'MSH'; write [\"MSH\"]"]),
        ("[[per-file-ignores]]\nfiles = ['a']", ["per-file-ignores[1]", "'codes'"]),
        ("trust = 1", ["'trust'", "true or false"]),
        ("xacro-seconds = 0", ["'xacro-seconds'", "from 1"]),
        ("xacro-megabytes = true", ["'xacro-megabytes'", "from 1"]),
        ("[per-file-ignores]\n'vendor/*' = ['URD']", ["written [[per-file-ignores]]"]),
        ("a = ", ["not TOML"]),
    ],
)
def test_a_typo_is_an_error_that_names_file_setting_and_fix(tmp_path, text, words):
    path = write(tmp_path, text)
    with pytest.raises(ConfigError) as error:
        load(path)
    for word in [path, *words]:
        assert word in str(error.value)


def test_an_unknown_rule_that_is_left_out_is_a_warning(tmp_path):
    path = write(
        tmp_path,
        'ignore = ["JNT020", "XYZ"]\n[[per-file-ignores]]\nfiles = ["*.urdf"]\ncodes = ["NEW001"]',
    )
    config = load(path)
    assert config.ignore == {"JNT020"}
    first, second = config.warnings
    assert first.startswith(f"{path}:1: 'ignore': no rule 'XYZ'")
    assert second.startswith(f"{path}:4: per-file-ignores[1]: 'codes': no rule 'NEW001'")


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("a = " + 5000 * "[", "urdfkit.toml"),
        ("width = " + 5000 * "1", "urdfkit.toml"),
        ("a = '\0'", "urdfkit.toml"),
        ("tool = 3  # [tool.urdfkit]", "pyproject.toml"),
        ("[tool]\nurdfkit = 3", "pyproject.toml"),
    ],
)
def test_hostile_files_are_an_error(tmp_path, text, name):
    with pytest.raises(ConfigError, match=name):
        load(write(tmp_path, text, name))


def test_severities_and_file_ignores_reach_the_report(tmp_path):
    file = tmp_path / "r.urdf"
    file.write_text(ROBOT)
    select = frozenset({"JNT020"})
    config = Config(select=select, severities={"JNT020": Severity.ERROR})
    (finding,) = check(file, config=config).diagnostics
    assert finding.severity is Severity.ERROR
    config = load(write(tmp_path, '[[per-file-ignores]]\nfiles = ["*.urdf"]\ncodes = ["JNT020"]'))
    report = check(file, config=config._replace(select=select))
    assert report.diagnostics == ()
    assert report.suppressed == 1


def test_all_variants_of_a_robot_are_checked(tmp_path):
    file = tmp_path / "r.xacro"
    file.write_text(ARGUED)
    config = load(
        write(
            tmp_path,
            '[[robot]]\nfile = "r.xacro"\nvariants = { a = {side = "l"}, b = {side = "r"} }',
        )
    )
    seen: list[tuple[int, int]] = []
    check(
        file,
        config=config,
        options=Options(progress=lambda done, total: seen.append((done, total))),
    )
    assert seen == [(1, 2), (2, 2)]
    seen.clear()
    check(
        file,
        config=config,
        arguments={"side": "x"},
        options=Options(progress=lambda *n: seen.append(n)),
    )
    assert seen == []  # by hand it is one robot, not the variants; one tells of its meshes only


def test_what_is_selected_by_hand_runs_although_the_configuration_ignores_it(tmp_path):
    file = tmp_path / "r.urdf"
    file.write_text(ROBOT)
    config = Config(ignore=frozenset({"JNT020"}))
    assert "JNT020" not in check(file, config=config).rules
    assert len(check(file, config=config, select=["JNT020"]).diagnostics) == 1


@pytest.mark.parametrize(
    ("path", "pattern", "expected"),
    [
        ("a/b.urdf", "*.urdf", True),
        ("a/b.urdf", "a", True),
        ("a/b.urdf", "a/", True),
        ("ab/b.urdf", "a", False),
        ("a/b.urdf", "a/*.xacro", False),
        ("a/b.urdf", "./a", True),
        ("a/b.urdf", "**/a/**", True),
        ("c/a/b.urdf", "**/a/**", True),
        ("a/b.urdf", "a/**/b.urdf", True),
        ("ca/b.urdf", "**/a/**", False),
    ],
)
def test_patterns(path, pattern, expected):
    assert matches(path, (pattern,)) is expected


def test_a_byte_order_mark_is_no_setting(tmp_path):
    """PowerShell writes one."""
    (tmp_path / "urdfkit.toml").write_bytes(b"\xef\xbb\xbfpreview = true\n")
    assert load(str(tmp_path / "urdfkit.toml")).preview


def test_limits_of_an_expansion_are_raised_by_the_user_alone(tmp_path):
    path = write(tmp_path, "xacro-seconds = 2\nxacro-megabytes = 100")
    assert load(path, trusted=False).limits == (2, 100)
    path = write(tmp_path, "xacro-seconds = 60")
    assert load(path).limits == (60, 512)
    with pytest.raises(ConfigError, match="'xacro-seconds' above 5 must be confirmed"):
        load(path, trusted=False)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ('# c\n\nignore = [\n  "X",\n  1,\n]', ":3: 'ignore'"),
        ('# targets = ["a"]\ntargets = ["gazebo"]', ":2: 'targets': unknown target 'gazebo'"),
        ('ignore = ["MSH"]\nselct = []', ":2: unknown setting 'selct'"),
        ('[severity]\nTRE002 = "info"\n"TRE001" = "bad"', ":3: 'severity.TRE001'"),
        ("[rules.MSH019]\nmost = 1", ":2: rules.MSH019: unknown option"),
        ('[[robot]]\nfile = "r.urdf"\n[[robot]]\nfil = "r.urdf"', ":4: robot[2]: unknown setting"),
        ("[[robot]]\nfile = 'r.urdf'\n[[robot]]\narguments.a = 1", ":3: robot[2]: it needs 'file'"),
        ("robot = [{file = 'r.urdf', arguments = {a = []}}]", ":1: robot[1]: 'arguments.a' must"),
        ("'ignore' = 1", ":1: 'ignore'"),
    ],
)
def test_an_error_names_its_line(tmp_path: Path, text: str, line: str) -> None:
    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    with pytest.raises(ConfigError, match=re.escape(f"urdfkit.toml{line}")):
        load(write(tmp_path, text))
    shared = tmp_path / "pyproject.toml"
    inside = re.sub(r"^(\[+)", r"\1tool.urdfkit.", text, flags=re.MULTILINE)
    other = "[tool.ruff]\nignore = []\n[tool.urdfkit]\n"
    shared.write_text(other + inside)
    number = int(line.split(":")[1]) + 3
    with pytest.raises(ConfigError, match=rf"pyproject.toml:{number}: "):
        load(str(shared))


def test_a_link_out_of_the_repository_is_not_read(tmp_path: Path) -> None:
    secret = write(tmp_path, "ignore = ['GEO002']", "secret.toml")
    repository = tmp_path / "repository"
    (repository / "robot").mkdir(parents=True)
    (repository / ".git").mkdir()
    shared = write(repository, "ignore = ['INE004']", "shared.toml")
    link = repository / "robot" / "urdfkit.toml"
    link.symlink_to(shared)
    assert load(str(link), trusted=False).ignore == load(shared).ignore
    link.unlink()
    link.symlink_to(secret)
    with pytest.raises(ConfigError, match="outside of the repository"):
        load(str(link), trusted=False)
    assert load(str(link)).ignore == load(secret).ignore

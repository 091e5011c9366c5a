"""Projects with robots and tests, in which pytest runs."""

from importlib.metadata import entry_points

import pytest

from tests.workspaces import add_file

#: An installed urdfkit brings its plugin along; a checkout has to name it.
PLUGIN = (
    []
    if any(point.name == "urdfkit" for point in entry_points(group="pytest11"))
    else ["-p", "urdfkit.pytest_plugin"]
)

ARM = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:arg name="joints" default="1"/>
  <link name="$(arg side)_base"/>
  <link name="$(arg side)_tip"/>
  <xacro:if value="${$(arg joints) == 1}">
    <joint name="$(arg side)_joint" type="revolute">
      <parent link="$(arg side)_base"/>
      <child link="$(arg side)_tip"/>
      <axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="10" velocity="1"/>
    </joint>
  </xacro:if>
  <xacro:unless value="${$(arg joints) == 1}">
    <joint name="$(arg side)_joint" type="fixed">
      <parent link="$(arg side)_base"/>
      <child link="$(arg side)_tip"/>
    </joint>
  </xacro:unless>
</robot>
"""

BROKEN = """\
<robot name="broken">
  <link name="a"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
</robot>
"""

#: What the robots above are about; rules about bodies without mass are not.
SETTINGS = 'select = ["XML", "XAC", "URD", "REF", "TRE"]\n'


class Project:
    """A directory with models and tests in which pytest runs."""

    def __init__(self, pytester: pytest.Pytester) -> None:
        self.pytester = pytester
        self.directory = pytester.path
        self.write("urdfkit.toml", SETTINGS)
        self.write("urdf/arm.urdf.xacro", ARM)
        self.write("urdf/broken.urdf", BROKEN)

    def write(self, name: str, text: str) -> None:
        add_file(self.directory / name, text)

    def run(self, *words: str) -> pytest.RunResult:
        """A run in this process, which has imported what it needs already."""
        return self.pytester.runpytest_inprocess(*PLUGIN, *words)

    def run_process(self, *words: str) -> pytest.RunResult:
        """A run in a process of its own."""
        return self.pytester.runpytest_subprocess(*PLUGIN, *words)

    def write_test(self, text: str) -> None:
        self.write("test_it.py", f"import pytest\nfrom urdfkit.testing import *\n\n{text}\n")

    def test(self, text: str, *words: str) -> pytest.RunResult:
        """The outcome of a test module."""
        self.write_test(text)
        return self.run("-v", *words)


def outcome(result: pytest.RunResult, **counts: int) -> str:
    """All that was printed, of a run with these outcomes and no others."""
    assert result.parseoutcomes() == counts, result.stdout.str() + result.stderr.str()
    return result.stdout.str()

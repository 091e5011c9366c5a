from tests.reported import reported
from urdfkit.text.diagnostic import Severity

ROBOT = """\
<link name="a"/>
<link name="b"/>
<joint name="{}" type="continuous">
  <parent link="a"/>
  <child link="b"/>
</joint>"""


def test_the_joint_is_the_place_and_the_link_is_shown() -> None:
    (found,) = reported("NAM003", ROBOT.format("b"))
    assert (found.span.line, found.span.text) == (4, "b")
    assert [one.span.text for one in found.related] == ['<link name="b"/>']
    assert found.severity is Severity.INFO
    assert reported("NAM003", ROBOT.format("ab")) == []


def test_gz_sim_refuses_the_model() -> None:
    report = reported("NAM003", ROBOT.format("b"), targets=("gz-harmonic",))
    assert [found.severity for found in report] == [Severity.ERROR]

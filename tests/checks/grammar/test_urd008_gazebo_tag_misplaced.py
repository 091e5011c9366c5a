import json

import pytest

from tests.conftest import MISSION, SHARED
from tests.naming import naming
from tests.reported import places, reported
from urdfkit.lint import engine
from urdfkit.text.schema import GAZEBO_TAGS


@pytest.mark.parametrize(
    ("robot", "block"),
    [
        ('<link name="wheel"><mu1>1</mu1></link>', naming("into", '<gazebo reference="wheel">')),
        (
            (
                '<link name="a"><collision><surface/><geometry><sphere radius="1"/></geometry>'
                "</collision></link>"
            ),
            naming("<collision>", '<gazebo reference="a">'),
        ),
        (
            (
                '<link name="a"/><joint name="j" type="fixed"><preserveFixedJoint>true'
                "</preserveFixedJoint></joint>"
            ),
            naming("into", '<gazebo reference="j">'),
        ),
        (
            '<link name="a"/><plugin name="p" filename="libgazebo_ros_imu.so"/>',
            naming("<gazebo>", "block"),
        ),
    ],
)
def test_the_block_it_belongs_in_is_named(robot: str, block: str) -> None:
    (found,) = reported("URD008", robot)
    assert found.help == block


def test_the_eight_of_the_mission_s_model() -> None:
    report = engine.check(MISSION, select=["URD008"])
    assert [found.span.text for found in report.diagnostics] == ["<mu1>", "<mu2>"] * 4
    assert [found.message.partition(":")[0] for found in report.diagnostics] == [
        f"link 'wheel_{number}'" for number in (1, 1, 2, 2, 3, 3, 4, 4)
    ]


def test_in_its_block_nothing_is_said() -> None:
    tags = "".join(f"<{tag}/>" for tag in sorted(GAZEBO_TAGS))
    assert places("URD008", f'<link name="a"/><gazebo reference="a">{tags}</gazebo>') == []


def test_every_tag_that_the_converter_handles_is_known() -> None:
    catalog = SHARED / "catalog" / "gazebo_extensions.json"
    if not catalog.is_file():
        pytest.skip("the catalogue of Gazebo's tags is not beside this checkout")
    handled = {row["tag"] for row in json.loads(catalog.read_text("utf-8"))["handled_tags"]}
    assert handled - GAZEBO_TAGS == {"material", "collision", "visual"}  # those of URDF


def test_the_pose_of_sdf_has_its_words_in_urdf() -> None:
    (found,) = reported("URD008", '<link name="a"><pose>0 0 1 0 0 0</pose></link>')
    assert found.help == naming("<origin>", "shape")
    assert found.fix is None


ROBOT = """<link name="a">{link}
<collision><geometry><sphere radius="1"/></geometry></collision></link>
<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/>{joint}</joint>"""


#: Tags of SDF, and those of the converter for them.
_INSTEAD = {"friction": "mu1", "max_contacts": "maxContacts", "laser_retro": "laserRetro"}


@pytest.mark.parametrize("owner", ["link", "joint"])
@pytest.mark.parametrize("tag", sorted(GAZEBO_TAGS - {"pose"}))
def test_the_help_leads_to_a_place_where_gazebo_reads_the_tag(owner: str, tag: str) -> None:
    """ROAR: <surface> in the block of a link is unknown, too; it belongs into its <collision>."""
    element, names = f"<{tag}>1</{tag}>", {"link": "a", "joint": "j"}
    (found,) = reported("URD008", ROBOT.format(**{"link": "", "joint": "", owner: element}))
    if (owner, tag) == ("joint", "friction"):
        assert "<dynamics friction=...>" in found.help
        return
    moved = element
    for name, other in _INSTEAD.items():
        moved = moved.replace(name, other)
    if "<collision>" in found.help:
        moved = f"<collision>{moved}</collision>"
    kind = found.help.rpartition("name of a ")[2] if "name of a " in found.help else owner
    reference = "" if "without" in found.help else f' reference="{names[kind]}"'
    robot = ROBOT.format(link="", joint="") + f"<gazebo{reference}>{moved}</gazebo>"
    assert [*reported("GAZ003", robot), *reported("GAZ005", robot)] == []

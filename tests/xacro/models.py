"""Small xacro models, each for one thing that xacro does."""

from pathlib import Path

#: Files that the models below include and load.
FILES = {
    "part.xacro": """\
<?xml version="1.0"?>
<!-- a part -->
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" xmlns:extra="urn:extra">
  <xacro:property name="length" value="0.3"/>
  <xacro:property name="double" value="${2*length}"/>
  <xacro:macro name="part" params="name size:=${length} *origin **rest">
    <link name="${name}" size="${size}"><xacro:insert_block name="origin"/></link>
    <xacro:insert_block name="rest"/>
    <xacro:inner name="${name}_inner"/>
  </xacro:macro>
  <xacro:macro name="inner" params="name"><link name="${name}" double="${double}"/></xacro:macro>
  <extra:loose/>
</robot>
""",
    "part_two.xacro": """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="two"/>
</robot>
""",
    "nested/outer.xacro": """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="../part.xacro" ns="p"/>
  <xacro:macro name="outer"><xacro:p.inner name="from_outer"/></xacro:macro>
</robot>
""",
    "values.yaml": """\
number: 1.5
text: some words
list: [1, 2, {deep: 3}]
units:
  angle: !degrees 180/2
  turn: !radians pi/2
  height: !millimeters 250
  foot: !foot 1
  inch: !inches 10
  metre: !meters 2
table: {a: {b: {c: 4}}, items: 5}
""",
    "bad.yaml": "a: [1, 2\n",
    "tab_in_text.yaml": "a: |\n  \tb\nc: 2\n",
    "bad_unit.yaml": "a: !degrees 1 +\n",
}


def _read() -> dict[str, str]:
    """The models in ``models.txt``: a line ``== name``, then the text."""
    text = (Path(__file__).parent / "models.txt").read_text(encoding="utf-8")
    sections = ("\n" + text).split("\n== ")[1:]
    return {name: body for name, _, body in (section.partition("\n") for section in sections)}


#: Models by what they show: what stands in the root element, or whole files.
BODIES = {name: text for name, text in _read().items() if not name.startswith("whole: ")}
WHOLE = {name: text for name, text in _read().items() if name.startswith("whole: ")}


def document(body: str) -> str:
    """A model with that body."""
    return f'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{body}</robot>'


def write(directory: Path, text: str | bytes) -> Path:
    """Write a model as ``robot.xacro``, and FILES around it."""
    for name, content in FILES.items():
        file = directory / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(content, encoding="utf-8")
    robot = directory / "robot.xacro"
    robot.write_bytes(text if isinstance(text, bytes) else text.encode())
    return robot

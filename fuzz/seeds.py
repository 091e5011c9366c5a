"""What the harnesses damage: texts and files that are right, and examples of rules."""

import re
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from urdfkit.lint import rule_index
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.lint.rules import Rule

ROOT = Path(__file__).resolve().parents[1]
MODELS = ROOT / "models"
HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'


@lru_cache
def rules() -> list[Rule]:
    return [rule_index.get(code) for code in rule_index.codes()]


def examples(*families: str) -> Iterator[bytes]:
    """The examples of rules whose code begins with one of some words."""
    for rule in rules():
        if rule.code.startswith(families):
            for which in ("BAD", "GOOD"):
                text = rule.example(which)
                if text:
                    yield whole_robot(text).encode("utf-8", "surrogateescape")


def files(*suffixes: str) -> list[bytes]:
    """The files beside the examples of rules, and those of the models."""
    import sys

    found = [
        path.read_bytes() for path in sorted(MODELS.rglob("*")) if path.name.endswith(suffixes)
    ]
    for rule in rules():
        rule.example("BAD")  # which imports it
        beside: Mapping[str, bytes] = getattr(sys.modules[rule.module], "FILES", {})
        found += [data for name, data in beside.items() if name.endswith(suffixes)]
    return list(dict.fromkeys(one for one in found if one and len(one) < 20_000))


def robots() -> list[bytes]:
    plain = [one for one in examples("") if b"<robot" in one and b"xacro:" not in one]
    return [*plain, *files(".urdf")]


def xacros() -> list[bytes]:
    return [*(one for one in examples("") if b"xacro:" in one), *files(".xacro")]


def expressions() -> list[bytes]:
    written = re.findall(rb"\$[{(][^\n\"]*[)}]", b"\n".join(xacros()))
    return [
        *dict.fromkeys(written),
        b"${'%d-%s' % (1, 'a')}",
        b"${[x*2 for x in python.range(3) if x]}",
        b"${dict(a=1)['a'] + sum([1, 2])}",
        b"${'a'.join(sorted(['b', 'c'], key=len)).upper().split('x')}",
        b"${radians(90) if True and not False else max(1, 2) ** 2 // 3 % 4 << 5}",
        b"${'{:>8.3f}{}'.format(pi, 'a')}${str(round(1.5, 1))}",
        b"${python.set([1]) | python.set([2])}${list(map(float, '1 2'.split()))}",
        b"${xacro.load_yaml('a.yaml')['a'][0]}$(eval arg('a') + 1)$(arg a)$(env ROS_DISTRO)",
    ]


def launches() -> list[bytes]:
    return [
        *(one for one in examples("LAU", "GAZ") if b"launch" in one),
        *files(".launch", ".py"),
    ]


def srdfs() -> list[bytes]:
    body = """<group name="arm"><chain base_link="a" tip_link="b"/><joint name="j"/></group>
    <group_state name="up" group="arm"><joint name="j" value="0.5"/></group_state>
    <end_effector name="hand" parent_link="b" group="hand" parent_group="arm"/>
    <virtual_joint name="v" type="fixed" parent_frame="world" child_link="a"/>
    <passive_joint name="j"/><disable_default_collisions link="a"/>
    <disable_collisions link1="a" link2="b" reason="Adjacent"/>"""
    return [f'<robot name="r">{body}</robot>'.encode(), *files(".srdf")]


def manifests() -> list[bytes]:
    return files("package.xml")


def configurations() -> list[bytes]:
    """The settings of the documentation, each by itself."""
    text = (ROOT / "docs" / "configuration.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"(?s)```toml\n(.*?)```", text)
    table = [part.encode() for part in re.split(r"\n(?=\[)", example)]
    return [*table, *table[0].splitlines(), example.encode()]


def meshes(*suffixes: str) -> Callable[[], list[bytes]]:
    def found() -> list[bytes]:
        from urdfkit.mesh import samples
        from urdfkit.mesh.io.load import load_bytes
        from urdfkit.mesh.writers import encode

        box = samples.stl(samples.box((0, 0, 0), (0.1, 0.1, 0.3)))
        mesh = load_bytes(box, "a.stl")
        made = [box] if ".stl" in suffixes else []
        for suffix in set(suffixes) - {".gltf"}:
            made += encode(mesh, f"a{suffix}").values()
        return [*made, *files(*suffixes)]

    return found

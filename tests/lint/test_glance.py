from __future__ import annotations

import re
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.conftest import manifest, model_id, needs_corpus
from urdfkit.lint import glance, rule_examples, rules
from urdfkit.lint.context import Subject
from urdfkit.lint.runner import applicable
from urdfkit.ros.gazebo.silence import about_blocks, about_plugins, about_sensors, about_tags
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

PLAIN = [entry for entry in manifest() if entry[1]["kind"] == "urdf"]


def silent(subject: Subject) -> set[str]:
    if subject.reading.document is None:
        return set()
    codes = glance.silent(subject.model, subject.tree)
    if subject.model.gazebo:
        codes |= about_blocks(subject.model)
        codes |= about_sensors(subject.model, subject.targets)
        codes |= about_plugins(subject.plugins, subject.targets, subject.gazebo)
        codes |= about_tags([found for _, found in subject.unread])
    if not subject.parameters and not glance.names_parameters(subject.model):
        codes |= glance.ABOUT_PARAMETERS
    return codes


def overlooked(subject: Subject) -> list[str]:
    """The codes of rules that were called silent and have something to say."""
    waiting = sorted(silent(subject).intersection(rules.codes()))
    return [code for code in waiting if any(rules.get(code).check(subject))]


def test_a_plain_robot_needs_none_of_these_rules() -> None:
    robot = rule_examples.whole_robot(
        '<link name="base"/><link name="wheel-2"/><joint name="axle" type="continuous">'
        '<parent link="base"/><child link="wheel-2"/><axis xyz="0 1 0"/></joint>'
    )
    subject = Subject(Source("robot.urdf", robot.encode()), Resolver(environment={}))
    others = {"NAM006", "NAM009", "REF003", "TRE008", "TRE009"}
    others |= {"JNT001", "JNT012", "JNT020", "JNT021", "JNT022", "JNT025"}
    others |= {"JNT039", "JNT040", "JNT042", "JNT043", "JNT044"}
    others |= {code for about in glance.ABOUT_CHILDREN.values() for code in about}
    others |= {"GEO002", "GEO003", "GEO007", "GEO009", "GEO010", "GEO011"}
    others |= {"NAM003", "NAM005", "NAM011", *glance.ABOUT_WORDS}
    others |= glance.ABOUT_SIZES | glance.ABOUT_SCALES | glance.ABOUT_PLUGINS | glance.ABOUT_SENSORS
    others |= {"JNT030", "JNT031", "JNT032", "JNT033", "JNT034", "JNT035", "JNT037", "JNT038"}
    others |= {"COL005", "GEO013", "GEO014", "GEO015", "GEO018", "GAZ058"} | glance.ABOUT_STATICS
    others |= glance.ABOUT_COMPONENTS | glance.ABOUT_TRANSMISSIONS
    others |= {code for about in glance.ABOUT_JOINTS for code in about}
    others |= {"TRE007"} | glance.ABOUT_PARAMETERS | set(glance.ABOUT_NAMES)
    assert silent(subject) == glance.ABOUT_TREES | others


@pytest.mark.parametrize("code", rules.codes())
@pytest.mark.parametrize("which", ["BAD", "GOOD"])
def test_no_rule_is_silenced_that_would_speak_of_an_example(code: str, which: str) -> None:
    rule = rules.get(code)
    text = rule.example(which)
    assert text
    with rule_examples.laid_out(rule, text) as source:
        subject = rule_examples.subject_of(rule, source)
        assert overlooked(subject) == []
        assert which == "GOOD" or code not in silent(subject)


_NUMBER = r'(?<=[" >])-?\d+(?:\.\d+)?(?=[" <])'

#: Those that look at more than the model: packages, SRDF files, libraries that are heavy.
_OF_MORE = ("CFG", "COL", "DYN", "LAU", "MSH", "PKG", "SRD", "XAC", "XML")


@pytest.mark.parametrize("seed", range(20))
def test_no_rule_is_left_out_that_would_speak_of_other_numbers(seed: int) -> None:
    """Numbers of the examples are made larger, smaller and negative."""
    codes = [code for code in rules.codes() if not code.startswith(_OF_MORE)]
    random = Random(seed)
    for code in random.sample(codes, 60):
        text = rule_examples.whole_robot(rules.get(code).example("BAD") or "")
        for _ in range(random.randint(1, 3)):
            numbers = list(re.finditer(_NUMBER, text))
            if not numbers:
                continue
            number = random.choice(numbers)
            other = random.choice(("0", "-1", "0.001", "0.5", "1", "4", "45", "90", "1000"))
            text = text[: number.start()] + other + text[number.end() :]
        subject = Subject(Source("robot.urdf", text.encode()), Resolver(environment={}))
        asked = {rule.code for rule in applicable(subject, codes)}
        found = [one for one in codes if one not in asked and any(rules.get(one).check(subject))]
        assert found == [], text


@needs_corpus
@pytest.mark.parametrize("entry", PLAIN, ids=model_id)
def test_no_rule_is_silenced_that_would_speak_of_a_real_robot(
    entry: tuple[Path, dict[str, Any]],
) -> None:
    folder, model = entry
    source = Source.read(folder / model["path"])
    assert overlooked(Subject(source, Resolver(environment={}))) == []

import sys

import pytest

from tests.documents import document as read
from urdfkit.text import schema
from urdfkit.text.grammar import MAX_UNKNOWN, deviations, is_number, version_of


def found(text: str) -> dict[str, int]:
    return {code: len(items) for code, items in deviations(read(text), plain=True).items()}


def test_one_defect_is_one_deviation() -> None:
    link = '<robot name="r"><link name="a">{}</link></robot>'
    assert found(link.format("")) == {}
    assert found(link.format("<visual/>")) == {"URD004": 1}
    assert found(link.format("<visual><geometry/></visual>")) == {"URD004": 1}
    assert found(link.format("<visual><geometry><box/></geometry></visual>")) == {"URD003": 1}
    assert found(link.format("<inertal/>")) == {"URD001": 1}
    assert found(link.format("<inertia/>")) == {"URD001": 1}
    assert found(link.format("<mu1/>")) == {"URD008": 1}
    assert found(link.format("<foo/>")) == {"URD001": 1}
    assert found("<robot><link name='a'/></robot>") == {"URD003": 1}
    assert found("<sdf><link/></sdf>") == {"URD015": 1}


def test_what_is_unknown_or_misplaced_is_not_looked_into() -> None:
    text = '<robot name="r"><foo><link/><joint/></foo><x:y><link/></x:y></robot>'
    assert found(text) == {"URD001": 1}


def test_claimed_tags_are_another_rule_s() -> None:
    document = read('<robot name="r"><arm/><link name="a"><arm/><leg/></link></robot>')
    (deviation,) = deviations(document, plain=False, claimed={"arm"})["URD001"]
    assert deviation.element.path == "link/a/leg"


def test_deviations_come_in_the_order_of_the_document() -> None:
    links = "".join(f'<link name="{name}"><visual/></link>' for name in "abc")
    missing = deviations(read(f'<robot name="r">{links}</robot>'), plain=True)["URD004"]
    assert [one.element.path for one in missing] == [f"link/{name}/visual" for name in "abc"]


def test_unknown_names_have_a_bound() -> None:
    many = "".join(f"<tag{number} />" for number in range(5000))
    assert found(f'<robot name="r">{many}</robot>') == {"URD001": MAX_UNKNOWN}
    many = "".join(f' key{number}="1"' for number in range(5000))
    assert found(f'<robot name="r"{many}/>') == {"URD002": MAX_UNKNOWN}
    many = "<visual><geometry><{0}/></geometry></visual>"
    shapes = "".join(many.format(f"shape{number}") for number in range(5000))
    reported = found(f'<robot name="r"><link name="a">{shapes}</link></robot>')
    assert sum(reported.values()) <= 2 * MAX_UNKNOWN


def test_the_work_grows_with_the_document_only() -> None:
    """Counted in calls of functions, which do not depend on the machine."""

    def calls(links: int) -> int:
        body = "".join(
            f'<link name="l{n}"><visual><origin xyz="{n} 0 0"/><geometry><sphere radius="{n}"/>'
            "</geometry></visual></link>"
            for n in range(links)
        )
        document, count = read(f'<robot name="r">{body}</robot>'), 0

        def profile(_frame: object, event: str, _argument: object) -> None:
            nonlocal count
            count += event == "call"

        sys.setprofile(profile)
        try:
            deviations(document, plain=True)
        finally:
            sys.setprofile(None)
        return count

    assert calls(2000) < 2.1 * calls(1000)
    assert calls(1000) < 1000 * 5 * 5, "five calls for each of five elements of a link"


@pytest.mark.parametrize(
    ("text", "version"),
    [("", "1.0"), ('version="1.1"', "1.1"), ('version="01.02"', "1.2"), ('version="x"', "x")],
)
def test_version_of(text: str, version: str) -> None:
    assert version_of(read(f"<robot {text}/>").root) == version


@pytest.mark.parametrize("text", ["1", " 1", "-1.5e-3", "+.5", "2.", "1E5", "0"])
def test_numbers(text: str) -> None:
    assert is_number(text)


@pytest.mark.parametrize("text", ["", " ", "1 ", "nan", "inf", "1e400", "0x1", "1_0", "\u0661"])
def test_no_numbers(text: str) -> None:
    assert not is_number(text)


def test_places_of() -> None:
    assert schema.places_of("link") == ["robot"]
    assert sorted(schema.places_of("material")) == ["robot", "visual"]
    assert schema.places_of("anchor") == []

"""CFG002: see the rule."""

import pytest

from urdfkit import check
from urdfkit.text.source import Source


@pytest.mark.parametrize("word", ["TRE0036", "missing-fil", "XYZ001"])
def test_the_word_is_the_place(word):
    text = f'<robot name="r"><!-- urdfkit: ignore[{word}] why --><link name="a"/></robot>'
    report = check(Source("r.urdf", text.encode()))
    (finding,) = [found for found in report.diagnostics if found.code == "CFG002"]
    assert finding.span.text == word
    assert word in finding.message


@pytest.mark.parametrize("word", ["TRE003", "TRE", "tre003", "missing-file"])
def test_codes_beginnings_and_names_are_known(word):
    text = f'<robot name="r"><!-- urdfkit: ignore[{word}] why --><link name="a"/></robot>'
    report = check(Source("r.urdf", text.encode()))
    assert "CFG002" not in [finding.code for finding in report.diagnostics]

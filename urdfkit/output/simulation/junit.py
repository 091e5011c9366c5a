"""Verdicts as JUnit XML for CI servers: a test case per verdict, the robot as test suite."""

from xml.etree.ElementTree import Element, SubElement

from urdfkit.output.formats._paths import posix
from urdfkit.output.formats._xml import document, xml_text
from urdfkit.physics.verdicts import Simulation, Verdict


def render(simulation: Simulation, file: str) -> str:
    """The verdicts on the robot of a file."""
    root = Element("testsuites", name="urdfkit simulate")
    suite = SubElement(root, "testsuite", name=xml_text(posix(file)))
    for verdict in simulation.verdicts:
        _case(suite, posix(file), verdict)
    for element in (root, suite):
        element.set("tests", str(len(simulation.verdicts)))
        element.set("failures", str(sum(not item.passes for item in simulation.verdicts)))
    return document(root)


def _case(suite: Element, file: str, verdict: Verdict) -> None:
    name = " ".join((verdict.test, *verdict.names))
    case = SubElement(suite, "testcase", classname=xml_text(file), name=xml_text(name))
    if verdict.span is not None:
        case.set("file", xml_text(posix(verdict.span.source.path)))
        case.set("line", str(verdict.span.line))
    if verdict.passes:
        text = f"warning: {verdict.message}" if verdict.warns else verdict.message
        SubElement(case, "system-out").text = xml_text(text)
    else:
        failure = SubElement(case, "failure", message=xml_text(verdict.message))
        failure.text = xml_text(str(verdict))

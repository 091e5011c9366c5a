from acme_rules.acm001_joint_too_fast import check as rule

from urdfkit.lint.rule_examples import assert_examples, diagnose_example


def test_bad_good_and_fixed():
    assert_examples(rule)


def test_it_says_which_joint_and_how_fast():
    (finding,) = diagnose_example(rule, rule.example("BAD"))
    assert finding.message == "joint 'shoulder': 6 rad/s is over 3.14 rad/s"
    assert finding.span.text == "6"


def test_wheels_may_be_faster():
    wheel = rule.example("BAD").replace("revolute", "continuous")
    assert diagnose_example(rule, wheel) == []

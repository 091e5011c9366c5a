from hypothesis import given
from hypothesis import strategies as st

from urdfkit.robot.support_polygon import hull


@given(st.lists(st.tuples(*[st.integers(-20, 20).map(float)] * 2), max_size=30))
def test_a_hull_holds_all_points_and_turns_left_everywhere(
    points: list[tuple[float, float]],
) -> None:
    corners = hull(points)
    assert set(corners) <= set(points)
    if len(corners) < 3:
        return
    edges = list(zip(corners, (*corners[1:], corners[0]), strict=True))
    for (ax, ay), (bx, by) in edges:
        for x, y in points:
            assert (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0
    assert len(set(corners)) == len(corners)

"""Launch files in Python with two actions, for the tests of the rules about them."""

SPAWNER = "Node(package='controller_manager', executable='spawner', arguments=['c'])"
LASTING = "Node(package='robot_state_publisher', executable='robot_state_publisher')"
PROGRAM = "def generate_launch_description():\n    {}\n"
HANDLED = "LaunchDescription([{}RegisterEventHandler(OnProcessExit(target_action=a, on_exit=[b]))])"


def described(first: str, entities: str) -> str:
    """A launch file with the actions ``a`` and ``b``."""
    return f"a = {first}\nb = {SPAWNER}\n" + PROGRAM.format(f"return {entities}")

"""Programs that a launch file starts as processes, not as nodes."""

import os
import re

from urdfkit.ros.launch.contents import StartedProgram

#: Commands that neither publish nor read messages of a robot, with their arguments.
_COMMAND = re.compile(
    r"(sleep|echo|printf|gzclient|rviz2|killall|pkill|mkdir|rm|cp|true)( .*)?"
    r"|ros2 (control|service|param|lifecycle|node|interface|daemon|action|doctor)( .*)?"
    r"|ros2 topic (echo|list|info|hz|bw|delay)( .*)?"
    r"|(gz|ign) (sim|gazebo|service|model|sdf)( .*)?"
)
#: What starts another command, in a shell.
_SHELL = re.compile(r"[;&|`<>\n]|\$\(")


def is_silent_process(program: StartedProgram) -> bool:
    """True for a command that is known to publish and to read no messages of a robot.

    Gazebo itself is one: its topics pass through a bridge.
    """
    first = program.words[0].text if program.words and not program.package else None
    if not first:
        return False
    words = [os.path.basename(first), *(word.text or "" for word in program.words[1:])]
    command = " ".join(words)
    return bool(_COMMAND.fullmatch(command)) and not _SHELL.search(command)

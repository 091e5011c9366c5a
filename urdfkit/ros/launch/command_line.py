"""The words of a command line of a launch file."""

import shlex

from urdfkit.core import disk

#: Words of a path that are looked at; a hostile command line may have any number.
_MOST = 16


def command_words(text: str) -> list[str]:
    """The words, as a shell splits them, but for white space in the names of directories.

    A package is installed elsewhere: what the directory of its checkout is called does not matter.
    """
    try:
        words = shlex.split(text)
    except ValueError:  # an unfinished quote
        words = text.split()
    position = 0
    while position < len(words):
        count = _words_of_directory(words[position : position + _MOST])
        if count > 1:
            words[position : position + count] = [" ".join(words[position : position + count])]
        else:
            position += 1
    return words


def _words_of_directory(words: list[str]) -> int:
    """How many words are one path, of which a directory has white space in its name."""
    path = words[0][words[0].find("/") :]
    if path.startswith("/") and not disk.exists(path):
        for count in range(1, len(words)):
            last = words[count].partition("/")[0]
            if disk.is_directory(" ".join((path, *words[1:count], last))):
                return count + 1
    return 1

"""The words of a command line of a launch file."""

import shlex

from urdfkit.core import disk

#: Placeholder in a command line for a part that is known only at run time.
UNKNOWN_PART = "\0"

#: Most words that are joined to a path; a hostile command line may have any number.
_MOST = 16


def command_words(text: str) -> list[str]:
    """The words, as a shell splits them, except for white space in names of directories.

    The directory name of a checkout is irrelevant, as a package is installed elsewhere.
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
    """Number of words that form one path, with white space in the name of a directory."""
    path = words[0][words[0].find("/") :]
    if path.startswith("/") and not disk.exists(path):
        for count in range(1, len(words)):
            last = words[count].partition("/")[0]
            if disk.is_directory(" ".join((path, *words[1:count], last))):
                return count + 1
    return 1

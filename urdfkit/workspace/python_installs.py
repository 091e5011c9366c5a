"""What the setup.py of a package installs: its ``data_files``, read as a syntax tree."""

import ast
import os
import posixpath
from collections.abc import Iterator
from fnmatch import fnmatchcase

from urdfkit.text import python_source
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.installs import MAX_BYTES

_MAX_DEPTH = 20


def patterns_of(directory: str, package: str, relative: str) -> Iterator[str]:
    """Paths below a package's directory, with wildcards, that are installed at a path of it.

    setuptools puts the files of a list into its directory by their last names alone:
    ``glob('launch/*/*.py')`` makes one flat directory.
    """
    text = read_head(os.path.join(directory, "setup.py"), MAX_BYTES).decode("utf-8", "replace")
    try:
        tree = python_source.parse(text)
    except SyntaxError:
        return
    wanted, name = posixpath.split(posixpath.normpath(f"share/{package}/{relative}"))
    reader = _Constants(tree)
    for target, files in reader.data_files():
        if posixpath.normpath(reader.text(target) or "") != wanted:
            continue
        for pattern in reader.patterns(files):
            parent, last = posixpath.split(posixpath.normpath(pattern))
            if fnmatchcase(name, last):
                yield posixpath.join(parent, name)


class _Constants:
    """The constants of a program, by the names of its module."""

    def __init__(self, tree: ast.Module) -> None:
        self._tree = tree
        self._values = {
            target.id: node.value
            for node in tree.body
            if isinstance(node, ast.Assign)
            for target in node.targets
            if isinstance(target, ast.Name)
        }

    def data_files(self) -> Iterator[tuple[ast.expr, ast.expr]]:
        """The directories that are installed, and the lists of their files."""
        for node in ast.walk(self._tree):
            if isinstance(node, ast.keyword) and node.arg == "data_files":
                value = self._value(node.value)
                for item in value.elts if isinstance(value, (ast.List, ast.Tuple)) else ():
                    if isinstance(item, ast.Tuple) and len(item.elts) == 2:
                        yield item.elts[0], item.elts[1]

    def patterns(self, node: ast.expr, depth: int = 0) -> Iterator[str]:
        """The paths of a list of files."""
        node = self._value(node)
        if isinstance(node, ast.BinOp) and depth < _MAX_DEPTH:
            yield from self.patterns(node.left, depth + 1)
            yield from self.patterns(node.right, depth + 1)
        elif isinstance(node, (ast.List, ast.Tuple)):
            yield from (text for item in node.elts if (text := self.text(item)))
        elif isinstance(node, ast.Call) and _called(node) == "glob" and node.args:
            yield self.text(node.args[0]) or ""

    def text(self, node: ast.expr, depth: int = 0) -> str | None:
        """The text that an expression gives; None if it is not known."""
        node = self._value(node)
        if isinstance(node, ast.Constant):
            return node.value if isinstance(node.value, str) else None
        parts: list[ast.expr] = []
        between = ""
        if isinstance(node, ast.BinOp):
            parts = [node.left, node.right]
        elif isinstance(node, ast.JoinedStr):
            parts = [
                one.value if isinstance(one, ast.FormattedValue) else one for one in node.values
            ]
        elif isinstance(node, ast.Call) and _called(node) == "join":
            parts, between = node.args, "/"
        texts = [self.text(part, depth + 1) for part in parts] if depth < _MAX_DEPTH else []
        known = [text for text in texts if text is not None]
        return between.join(known) if texts and len(known) == len(texts) else None

    def _value(self, node: ast.expr) -> ast.expr:
        found = self._values.get(node.id) if isinstance(node, ast.Name) else None
        return found or node


def _called(call: ast.Call) -> str:
    """The last part of what is called."""
    return getattr(call.func, "attr", "") or getattr(call.func, "id", "")

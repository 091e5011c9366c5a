"""Installed files of a setup.py: its ``data_files``, read from the syntax tree."""

import ast
import os
import posixpath
from collections.abc import Iterator
from fnmatch import fnmatchcase

from urdfkit.text import python_source
from urdfkit.workspace.file_head import head_text

_MAX_DEPTH = 20


def patterns_of(directory: str, package: str, relative: str) -> Iterator[str]:
    """Source paths of a package, with wildcards, that are installed at a path of it.

    setuptools installs the files of a list into one directory, by their base names:
    ``glob('launch/*/*.py')`` results in a flat directory.
    """
    text = head_text(os.path.join(directory, "setup.py"))
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


def place_of(directory: str, package: str, relative: str) -> str:
    """Where a setup.py installs a file of a package; empty if it is not known for sure."""
    text = head_text(os.path.join(directory, "setup.py"))
    try:
        reader = _Constants(python_source.parse(text))
    except SyntaxError:
        return ""
    places = []
    for target, files in reader.data_files():
        place, patterns = reader.text(target), list(reader.patterns(files))
        if place is None or not patterns or "" in patterns:
            return ""
        for pattern in map(posixpath.normpath, patterns):
            same_depth = pattern.count("/") == relative.count("/")
            if same_depth and fnmatchcase(relative, pattern):
                places.append(posixpath.normpath(f"{place}/{posixpath.basename(relative)}"))
    wanted = f"share/{package}/{relative}"
    return wanted if wanted in places else "".join(places[:1])


def globbed_files(tree: ast.Module) -> Iterator[tuple[str, ast.Constant]]:
    """The patterns of the data files of a setup.py that are written there, with their targets."""
    reader = _Constants(tree)
    for target, files in reader.data_files():
        is_glob = isinstance(files, ast.Call) and _called(files) == "glob" and files.args
        pattern = files.args[0] if isinstance(files, ast.Call) and is_glob else None
        place = reader.text(target)
        if place and isinstance(pattern, ast.Constant) and isinstance(pattern.value, str):
            yield place, pattern


def listed_files(tree: ast.Module) -> Iterator[tuple[str, ast.expr]]:
    """The data files of a setup.py that are written there without a pattern."""
    reader = _Constants(tree)
    for _, files in reader.data_files():
        for item in files.elts if isinstance(files, (ast.List, ast.Tuple)) else ():
            if path := reader.text(item):
                yield path, item


class _Constants:
    """Evaluates constant expressions of a module."""

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
        """Pairs of a target directory and its list of files, also of those that are appended."""
        for node in ast.walk(self._tree):
            for item in self._items(node):
                if isinstance(item, ast.Tuple) and len(item.elts) == 2:
                    yield item.elts[0], item.elts[1]

    def _items(self, node: ast.AST) -> list[ast.expr]:
        """The items that an argument, a call or an addition brings into the data files."""
        if isinstance(node, ast.Call) and _called(node) == "append":
            return node.args
        value: ast.expr | None = None
        if isinstance(node, ast.keyword) and node.arg == "data_files":
            value = self._value(node.value)
        elif isinstance(node, ast.Call) and _called(node) == "extend" and node.args:
            value = node.args[0]
        elif isinstance(node, ast.AugAssign):
            value = node.value
        return value.elts if isinstance(value, (ast.List, ast.Tuple)) else []

    def patterns(self, node: ast.expr, depth: int = 0) -> Iterator[str]:
        """The paths of a list of files."""
        node = self._value(node)
        if isinstance(node, ast.BinOp) and depth < _MAX_DEPTH:
            yield from self.patterns(node.left, depth + 1)
            yield from self.patterns(node.right, depth + 1)
        elif isinstance(node, (ast.List, ast.Tuple)):
            yield from (self.text(item) or "" for item in node.elts)
        elif isinstance(node, ast.Call) and _called(node) == "glob" and node.args:
            yield self.text(node.args[0]) or ""

    def text(self, node: ast.expr, depth: int = 0) -> str | None:
        """The string value of an expression; None if unknown."""
        node = self._value(node)
        if isinstance(node, ast.Constant):
            return node.value if isinstance(node.value, str) else None
        parts: list[ast.expr] = []
        separator = ""
        if isinstance(node, ast.BinOp):
            parts = [node.left, node.right]
        elif isinstance(node, ast.JoinedStr):
            parts = [
                part.value if isinstance(part, ast.FormattedValue) else part for part in node.values
            ]
        elif isinstance(node, ast.Call) and _called(node) == "join":
            parts, separator = node.args, "/"
        texts = [self.text(part, depth + 1) for part in parts] if depth < _MAX_DEPTH else []
        known = [text for text in texts if text is not None]
        return separator.join(known) if texts and len(known) == len(texts) else None

    def _value(self, node: ast.expr) -> ast.expr:
        value = self._values.get(node.id) if isinstance(node, ast.Name) else None
        return value or node


def _called(call: ast.Call) -> str:
    """Name of the called function, without its module."""
    return getattr(call.func, "attr", "") or getattr(call.func, "id", "")

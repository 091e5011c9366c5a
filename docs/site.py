"""A hook of mkdocs: what the pages need to become a site.

Pages link to files of the repository that are no pages; on the site such a link is its text.
Commands that the navigation of ``mkdocs.yml`` does not name follow those that it does, so that a
new command needs no edit there.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

DOCS = Path(__file__).resolve().parent

_LINK = re.compile(r"(?<!!)\[([^\]]+)\]\((?!https?:|#)([^)#\s]+)(#[^)]*)?\)")


def on_config(config: Any) -> Any:
    """Complete the list of commands."""
    (commands,) = [entry["Commands"] for entry in config["nav"] if "Commands" in entry]
    listed = {path for entry in commands for path in entry.values()}
    for page in sorted(DOCS.glob("commands/*.md")):
        path = f"commands/{page.name}"
        if path not in listed:
            commands.append({page.stem.replace("-", " "): path})
    return config


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Take out the links that lead out of the documentation."""
    folder = Path(page.file.abs_src_path).parent

    def shown(link: re.Match[str]) -> str:
        target = (folder / link[2]).resolve()
        return link[0] if target.is_relative_to(DOCS) and target.is_file() else link[1]

    return _LINK.sub(shown, markdown)

"""A hook of mkdocs: what the pages need to become a site.

The pages of the rules are generated from the rules, into ``docs/rules``.

Pages link to files of the repository that are no pages; on the site such a link is its text.
Commands that the navigation of ``mkdocs.yml`` does not name follow those that it does, so that a
new command needs no edit there; public names that ``api.md`` does not sort in end its page.
"""

import re
import shutil
from pathlib import Path
from typing import Any

import urdfkit
from docs import generate
from docs.playground.build import build as build_playground

DOCS = Path(__file__).resolve().parent

_LINK = re.compile(r"(?<!!)\[([^\]]+)\]\((?!https?:|#)([^)#\s]+)(#[^)]*)?\)")


def on_config(config: Any) -> Any:
    """Complete the list of commands."""
    (commands,) = [entry["Commands"] for entry in config["nav"] if "Commands" in entry]
    listed = {path for entry in commands for path in entry.values()}
    for page in sorted(DOCS.glob("commands/*.md"), key=lambda page: page.stem):
        path = f"commands/{page.name}"
        if path not in listed:
            commands.append({page.stem.replace("-", " "): path})
    return config


def on_pre_build(**_: Any) -> None:
    """Write the pages of the rules, which the repository does not hold."""
    generate.main()


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Take out the links that lead out of the documentation."""
    if page.file.src_uri == "api.md":
        markdown += _not_described(markdown)
    directory = Path(page.file.abs_src_path).parent

    def shown(link: re.Match[str]) -> str:
        target = (directory / link[2]).resolve()
        return link[0] if target.is_relative_to(DOCS) and target.is_file() else link[1]

    return _LINK.sub(shown, markdown)


def on_post_build(config: Any, **_: Any) -> None:
    """Write what the playground loads, and ``llms.txt`` with the pages that it lists as written.

    https://llmstxt.org has the format of the latter.
    """
    site = Path(config["site_dir"])
    build_playground(site / "playground")
    for page in _pages():
        shutil.copyfile(DOCS / page, site / page)
    (site / "llms.txt").write_text(llms(), encoding="utf-8")


def llms() -> str:
    """The pages with what each is about: its first sentence that begins a paragraph."""
    lines = ["# urdfkit", "", f"> {_about('index.md')}", ""]
    lines += ["Agents can start `urdfkit mcp` (Model Context Protocol).", "", "## Docs", ""]
    for page in _pages():
        about = _about(page)
        lines.append(f"- [{_title(page)}]({page})" + f": {about}" * bool(about))
    return "\n".join(lines) + "\n"


def _pages() -> list[str]:
    found = [*DOCS.glob("*.md"), *DOCS.glob("commands/*.md")]
    return sorted(str(page.relative_to(DOCS)) for page in found)


def _title(page: str) -> str:
    return (DOCS / page).read_text(encoding="utf-8").partition("\n")[0].removeprefix("# ")


def _about(page: str) -> str:
    """The first sentence that begins a paragraph, without links; empty if there is none."""
    text = re.sub(r"```.*?```", "", (DOCS / page).read_text(encoding="utf-8"), flags=re.DOTALL)
    paragraphs = [" ".join(one.split()) for one in text.split("\n\n")[1:]]
    first = next((one for one in paragraphs if one[:1].isalnum()), "")
    sentence = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", first).partition(". ")[0]
    return sentence.rstrip(".:") + "." if sentence else ""


def _not_described(markdown: str) -> str:
    """Directives for the public names that a page leaves out."""
    described = set(re.findall(r"^::: urdfkit\.(\w+)", markdown, re.MULTILINE))
    rest = [name for name in urdfkit.__all__ if name not in described]
    return "\n## More\n" * bool(rest) + "".join(f"\n::: urdfkit.{name}\n" for name in rest)

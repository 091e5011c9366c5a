"""The language server under a real editor, without a screen."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import urdfkit
from tests.conftest import MISSION, MODELS, ROOT

pytest.importorskip("pygls")
pytestmark = pytest.mark.skipif(shutil.which("nvim") is None, reason="Neovim is not installed")

#: Opens the file, waits for findings, asks, fixes and renames; what it saw goes to a file.
SESSION = """
vim.cmd("edit " .. vim.env.ROBOT)
local buffer = vim.api.nvim_get_current_buf()
local command = { vim.env.PYTHON, "-m", "urdfkit", "lsp" }
local start = vim.lsp.start or vim.lsp.start_client -- the latter before 0.8
local id = start({ name = "urdfkit", cmd = command, root_dir = vim.env.DIRECTORY })
vim.lsp.buf_attach_client(buffer, id)
local function wait(done) return vim.wait(30000, done, 20) end
local seen = {}

local function codes()
  local found = {}
  for _, one in ipairs(vim.diagnostic.get(buffer)) do
    local code = one.code or one.user_data.lsp.code
    table.insert(found, code .. ":" .. (one.lnum + 1))
  end
  return found
end

-- Those that take longer come behind the others: wait until nothing new comes for a second.
local number = 0
wait(function() return #codes() > 0 end)
repeat
  number = #codes()
  vim.wait(1000, function() return #codes() ~= number end, 20)
until #codes() == number
seen.opened = codes()

local function at(text, skip)
  vim.fn.cursor(1, 1)
  vim.fn.search(text, "c")
  vim.fn.cursor(vim.fn.line("."), vim.fn.col(".") + skip)
  return vim.lsp.util.make_position_params(0, "utf-16")
end

local function ask(method, params)
  return vim.lsp.buf_request_sync(buffer, method, params, 30000)[id].result
end

seen.hover = ask("textDocument/hover", at('parent link="base_link"', 14)).contents.value
local places = ask("textDocument/definition", at('parent link="base_link"', 14))
seen.definition = places[1].range.start.line

local params = at('parent link="base_link"', 14)
params.newName = "chassis"
vim.lsp.util.apply_workspace_edit(ask("textDocument/rename", params), "utf-16")
seen.renamed = vim.fn.searchcount({ pattern = '"chassis"', maxcount = 0 }).total

-- Typing: the property that repeats pi is taken out.
vim.fn.cursor(1, 1)
local line = vim.fn.search('name="PI"')
vim.api.nvim_buf_set_lines(buffer, line - 1, line, true, {})
wait(function() return not table.concat(codes(), " "):find("XAC007") end)
seen.typed = codes()

local file = io.open(vim.env.SEEN, "w")
file:write(vim.fn.json_encode(seen))
file:close()
"""


@pytest.fixture(scope="module")
def seen(tmp_path_factory: pytest.TempPathFactory) -> Any:
    directory = tmp_path_factory.mktemp("neovim")
    shutil.copytree(MODELS / "gazebo_pkg", directory / "gazebo_pkg")
    script = directory / "session.lua"
    script.write_text(SESSION)
    done = subprocess.run(
        ["nvim", "--headless", "-u", "NONE", "-c", f"luafile {script}", "-c", "qa!"],
        check=False,
        cwd=directory,
        env={
            **os.environ,
            "PYTHONPATH": str(ROOT),
            "PYTHON": sys.executable,
            "DIRECTORY": str(directory),
            "ROBOT": "gazebo_pkg/urdf/waking_robot_new.xacro",
            "SEEN": str(directory / "seen.json"),
            "XDG_STATE_HOME": str(directory),
        },
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert (directory / "seen.json").exists(), done.stderr
    return json.loads((directory / "seen.json").read_text())


def test_it_shows_what_the_command_line_finds(seen: Any) -> None:
    report = urdfkit.check(MISSION)
    assert sorted(seen["opened"]) == sorted(f"{d.code}:{d.span.line}" for d in report.diagnostics)


def test_it_answers(seen: Any) -> None:
    assert seen["hover"].startswith("**link** `base_link`\n- 8.2 kg")
    assert seen["definition"] == 52


def test_a_link_is_renamed_everywhere(seen: Any) -> None:
    text = Path(MISSION).read_text()
    assert seen["renamed"] == text.count('"base_link"')


def test_what_is_typed_is_checked(seen: Any) -> None:
    before = {code.partition(":")[0] for code in seen["opened"]}
    after = {code.partition(":")[0] for code in seen["typed"]}
    assert "XAC007" in before - after
    assert "XAC001" in after, "PI is used and no longer defined"

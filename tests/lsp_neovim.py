#!/usr/bin/env python3
"""Tests `kadr lsp` with a real editor: Neovim without a screen, through its built-in client. It opens an example, waits for the findings, and
asks for hover, completion, definition, rename and formatting; what Neovim has understood is compared.

    lsp_neovim.py --kadr build/release/kadr

Skipped if `nvim` is not installed (`dev/setup oracle` installs it).
"""
import json
import shutil
import subprocess
import sys

import harness
from harness import expect

PROGRAM = 'O0001\nG21 G90 G54\n#101=5.\nN30 G1 X#101 F100\nIF[#101GT9]GOTO 30\nG0 X1. Q\nM30\n'

SCRIPT = r'''
local kadr, out = ...
local client = vim.lsp.start_client({ name = "kadr", cmd = { kadr, "lsp" }, init_options = { control = "fanuc" }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(0, client)
local function wait(what) return vim.wait(100000, what, 20) end
local function ask(method, line, character, more)
  local params = vim.tbl_extend("force", { textDocument = vim.lsp.util.make_text_document_params(0) }, more or {})
  if line then params.position = { line = line, character = character } end
  local answer = vim.lsp.buf_request_sync(0, method, params, 100000)
  return answer and answer[client] and answer[client].result
end
local seen = {}
seen.found = wait(function() return #vim.diagnostic.get(0) > 0 end)
seen.diagnostics = vim.tbl_map(function(d) return { line = d.lnum, column = d.col, text = d.message, code = d.code } end, vim.diagnostic.get(0))
seen.hover = ask("textDocument/hover", 3, 5)
seen.completion = ask("textDocument/completion", 3, 6)
seen.definition = ask("textDocument/definition", 4, 18)
local rename = ask("textDocument/rename", 2, 1, { newName = "500" })
vim.lsp.util.apply_workspace_edit(rename, "utf-16")
seen.renamed = vim.api.nvim_buf_get_lines(0, 0, -1, false)
vim.api.nvim_buf_set_lines(0, 5, 6, false, { "G0X1." })
seen.mended = wait(function() return #vim.tbl_filter(function(d) return d.severity == 1 end, vim.diagnostic.get(0)) == 0 end)
local edits = ask("textDocument/formatting", nil, nil, { options = { tabSize = 2, insertSpaces = true } })
vim.lsp.util.apply_text_edits(edits, 0, "utf-16")
seen.formatted = vim.api.nvim_buf_get_lines(0, 5, 6, false)
vim.lsp.stop_client(client)
seen.stopped = wait(function() return vim.lsp.client_is_stopped(client) end)
local file = io.open(out, "w")
file:write(vim.fn.json_encode(seen))
file:close()
vim.cmd("qall!")
'''


def check_neovim(kadr):
    if not shutil.which('nvim'):
        harness.skipped('nvim is not installed')
        return
    kadr.file('part.nc', PROGRAM)
    script, out = kadr.file('editor.lua', SCRIPT), kadr.folder / 'seen.json'
    done = subprocess.run(['nvim', '--headless', '--clean', '-n', 'part.nc', '-c', f'lua loadfile("{script}")("{kadr.program}", "{out}")'], cwd=kadr.folder,
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=10 * harness.TIME_LIMIT_S, check=False)
    expect(out.exists(), f'Neovim wrote nothing: {done.stdout[-500:]} {done.stderr[-1500:]}')
    seen = json.loads(out.read_text())
    expect(seen['found'] and any(d['line'] == 5 for d in seen['diagnostics']), f'findings: {seen["diagnostics"]}')
    expect('G1' in seen['hover']['contents']['value'], f'hover: {seen["hover"]}')
    expect(any(item['label'] == 'G1' for item in seen['completion']['items']), 'completion')
    expect([one['range']['start']['line'] for one in seen['definition']] == [3], f'definition: {seen["definition"]}')
    expect(seen['renamed'] == PROGRAM.replace('#101', '#500').split('\n')[:-1], f'rename: {seen["renamed"]}')
    expect(seen['mended'], 'the findings follow the text')
    expect(seen['formatted'] == ['G0 X1.'], f'formatting: {seen["formatted"]}')
    expect(seen['stopped'], 'the server ends with the editor')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))

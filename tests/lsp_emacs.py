#!/usr/bin/env python3
"""Tests `kadr lsp` with a real editor: Emacs without a screen, with eglot and the lines of docs/lsp.md. It opens an example, waits for the
findings, and asks for hover, completion and definition; what Emacs shows is compared.

    lsp_emacs.py --kadr build/release/kadr

Skipped if `emacs` or eglot is not installed (emacs-nox and elpa-eglot of Debian: more than 100 MB, so `dev/setup` does not install them).
"""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import harness
from harness import expect

PROGRAM = 'O0001\nG21 G90 G54\n#101=5.\nN30 G1 X#101 F100\nIF[#101GT9]GOTO 30\nG0 X1. Q\nM30\n'

SCRIPT = r'''
(require 'eglot)
(load "~/init.el")
(setq eglot-sync-connect t eglot-connect-timeout 100 eldoc-idle-delay 0)
(find-file "part.nc")
(unless (eglot-current-server) (eglot-ensure) (run-hooks 'post-command-hook))
(defun wait (what)
  (let ((until (+ (float-time) 100)))
    (while (and (not (funcall what)) (< (float-time) until)) (accept-process-output nil 0.05))
    (funcall what)))
(defun place (line column) (goto-char (point-min)) (forward-line line) (forward-char column))
(wait (lambda () (eglot-current-server)))
(wait (lambda () (flymake-start) (flymake-diagnostics)))
(let* ((mode (symbol-name major-mode))
       (found (mapcar (lambda (d) (list (line-number-at-pos (flymake-diagnostic-beg d)) (flymake-diagnostic-text d))) (flymake-diagnostics)))
       (hover (progn (place 3 5) (let (shown) (run-hook-with-args 'eldoc-documentation-functions (lambda (text &rest _) (setq shown text)))
                                   (wait (lambda () shown)) (substring-no-properties shown))))
       (completed (progn (place 3 6) (let ((at (eglot-completion-at-point))) (all-completions "G1" (nth 2 at)))))
       (definition (progn (place 4 18) (call-interactively 'xref-find-definitions) (line-number-at-pos))))
  (with-temp-file "seen.json"
    (insert (json-encode (list (cons 'mode mode) (cons 'found (vconcat (mapcar 'vconcat found))) (cons 'hover hover)
                               (cons 'completed (vconcat completed)) (cons 'definition definition))))))
(eglot-shutdown (eglot-current-server))
(kill-emacs 0)
'''


def check_emacs(kadr):
    if not shutil.which('emacs') or not list(Path('/usr/share/emacs/site-lisp').glob('**/eglot*')):
        harness.skipped('emacs or eglot is not installed')
        return
    page = (harness.ROOT / 'docs' / 'lsp.md').read_text(encoding='utf-8')
    kadr.file('init.el', re.search(r'```elisp\n(.*?)```', page, re.S)[1].replace('"kadr"', f'"{kadr.program}"'))
    kadr.file('part.nc', PROGRAM)
    kadr.file('.kadr.toml', 'control = "fanuc"\n')
    script = kadr.file('editor.el', SCRIPT)
    done = subprocess.run(['emacs', '--batch', '-q', '-l', script], cwd=kadr.folder, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          env={**os.environ, 'HOME': str(kadr.folder)}, timeout=10 * harness.TIME_LIMIT_S, check=False)
    out = kadr.folder / 'seen.json'
    expect(out.exists(), f'Emacs wrote nothing: {done.stdout[-500:]} {done.stderr[-1500:]}')
    seen = json.loads(out.read_text(encoding='utf-8'))
    expect(seen['mode'] == 'nc-mode', f'mode: {seen["mode"]}')
    expect(any(line == 6 and 'Q' in text for line, text in seen['found']), f'findings: {seen["found"]}')
    expect('G1' in seen['hover'] and 'linear' in seen['hover'], f'hover: {seen["hover"]}')
    expect('G1' in [one.strip() for one in seen['completed']], f'completion: {seen["completed"]}')
    expect(seen['definition'] == 4, f'definition: {seen["definition"]}')


if __name__ == '__main__':
    sys.exit(harness.main(__doc__, globals()))

"""The shapes of the messages that a language server sends: a table by hand from the Language Server Protocol 3.17, and a check.

A type is the name of a row of SHAPES, or one of `uint`, `int`, `string`, `bool`, `null`, `any`, a literal such as 'create', `T[]`, `{T}` for
an object whose members are T, or alternatives with `|`. A field with `?` may be missing; a field that is not in the table is a fault.
"""

SHAPES = {
    'Position': {'line': 'uint', 'character': 'uint'},
    'Range': {'start': 'Position', 'end': 'Position'},
    'Location': {'uri': 'string', 'range': 'Range'},
    'MarkupContent': {'kind': "'plaintext'|'markdown'", 'value': 'string'},
    'Command': {'title': 'string', 'command': 'string', 'arguments?': 'any[]'},
    'TextEdit': {'range': 'Range', 'newText': 'string'},
    'OptionalVersionedTextDocumentIdentifier': {'uri': 'string', 'version': 'int|null'},
    'TextDocumentEdit': {'textDocument': 'OptionalVersionedTextDocumentIdentifier', 'edits': 'TextEdit[]'},
    'CreateFile': {'kind': "'create'", 'uri': 'string', 'options?': 'any', 'annotationId?': 'string'},
    'WorkspaceEdit': {'changes?': '{TextEdit[]}', 'documentChanges?': 'TextDocumentEdit|CreateFile[]', 'changeAnnotations?': 'any'},
    # documents
    'DiagnosticRelatedInformation': {'location': 'Location', 'message': 'string'},
    'Diagnostic': {'range': 'Range', 'severity?': '1|2|3|4', 'code?': 'int|string', 'codeDescription?': 'any', 'source?': 'string',
                   'message': 'string', 'tags?': '1|2[]', 'relatedInformation?': 'DiagnosticRelatedInformation[]', 'data?': 'any'},
    'PublishDiagnosticsParams': {'uri': 'string', 'version?': 'int', 'diagnostics': 'Diagnostic[]'},
    'LogMessageParams': {'type': '1|2|3|4', 'message': 'string'},
    'ShowMessageParams': {'type': '1|2|3|4', 'message': 'string'},
    'ShowDocumentParams': {'uri': 'string', 'external?': 'bool', 'takeFocus?': 'bool', 'selection?': 'Range'},
    'ApplyWorkspaceEditParams': {'label?': 'string', 'edit': 'WorkspaceEdit'},
    # features
    'Hover': {'contents': 'MarkupContent', 'range?': 'Range'},
    'CompletionItemLabelDetails': {'detail?': 'string', 'description?': 'string'},
    'CompletionItem': {'label': 'string', 'labelDetails?': 'CompletionItemLabelDetails', 'kind?': 'uint', 'tags?': 'uint[]', 'detail?': 'string',
                       'documentation?': 'string|MarkupContent', 'deprecated?': 'bool', 'preselect?': 'bool', 'sortText?': 'string',
                       'filterText?': 'string', 'insertText?': 'string', 'insertTextFormat?': '1|2', 'insertTextMode?': '1|2',
                       'textEdit?': 'TextEdit', 'textEditText?': 'string', 'additionalTextEdits?': 'TextEdit[]',
                       'commitCharacters?': 'string[]', 'command?': 'Command', 'data?': 'any'},
    'CompletionList': {'isIncomplete': 'bool', 'itemDefaults?': 'any', 'items': 'CompletionItem[]'},
    'ParameterInformation': {'label': 'string|uint[]', 'documentation?': 'string|MarkupContent'},
    'SignatureInformation': {'label': 'string', 'documentation?': 'string|MarkupContent', 'parameters?': 'ParameterInformation[]',
                             'activeParameter?': 'uint'},
    'SignatureHelp': {'signatures': 'SignatureInformation[]', 'activeSignature?': 'uint', 'activeParameter?': 'uint'},
    'DocumentHighlight': {'range': 'Range', 'kind?': '1|2|3'},
    'DocumentSymbol': {'name': 'string', 'detail?': 'string', 'kind': 'uint', 'tags?': 'uint[]', 'deprecated?': 'bool', 'range': 'Range',
                       'selectionRange': 'Range', 'children?': 'DocumentSymbol[]'},
    'SymbolInformation': {'name': 'string', 'kind': 'uint', 'tags?': 'uint[]', 'containerName?': 'string', 'deprecated?': 'bool',
                          'location': 'Location'},
    'FoldingRange': {'startLine': 'uint', 'startCharacter?': 'uint', 'endLine': 'uint', 'endCharacter?': 'uint', 'kind?': 'string',
                     'collapsedText?': 'string'},
    'SemanticTokens': {'resultId?': 'string', 'data': 'uint[]'},
    'InlayHint': {'position': 'Position', 'label': 'string', 'kind?': '1|2', 'textEdits?': 'TextEdit[]', 'tooltip?': 'string|MarkupContent',
                  'paddingLeft?': 'bool', 'paddingRight?': 'bool', 'data?': 'any'},
    'CodeAction': {'title': 'string', 'kind?': 'string', 'diagnostics?': 'Diagnostic[]', 'isPreferred?': 'bool', 'disabled?': 'any',
                   'edit?': 'WorkspaceEdit', 'command?': 'Command', 'data?': 'any'},
    'CodeLens': {'range': 'Range', 'command?': 'Command', 'data?': 'any'},
    'PrepareRename': {'range': 'Range', 'placeholder': 'string'},
    # life cycle
    'ServerInfo': {'name': 'string', 'version?': 'string'},
    'InitializeResult': {'capabilities': 'ServerCapabilities', 'serverInfo?': 'ServerInfo'},
    'SaveOptions': {'includeText?': 'bool'},
    'TextDocumentSyncOptions': {'openClose?': 'bool', 'change?': '0|1|2', 'willSave?': 'bool', 'willSaveWaitUntil?': 'bool',
                                'save?': 'bool|SaveOptions'},
    'CompletionOptions': {'triggerCharacters?': 'string[]', 'allCommitCharacters?': 'string[]', 'resolveProvider?': 'bool',
                          'completionItem?': 'any', 'workDoneProgress?': 'bool'},
    'SignatureHelpOptions': {'triggerCharacters?': 'string[]', 'retriggerCharacters?': 'string[]', 'workDoneProgress?': 'bool'},
    'CodeActionOptions': {'codeActionKinds?': 'string[]', 'resolveProvider?': 'bool', 'workDoneProgress?': 'bool'},
    'CodeLensOptions': {'resolveProvider?': 'bool', 'workDoneProgress?': 'bool'},
    'RenameOptions': {'prepareProvider?': 'bool', 'workDoneProgress?': 'bool'},
    'ExecuteCommandOptions': {'commands': 'string[]', 'workDoneProgress?': 'bool'},
    'SemanticTokensLegend': {'tokenTypes': 'string[]', 'tokenModifiers': 'string[]'},
    'SemanticTokensOptions': {'legend': 'SemanticTokensLegend', 'range?': 'bool', 'full?': 'bool', 'workDoneProgress?': 'bool'},
    'ServerCapabilities': {
        'positionEncoding?': "'utf-8'|'utf-16'|'utf-32'", 'textDocumentSync?': 'TextDocumentSyncOptions', 'hoverProvider?': 'bool',
        'completionProvider?': 'CompletionOptions', 'signatureHelpProvider?': 'SignatureHelpOptions', 'definitionProvider?': 'bool',
        'referencesProvider?': 'bool', 'documentHighlightProvider?': 'bool', 'documentSymbolProvider?': 'bool',
        'workspaceSymbolProvider?': 'bool', 'foldingRangeProvider?': 'bool', 'inlayHintProvider?': 'bool',
        'codeActionProvider?': 'CodeActionOptions', 'executeCommandProvider?': 'ExecuteCommandOptions', 'codeLensProvider?': 'CodeLensOptions',
        'documentFormattingProvider?': 'bool', 'renameProvider?': 'RenameOptions', 'semanticTokensProvider?': 'SemanticTokensOptions', 'workspace?': 'WorkspaceOptions'},
    'WorkspaceOptions': {'workspaceFolders?': 'WorkspaceFoldersOptions'}, 'WorkspaceFoldersOptions': {'supported?': 'bool', 'changeNotifications?': 'bool'},
    'KadrControlParams': {'uri': 'string', 'control': 'string', 'guessed': 'bool'},   # docs/lsp.md
    'ResponseError': {'code': 'int', 'message': 'string', 'data?': 'any'},
}

# The result of each request that the server answers.
RESULTS = {
    'initialize': 'InitializeResult', 'shutdown': 'null', 'workspace/symbol': 'SymbolInformation[]|null', 'workspace/executeCommand': 'any',
    'textDocument/hover': 'Hover|null', 'textDocument/completion': 'CompletionList|null', 'textDocument/signatureHelp': 'SignatureHelp|null',
    'textDocument/definition': 'Location[]|null', 'textDocument/references': 'Location[]|null',
    'textDocument/documentHighlight': 'DocumentHighlight[]|null', 'textDocument/prepareRename': 'PrepareRename|null',
    'textDocument/rename': 'WorkspaceEdit|null', 'textDocument/documentSymbol': 'DocumentSymbol[]|SymbolInformation[]|null',
    'textDocument/foldingRange': 'FoldingRange[]|null', 'textDocument/semanticTokens/full': 'SemanticTokens|null',
    'textDocument/semanticTokens/range': 'SemanticTokens|null',
    'textDocument/inlayHint': 'InlayHint[]|null', 'textDocument/codeAction': 'Command|CodeAction[]|null',
    'textDocument/codeLens': 'CodeLens[]|null', 'textDocument/formatting': 'TextEdit[]|null',
}

# The parameters of each notification and request that the server sends.
SENT = {
    'textDocument/publishDiagnostics': 'PublishDiagnosticsParams', 'window/logMessage': 'LogMessageParams',
    'window/showMessage': 'ShowMessageParams', 'window/showDocument': 'ShowDocumentParams', 'workspace/applyEdit': 'ApplyWorkspaceEditParams',
    'kadr/control': 'KadrControlParams',
}

PLAIN = {
    'uint': lambda v: isinstance(v, int) and not isinstance(v, bool) and 0 <= v < 2 ** 31,
    'int': lambda v: isinstance(v, int) and not isinstance(v, bool) and -2 ** 31 <= v < 2 ** 31,
    'string': lambda v: isinstance(v, str), 'bool': lambda v: isinstance(v, bool), 'null': lambda v: v is None, 'any': lambda v: True,
}


def fault_of(value, kind, path='message'):
    """Returns what is wrong with a value of this type; None if nothing is."""
    if kind.endswith('|null'):
        return None if value is None else fault_of(value, kind[:-5], path)
    if kind.startswith('{'):
        if not isinstance(value, dict):
            return f'{path} is no object'
        return next((f for f in (fault_of(v, kind[1:-1], f'{path}.{k}') for k, v in value.items()) if f), None)
    if kind.endswith('[]'):
        parts = kind.split('[]|')
        if len(parts) > 1:   # one of several lists
            faults = [fault_of(value, part if part.endswith('[]') else part + '[]', path) for part in parts]
            return None if None in faults else faults[0]
        if kind.startswith('string|'):   # a text, or a list
            return None if isinstance(value, str) else fault_of(value, kind[7:], path)
        if not isinstance(value, list):
            return f'{path} is no list'
        return next((f for f in (fault_of(v, kind[:-2], f'{path}[{i}]') for i, v in enumerate(value)) if f), None)
    if '|' in kind:
        faults = [fault_of(value, one, path) for one in kind.split('|')]
        return None if None in faults else faults[-1]
    if kind in PLAIN:
        return None if PLAIN[kind](value) else f'{path} is no {kind}: {value!r}'
    if kind not in SHAPES:   # a literal
        return None if repr(value) == kind else f'{path} is {value!r}, not {kind}'
    if not isinstance(value, dict):
        return f'{path} is no {kind}: {value!r}'
    fields = SHAPES[kind]
    for name in value:
        if name not in fields and name + '?' not in fields:
            return f'{path}: {kind} has no {name}'
    for name, of in fields.items():
        plain = name.rstrip('?')
        if plain in value:
            fault = fault_of(value[plain], of, f'{path}.{plain}')
            if fault:
                return fault
        elif not name.endswith('?'):
            return f'{path}: {kind} lacks {plain}'
    return None


def fault_of_message(message, method_of):
    """Returns what is wrong with a message of the server; None if nothing is.  `method_of`: id → method of the requests of the editor"""
    if message.get('jsonrpc') != '2.0':
        return 'jsonrpc must be 2.0'
    if 'method' in message:
        kind = SENT.get(message['method'])
        return fault_of(message.get('params'), kind, message['method']) if kind else f'the server sends no {message["method"]}'
    if ('result' in message) == ('error' in message) or 'id' not in message:
        return f'an answer has an id, and a result or an error: {message}'
    if 'error' in message:
        return fault_of(message['error'], 'ResponseError')
    method = method_of.get(message['id'])
    return fault_of(message['result'], RESULTS[method], method) if method in RESULTS else f'an answer to {method}'

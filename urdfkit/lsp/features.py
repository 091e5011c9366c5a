"""Features of the server: a handler for each request and notification."""

import re

from lsprotocol import types as lsp

from urdfkit.lsp import actions, completion, hover, navigation, outline
from urdfkit.lsp.completion_in_text import CompletionItem
from urdfkit.lsp.inlay_hints import inlay_hints
from urdfkit.lsp.server import Server
from urdfkit.lsp.text import PositionEncoding, to_uri
from urdfkit.lsp.workspace import slow_rules
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.editing.edits import escaped
from urdfkit.text.source import Source, Span
from urdfkit.text.terminal import printable

_SYMBOLS = {
    "link": lsp.SymbolKind.Object,
    "joint": lsp.SymbolKind.Event,
    "macro": lsp.SymbolKind.Function,
    "property": lsp.SymbolKind.Variable,
    "argument": lsp.SymbolKind.Constant,
    "arg": lsp.SymbolKind.Constant,
    "material": lsp.SymbolKind.EnumMember,
    "gazebo": lsp.SymbolKind.Module,
    "transmission": lsp.SymbolKind.Interface,
    "group": lsp.SymbolKind.Package,
}
_ITEMS = {
    "tag": lsp.CompletionItemKind.Class,
    "attribute": lsp.CompletionItemKind.Property,
    "name": lsp.CompletionItemKind.Reference,
    "word": lsp.CompletionItemKind.Value,
    "file": lsp.CompletionItemKind.File,
    "directory": lsp.CompletionItemKind.Folder,
    "end": lsp.CompletionItemKind.Text,
}


def make() -> Server:
    server = Server()
    _add_documents(server)
    _add_pull(server)
    triggers = lsp.CompletionOptions(trigger_characters=["<", '"', "'", "/", "{", "(", " ", ":"])
    kinds = [lsp.CodeActionKind.QuickFix, lsp.CodeActionKind.SourceFixAll]
    server.register(lsp.TEXT_DOCUMENT_HOVER, _hover, None)
    server.register(lsp.TEXT_DOCUMENT_DEFINITION, _definitions, [])
    server.register(lsp.TEXT_DOCUMENT_REFERENCES, _references, [])
    server.register(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL, _symbols, [])
    server.register(lsp.TEXT_DOCUMENT_DOCUMENT_LINK, _links, [])
    server.register(lsp.TEXT_DOCUMENT_INLAY_HINT, _inlay_hints, [])
    server.register(lsp.WORKSPACE_SYMBOL, _workspace_symbols, [])
    server.register(lsp.TEXT_DOCUMENT_COMPLETION, _completions, [], triggers)
    server.register(lsp.TEXT_DOCUMENT_PREPARE_RENAME, _rename_placeholder, None)
    server.register(
        lsp.TEXT_DOCUMENT_RENAME, _rename, None, lsp.RenameOptions(prepare_provider=True)
    )
    server.register(lsp.TEXT_DOCUMENT_FORMATTING, _format, None)
    server.register(lsp.TEXT_DOCUMENT_CODE_ACTION, _actions, [], lsp.CodeActionOptions(kinds))
    return server


def _add_documents(server: Server) -> None:
    @server.feature(lsp.INITIALIZED)
    def _(params: lsp.InitializedParams) -> None:
        server.worker.submit(slow_rules)  # imports the rules before the first check
        server.encoding = PositionEncoding(server.server_capabilities.position_encoding or "utf-16")
        server.watch()

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    def _(params: lsp.DidOpenTextDocumentParams) -> None:
        server.update_text(params.text_document.uri)
        server.check_soon(params.text_document.uri, thorough=True)
        server.clear_published(params.text_document.uri)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def _(params: lsp.DidChangeTextDocumentParams) -> None:
        server.update_text(params.text_document.uri)
        server.check_soon(params.text_document.uri)

    @server.feature(lsp.TEXT_DOCUMENT_DID_SAVE)
    def _(params: lsp.DidSaveTextDocumentParams) -> None:
        server.worker.submit(server.robots.reload)
        server.check_soon(params.text_document.uri, thorough=True)

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    async def _(params: lsp.DidCloseTextDocumentParams) -> None:
        server.cancel_check(params.text_document.uri)
        path = server.path(params.text_document.uri)
        nothing: dict[str, list[Diagnostic]] = {}
        remaining = await server.in_worker(lambda: server.robots.close(path), nothing)
        for file, diagnostics in remaining.items():
            server.publish(file, diagnostics)
        if params.text_document.uri not in server.workspace.text_documents:  # not reopened
            server.uris.pop(path, None)

    @server.feature(lsp.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def _(params: lsp.DidChangeWatchedFilesParams) -> None:
        server.worker.submit(server.robots.reload)
        for uri in list(server.uris.values()):
            server.check_soon(uri)


def _add_pull(server: Server) -> None:
    options = lsp.DiagnosticOptions(inter_file_dependencies=True, workspace_diagnostics=False)

    @server.feature(lsp.TEXT_DOCUMENT_DIAGNOSTIC, options)
    async def _(params: lsp.DocumentDiagnosticParams) -> lsp.DocumentDiagnosticReport:
        found = await server.checked(params.text_document.uri)
        return lsp.RelatedFullDocumentDiagnosticReport(list(map(server.diagnostic, found)))


def _hover(server: Server, params: lsp.HoverParams) -> lsp.Hover | None:
    robot, markup, offset = server.at(params.text_document.uri, params.position)
    diagnostics = server.robots.diagnostics(server.path(params.text_document.uri))
    text = hover.hover(robot, markup, offset, diagnostics)
    return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, text)) if text else None


def _definitions(server: Server, params: lsp.DefinitionParams) -> list[lsp.Location]:
    location = server.at(params.text_document.uri, params.position)
    return server.locations(navigation.definitions(*location))


def _references(server: Server, params: lsp.ReferenceParams) -> list[lsp.Location]:
    uri = params.text_document.uri
    spans = navigation.references(
        *server.at(uri, params.position),
        definitions=params.context.include_declaration,
        others=server.robots.other_robots(server.path(uri)),
    )
    return server.locations(spans)


def _symbols(server: Server, params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
    robot, markup = server.markup(params.text_document.uri)
    return [_symbol(server.encoding, entry) for entry in outline.outline(robot, markup)]


def _links(server: Server, params: lsp.DocumentLinkParams) -> list[lsp.DocumentLink]:
    robot, markup = server.markup(params.text_document.uri)
    return [
        lsp.DocumentLink(server.encoding.range(span), to_uri(path))
        for span, path in navigation.links(robot, markup)
    ]


def _inlay_hints(server: Server, params: lsp.InlayHintParams) -> list[lsp.InlayHint]:
    robot, markup, start = server.at(params.text_document.uri, params.range.start)
    end = server.encoding.offset(markup.source, params.range.end)
    return [
        lsp.InlayHint(server.encoding.position(markup.source, offset), text, padding_left=True)
        for offset, text in inlay_hints(robot, markup, start, end)
    ]


def _workspace_symbols(
    server: Server, params: lsp.WorkspaceSymbolParams
) -> list[lsp.WorkspaceSymbol]:
    """Symbols of the robots of all open files."""
    symbols = outline.symbols(server.robots.open_robots(), params.query)
    return [
        lsp.WorkspaceSymbol(
            server.encoding.location(span, server.uris), printable(name), _SYMBOLS[kind]
        )
        for kind, name, span in symbols
    ]


def _completions(server: Server, params: lsp.CompletionParams) -> list[lsp.CompletionItem]:
    robot, markup, offset = server.at(params.text_document.uri, params.position)
    offers = completion.complete(robot, markup, offset)
    encoding, source, snippets = server.encoding, markup.source, server.supports_snippets
    return [_item(encoding, source, offset, offer, snippets=snippets) for offer in offers]


def _rename_placeholder(
    server: Server, params: lsp.PrepareRenameParams
) -> lsp.PrepareRenamePlaceholder:
    name = navigation.renamable(*server.at(params.text_document.uri, params.position))
    return lsp.PrepareRenamePlaceholder(server.encoding.range(name.span), name.text)


def _rename(server: Server, params: lsp.RenameParams) -> lsp.WorkspaceEdit | None:
    location = server.at(params.text_document.uri, params.position)
    others = server.robots.other_robots(server.path(params.text_document.uri))
    try:
        return server.edit(navigation.rename(*location, params.new_name, others))
    except navigation.CannotRename as error:
        warning = lsp.ShowMessageParams(lsp.MessageType.Warning, str(error))
        server.window_show_message(warning)
        return None


def _format(server: Server, params: lsp.DocumentFormattingParams) -> list[lsp.TextEdit]:
    path = server.path(params.text_document.uri)
    return server.replaced(path, server.robots.formatted_text(path))


def _actions(server: Server, params: lsp.CodeActionParams) -> list[lsp.CodeAction]:
    path = server.path(params.text_document.uri)
    if any(kind.startswith("source") for kind in params.context.only or ()):
        return _fix_all(server, path)
    _, markup, start = server.at(params.text_document.uri, params.range.start)
    end = server.encoding.offset(markup.source, params.range.end)
    return [
        _action(server, action)
        for diagnostic in server.robots.diagnostics(path)
        if diagnostic.span.start <= end and start <= diagnostic.span.end
        for action in actions.actions(markup, diagnostic)
    ]


def _symbol(encoding: PositionEncoding, entry: outline.OutlineEntry) -> lsp.DocumentSymbol:
    range_ = encoding.range(entry.span)
    return lsp.DocumentSymbol(
        printable(entry.name),
        _SYMBOLS[entry.kind],
        range_,
        lsp.Range(range_.start, range_.start),
        detail=printable(entry.detail),
        children=[_symbol(encoding, child) for child in entry.children],
    )


def _item(
    encoding: PositionEncoding,
    source: Source,
    offset: int,
    offer: CompletionItem,
    *,
    snippets: bool,
) -> lsp.CompletionItem:
    at = encoding.range(Span(source, offer.start, offset))
    # Names of files and links may contain special characters; those of tags and attributes cannot.
    item = lsp.CompletionItem(
        printable(offer.text),
        kind=_ITEMS[offer.kind],
        detail=offer.detail or None,
        sort_text=f"{0 if offer.required else 1}{offer.text}",
        filter_text=offer.text,
        text_edit=lsp.TextEdit(at, escaped(offer.text)),
    )
    if snippets and offer.kind == "attribute" and _ends_a_name(source, offset):
        item.text_edit = lsp.TextEdit(at, f'{offer.text}="$1"')
        item.insert_text_format = lsp.InsertTextFormat.Snippet
    return item


def _ends_a_name(source: Source, offset: int) -> bool:
    """True if neither the rest of a name nor a value follows."""
    return re.match(rb"[\w:-]|\s*=", source.data[offset : offset + 20]) is None


def _action(server: Server, action: actions.QuickFix) -> lsp.CodeAction:
    return lsp.CodeAction(
        printable(action.title),
        lsp.CodeActionKind.QuickFix,
        [server.diagnostic(action.diagnostic)],
        action.preferred,
        edit=server.edit(action.edits),
    )


def _fix_all(server: Server, path: str) -> list[lsp.CodeAction]:
    """All safe fixes as one action; computed only on request, such as on saving."""
    changes = {
        server.uris.get(file) or to_uri(file): server.replaced(file, text)
        for file, text in server.robots.fixed(path).items()
    }
    if not changes:
        return []
    edit = lsp.WorkspaceEdit(changes)
    title = "Apply all safe fixes"
    return [lsp.CodeAction(title, lsp.CodeActionKind.SourceFixAll, edit=edit)]

"""Text in XML reports."""


def xml_text(text: str) -> str:
    """A text with ``?`` in place of characters that XML does not allow."""
    return "".join(
        char if char in "\t\n" or (char >= " " and not "\ud800" <= char <= "\udfff") else "?"
        for char in text
        if char not in "\ufffe\uffff"
    )

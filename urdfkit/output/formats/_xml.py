"""Text in reports that are XML."""


def xml_text(text: str) -> str:
    """A text without the characters that XML cannot hold."""
    return "".join(
        char if char in "\t\n" or (char >= " " and not "\ud800" <= char <= "\udfff") else "?"
        for char in text
        if char not in "\ufffe\uffff"
    )

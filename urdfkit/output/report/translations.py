"""The words of a page in the reader's language; what a rule says stays English."""

import json
import os

#: Languages by their code; English is the key that the others are found under.
LANGUAGES = ("en", "zh")
#: Severities after any number but 1.
PLURALS = {"error": "errors", "warning": "warnings", "info": "infos"}


class Translator:
    """Translates; a word without a translation stays as it is.

    Args:
        language: of `LANGUAGES`.
    """

    def __init__(self, language: str = "en") -> None:
        self.language = language
        self.known: dict[str, str] = {}
        if language != "en":
            directory = os.path.join(os.path.dirname(__file__), "languages")
            with open(os.path.join(directory, f"{language}.json"), encoding="utf-8") as file:
                self.known = json.load(file)

    def __call__(self, word: str) -> str:
        return self.known.get(word, word)

"""Translations of the texts of a page; messages of rules remain English."""

import json
import os

#: Language codes; the English texts are the keys of the translations.
LANGUAGES = ("en", "zh")
#: Plurals of severities.
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

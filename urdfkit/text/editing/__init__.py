"""Edits of texts that people wrote: comments, quotes and line ends stay as they are."""

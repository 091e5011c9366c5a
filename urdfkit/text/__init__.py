"""Texts and places in them: XML and YAML that know where they were written, and edits."""

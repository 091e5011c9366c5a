"""The XML text, independent of its content."""

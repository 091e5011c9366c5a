"""The mesh files and colours that a model names: their places, defects and placeholders."""

"""The mesh files and colours that a model names: where, what they hold, what stands in."""

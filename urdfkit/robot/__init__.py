"""What mechanics alone tells of a model: tree, frames, rigid bodies, shapes, loads."""

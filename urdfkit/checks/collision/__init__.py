"""Self-collision: overlapping collision geometry."""

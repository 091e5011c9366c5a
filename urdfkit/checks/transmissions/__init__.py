"""``<transmission>`` elements."""

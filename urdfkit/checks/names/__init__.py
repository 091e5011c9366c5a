"""Names of links, joints and materials, and references to them."""

"""The report of a robot: findings and computed properties, as one document for all outputs.

`describe` creates the document, a tree of plain values. ``html``, ``markdown``, ``json`` and
``csv`` write it, the viewer shows it live; none of them reads the robot itself.
"""

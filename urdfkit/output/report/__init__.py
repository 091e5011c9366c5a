"""The report of one robot: what was found and what was measured, as one document for all outputs.

`describe` gathers the document, a tree of plain values. ``html``, ``markdown``, ``json`` and
``csv`` write it, the viewer shows it live; none of them looks at the robot itself.
"""

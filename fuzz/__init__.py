"""Random damage to every kind of input: nothing may raise, die, hang, or take all memory.

``python -m fuzz HARNESS`` runs one harness; `docs/security.md` says what is expected of it.
"""

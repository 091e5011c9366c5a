"""BLAKE2, the hash of the caches.

Importing ``hashlib`` loads OpenSSL: 4 of the 13 ms that an unchanged robot takes. The module that
implements BLAKE2 is imported directly instead, as Python's ``random`` does for SHA-512.
"""

try:
    from _blake2 import blake2b
except ImportError:  # not CPython
    from hashlib import blake2b

__all__ = ["blake2b"]

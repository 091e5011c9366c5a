"""The hash by which caches look up contents.

Importing ``hashlib`` loads OpenSSL, which takes 4 of the 13 ms of an unchanged robot. It is done
without as Python's own ``random`` does.
"""

try:
    from _blake2 import blake2b
except ImportError:  # another Python
    from hashlib import blake2b

__all__ = ["blake2b"]

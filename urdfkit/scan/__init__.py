"""Checks of whole model collections: results in files, crashes isolated, runs resumable."""

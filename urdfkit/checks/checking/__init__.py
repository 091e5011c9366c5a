"""The checking itself: robots that are not checked, and comments that suppress findings."""

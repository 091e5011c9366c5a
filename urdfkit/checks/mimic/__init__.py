"""Joints that mimic other joints."""

"""What everything rests on: records, optional libraries, vectors, safe writing."""

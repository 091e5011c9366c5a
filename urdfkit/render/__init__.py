"""Pictures of robots, without a display, a graphics card or a graphics library."""

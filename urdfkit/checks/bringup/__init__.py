"""What the programs of a launch file read, publish and expect of one another."""

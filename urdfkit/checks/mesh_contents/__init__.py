"""Contents of the mesh files of a robot."""

"""The grammar of URDF: elements, attributes, values."""

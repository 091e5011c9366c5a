"""The formats that a robot can be converted to.

Each format has a module of its name here with a function ``write``, loaded when needed.
"""

#: The extra of urdfkit with the required libraries, by the format (the value of --to).
FORMATS = {"mjcf": "simulate", "usd": "usd", "sdf": "meshes", "urdf": "meshes"}

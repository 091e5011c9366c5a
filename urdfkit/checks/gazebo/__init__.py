"""The ``<gazebo>`` elements: references, tags, materials, frames."""

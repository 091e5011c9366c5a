"""The facts about Gazebo's materials hang together."""

from urdfkit.ros.catalog import data, materials


def test_a_material_follows_the_documented_fields() -> None:
    for name, material in materials.materials().items():
        assert material.name == name
        assert material.internal or name.startswith(("Gazebo/", "drc/"))
        assert len(material.rgba or "rgba") == 4, name
        assert len(material.gz_diffuse or "rgb") == 3, name
        values = (*(material.rgba or ()), *(material.gz_diffuse or ()))
        assert all(0 <= value <= 1 for value in values), name


def test_common_colours() -> None:
    known = materials.materials()
    assert known["Gazebo/Red"].rgba == (1.0, 0.0, 0.0, 1.0)
    assert known["Gazebo/Grey"].gz_diffuse == (0.5, 0.5, 0.5), (
        "Gazebo/GreyTransparent is found, too"
    )
    assert [known[name].is_textured for name in ("Gazebo/Wood", "Gazebo/Red")] == [True, False]
    assert "gazebo.material" in data("materials")["source"]

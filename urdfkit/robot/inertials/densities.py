"""Densities of robot materials, in kg/m³.

Solid material of common grades, rounded; printed parts with infill have less. Sources: metals from
the EN standards of their grades (aluminium 6061 2700, structural steel 7850, stainless 1.4301 7900,
titanium grade 5 4430, brass CW614N 8470); plastics from the data sheets of the common makers.
"""

DENSITIES = {
    "abs": 1040.0,
    "acrylic": 1180.0,
    "aluminium": 2700.0,
    "brass": 8470.0,
    "carbon-fibre": 1600.0,
    "copper": 8960.0,
    "epoxy-glass": 1850.0,
    "foam": 30.0,
    "magnesium": 1780.0,
    "nylon": 1140.0,
    "petg": 1270.0,
    "pla": 1240.0,
    "plywood": 650.0,
    "polycarbonate": 1200.0,
    "pom": 1410.0,
    "rubber": 1150.0,
    "stainless": 7900.0,
    "steel": 7850.0,
    "titanium": 4430.0,
    "water": 1000.0,
}

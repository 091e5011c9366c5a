"""xacro: macros, properties, arguments, expressions."""

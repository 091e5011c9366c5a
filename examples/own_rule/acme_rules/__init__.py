"""The rules of our workshop: one module each, named after its code and its defect."""

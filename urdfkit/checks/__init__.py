"""One rule per file, named by its code: the listing of this folder is the catalogue."""

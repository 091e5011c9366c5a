"""One rule per file, named by its code: the listing of this directory is the catalogue."""

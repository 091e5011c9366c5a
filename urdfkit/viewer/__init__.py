"""The viewer: a robot in the browser, updated whenever a file is saved."""

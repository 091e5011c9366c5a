"""The viewer: a robot in the browser, sent anew whenever a file is saved."""

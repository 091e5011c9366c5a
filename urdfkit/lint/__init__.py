"""The checking: rules, their context, the runner, fixes, suppression."""

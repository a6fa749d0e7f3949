"""Errors that a user can mend."""


class BadInput(Exception):
    """What was found and expected; exit status 2."""

"""The exceptions of the package."""


class Error(Exception):
    """What the package raises. Its text names the argument or file, the place in it, what was found and what is expected.

    `kind` is "bad_input" (a mesh, a file or a camera's place is wrong), "usage" (an option is wrong), "io" (a file cannot be
    read) or "cancelled".
    """

    __module__ = "sightline"

    def __init__(self, message, kind="bad_input"):
        super().__init__(message)
        self.kind = kind


class InputError(Error, ValueError):
    """An argument, a mesh or a file's contents are wrong: kind "bad_input" or "usage"."""

    __module__ = "sightline"


class FileError(Error, OSError):
    """A file cannot be read: kind "io"."""

    __module__ = "sightline"

    def __init__(self, message, kind="io"):
        super().__init__(message, kind)


class Cancelled(Error):
    """A progress function returned False: kind "cancelled"."""

    __module__ = "sightline"

    def __init__(self, message="cancelled", kind="cancelled"):
        super().__init__(message, kind)

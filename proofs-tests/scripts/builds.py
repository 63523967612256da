"""Which build a test has before it."""
import pathlib
import unittest


def is_sanitized(program):
    return b"__asan_init" in pathlib.Path(program).read_bytes()


def once(program):
    """Marks tests that fit or decide many cases of what others do with one: the sanitized build, which takes many times as long, leaves them out."""
    return unittest.skipIf(is_sanitized(program), "many cases of what others show of one")

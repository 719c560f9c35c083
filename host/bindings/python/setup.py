# Makes a wheel of this folder in the build, where CMake has put the compiled module: `tools/dev python` calls it. All else is in
# pyproject.toml.
from setuptools import Distribution, setup


class CompiledDistribution(Distribution):
    """A wheel for one version of Python and one platform, although setuptools compiles nothing."""

    def has_ext_modules(self):
        return True


setup(distclass=CompiledDistribution)

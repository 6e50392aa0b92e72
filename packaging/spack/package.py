"""Builds the C libraries with Spack, and with +python the Python client. `spack develop` builds it from the sources.
For a submission, a version needs the address of the release's archive and its SHA-256. docs/plugged-in.md lists the
parts that were tested here."""
# ruff: noqa: F403, F405, RUF012

from spack.package import *  # is the convention of recipes for Spack


class Contactd(CMakePackage):
    """Elastic contact with friction, rolling, and wheels on rails, by the boundary element method with influence coefficients in
    closed form, of layers, or from tables."""

    license("BSD-3-Clause", checked_by="the contactd authors")

    version("0.1.0")

    variant("fftw", default=False, description="Transforms by FFTW, under whose licence binaries come then; else by ducc0's FFT")
    variant("python", default=False, description="The client of Python")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("eigen@3.4:")
    depends_on("hdf5+cxx~mpi")
    depends_on("libsodium")
    depends_on("nlohmann-json")
    depends_on("reproc")
    depends_on("fftw@3:~mpi", when="+fftw")
    depends_on("libzmq")
    depends_on("cppzmq")
    depends_on("python@3.10:", when="+python", type=("build", "run"))
    depends_on("py-pip", when="+python", type="build")
    depends_on("py-setuptools@77:", when="+python", type="build")
    depends_on("py-numpy@1.24:", when="+python", type="run")
    depends_on("py-pyzmq@24:", when="+python", type="run")

    extends("python", when="+python")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define("CONTACTD_FEM", False),
            self.define("CONTACTD_SERVER", False),
            self.define("CONTACTD_TESTS", False),
            self.define("CONTACTD_FFT", "fftw" if self.spec.satisfies("+fftw") else "ducc0"),
        ]

    build_targets = ["contactd_c", "contactd_local_c", "contactd_cntc"]

    def install(self, spec, prefix):
        with working_dir(self.build_directory):
            for component in ("c_library", "c_local_library", "c_development", "cntc", "cntc_development"):
                cmake("--install", ".", "--component", component)

    @run_after("install")
    def install_client(self):
        if self.spec.satisfies("+python"):
            with working_dir(join_path(self.stage.source_path, "client", "python")):
                pip("install", "--no-deps", "--no-build-isolation", f"--prefix={self.prefix}", ".")

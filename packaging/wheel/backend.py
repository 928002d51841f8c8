# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a wheel of the Python module, as pip asks for it (PEP 517). CMake builds it, with what the
public face needs and no more; it wants CMake, a compiler, CGAL, Eigen, Boost, nlohmann-json,
pybind11, and zlib and expat as static libraries, but no other Python package.

    pip wheel . [--config-settings build-dir=FOLDER] [--config-settings threads=N]
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class UnsupportedOperation(Exception):
    """What pip is told where there is no source distribution."""


def version():
    text = (ROOT / "CMakeLists.txt").read_text("utf-8")
    return re.search(r"project\(sonde VERSION (\S+)", text).group(1)


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


def metadata():
    return "\n".join(
        [
            "Metadata-Version: 2.1",
            "Name: sonde",
            f"Version: {version()}",
            "Summary: Generalized penetration depth of two polygon soups",
            "License: GPL-3.0-or-later",
            "Requires-Python: >=3.9",
            "Requires-Dist: numpy",
            "Description-Content-Type: text/markdown",
            "",
            (ROOT / "README.md").read_text("utf-8"),
        ]
    )


def build(folder, threads):
    """The files of the module, by their names in the wheel."""
    run = lambda *command: subprocess.run(command, check=True, stdout=sys.stderr)
    run(
        "cmake", "-S", str(ROOT), "-B", str(folder), "-Wno-dev", "-DCMAKE_BUILD_TYPE=Release",
        "-DSONDE_FACE_ONLY=ON", "-DSONDE_BUILD_PYTHON=ON", "-DSONDE_BUILD_VIEW=OFF",
        "-DSONDE_BUILD_TESTS=OFF", "-DSONDE_INSTALL=OFF", "-DCMAKE_UNITY_BUILD=ON",
        f"-DPython3_EXECUTABLE={sys.executable}",
        "-DCMAKE_SHARED_LINKER_FLAGS=-s", "-DCMAKE_MODULE_LINKER_FLAGS=-s",
    )  # fmt: skip
    run("cmake", "--build", str(folder), "--target", "sonde_python", "-j", str(threads))
    module = Path(folder) / "python" / "sonde"
    return {f"sonde/{file.name}": file.read_bytes() for file in sorted(module.iterdir())
            if file.is_file()}


def digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode().rstrip("=")


def write(file, contents):
    """A wheel: a ZIP with a record of what is in it, the same bytes for the same contents."""
    info = f"sonde-{version()}.dist-info"
    contents = dict(contents)
    contents[f"{info}/METADATA"] = metadata().encode()
    contents[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    contents[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: sonde\nRoot-Is-Purelib: false\nTag: {tag()}\n"
    ).encode()
    record = [f"{name},sha256={digest(data)},{len(data)}" for name, data in contents.items()]
    contents[f"{info}/RECORD"] = "\n".join([*record, f"{info}/RECORD,,", ""]).encode()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in contents.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            archive.writestr(entry, data)


def get_requires_for_build_wheel(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    name = f"sonde-{version()}.dist-info"
    folder = Path(metadata_directory) / name
    folder.mkdir()
    (folder / "METADATA").write_text(metadata(), "utf-8")
    (folder / "WHEEL").write_text(f"Wheel-Version: 1.0\nTag: {tag()}\n", "utf-8")
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    threads = settings.get("threads", os.cpu_count() or 1)
    name = f"sonde-{version()}-{tag()}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        contents = build(Path(settings.get("build-dir", temporary)).resolve(), threads)
    write(Path(wheel_directory) / name, contents)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("the sources are the repository")

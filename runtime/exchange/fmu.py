"""A model with the numbers of an aircraft as a component of the Functional Mock-up Interface."""

from __future__ import annotations

import hashlib
import platform
import sys
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree as ET

from groundroll.base.errors import GroundrollError
from groundroll.base.files import complete
from groundroll.generated.compiler import NoCompilerError, compiler, make

from .c_code import c_facts, rendered
from .fmi_description import description, xml
from .fmi_variables import variables
from .subject import Subject

_HERE = Path(__file__).parent / "fmi"
#: It goes to other machines, so that no processor of this one may be asked for.
_FLAGS = (
    *("-O2", "-std=c99", "-ffp-contract=off", "-fPIC", "-shared", "-fvisibility=hidden"),
    *(("-s",) if sys.platform != "darwin" else ()),
)
_MACHINES = {"AMD64": "x86_64", "arm64": "aarch64", "i386": "x86", "i686": "x86"}
_SYSTEMS = {"darwin": ("darwin", ".dylib"), "win32": ("windows", ".dll")}
#: What FMI 2.0 calls a machine; it has no words for others.
_IN_2 = {
    "x86_64-linux": "linux64",
    "x86-linux": "linux32",
    "x86_64-darwin": "darwin64",
    "x86_64-windows": "win64",
    "x86-windows": "win32",
}
#: Time stamp of everything in the archive, so that equal components are equal files.
_THEN = (1980, 1, 1, 0, 0, 0)


def write_fmu(subject: Subject, path: Path, fmi: str) -> None:
    """Write a component, compiled for this machine, with its source.

    Parameters
    ----------
    subject : Subject
    path : Path
    fmi : str
        Version of the interface, ``"2.0"`` or ``"3.0"``.

    Raises
    ------
    GroundrollError
        If there is no C compiler, or the file cannot be written.
    """
    name = subject.model.name
    identifier = name if name.isascii() else "model"
    listed = variables(subject)
    sources = _sources(subject, fmi)
    untold = description(subject, listed, fmi, identifier, "")
    digest = hashlib.sha256(b"\0".join([untold, *sources.values()])).hexdigest()
    token = f"{{{digest[:8]}-{digest[8:12]}-{digest[12:16]}-{digest[16:20]}-{digest[20:32]}}}"
    sources["token.h"] = f'#define TOKEN "{token}"\n'.encode()
    machine, suffix = this_machine()
    place = machine if fmi == "3.0" else _IN_2.get(machine, machine)
    files = {
        "modelDescription.xml": description(subject, listed, fmi, identifier, token),
        **{f"sources/{name}": text for name, text in sources.items()},
        "documentation/licenses/FMI.txt": _licence(),
        f"binaries/{place}/{identifier}{suffix}": _compiled(sources, identifier, suffix),
    }
    if fmi == "3.0":
        files["sources/buildDescription.xml"] = _build_description(identifier)
    with complete(path) as draft, zipfile.ZipFile(draft, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name, _THEN)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.startswith("binaries") else 0o644) << 16
            archive.writestr(entry, data)


def this_machine() -> tuple[str, str]:
    """What FMI 3.0 calls this machine, and the suffix of its libraries."""
    machine = platform.machine()
    system, suffix = _SYSTEMS.get(sys.platform, ("linux", ".so"))
    return f"{_MACHINES.get(machine, machine)}-{system}", suffix


def _sources(subject: Subject, fmi: str) -> dict[str, bytes]:
    """The C files by name; ``all.c`` includes the others."""
    facts = c_facts(subject, "model")
    number = fmi[0]
    texts = {
        "model.h": rendered("model.h", facts),
        "model.c": rendered("model.c", facts),
        "parameters.c": rendered("parameters.c", facts),
        "all.c": f'#include "model.c"\n#include "parameters.c"\n#include "fmi{number}.c"\n',
    }
    shipped = ["component.c", *(path.name for path in sorted(_HERE.glob(f"fmi{number}*")))]
    return {
        **{name: text.encode() for name, text in texts.items()},
        **{name: (_HERE / name).read_bytes() for name in shipped},
    }


def _licence() -> bytes:
    return (_HERE / "LICENSE.txt").read_bytes()


def _build_description(identifier: str) -> bytes:
    """How FMI 3.0 is told what to compile."""
    root = ET.Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = ET.SubElement(root, "BuildConfiguration", modelIdentifier=identifier)
    files = ET.SubElement(configuration, "SourceFileSet", language="C99")
    ET.SubElement(files, "SourceFile", name="all.c")
    return xml(root)


def _compiled(sources: Mapping[str, bytes], identifier: str, suffix: str) -> bytes:
    """The library, compiled beside its sources."""
    try:
        command, _ = compiler(_FLAGS)
        with tempfile.TemporaryDirectory(prefix="groundroll-") as folder:
            for name, text in sources.items():
                (Path(folder) / name).write_bytes(text)
            product = Path(folder) / f"{identifier}{suffix}"
            symbol = "fmi3GetVersion" if "fmi3.c" in sources else "fmi2GetVersion"
            make(command, _FLAGS, Path(folder) / "all.c", product, symbol)
            return product.read_bytes()
    except NoCompilerError as problem:
        raise GroundrollError(
            f"a component needs a C compiler to be made: {problem}; --to c needs none"
        ) from problem

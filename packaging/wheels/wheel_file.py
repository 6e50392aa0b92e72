"""A wheel (PEP 427): a zip of files, with metadata and a list of their digests. The same bytes for the same content."""

from __future__ import annotations

import base64
import hashlib
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

__all__ = ["Wheel"]

_EPOCH = (1980, 1, 1, 0, 0, 0)


@dataclass
class Wheel:
    """What goes into one. Names of files are those of the wheel, with `/` between folders.

    Attributes:
        name: Of the distribution, such as contactd-local.
        version, summary, license: As in the metadata.
        tag: What it runs on, such as py3-none-any.
        readme: Its page, in Markdown.
        files: name -> content.
        programs: Names of those that are executable.
        scripts: Of the environment's bin folder: name -> "module:function".
        licenses: name -> text; in the metadata, where pip leaves them.
    """

    name: str
    version: str
    summary: str
    license: str
    tag: str
    readme: str
    files: dict[str, bytes] = field(default_factory=dict)
    programs: set[str] = field(default_factory=set)
    scripts: dict[str, str] = field(default_factory=dict)
    licenses: dict[str, str] = field(default_factory=dict)

    def write(self, folder: Path) -> Path:
        """The wheel in `folder`, in the place of earlier ones of this distribution."""
        stem = self.name.replace("-", "_")
        for old in folder.glob(f"{stem}-*.whl"):
            old.unlink()
        path = folder / f"{stem}-{self.version}-{self.tag}.whl"
        info = f"{stem}-{self.version}.dist-info"
        content = {**self.files, **{f"{info}/{name}": text.encode() for name, text in self._metadata().items()}}
        record = f"{info}/RECORD"
        lines = [f"{name},sha256={_digest(data)},{len(data)}\n" for name, data in content.items()]
        content[record] = "".join([*lines, f"{record},,\n"]).encode()
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=6) as archive:
            for name, data in content.items():
                entry = zipfile.ZipInfo(name, _EPOCH)
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = (0o100755 if name in self.programs else 0o100644) << 16
                archive.writestr(entry, data)
        return path

    def _metadata(self) -> Mapping[str, str]:
        python, abi, platforms = self.tag.split("-")
        head = {
            "Metadata-Version": "2.1", "Name": self.name, "Version": self.version, "Summary": self.summary,
            "License": self.license, "Requires-Python": ">=3.10",
        }  # fmt: skip
        lines = [f"{key}: {value}" for key, value in head.items()]
        lines += [f"License-File: {name}" for name in self.licenses]
        lines += ["Description-Content-Type: text/markdown", "", self.readme]
        tags = [f"Tag: {python}-{abi}-{platform}" for platform in platforms.split(".")]
        wheel = ["Wheel-Version: 1.0", "Generator: contactd", "Root-Is-Purelib: false", *tags]
        texts = {f"licenses/{name}": text for name, text in self.licenses.items()}
        texts |= {"METADATA": "\n".join(lines), "WHEEL": "\n".join(wheel) + "\n"}
        if self.scripts:
            points = [f"{name} = {target}\n" for name, target in self.scripts.items()]
            texts["entry_points.txt"] = "[console_scripts]\n" + "".join(points)
        return texts


def _digest(data: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()

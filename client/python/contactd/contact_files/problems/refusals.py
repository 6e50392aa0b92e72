"""Errors of a set-up in the names of the file from which it was made."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ...errors import InvalidArgument
    from ...values.generated.contact_files import ContactCase as Case

__all__ = ["in_words_of"]

_BOTH = {
    "bodies.upper.nu": "POISS1", "bodies.lower.nu": "POISS2", "bodies.upper.G": "GG1", "bodies.lower.G": "GG2",
    "friction.mu": "FSTAT, FKIN",
}  # fmt: skip
_ON_RAILS = {
    "dx": "DX", "dy": "DS", "dq": "DQREL", "patches.angle_separate": "A_SEP", "patches.distance_separate": "D_SEP",
    "patches.distance_combine": "D_COMB", "patches.distance_turn": "D_TURN", "track.gauge": "GAUGWD", "track.gauge_height": "GAUGHT",
    "track.cant": "CANT", "track.roller_radius": "NOMRADR", "track.springs.y": "KYRAIL", "track.springs.z": "KZRAIL",
    "wheelset.nominal_radius": "NOMRADW", "wheelset.flange_back_distance": "FBDIST", "wheelset.flange_back_position": "FBPOS",
    "rail.file": "RFNAME, MIRRORY, SCALE, SMOOTH", "wheel.file": "WFNAME, MIRRORY, SCALE, SMOOTH",
    "rail_slices": "RFNAME", "wheel_slices": "WFNAME", "Fz": "FZ", "position.x": "S", "position.y": "Y", "position.z": "Z",
    "position.roll": "ROLL", "position.yaw": "YAW", "position.pitch": "PITCH", "velocity.x": "VS", "velocity.y": "VY",
    "velocity.z": "VZ", "velocity.roll": "VROLL", "velocity.yaw": "VYAW", "velocity.pitch": "VPITCH",
    "rail.y": "DYRAIL", "rail.z": "DZRAIL", "rail.roll": "DROLLR",
}  # fmt: skip
_ALONE = {
    "grid.nx": "MX", "grid.ny": "MY", "grid.dx": "DX", "grid.dy": "DY", "Fn": "FN", "approach": "PEN",
    "friction.rolling.chi": "CHI", "friction.rolling.dq": "DQ", "friction.rolling.velocity": "VELOC", "friction.rolling.xi": "CKSI",
    "friction.rolling.eta": "CETA", "friction.rolling.phi": "CPHI",
}  # fmt: skip


def in_words_of(case: Case, error: InvalidArgument) -> str:
    """Returns the sentence of an outcome, with the name of each field in the file, if it has one."""
    names = {**_BOTH, **(_ON_RAILS if case.module == 1 else _ALONE)}
    sentences = []
    for violation in error.violations:
        field = violation.field.removeprefix("setup.").removeprefix("state.")
        name = next((names[start] for start in _starts_of(field) if start in names), "")
        sentences.append(f"{name} ({violation.field}) {violation.description}" if name else f"{violation.field} {violation.description}")
    return "; ".join(sentences) + "." if sentences else str(error)


def _starts_of(field: str) -> list[str]:
    """Yields the path itself, that of its parent, and so on."""
    parts = field.split(".")
    return [".".join(parts[:count]) for count in range(len(parts), 0, -1)]

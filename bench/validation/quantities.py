"""Lists the compared numbers: their names here, and their labels in the output of the CONTACT program."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from contactd.contact_files.comparison import Difference

__all__ = ["GROUPS", "QUANTITIES", "Quantity", "by_quantity"]


@dataclass(frozen=True)
class Quantity:
    """Describes a number that both programs print.

    Attributes:
        name: Name of its columns `name_printed`, `name` and `name_over`.
        labels: Labels of CONTACT, of which a case has one.
        group: The place in pictures.
    """

    name: str
    labels: tuple[str, ...]
    group: str


_FORCES, _MOMENT, _MOTION, _APPROACH = "forces", "spin\nmoment", "creepages,\nspin", "approach"
_PRESSURE, _ELEMENTS, _PLACE, _ANGLE = "largest\npressure", "numbers of\nelements", "places", "angles"
GROUPS = (_FORCES, _MOMENT, _MOTION, _APPROACH, _PRESSURE, _ELEMENTS, _PLACE, _ANGLE)

QUANTITIES = (
    Quantity("Fn", ("FN", "BAR_FN"), _FORCES),
    Quantity("Fx", ("FX", "BAR_FX"), _FORCES),
    Quantity("Fy", ("FY", "FS", "BAR_FS"), _FORCES),
    Quantity("Mz", ("MZ", "MN"), _MOMENT),
    Quantity("xi", ("CKSI", "CREEP X", "SHIFT X"), _MOTION),
    Quantity("eta", ("CETA", "CREEP Y", "SHIFT Y"), _MOTION),
    Quantity("phi", ("CPHI",), _MOTION),
    Quantity("approach", ("APPROACH",), _APPROACH),
    Quantity("pmax", ("PMAX",), _PRESSURE),
    Quantity("contact", ("NCON",), _ELEMENTS),
    Quantity("adhesion", ("NADH",), _ELEMENTS),
    Quantity("slip", ("NSLIP",), _ELEMENTS),
    Quantity("plastic", ("NPLAST",), _ELEMENTS),
    Quantity("x", ("XCP(TR)",), _PLACE),
    Quantity("y", ("YCP(TR)",), _PLACE),
    Quantity("z", ("ZCP(TR)",), _PLACE),
    Quantity("angle", ("DELTCP(TR)",), _ANGLE),
    Quantity("position_z", ("Z_WS",), _PLACE),
    Quantity("pitch_rate", ("VPITCH_WS",), _MOTION),
    Quantity("track_Fx", ("FX(TR)",), _FORCES),
    Quantity("track_Fy", ("FY(TR)",), _FORCES),
    Quantity("track_Fz", ("FZ(TR)",), _FORCES),
    Quantity("wheelset_Fx", ("FX(WS)",), _FORCES),
    Quantity("wheelset_Fy", ("FY(WS)",), _FORCES),
    Quantity("wheelset_Fz", ("FZ(WS)",), _FORCES),
)
_BY_LABEL = {label: quantity for quantity in QUANTITIES for label in quantity.labels}


def by_quantity(differences: Iterable[Difference]) -> dict[str, Difference]:
    """Returns differences by the names of their quantities."""
    return {_BY_LABEL[one.name].name: one for one in differences if one.name in _BY_LABEL}

"""Creates the cases: a number of each kind, in random order, each with its own generator."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from . import contacts, motions, refusals, sessions, tables
from .contacts import Play
from .dice import Dice

Make = Callable[[Dice], Play]

_OF_FASTSIM = motions.without(motions.rolling, "kinetic", "chi")


def _any_friction(dice: Dice) -> motions.MakeFriction:
    return dice.choice([motions.shift, motions.rolling, motions.transient])


def _half_spaces(make: motions.MakeFriction) -> Make:
    return lambda dice: contacts.with_friction(dice, contacts.half_spaces(dice), make)


def _in_a_line(dice: Dice) -> motions.MakeFriction:
    return motions.without(_any_friction(dice), "phi", "rotation", "chi")


def _of_hertz(dice: Dice) -> motions.MakeFriction:
    make = dice.choice([motions.shift, motions.rolling])
    return motions.without(make, "kinetic", "chi", "phi", "spin_offset", "rotation")


#: Maps kinds to the number of cases among 300 and the function that creates one.
KINDS: dict[str, tuple[int, Make]] = {
    "normal contact": (20, lambda dice: contacts.normal(dice, contacts.half_spaces(dice))),
    "shift": (30, _half_spaces(motions.shift)),
    "steady rolling": (30, _half_spaces(motions.rolling)),
    "transient rolling": (25, _half_spaces(motions.transient)),
    "line contact": (15, lambda dice: contacts.with_friction(dice, contacts.line_contact(dice), _in_a_line(dice))),
    "given table": (15, lambda dice: contacts.given_table(dice, _any_friction(dice))),
    "hertz": (10, lambda dice: contacts.quick(dice, "hertz", _of_hertz(dice))),
    "fastsim": (15, lambda dice: contacts.quick(dice, "fastsim", _OF_FASTSIM)),
    "many at once": (10, contacts.many),
    "contact of finite elements": (5, tables.contact_of_fem),
    "session": (25, lambda dice: sessions.full(dice, _any_friction(dice))),
    "session of a quick model": (8, lambda dice: sessions.quick(dice, "fastsim", _OF_FASTSIM)),
    "subsurface stresses": (12, tables.subsurface),
    "closed-form table": (10, tables.get_analytic),
    "exported table": (10, tables.export),
    "finite-element table": (25, tables.get_fem),
    "list of the store": (3, tables.stored),
    "impossible table": (12, refusals.impossible_tables),
    "damaged request": (20, refusals.damaged),
}
#: Lists the kinds whose tables are in the store.
STORED = ("finite-element table", "contact of finite elements")


@dataclass(frozen=True)
class Case:
    number: int
    kind: str
    seed: str

    def play(self) -> Play:
        """Plays the case from its beginning; each of its requests may depend on earlier answers."""
        return KINDS[self.kind][1](Dice(self.seed))


def cases(count: int, seed: int) -> list[Case]:
    """Returns the first `count` cases; each 300 of them contain every kind as often as KINDS states."""
    kinds = [kind for kind, (often, _) in KINDS.items() for _ in range(often)]
    order = Dice(seed)
    drawn: list[str] = []
    while len(drawn) < count:
        order.shuffle(kinds)
        drawn += kinds
    return [Case(number, kind, f"{seed}/{number}") for number, kind in enumerate(drawn[:count], 1)]

"""Writes one case of a history as an input file of the CONTACT program that requires no earlier case."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

from contactd.contact_files.case import Case

__all__ = ["kept", "text_of"]

Line = Iterable[Any]

_AREAS = {-6: "AA BNEG BPOS SCALE", -5: "AA BB SCALE", -4: "A1 BB SCALE", -3: "AA BB SCALE", -2: "A1 AOB SCALE",
          -1: "A1 B1 SCALE", 1: "XL YL DX DY", 2: "XL YL XH YH", 3: "XC1 YC1 DX DY", 4: "XC1 YC1 XCM YCM"}  # fmt: skip
_BASES = {1: "B1 B2 B3 B4 B5 B6", 3: "B1 B2 B3 B4 B5 B6 B7 B8"}
_PLANS = {2: "P1 P2 P3 P4 P5 P6", 3: "XL1 XH1 YL1 YH1 XL2 XH2 YL2 YH2"}
_BODIES = {1: "FG1 FG2 TC1 TC2", 2: "FLX K0 ALFA BETA", 3: "K0 ALFA BETA", 4: "GG3 LAYTHK TAU_C0 K_TAU", 5: "K0 ALFA BETA"}
_OPTIONS = {2: "OMEGAH OMEGAS INISLP OMGSLP", 3: "OMEGAH OMEGAS INISLP OMGSLP", 4: "INISLP OMGSLP",
            5: "FDECAY BETATH KDOWFB D_IFC D_LIN D_CNS D_SLP POW_S"}  # fmt: skip
_LAWS = {0: "FSTAT FKIN", 6: "FREF TREF DFHEAT DTHEAT"}
_PLACES = {1: "ALPHVF", 2: "SVF"}
_HEAT = "BKTEMP{0} HEATCP{0} LAMBDA{0} DENS{0}"
_DEVIATIONS = "DXWHL DYWHL DZWHL DROLLW DYAWW DPITCHW", "VXWHL VYWHL VZWHL VROLLW VYAWW VPITCHW"
_ROLLER = 4  #: C1
_ON_A_LINE = 6
#: These digits select the values that are read or kept. A case in the text either contains the values in force or does
#: not depend on them.
_KEPT = ("P", "I", "S", "V", "L", "D", "C", "Z", "E", "G", "H", "X", "A", "O", "W", "R", "M2")


def kept(case: Case, folder: Path) -> dict[str, Any]:
    """Returns everything that the text of a case must preserve, with files by their names relative to `folder`."""
    digits = {name: digit for name, digit in case.digits.items() if name not in _KEPT}
    idle = set(_idle(case))
    values = {name: value for name, value in case.values.items() if name not in idle}
    values |= {name: str(_path(folder, values[name])) for name in ("RFNAME", "WFNAME", "CFNAME") if name in values}
    blocks = [{name: value for name, value in block.items() if name != "ISUBS"} for block in case.subsurface]
    return {"digits": digits, "values": values, "friction": case.friction, "blocks": blocks if case.digits["S"] else []}


def _idle(case: Case) -> Iterator[str]:
    """Yields values in memory that do not affect the case."""
    digits, values = case.digits, case.values
    for names in {*_BODIES.values()} - {_BODIES.get(digits["M"], "")}:
        yield from set(names.split()) - set(_BODIES.get(digits["M"], "").split())
    if values.get("INISLP", 0) >= 0:
        yield from set(" ".join(_OPTIONS.values()).split()) - set(_OPTIONS.get(values["GAUSEI"], "").split())
    if digits["T"] == 0:
        yield from ("CHI", "DQ", "VELOC")
    if digits["T"] < 2:
        yield "FACPHI"
    if digits["B"] != 1:
        yield "FLXZ"
    if digits["F"] != 3:
        yield from ("KYRAIL", "FYRAIL", "KZRAIL", "FZRAIL", "DYSTEP0")
    if digits["E"] == 0 or values.get("EXRHS") != 9:
        yield from ("SLIP_X", "SLIP_Y")
    if digits["E"] == 0:
        yield "EXRHS"
    if digits["S"] == 0:
        yield from ("SUBS_A", "SUBS_O")
    if values["FRCLAW"] == 0:
        yield from ("MEMDST", "MEM_S0")
    if digits.get("C1", 0) >= _ROLLER and values.get("CANT") == 0:
        yield "CANT"


def _path(folder: Path, name: Any) -> Path:
    return folder / str(name).replace("\\", "/")


def text_of(case: Case, folder: Path, is_first: bool = True) -> str:
    """The text. Profiles and coefficients get their names from `folder` on. P is 2 and I is 0, as of every first case; others
    have their own P, I, A and O, and no end."""
    lines = [*(_OnRails if case.module == 1 else _Basic)(case, folder, is_first).lines(), *([[0, "MODULE"]] if is_first else [])]
    return "".join(f"{' '.join(_word(word) for word in line)}\n" for line in lines)


def _word(word: Any) -> str:
    return repr(word) if isinstance(word, float) else str(word)


class _Text:
    def __init__(self, case: Case, folder: Path, is_first: bool) -> None:
        self.case, self.digits, self.values, self.folder = case, case.digits, case.values, folder
        self.previous, self.estimate, self.files, self.prints = (
            (2, 0, 0, 0) if is_first else (case.digits[name] for name in ("P", "I", "A", "O"))
        )  # fmt: skip
        self.module = f"{case.module} MODULE" if is_first or case.reid is None else f"{case.module} {case.reid} {case.cpid or ''}"

    def named(self, names: str) -> list[Any]:
        return [self.values[name] for name in names.split()]

    def file(self, name: str) -> str:
        return f"'{_path(self.folder, self.values[name])}'"

    def bounds(self) -> Iterator[Line]:
        yield self.named("MAXGS MAXIN MAXNR MAXOUT EPS" + (" NPOT_MAX" if self.case.module == 1 else ""))
        if options := _OPTIONS.get(self.values["GAUSEI"]):
            yield self.named(options)

    def third_word(self) -> Line:
        heat = 3 if self.digits["H"] else 0
        return [f"0{heat}{self.values['GAUSEI']}{self.estimate}{self.files}{self.prints}01"]

    def damping(self) -> str:
        has_values = self.digits["M2"] != 0 and "CDAMPN" in self.values
        return f"{self.digits['W2']}{2 if has_values else self.digits['M2']}"

    def bodies(self) -> Iterator[Line]:
        yield self.named("POISS1 POISS2 GG1 GG2")
        if self.digits["B"] == 1:
            yield self.named("FLXZ")
        if (constants := _BODIES.get(self.digits["M"])) is not None:
            yield self.named(constants)
        if self.digits["M2"] != 0 and "CDAMPN" in self.values:
            yield self.named("CDAMPN CDAMPT DFNMAX DFTMAX")
        if self.digits["H"] != 0:
            yield self.named(_HEAT.format(1))
            yield self.named(_HEAT.format(2))
            if self.digits["M"] == 4:
                yield self.named("BETAPL")

    def friction(self) -> Iterator[Line]:
        law, varies = self.values["FRCLAW"], self.values["VARFRC"]
        names = _LAWS.get(law, "FKIN F1 SABSH1 F2 SABSH2")
        if varies in _PLACES:
            names = f"{_PLACES[varies]} {names}"
            yield [len(self.case.friction)]
        for one in self.case.friction:
            yield [one[name] for name in names.split()]
        if law != 0:
            yield [self.values.get("MEMDST", 0.0), self.values.get("MEM_S0", 1.0)]

    def blocks(self) -> Iterator[Line]:
        if self.digits["S"] == 0:
            return
        yield [self.values.get("SUBS_A", 0), self.values.get("SUBS_O", 0)]
        for block in self.case.subsurface:
            yield from self._block(block)
        yield [0]

    def _block(self, block: Mapping[str, Any]) -> Iterator[Line]:
        axes = ("X", "Y", "Z") if "X" in block else ("IX", "IY", "Z") if "IX" in block else ("Z",)
        yield [{3: 9 if "X" in block else 7, 1: 5}[len(axes)]]
        sizes = [len(block[axis]) for axis in axes]
        if "IX" in block:
            yield sizes[:2]
            yield from _many(map(int, [*block["IX"]]))
            yield from _many(map(int, [*block["IY"]]))
            yield sizes[2:]
        else:
            yield sizes
            for axis in axes[:-1]:
                yield from _many(block[axis])
        yield from _many(block["Z"])


class _Basic(_Text):
    def lines(self) -> Iterator[Line]:
        digit, values = self.digits, self.values
        yield [self.module]
        yield [f"{self.previous}{digit['B']}{digit['T']}{digit['N']}{digit['F']}{3 if digit['S'] else 0}"]
        yield [f"{values['VARFRC']}{values['FRCLAW']}2{values['INFLCF']}{digit['M']}2{self.extra_slip()}", self.damping()]
        yield self.third_word()
        yield from self.bounds()
        motion = f"{'FX' if digit['F'] else 'CKSI'} {'FY' if digit['F'] == 2 else 'CETA'} CPHI SPINXO SPINYO"
        yield self.named(f"{'FN' if digit['N'] else 'PEN'} {motion}")
        if values["VARFRC"] != 3:
            yield from self.friction()
        if digit["T"] >= 2:
            yield [*self.named("CHI DQ VELOC"), *([values["FACPHI"]] if "FACPHI" in values else [])]
        if values["INFLCF"] == 9:
            yield [self.file("CFNAME")]
        if values["INFLCF"] == 4:
            yield [*self.named("IF_METH VARIANT"), len(values["ANGLE"])]
            yield from zip(values["ANGLE_Y"], values["ANGLE"])
        yield from self.bodies()
        yield from self.area()
        if values["VARFRC"] == 3:
            yield from self.friction()
        if self.extra_slip() == 9:
            yield from _many(part for pair in zip(values["SLIP_X"], values["SLIP_Y"]) for part in pair)
        yield from self.blocks()

    def extra_slip(self) -> int:
        return int(self.values.get("EXRHS", 0)) if self.digits["E"] != 0 else 0

    def area(self) -> Iterator[Line]:
        values, kind = self.values, self.values["IPOTCN"]
        yield [kind]
        yield self.named(f"MX MY {_AREAS[kind]}")
        if kind < 0:
            return
        yield self.named("IBASE IPLAN")
        if values["IBASE"] == 2:
            yield [len(values["HEIGHTS"]), *self.named("XM RM Y1 DY1")]
            yield from _many(values["HEIGHTS"])
        elif values["IBASE"] == 9:
            yield from _many(values["GAP"])
        else:
            yield self.named(_BASES[values["IBASE"]])
        if values["IPLAN"] in _PLANS:
            yield self.named(_PLANS[values["IPLAN"]])
        if values["IPLAN"] == 4:
            yield self.named("NPATCH")
            limits = list(values["PATCH_LIMITS"])
            yield from (limits[at : at + 4] for at in range(0, len(limits), 4))
            yield from _many(values["PATCH_FACTORS"])


class _OnRails(_Text):
    def lines(self) -> Iterator[Line]:
        digit, values, roller = self.digits, self.values, self.digits["C1"] >= _ROLLER
        is_flexible = "DXWHL" in values
        yield [self.module]
        yield [f"{digit['C1']}{self.previous}{digit['B']}{digit['T']}{digit['N']}{digit['F']}{3 if digit['S'] else 0}"]
        yield [f"{values['VARFRC']}{values['FRCLAW']}{values['DISCNS']}{values['INFLCF']}{digit['M']}3{5 if is_flexible else 3}",
               self.damping()]  # fmt: skip
        yield self.third_word()
        yield from self.bounds()
        yield from self.friction()
        if values["INFLCF"] == 4:
            yield self.named("IF_METH VARIANT")
        yield from self.bodies()
        yield self.named("DX DS DQREL A_SEP D_SEP D_COMB D_TURN G_MISS")
        by_gauge = "GAUGSQ GAUGWD" if values["GAUGHT"] > 0 else "RAILY0 RAILZ0"
        yield self.named(f"GAUGHT {by_gauge} {'NOMRADR' if roller else 'CANT'} CURV")
        yield from self.profile("RFNAME", "RAIL_")
        yield self.named("DYRAIL DZRAIL DROLLR VYRAIL VZRAIL VROLLR")
        if digit["F"] == 3:
            yield self.named("KYRAIL FYRAIL KZRAIL FZRAIL DYSTEP0")
        yield [*self.named("FBDIST FBPOS NOMRADW"), *([values["YTAPE"]] if "YTAPE" in values else [])]
        yield from self.profile("WFNAME", "WHEEL_")
        yield self.named(f"{'X' if roller else 'S'}_WS Y_WS {'FZ' if digit['N'] else 'Z_WS'} ROLL YAW PITCH")
        yield self.named(f"{'RPITCH' if roller else 'VS'} VY VZ VROLL VYAW {'FX' if digit['F'] == 1 else 'VPITCH'}")
        if is_flexible:
            yield self.named(_DEVIATIONS[0])
            yield self.named(_DEVIATIONS[1])
        yield from self.blocks()

    def profile(self, name: str, of: str) -> Iterator[Line]:
        options = [self.values[of + option] for option in ("MIRRORY", "SCALE", "SMOOTH", "MIRRORZ", "PRFOPT")]
        yield [self.file(name)]  # the first word of a list that continues on the next line
        yield options
        if options[-1] >= 1:
            yield [self.values[of + option] for option in ("ISMOOTH", "ZIGTHRS", "KINKHIGH", "KINKLOW", "KINKWID")]
        if options[-1] >= 2:
            yield [self.values[of + option] for option in ("ERRHND", "MAXOMIT")]


def _many(numbers: Iterable[Any]) -> Iterator[Line]:
    """Writes many numbers, a few per line."""
    line: list[Any] = []
    for number in numbers:
        line.append(number)
        if len(line) == _ON_A_LINE:
            yield line
            line = []
    if line:
        yield line

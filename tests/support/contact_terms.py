"""Lists terms that users of the CONTACT program look for: from its control words, input and output files, guide and C
library."""

from __future__ import annotations

#: Some page must contain all words of each term.
CONTACT_TERMS = [
    # kinds of problems
    "potential contact area", "undeformed distance", "penetration", "approach", "normal force", "tangential force", "creepage",
    "spin", "shift", "steady rolling", "transient rolling", "rolling direction", "rolling velocity", "rolling step",
    "rigid slip", "extra rigid slip", "micro-slip", "relative slip", "spin centre", "half-space", "quasi-identical",
    "dissimilar", "influence coefficients", "piecewise constant", "bilinear", "thin sheet", "viscoelastic",
    "third-body layer", "interfacial layer", "plasticity", "simplified theory", "flexibilities", "FASTSIM",
    "modified FASTSIM", "FaStrip", "KPEC", "ANALYN", "SDEC", "Hertzian", "semi-axes", "curvature", "line contact",
    "planform", "damping", "heat", "temperature", "friction law", "Coulomb", "falling friction", "friction memory",
    "exponential", "rational", "Polach", "variable friction", "conformal", "curved reference surface",
    # solvers
    "NORM", "TANG", "ConvexGS", "SteadyGS", "GDsteady", "Johnson process", "Panagiotopoulos", "KOMBI", "outer iterations",
    "initial estimate", "relaxation", "sensitivities", "MAXGS", "MAXIN", "MAXNR", "MAXOUT", "EPS", "OMEGAH", "OMEGAS", "INISLP",
    # wheels on rails
    "wheel profile", "rail profile", "MiniProf", "Simpack", "slices", "smoothing", "kink", "MIRRORY", "MIRRORZ", "gauge",
    "cant", "CURV", "roller", "track coordinates", "contact reference", "contact angle", "contact patches", "contact locus",
    "interpenetration", "massless rail", "rail deflection", "rail irregularity", "flexible wheelset", "yaw", "roll", "pitch",
    "GAUGHT", "GAUGWD", "NOMRADW", "FBDIST", "FBPOS", "KYRAIL", "FYRAIL", "DYRAIL", "VPITCH", "A_SEP", "D_SEP", "D_COMB",
    "D_TURN", "DELTCP", "XCP", "S_WS", "Y_WS", "Z_WS",
    # input and output
    "control words", "result element", "IPOTCN", "IBASE", "IPLAN", "FSTAT", "FKIN", "SABSH1", "MEMDST", "CKSI", "CETA", "CPHI",
    "CHI", "VELOC", "FACPHI", "SPINXO", "GG", "POISS", "FLXZ", "GG3", "LAYTHK", "TAU_C0", "CDAMPN", "DQREL", "NPOT", "NCON",
    "NADH", "NSLIP", "INORM", "ITANG", "TRCBND", "PMAX", "element division", "adhesion area", "slip area", "exterior",
    "traction bound", "torsional moment", "elastic energy", "FRIC.POWER", "frictional work", "subsurface stresses", "SIGVM",
    "SIGHYD", "SIGTR", "von Mises", "principal stress", "cntc_calculate", "cntc_setflags", "cntc_getcontactforces",
    "cntc_settangentialforces", "subs_calculate",
]  # fmt: skip

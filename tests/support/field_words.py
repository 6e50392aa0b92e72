"""Everyday expressions, and what the field says: pages (tests/docs) and comments (tests/architecture) have none of them."""

from __future__ import annotations

import re

OTHERWISE = {
    "bodies that differ": "dissimilar bodies",
    "quick (?:contact )?models?": "simplified contact model",
    "stop tests?": "stopping criterion",
    "turning stiffness": "tangent stiffness",
    "(?:coarse|outer) turns?": "outer iteration",
    "turns between": "outer iterations",
    "not round": "out-of-round",
    "rails? on springs": "massless flexible rail",
    "rails? that gives? way": "massless flexible rail, rail deflection",
    "friction that falls": "falling friction",
    "wid(?:e|est) registers?": "SIMD",
    "tents?": "bilinear hat function",
    "bears? (?:its|their) force": "carries its load",
    "feels? (?:a )?shares?": "weighted interaction",
    "divisions? held": "frozen element division",
    "held (?:contacts?|divisions?)": "frozen contact status, clamped",
    "honest answers?": "convergence reporting",
    "nobody waits": "the request is abandoned",
}


def everyday(text: str) -> dict[str, str]:
    """Returns the expressions of OTHERWISE in `text`, each with the field's term."""
    return {old: term for old, term in OTHERWISE.items() if re.search(rf"\b{old}\b", text, re.IGNORECASE)}

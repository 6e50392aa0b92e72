"""Creates random requests from the schemas of server.describe, and damages them."""

from __future__ import annotations

import copy
import json
import random
import struct
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

#: Values that are invalid nearly everywhere.
ODD_VALUES: list[Any] = [
    None, True, False, "", "text", "\u0000", "\ud83d\ude80", "e\u0301" * 40, "x" * 3000, -1, 0, 1, 0.5, -0.0, 5e-324, 1e308, 2**31, 2**53 + 1,
    2**63, 10**30, [], {}, [[]], [None], [1, [2]], {"": 1}, {"$array": 1}, {"$array": {"frame": 1, "dtype": "<f8", "shape": [1]}},
    {"$array": {"frame": 99, "dtype": ">i4", "shape": [-1, 2**40]}}, {"$ref": "#"}, {"nested": {"nested": {"nested": {}}}},
]  # fmt: skip
ODD_FRAMES = [b"", b"\0", b"x" * 7, struct.pack("<d", float("nan")), struct.pack("<d", float("inf")), b"\xff" * 800, bytes(5000)]
MAX_DEPTH = 8
#: Damage affects this number of places of a list.
LONG_LIST = 50
SESSION_GRID = (3, 2)
#: Parameters with which a session is opened, so that steps and states have one.
SESSION: dict[str, Any] = {
    "grid": {"nx": SESSION_GRID[0], "ny": SESSION_GRID[1], "dx": 0.5, "dy": 0.5}, "bodies": {"upper": {"G": 200, "nu": 0.42}},
    "ics": {"source": "analytic"}, "gap": {"paraboloid": {"Rx": 50, "Ry": 50}}, "approach": 0.02, "lease_seconds": 10,
    "friction": {"mu": 0.4, "rolling": {"kind": "transient"}},
}  # fmt: skip


@dataclass
class Message:
    """Holds a request before it is sent, with the envelope as text, because texts may be damaged."""

    text: bytes
    frames: list[bytes] = field(default_factory=list)

    def __str__(self) -> str:
        """Returns a part of it that identifies it."""
        return f"{self.text[:600]!r} ({len(self.text)} bytes), frames of {[len(frame) for frame in self.frames][:10]} bytes"


class Messages:
    """`document` is the result of server.describe. Grids have up to 36 elements."""

    # A message of twice max_frame_bytes would end the connection, which another test covers.
    max_bytes = 100_000
    timeouts_ms = (1, 50, 200, 1000)

    def __init__(self, document: dict[str, Any], seed: int) -> None:
        self._schemas = document["components"]["schemas"]
        # A watch is answered at its deadline, and damage may remove the deadline.
        self.methods = [method["name"] for method in document["methods"] if method["name"] != "health.watch"]
        self._random = random.Random(seed)
        self._grid = (1, 1)
        self._frames: list[bytes] = []
        #: Names of open sessions, for messages that refer to one.
        self.sessions: list[str] = []

    def next(self, name: str) -> Message:
        """Creates a request whose id is `name` unless it was damaged."""
        while True:
            message = self._next(name)
            if max(map(len, [message.text, *message.frames])) <= self.max_bytes:
                return message

    def _next(self, name: str) -> Message:
        choose = self._random
        self._grid = self._random_grid()
        self._frames = []
        method = choose.choice(self.methods)
        if method == "session.step" and choose.random() < 0.8:
            self._grid = SESSION_GRID
        params = self._params(method)
        envelope = {"contactd": 1, "id": name, "method": method, "params": params}
        if choose.random() < 0.3:
            envelope["arrays"] = choose.choice(["frame", "list"])
        # Adds a deadline, because small problems can also take long, such as transient rolling of 100,000 steps.
        envelope["timeout_ms"] = choose.choice(self.timeouts_ms)
        frames = self._frames
        self._damage_some(envelope)
        if choose.random() < 0.15:
            self._damage_frames(frames)
        text = json.dumps(envelope, ensure_ascii=choose.random() < 0.5).encode("utf-8", "surrogatepass")
        if choose.random() < 0.1:
            text = self._damaged_text(text)
        return Message(text, frames)

    def _damage_some(self, envelope: dict[str, Any]) -> None:
        for _ in range(self._random.choice([0, 0, 1, 1, 2, 4])):
            self.damage(envelope)

    def _random_grid(self) -> tuple[int, int]:
        return self._random.randint(1, 6), self._random.randint(1, 6)

    def _params(self, method: str) -> Any:
        return self.value({"$ref": f"#/components/schemas/{method}.params"})

    # --- from the schemas ---------------------------------------------------------------------------------------------

    def value(self, schema: Any, name: str = "", depth: int = 0) -> Any:
        """Creates a value that the schema would usually accept."""
        choose = self._random
        while isinstance(schema, dict) and "$ref" in schema:
            schema = self._resolve(schema["$ref"])
        if not isinstance(schema, dict) or depth > MAX_DEPTH:
            return self._odd_value()
        for key in ("oneOf", "anyOf"):
            if key in schema and "properties" not in schema:
                return self.value(choose.choice(schema[key]), name, depth + 1)
        if "const" in schema:
            return schema["const"]
        if "enum" in schema:
            return choose.choice(schema["enum"])
        kinds = schema.get("type", "object" if "properties" in schema else "number")
        kind = choose.choice(kinds) if isinstance(kinds, list) else kinds
        if "$array" in schema.get("properties", {}) and kind in ("array", "object"):
            return self._array()
        match kind:
            case "object":
                return self._object(schema, depth)
            case "array":
                low = schema.get("minItems", 0)
                count = choose.randint(low, max(low, min(schema.get("maxItems", 3), 3)))
                return [self.value(schema.get("items", {}), name, depth + 1) for _ in range(count)]
            case "string" if name == "session" and self.sessions and choose.random() < 0.8:
                return choose.choice(self.sessions)
            case "string" if name == "state" and choose.random() < 0.8:
                return "state-1"
            case "string":
                return "a" * max(1, schema.get("minLength", 1))
            case "boolean":
                return choose.random() < 0.5
            case "null":
                return None
        return self._number(schema, name, kind == "integer")

    def _resolve(self, reference: str) -> Any:
        at: Any = {"components": {"schemas": self._schemas}}
        for key in reference.removeprefix("#/").split("/"):
            at = at[key.replace("~1", "/").replace("~0", "~")]
        return at

    def _object(self, schema: dict[str, Any], depth: int) -> dict[str, Any]:
        choose = self._random
        properties = schema.get("properties", {})
        chosen = set(schema.get("required", []))
        # Conditions require one of several fields: "oneOf" of "required"; other conditions are met by chance.
        for alternatives in (schema.get("oneOf"), schema.get("anyOf")):
            if alternatives:
                chosen |= set(choose.choice(alternatives).get("required", []))
        share = choose.choice([0.0, 0.2, 0.6])
        chosen |= {name for name in sorted(properties) if choose.random() < share}
        return {name: self.value(properties.get(name, {}), name, depth + 1) for name in sorted(chosen)}

    def _number(self, schema: dict[str, Any], name: str, integer: bool) -> Any:
        choose = self._random
        if name in ("nx", "ny"):
            return self._grid[name == "ny"]
        if name == "step":
            return choose.choice([1, 1, 2, 3])
        low = schema.get("minimum", schema.get("exclusiveMinimum", -1e3))
        high = schema.get("maximum", schema.get("exclusiveMaximum", 1e3))
        if choose.random() < 0.1:
            return choose.choice([low, high])
        if integer:
            return choose.randint(int(low), int(min(high, low + 20)))
        return choose.uniform(low, min(high, low + choose.choice([0.5, 1.0, 100.0])))

    def _array(self) -> Any:
        nx, ny = self._grid
        shape = self._random.choice([[ny, nx], [ny, nx], [ny, nx], [3, 3, ny, nx], [nx, 3], [nx]])
        count = 1
        for extent in shape:
            count *= extent
        values = [self._random.choice([0.0, 1.0, self._random.uniform(-1, 1)]) for _ in range(count)]
        if self._random.random() < 0.3:
            nested: Any = values
            for extent in reversed(shape[1:]):
                nested = [nested[at : at + extent] for at in range(0, len(nested), extent)]
            return nested
        self._frames.append(struct.pack(f"<{count}d", *values))
        return {"$array": {"frame": len(self._frames), "dtype": "<f8", "shape": shape}}

    # --- damage -------------------------------------------------------------------------------------------------------

    def damage(self, envelope: dict[str, Any]) -> None:
        """Replaces, removes, adds or duplicates one value somewhere, mostly among the parameters."""
        choose = self._random
        places: list[tuple[Any, Any]] = []
        params = envelope.get("params")
        only_params = isinstance(params, dict | list) and params and choose.random() < 0.7
        self._collect(params if only_params else envelope, places)
        parent, key = choose.choice(places)
        match choose.randrange(5):
            case 0:
                del parent[key]
            case 1 if isinstance(parent, dict):
                parent[choose.choice(["extra", "", "nx", "$array", "params", "\u00e9" * 50])] = self._odd_value()
            case 2 if isinstance(parent, list):
                parent.extend([copy.deepcopy(parent[key])] * choose.choice([1, 2, 50]))
            case 3 if isinstance(parent[key], int | float) and not isinstance(parent[key], bool):
                parent[key] = choose.choice([-parent[key], parent[key] * 1e6, parent[key] + 0.5, str(parent[key])])
            case _:
                parent[key] = self._odd_value()

    def _odd_value(self) -> Any:
        return copy.deepcopy(self._random.choice(ODD_VALUES))

    def _collect(self, node: Any, places: list[tuple[Any, Any]]) -> None:
        for key in list(node) if isinstance(node, dict) else self._some(len(node)):
            places.append((node, key))
            if isinstance(node[key], dict | list):
                self._collect(node[key], places)

    def _some(self, count: int) -> Iterable[int]:
        """Selects places of a list, only some for long lists, whose numbers would otherwise dominate the message."""
        return range(count) if count <= LONG_LIST else self._random.sample(range(count), LONG_LIST)

    def _damage_frames(self, frames: list[bytes]) -> None:
        choose = self._random
        match choose.randrange(4):
            case 0 if frames:
                del frames[choose.randrange(len(frames))]
            case 1 if frames:
                at = choose.randrange(len(frames))
                frames[at] = frames[at][: choose.randrange(len(frames[at]) + 1)]
            case 2:
                frames.extend([choose.choice(ODD_FRAMES)] * choose.choice([1, 1, 2, 20]))
            case _:
                frames.insert(choose.randrange(len(frames) + 1), choose.choice(ODD_FRAMES))

    def _damaged_text(self, text: bytes) -> bytes:
        choose = self._random
        at = choose.randrange(len(text) + 1)
        match choose.randrange(6):
            case 0:
                return text[:at]
            case 1:
                return text[:at] + bytes([choose.randrange(256)]) + text[at + 1 :]
            case 2:
                return text[:at] + choose.choice([b"[", b"{", b"NaN", b"1e999", b"\xff\xfe", b"\xed\xa0\x80", b"\0"]) + text[at:]
            case 3:
                return b"[" * choose.choice([10, 1000, 40_000]) + text
            case 4:
                return text + text
        return choose.choice([b"", b"GET / HTTP/1.1\r\nHost: a\r\n\r\n", b"\xef\xbb\xbf" + text, b"null", b"[]", b'"id"', b"{}"])

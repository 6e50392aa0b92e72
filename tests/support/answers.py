"""Makes valid results, as a daemon would send them, for the fake one."""

import numpy as np

INFO = {
    "version": "0.1.0",
    "commit": "unknown",
    "protocol": 1,
    "libraries": {"mfem": "4.7"},
    "limits": {
        "max_frame_bytes": 1 << 20,
        "max_frames": 4,
        "max_message_bytes": 1 << 20,
        "max_array_elements": 1000,
        "max_grid_elements": 1000,
        "max_queue": 8,
        "max_queue_per_client": 4,
        "max_queue_bytes": 1 << 20,
        "max_sessions": 2,
        "max_session_bytes": 1 << 20,
        "max_session_states": 2,
        "max_lease_seconds": 60,
    },
    "counters": {"requests": 1},
    "cache": {"tables": 0},
    "queue": {"solves_waiting": 0},
    "uptime_seconds": 1.5,
}


def array(frame, shape, dtype="<f8"):
    return {"$array": {"frame": frame, "dtype": dtype, "shape": list(shape)}}


def table(ny, nx):
    """Returns result and frames of ic.get for a closed-form table whose entries count 0, 1, 2, ..."""
    values = np.arange(9.0 * ny * nx)
    spec = {
        "material": {"G": 1, "nu": 0},
        "grid": {"nx": nx, "ny": ny, "dx": 1, "dy": 1},
        "ics": {"source": "analytic", "body": "half_space", "load_shape": "constant"},
    }
    evidence = {"source": "analytic", "version": "0.1.0"}
    result = {"key": "", "origin": "closed_form", "spec": spec, "table": array(1, (3, 3, ny, nx)), "evidence": evidence}
    return result, values.tobytes()


def solution(ny, nx):
    """Returns result and frames of contact.solve."""
    solver = {"iterations": 7, "residual": 1e-7, "converged": True, "seconds": 0.1}
    use = {"origin": "closed_form", "key": "", "evidence": {"source": "analytic"}}
    result = {
        "approach": 0.02,
        "forces": {"Fn": 9.2, "Fx": -3.2, "Fy": 0, "Mz": 0.5},
        "pmax": 4.4,
        "area": {"contact": 3.0, "adhesion": 1.0, "slip": 2.0},
        "elements": {"contact": 3, "adhesion": 1, "slip": 2, "border": 0},
        "element_division": array(1, (ny, nx), "|u1"),
        "pressure": array(2, (ny, nx)),
        "traction_x": array(3, (ny, nx)),
        "traction_y": array(4, (ny, nx)),
        "warnings": [],
        "converged": True,
        "evidence": {"normal": solver, "tangential": solver, "ics": {"upper": use, "lower": use}},
    }
    return result, bytes(ny * nx), *[bytes(8 * ny * nx)] * 3


def solutions(*entries):
    """Returns result and frames of contact.solve_many: each entry is the shape of a solution, or a status."""
    listed, frames = [], []
    for entry in entries:
        if isinstance(entry, dict):
            listed.append({"status": entry})
            continue
        result, *own = solution(*entry)
        for name in ["element_division", "pressure", "traction_x", "traction_y"]:
            result[name]["$array"]["frame"] += len(frames)
        listed.append({"status": {"code": 0, "name": "OK", "message": ""}, "result": result})
        frames += own
    return {"solutions": listed}, *frames


def stresses(*shape):
    """Returns result and frames of contact.subsurface. The components are 0 to 5 everywhere, and von Mises' stress is 6."""
    names = ["xx", "yy", "zz", "xy", "xz", "yz"]
    result = {
        "shape": list(shape),
        "stress": {name: array(frame, shape) for frame, name in enumerate(names, 1)},
        "von_mises": array(7, shape),
        "largest": {"von_mises": 6, "x": 0, "y": 0, "z": -1, "depth": 1},
    }
    return result, *[np.full(shape, float(n)).tobytes() for n in range(7)]

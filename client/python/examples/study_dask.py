"""Runs a parameter study on several workers: Dask distributes the cases, and each worker uses the daemon of its
machine.

    python3 study_dask.py --bin build/production/bin

starts two daemons that share one store and two local Dask workers. It computes the normal force for a grid of
approaches and Poisson's ratios, with finite-element coefficients: the first daemon builds a table, the other one waits
for it and reads it. On a cluster, pass the address of its scheduler to Client(), and start a daemon on each machine
with `store.folder` on the shared file system (docs/scaling.md).
"""

from __future__ import annotations

import argparse
import itertools
import tempfile
from pathlib import Path

from dask.distributed import Client as Dask
from dask.distributed import LocalCluster, get_worker

import contactd


def daemon_of_this_worker(endpoints: list[str]) -> contactd.Client:
    """Returns the client of this worker, created on first use; each worker uses one daemon."""
    worker = get_worker()
    if not hasattr(worker, "contactd_client"):
        worker.contactd_client = contactd.Client(endpoints[int(worker.name) % len(endpoints)])
    return worker.contactd_client


def normal_force(case: tuple[float, float], endpoints: list[str]) -> tuple[float, float, float, str]:
    """Returns Poisson's ratio, approach, the normal force (N), and the origin of the coefficients."""
    nu, approach = case
    solution = daemon_of_this_worker(endpoints).solve(
        grid=contactd.Grid.centred(20, 20, 2.4, 2.4),
        upper=contactd.Material(G=200, nu=nu),
        ics=contactd.FemIcs(accuracy=1e-2),
        gap=contactd.Paraboloid(Rx=50, Ry=50),
        approach=approach,
    )
    if not solution.converged:
        raise RuntimeError(f"The case nu = {nu}, approach = {approach} did not converge.")
    return nu, approach, solution.Fn, solution.evidence.ics["upper"].origin


def study(endpoints: list[str], dask: Dask) -> list[tuple[float, float, float, str]]:
    cases = list(itertools.product([0.25, 0.3, 0.35, 0.4], [0.005, 0.01, 0.015, 0.02]))
    return dask.gather(dask.map(normal_force, cases, endpoints=endpoints))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bin", type=Path, help="folder of contactd; default: from PATH")
    options = parser.parse_args()
    program = options.bin / "contactd" if options.bin else "contactd"
    with tempfile.TemporaryDirectory(prefix="study-", dir="/tmp") as folder:
        config = {"store": {"folder": f"{folder}/store"}}
        daemons = [contactd.LocalDaemon(program, folder=Path(folder) / f"daemon-{n}", config=config) for n in (1, 2)]
        try:
            with (
                LocalCluster(n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None) as cluster,
                Dask(cluster) as dask,
            ):
                rows = study([daemon.endpoint for daemon in daemons], dask)
        finally:
            for daemon in daemons:
                daemon.close()
    print("   nu   approach (mm)   Fn (N)   coefficients")
    for nu, approach, force, origin in rows:
        print(f"{nu:5.2f}   {approach:13.3f}   {force:6.3f}   {origin}")


if __name__ == "__main__":
    main()
